// SPDX-License-Identifier: MIT

#include <typemesh/core/fill_rule.hpp>

#include "support/catch.hpp"

#include <limits>

using namespace typemesh;

TEST_CASE("non_zero fills all but 0, even_odd what is odd, negative winding numbers too", "[core]")
{
    for (std::int32_t w = -9; w <= 9; ++w) {
        CHECK(is_filled(fill_rule::non_zero, w) == (w != 0));
        CHECK(is_filled(fill_rule::even_odd, w) == (w % 2 != 0));
    }
    CHECK(is_filled(fill_rule::non_zero, (std::numeric_limits<std::int32_t>::min)()));
    CHECK_FALSE(is_filled(fill_rule::even_odd, (std::numeric_limits<std::int32_t>::min)()));
    CHECK(is_filled(fill_rule::even_odd, (std::numeric_limits<std::int32_t>::max)()));
}
