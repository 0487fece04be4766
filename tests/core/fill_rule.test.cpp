// SPDX-License-Identifier: MIT

#include <typemesh/core/fill_rule.hpp>

#include "support/catch.hpp"

#include <limits>

using namespace typemesh;

TEST_CASE("non_zero fills every winding number but 0, and even_odd the odd ones", "[core]")
{
    for (std::int32_t w = -9; w <= 9; ++w) {
        CHECK(is_filled(fill_rule::non_zero, w) == (w != 0));
        CHECK(is_filled(fill_rule::even_odd, w) == (w % 2 != 0));
    }
    CHECK(is_filled(fill_rule::non_zero, (std::numeric_limits<std::int32_t>::min)()));
    CHECK_FALSE(is_filled(fill_rule::even_odd, (std::numeric_limits<std::int32_t>::min)()));
    CHECK(is_filled(fill_rule::even_odd, (std::numeric_limits<std::int32_t>::max)()));
}
