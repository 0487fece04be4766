// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/grid.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace typemesh;

namespace {

box around(double size)
{
    box b;
    b.add(point{-size, -size / 3});
    b.add(point{size / 2, size});
    return b;
}

}  // namespace

TEST_CASE("snapping stays within the snap error, and a snapped place snaps to itself", "[core][grid]")
{
    std::mt19937_64 random{7};
    for (const double cells : {0x1p-10, 1.0, 512.0, 0x1p30}) {
        const grid g{cells};
        std::uniform_real_distribution<double> range{-grid::reach / cells, grid::reach / cells};
        std::size_t wrong = 0;
        for (int i = 0; i < 10000; ++i) {
            const point p{range(random), range(random)};
            const grid_point s = g.snap(p);
            wrong += !(length(g.place(s) - p) <= g.snap_error() * (1 + 1e-12));
            wrong += !(g.snap(g.place(s)) == s);
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("snapping rounds to the nearest cell, and halves to the even one, on both sides of 0", "[core][grid]")
{
    const grid g{1.0};
    const double at[] = {0.0, 0.49, 0.5, 0.51, 1.5, 2.5, -0.49, -0.5, -0.51, -1.5, -2.5, 268435456.0, -268435456.0};
    const std::int32_t expected[] = {0, 0, 0, 1, 2, 2, 0, 0, -1, -2, -2, 268435456, -268435456};
    for (int i = 0; i < 13; ++i) CHECK(g.snap({at[i], -at[i]}) == grid_point{expected[i], -expected[i]});
}

TEST_CASE("ordinary fonts have 512 cells a unit, and every outline fits its grid", "[core][grid]")
{
    for (const double upem : {64.0, 1000.0, 2048.0, 16384.0, 65536.0}) {
        const auto g = grid::fitting(upem, around(upem));
        REQUIRE(g);
        CHECK(g->cells <= 512.0);
        if (upem <= 16384.0) CHECK(g->cells == 512.0);
    }
    for (const double upem : {1e-6, 0.01, 1.0, 32.0, 1000.0, 1e6, 1e9})
        for (const double size : {1e-9, 1e-3, 1.0, 1e4, 1e8, 1e12}) {
            const auto g = grid::fitting(upem, around(size));
            INFO(upem << " units per em, " << size << " wide");
            if (!g) {
                CHECK(g.error() == error::outline_beyond_grid);
                continue;
            }
            int exponent = 0;
            CHECK(std::frexp(g->cells, &exponent) == 0.5);  // a power of two
            CHECK(size * g->cells <= grid::reach - 1.0);
        }
    CHECK(grid::fitting(1000.0, box{})->cells == 512.0);
    CHECK(std::ilogb(grid::fitting(1.0, around(1.0))->cells) == 20);
}

TEST_CASE("an outline that is not finite or too large has no grid", "[core][grid]")
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
    for (const double upem : {0.0, -1000.0, nan, infinite})
        CHECK(grid::fitting(upem, around(1.0)).error() == error::bad_option);
    CHECK(grid::fitting(1000.0, around(1e30)).error() == error::outline_beyond_grid);
    box open = around(1.0);
    open.high.x = infinite;
    CHECK(grid::fitting(1000.0, open).error() == error::outline_not_finite);
}

TEST_CASE("coarsen() halves a grid until an em has few enough cells", "[grid]")
{
    grid g;
    g.units_per_em = 1000.0;
    g.span = 4096.0;
    g.coarsen(0x1p20);
    CHECK(same(g.cells, 512.0));
    CHECK(same(g.span, 4096.0));
    g.coarsen(0x1p18);
    CHECK(same(g.cells, 256.0));
    CHECK(same(g.span, 2056.0));  // two points a cell apart may have been two half cells apart
    g.coarsen(1.0);
    CHECK(g.cells * g.units_per_em <= 1.0);
    CHECK(g.cells * g.units_per_em > 0.5);
    g.coarsen(0.0);
    CHECK(g.cells > 0.0);
}
