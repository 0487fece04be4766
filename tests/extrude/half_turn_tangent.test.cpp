// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/half_turn_tangent.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>
#include <cstdint>

using namespace typemesh;

namespace {

/// In long doubles, from the angles of both edges.
long double half_turn_by_angles(grid_point a, grid_point b, grid_point c)
{
    const auto angle = [](grid_point from, grid_point to) {
        return std::atan2(static_cast<long double>(to.y) - from.y, static_cast<long double>(to.x) - from.x);
    };
    return std::tan((angle(b, c) - angle(a, b)) / 2);
}

}  // namespace

TEST_CASE("half a turn is the tangent of half the angle, for turns by up to half a circle", "[extrude]")
{
    test::dice d{41};
    for (int i = 0; i < 20'000; ++i) {
        const int bits = 2 + static_cast<int>(d.roll(27));
        const auto any = [&] {
            return static_cast<std::int32_t>(d.roll(std::int32_t{1} << bits)) - (std::int32_t{1} << (bits - 1));
        };
        const grid_point a{any(), any()}, b{any(), any()}, c{any(), any()};
        if (a == b || b == c || orientation(a, b, c) == 0) continue;
        const double made = detail::half_turn_tangent(a, b, c);
        CHECK((made > 0.0) == (orientation(a, b, c) > 0));
        CHECK(detail::half_turn_tangent(c, b, a) == -made);
        if (std::fabs(made) < 1e6)
            CHECK(made == Catch::Approx(static_cast<double>(half_turn_by_angles(a, b, c))).epsilon(1e-9).margin(1e-12));
        else
            CHECK(std::fabs(made) < detail::turned_back);
    }
}

TEST_CASE("only a path that goes back the way it came turns by exactly half a circle", "[extrude]")
{
    constexpr std::int32_t most = 1 << 28;
    for (const grid_point by :
         {grid_point{1, 0}, grid_point{3, 7}, grid_point{-5, 2}, grid_point{most - 1, most - 3}}) {
        const grid_point a{0, 0}, back{-by.x, -by.y};
        CHECK(detail::half_turn_tangent(a, by, a) == detail::turned_back);
        CHECK(detail::half_turn_tangent(a, by, back) == detail::turned_back);
        CHECK(detail::half_turn_tangent(back, a, by) == 0.0);
    }
    // The turn by nearly half a circle at the end of a spike whose ends are a cell apart: its width is one cell, so the
    // tangent is the sum of both lengths, less than a cell apart from it.
    const grid_point a{-most, 0}, tip{most, 0}, b{-most, 1};
    CHECK(detail::half_turn_tangent(a, tip, b) == Catch::Approx(4.0 * most).epsilon(1e-12));
}
