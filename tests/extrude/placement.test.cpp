// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/axes.hpp>
#include <typemesh/extrude/placement.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;
using Catch::Approx;

namespace {

placement any_placement(const frame& f, test::dice& d)
{
    placement at;
    at.frame = f;
    at.pen = {1e6 * (d.fraction() - 0.5), 1e6 * (d.fraction() - 0.5)};
    at.unit_per_cell = d.fraction() / 512.0;
    return at;
}

}  // namespace

TEST_CASE("a position is the frame's sum of the cell in output units", "[extrude][placement]")
{
    test::dice d{17};
    for (const frame& f : meshes::frames())
        for (int round = 0; round < 500; ++round) {
            const placement at = any_placement(f, d);
            const grid_point p{d.roll(1 << 20) - (1 << 19), d.roll(1 << 20) - (1 << 19)};
            const float z = static_cast<float>(d.fraction());
            const double x = (p.x + at.pen.x) * at.unit_per_cell, y = (p.y + at.pen.y) * at.unit_per_cell;
            const vec3 made = at.position(p, z);
            const auto is = [&](float value, float right, float up, float toward) {
                const double wanted = double(right) * x + double(up) * y + double(toward) * double(z);
                CHECK(double(value) == Approx(wanted).epsilon(2e-7).margin(2e-7 * (std::abs(x) + std::abs(y) + 1.0)));
            };
            is(made.x, f.right.x, f.up.x, f.toward.x);
            is(made.y, f.right.y, f.up.y, f.toward.y);
            is(made.z, f.right.z, f.up.z, f.toward.z);
            CHECK(at.position(at.foot(p), z) == made);
        }
}

TEST_CASE("positions that are equal in exact numbers are equal floats, from any pen and cell", "[extrude][placement]")
{
    test::dice d{18};
    placement a, b;
    a.unit_per_cell = b.unit_per_cell = 1.0 / 3.0;
    for (int round = 0; round < 2000; ++round) {
        const grid_point p{d.roll(1 << 24), d.roll(1 << 24)}, by{d.roll(1 << 20), d.roll(1 << 20)};
        b.pen = {double(by.x), double(by.y)};
        CHECK(a.position(grid_point{p.x + by.x, p.y + by.y}, 1.5f) == b.position(p, 1.5f));
    }
}

TEST_CASE("a position with height 0 is rounded once, to the nearest float", "[extrude][placement]")
{
    test::dice d{19};
    placement at;
    at.unit_per_cell = 1.0 / 1024000.0;
    for (int round = 0; round < 5000; ++round) {
        const grid_point p{d.roll(1 << 28) - (1 << 27), d.roll(1 << 28) - (1 << 27)};
        const vec3 made = at.position(p, 0.0f);
        REQUIRE(made.x == static_cast<float>(p.x * at.unit_per_cell));
        REQUIRE(made.y == static_cast<float>(p.y * at.unit_per_cell));
        REQUIRE(made.z == 0.0f);
    }
}

TEST_CASE("a position half-way between two floats is rounded to the even one", "[extrude][placement]")
{
    placement at;
    for (std::int32_t i = -200; i < 200; ++i) {
        const grid_point p{(1 << 24) + i, -(1 << 25) - 2 * i};
        const vec3 made = at.position(p, 0.0f);
        CHECK(made.x == static_cast<float>(p.x));
        CHECK(made.y == static_cast<float>(p.y));
    }
}

TEST_CASE("heights follow the unit of depths, and wall normals follow the frame", "[extrude][placement]")
{
    placement at;
    at.unit_per_depth = 2.5;
    CHECK(at.height(0.5) == 1.25f);
    for (const frame& f : meshes::frames()) {
        at.frame = f;
        CHECK(at.normal({1.0f, 0.0f}) == f.right);
        CHECK(at.normal({0.0f, 1.0f}) == f.up);
        CHECK(at.normal({-1.0f, 0.0f}).x == -f.right.x);
    }
}

TEST_CASE("a point is placed like the grid point with its coordinates, to the bit", "[extrude][placement]")
{
    test::dice d{23};
    for (const frame& f : meshes::frames())
        for (int round = 0; round < 500; ++round) {
            placement at = any_placement(f, d);
            at.unit_per_depth = 10.0 * d.fraction();
            const grid_point p{d.roll(1 << 28) - (1 << 27), d.roll(1 << 28) - (1 << 27)};
            const double x = p.x, y = p.y, z = d.fraction() - 0.5;
            CHECK(at.position({x, y, z}) == at.position(p, at.height(z)));
            CHECK(free_axes{at}.position(free_axes{at}.foot(point{x, y}), 0.25f) == at.position(p, 0.25f));
            if (upright_axes::fit(f))
                CHECK(upright_axes{at}.position(upright_axes{at}.foot(point{x, y}), 0.25f) == at.position(p, 0.25f));
            CHECK(at.direction({0.6f, 0.8f, 0.0f}) == at.normal({0.6f, 0.8f}));
            CHECK(at.direction(0.0f, 0.0f, 1.0f) == f.toward);

            // Between two of them it lies between where they go.
            const vec3 half = at.position({x + 0.5, y, z}), next = at.position({x + 1.0, y, z}),
                       here = at.position({x, y, z});
            CHECK(((here.x <= half.x && half.x <= next.x) || (here.x >= half.x && half.x >= next.x)));
        }
    placement at;
    at.unit_per_cell = 1.0 / 512.0;
    at.unit_per_depth = 2.0;
    CHECK(at.cells_per_depth() == 1024.0);
}
