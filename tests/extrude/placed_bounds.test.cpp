// SPDX-License-Identifier: MIT

#include <typemesh/extrude/placed_bounds.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

TEST_CASE("placed bounds contain all that stands over the box, and touch it on all sides", "[extrude][placed_bounds]")
{
    test::dice d{29};
    for (const frame& f : meshes::frames())
        for (int round = 0; round < 200; ++round) {
            placement at;
            at.frame = f;
            at.unit_per_cell = 1.0 / 512.0;
            at.unit_per_depth = 3.0;
            at.pen = {double(d.roll(5000)), -double(d.roll(5000))};
            box around;
            for (int k = 0; k < 2; ++k) around.add({double(d.roll(100'000)), double(d.roll(100'000))});
            const height_range heights{-d.fraction(), d.fraction()};
            const bounds3 all = placed_bounds(around, heights, at);
            bounds3 corners{};
            for (int k = 0; k < 8; ++k) {
                const point p{k % 2 == 0 ? around.low.x : around.high.x, k / 2 % 2 == 0 ? around.low.y : around.high.y};
                const vec3 corner = at.position(at.foot(p), at.height(k < 4 ? heights.low : heights.high));
                if (k == 0) corners = {corner, corner};
                corners.add(corner);
            }
            CHECK(all.low == corners.low);
            CHECK(all.high == corners.high);
            for (int k = 0; k < 20; ++k) {
                const point p =
                    point{around.low.x + d.fraction() * around.width(), around.low.y + d.fraction() * around.height()};
                const double h = heights.low + d.fraction() * (heights.high - heights.low);
                CHECK(all.holds(at.position(at.foot(p), at.height(h))));
            }
        }
}

TEST_CASE("promised bounds without a box are the bounds of the points", "[extrude][placed_bounds]")
{
    const placement at = meshes::in_em();
    const grid_point points[] = {{0, 512'000}, {-512'000, 0}, {1024, 1024}};
    const bounds3 all = detail::promised_bounds({}, points, {-0.5, 0.0}, at);
    CHECK(all.holds({-1.0f, 0.0f, -0.5f}));
    CHECK(all.holds({0.002f, 1.0f, 0.0f}));
    CHECK_FALSE(all.holds({-1.01f, 0.0f, 0.0f}));
    CHECK_FALSE(all.holds({0.0f, 0.5f, 0.01f}));
}
