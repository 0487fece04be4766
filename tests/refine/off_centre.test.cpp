// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/off_centre.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>

using namespace typemesh;

namespace {

double distance(grid_point p, grid_point q) { return std::sqrt(double(squared_distance(p, q))); }

}  // namespace

TEST_CASE("an off-centre is as far from both ends of the short edge, and no farther from it than it may be", "[refine]")
{
    test::dice d{11};
    std::size_t centres = 0, nearer = 0;
    for (int round = 0; round < 4000; ++round) {
        const auto roll = [&] { return d.roll(200'000) - 100'000; };
        const grid_point a{roll(), roll()}, b{a.x + d.roll(2000) - 1000, a.y + d.roll(2000) - 1000},
            c = round % 2 == 0 ? grid_point{roll(), roll()}
                               : grid_point{a.x + d.roll(4000) - 2000, a.y + d.roll(4000) - 2000};
        if (orientation(a, b, c) <= 0 || distance(a, b) > distance(b, c) || distance(a, b) > distance(c, a)) continue;
        const double farthest = 1.2;
        const grid_point p = detail::off_centre(a, b, c, farthest);
        CHECK(std::abs(distance(p, a) - distance(p, b)) < 1.5);
        CHECK(orientation(a, b, p) + 2 * std::int64_t(distance(a, b)) > 0);  // on c's side of the edge
        const grid_point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        CHECK(distance(p, middle) <= farthest * distance(a, b) + 2.0);
        const bool is_centre = std::abs(distance(p, c) - distance(p, a)) < 2.0;
        const bool is_at_limit = std::abs(distance(p, middle) - farthest * distance(a, b)) < 2.0;
        CHECK((is_centre || is_at_limit));
        ++(is_centre ? centres : nearer);
    }
    CHECK(centres > 10);
    CHECK(nearer > 1000);
}

TEST_CASE("an off-centre stays on the grid", "[refine]")
{
    const grid_point p = detail::off_centre({-(1 << 28), -(1 << 28)}, {1 << 28, -(1 << 28)}, {0, 1 - (1 << 28)}, 1e9);
    CHECK(p.x >= -(1 << 28));
    CHECK(p.x <= 1 << 28);
    CHECK(p.y >= -(1 << 28));
    CHECK(p.y <= 1 << 28);
}
