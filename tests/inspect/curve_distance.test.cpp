// SPDX-License-Identifier: MIT

#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/curve_distance.hpp>
#include <typemesh/inspect/fill_check.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

/// The toy font's o, filled to a tolerance of 2 font units.
struct curved_ring {
    static constexpr double tolerance = 2.0;
    test::toy_font font;
    outline drawn;
    contours loops;
    workspace space;
    region filled;
    double cells = 0.0, allowed = 0.0;
    inspect::curve_chords curves;

    curved_ring()
    {
        REQUIRE(record(font, 1, drawn));
        const auto g = grid::fitting(font.units_per_em(), drawn.bounds);
        REQUIRE(g);
        cells = g->cells;
        REQUIRE(discretise(drawn, certified{}, tolerance, *g, loops));
        const auto r = fill(loops, drawn.rule, space);
        REQUIRE(r);
        filled = *r;
        allowed = 1.01 * tolerance * cells;
        curves.take(drawn, cells, 0.01 * tolerance * cells);
    }
};

}  // namespace

TEST_CASE("a boundary within its tolerance passes, and a point beyond the tolerance is found", "[inspect]")
{
    curved_ring r;
    const auto right = inspect::check_distance(r.filled, r.curves, r.allowed);
    CHECK(right.places == 2 * r.filled.points().size());
    CHECK(right.strays == 0);
    CHECK(right.farthest > 0.3 * r.allowed);
    CHECK(right.farthest <= r.allowed);
    // Every point strays when it is moved straight out from the middle. (The region is a view of the loops.)
    for (std::size_t i = 0; i < r.loops.points.size(); ++i) {
        const grid_point kept = r.loops.points[i];
        const point middle{250 * r.cells, 250 * r.cells}, out = point{double(kept.x), double(kept.y)} - middle;
        const double more = 1.05 * r.allowed / length(out);
        r.loops.points[i] = {static_cast<std::int32_t>(kept.x + more * out.x),
                             static_cast<std::int32_t>(kept.y + more * out.y)};
        CHECK(inspect::check_distance(r.filled, r.curves, r.allowed).strays > 0);
        r.loops.points[i] = kept;
    }
}

TEST_CASE("a region is filled like its curves, and another region is not", "[inspect]")
{
    const curved_ring r;
    const auto kept = inspect::loops_of(r.filled);
    const auto right = inspect::check_fill(r.curves, r.drawn.rule, kept, r.allowed, 500);
    CHECK(right.places + right.skipped == 500);
    CHECK(right.places > 400);
    CHECK(right.wrong == 0);
    CHECK(inspect::check_fill(r.curves, r.drawn.rule, {kept[0]}, r.allowed, 500).wrong > 0);
    CHECK(inspect::check_fill(r.curves, r.drawn.rule, {kept[1]}, r.allowed, 500).wrong > 0);
    CHECK(inspect::check_fill(inspect::curve_chords{}, r.drawn.rule, kept, r.allowed).places == 0);
}

TEST_CASE("chords stay within the requested error of their curves", "[inspect]")
{
    const curved_ring r;
    const auto fine = inspect::curve_chords{r.drawn, r.cells, 1.0};
    CHECK(fine.all().size() > inspect::curve_chords(r.drawn, r.cells, 100.0).all().size());
    for (std::uint32_t k = 0; k < r.drawn.curves.size(); ++k)
        for (int i = 0; i <= 100; ++i) {
            const point p = r.cells * r.drawn.curves[k].at(i / 100.0);
            CHECK(inspect::curve_chords::squared_distance(p, fine.of_curve(k)) <= 1.0);
        }
    CHECK(fine.winding(r.cells * point{50, 250}) == 1);
    CHECK(fine.winding(r.cells * point{250, 250}) == 0);
}
