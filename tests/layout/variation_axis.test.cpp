// SPDX-License-Identifier: MIT
#include <typemesh/layout/variation_axis.hpp>

#include "morph/toy_axis.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct without_changes : test::toy_axis {
    error append_changes(buffer<axis_coordinate>&) const noexcept = delete;
};

}  // namespace

TEST_CASE("an axis needs all its functions", "[layout][morph]")
{
    STATIC_REQUIRE(variation_axis<test::toy_axis>);
    STATIC_REQUIRE_FALSE(variation_axis<without_changes>);
    STATIC_REQUIRE_FALSE(variation_axis<test::toy_axis::toy_font>);
}
