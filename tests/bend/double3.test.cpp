// SPDX-License-Identifier: MIT

#include <typemesh/bend/double3.hpp>

#include "deformations.hpp"

using namespace typemesh;

TEST_CASE("a cross product is perpendicular to both factors, and as long as their parallelogram is large", "[bend]")
{
    static_assert(dot({1.0, 2.0, 3.0}, {4.0, -5.0, 6.0}) == 12.0);
    static_assert(cross({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}).z == 1.0);
    test::dice d{1};
    const box3 all{{-3.0, -3.0, -3.0}, {3.0, 3.0, 3.0}};
    for (int round = 0; round < 1000; ++round) {
        const double3 a = bending::within(d, all), b = bending::within(d, all), c = cross(a, b);
        CHECK_QUICKLY(std::fabs(dot(a, c)) < 1e-13 && std::fabs(dot(b, c)) < 1e-13);
        CHECK_QUICKLY(dot(c, c) == Approx(dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b)).margin(1e-12));
        CHECK_QUICKLY(length(a + b) <= length(a) + length(b) + 1e-13);
        CHECK_QUICKLY(length(a - b) == length(b - a));
        CHECK_QUICKLY(length(2.0 * a) == 2.0 * length(a));
        const double3 back = cross(b, a);
        CHECK_QUICKLY(back.x == -c.x && back.y == -c.y && back.z == -c.z);
    }
}
