// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("steady angles are exact on the axes and near elsewhere", "[core]")
{
    CHECK(detail::steady_angle(0.0, 1.0) == 0.0);
    for (double a = -3.1; a < 3.1; a += 0.0173) {
        const double found = detail::steady_angle(std::sin(a), std::cos(a));
        CHECK(std::fabs(found - a) <= 0x1p-38);
        CHECK(detail::steady(found) == found);
        CHECK(detail::steady(detail::steady_tangent(a)) == detail::steady_tangent(a));
    }
}
