// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("steady numbers are near, and the same for neighbours", "[core]")
{
    for (double v = -3.0; v < 3.0; v += 0.0371) {
        const double s = detail::steady(v);
        CHECK(std::fabs(s - v) <= 0x1p-40 * std::fabs(v));
        CHECK(detail::steady(s) == s);
        CHECK(detail::steady(std::nextafter(s, 9.0)) == s);
        CHECK(detail::steady(std::nextafter(s, -9.0)) == s);
    }
    for (const double tiny : {1e-300, 1e-310, 5e-324, -3e-320}) CHECK(detail::steady_sine(tiny) == tiny);
    CHECK(detail::steady(0.0) == 0.0);
    CHECK(detail::steady_sine(0.0) == 0.0);
    CHECK(detail::steady_cosine(0.0) == 1.0);
}

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
