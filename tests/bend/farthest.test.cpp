// SPDX-License-Identifier: MIT
#include <typemesh/bend/impl/farthest.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("the farther end of an interval is found from inside and outside", "[bend][warp]")
{
    CHECK(detail::farthest(-3.0, 1.0, 0.0) == 3.0);
    CHECK(detail::farthest(2.0, 5.0, 3.0) == 2.0);
    CHECK(detail::farthest(2.0, 5.0, 1.0) == 4.0);
    CHECK(detail::farthest(2.0, 5.0, 6.0) == 4.0);
}
