// SPDX-License-Identifier: MIT
#include <typemesh/core/impl/same.hpp>
#include <typemesh/text/cells_told_apart.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <random>

using namespace typemesh;

namespace {

glyph_run run_at(double x, double y)
{
    glyph_run run;
    REQUIRE(run.glyphs.push_back({0, 0, {x, y}}));
    return run;
}

}  // namespace

TEST_CASE("an em has fewer cells the farther glyphs stand, a power of two", "[cells_told_apart]")
{
    CHECK(same(cells_told_apart(0.0, true), 0x1p23));
    CHECK(same(cells_told_apart(1.9, true), 0x1p22));
    CHECK(same(cells_told_apart(2.0, true), 0x1p21));
    CHECK(same(cells_told_apart(7.9, true), 0x1p20));
    CHECK(same(cells_told_apart(8.0, true), 0x1p19));
    CHECK(same(cells_told_apart(62.0, true), 0x1p17));
    CHECK(same(cells_told_apart(62.0, false), 0x1p14));
    CHECK(same(cells_told_apart(4000.0, true), 0x1p11));
    CHECK(same(cells_told_apart(1e9, true), 0x1p9));
}

TEST_CASE("runs reach 2 em beyond their pens, boxes as far as they do", "[cells_told_apart]")
{
    CHECK(same(reach_of(glyph_run{}, 1000.0), 2.0));
    CHECK(same(reach_of(run_at(-3000.0, 500.0), 1000.0), 5.0));
    CHECK(same(reach_of(run_at(0.0, -4000.0), 1000.0), 6.0));
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
        CHECK(same(reach_of(run_at(bad, 0.0), 1000.0), 2.0));
    CHECK(same(reach_of(box{}, 1000.0), 0.0));
    CHECK(same(reach_of(box{{-3000.0, 0.0}, {100.0, 2000.0}}, 1000.0), 3.0));
    CHECK(same(reach_of(box{{-3000.0, 0.0}, {100.0, 20000.0}}, 1000.0), 20.0));
}

TEST_CASE("places a cell apart are different floats, in any unit", "[cells_told_apart]")
{
    std::mt19937_64 random{3};
    std::uniform_real_distribution<double> share{0.0, 1.0};
    for (int run = 0; run < 200000; ++run) {
        const double far = std::exp2(1.0 + 13.0 * share(random)) - 2.0;  // em; a letter's own places up to 2 em beyond
        const double per_em = cells_told_apart(far + 2.0, true);
        const double unit = std::exp2(40.0 * share(random) - 20.0);
        const double pen = far * share(random) * per_em;
        const double cell = std::floor(share(random) * 2.0 * per_em);
        const auto here = static_cast<float>((cell + pen) * (unit / per_em)),
                   next = static_cast<float>((cell + 1.0 + pen) * (unit / per_em));
        REQUIRE(here < next);
    }
}
