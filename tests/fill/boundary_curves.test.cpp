// SPDX-License-Identifier: MIT

// Regions whose boundary becomes curves again: the font's own where nothing meets, and pieces of them where curves meet.

#include <typemesh/fill/boundary_curves.hpp>
#include <typemesh/fill/region_union.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cmath>
#include <string>

#include "outline/same_curves.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/redrawn_glyph.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// A disc of four cubics.
template <class Sink>
void add_disc(Sink& to, point c, double r, bool turned = false)
{
    const double h = 0.5522847498 * r, s = turned ? -1.0 : 1.0;
    const auto at = [&](double x, double y) { return c + point{x, s * y}; };
    to.move(at(r, 0));
    to.cubic(at(r, h), at(h, r), at(0, r));
    to.cubic(at(-h, r), at(-r, h), at(-r, 0));
    to.cubic(at(-r, -h), at(-h, -r), at(0, -r));
    to.cubic(at(h, -r), at(r, -h), at(r, 0));
    to.close();
}
template <class Draw>
outline drawn_by(const Draw& draw, fill_rule rule = fill_rule::non_zero)
{
    outline all;
    outline_recorder to{all};
    draw(to);
    REQUIRE(to.finish() == error::none);
    all.rule = rule;
    return all;
}

/// The distance from a circle.
double off(point p, point c, double r) { return std::fabs(length(p - c) - r); }

}  // namespace

TEST_CASE("curves that meet no other one are given back as they were drawn", "[fill][boundary]")
{
    const outline ring = drawn_by([](auto& to) {
        add_disc(to, {500, 400}, 300);
        add_disc(to, {500, 400}, 200, true);
        to.move({900, 100});
        to.line({1000, 100});
        to.quadratic({1000, 900}, {900, 900});
        to.close();
    });
    for (const double tolerance : {1.0 / 20, 1.0 / 200, 1.0 / 2000}) {
        test::redrawn_glyph again;
        REQUIRE(again.make(ring, 1000.0, tolerance) == error::none);
        CHECK(test::same_curves(again.drawn, ring));
        CHECK(again.found().meetings() == 0);
        CHECK(again.found().straight_edges() == 0);
    }
}

TEST_CASE("a loop that runs backwards is turned round, piece by piece", "[fill][boundary]")
{
    const outline disc = drawn_by([](auto& to) { add_disc(to, {500, 400}, 300, true); });
    test::redrawn_glyph again;
    REQUIRE(again.make(disc, 1000.0, 1e-3) == error::none);
    REQUIRE(again.drawn.curves.size() == 4);
    for (const curve& c : again.drawn.curves) {
        CHECK(cross(c.start() - point{500, 400}, c.end() - point{500, 400}) > 0.0);
        for (int k = 0; k <= 8; ++k) CHECK(off(c.at(k / 8.0), {500, 400}, 300) < 0.1);
    }
}

TEST_CASE("two discs become two arcs that end where the circles cross", "[fill][boundary]")
{
    for (const double tolerance : {1.0 / 20, 1.0 / 100, 1.0 / 1000}) {
        const point a{400, 400}, b{700, 430};
        const outline both = drawn_by([&](auto& to) {
            add_disc(to, a, 300);
            add_disc(to, b, 250);
        });
        test::redrawn_glyph again;
        REQUIRE(again.make(both, 1000.0, tolerance) == error::none);
        CHECK(again.found().meetings() == 2);
        CHECK(again.found().straight_edges() == 0);
        CHECK(again.drawn.contour_count() == 1);
        CHECK(again.drawn.curves.size() < 10);
        int crossings = 0;
        for (const curve& c : again.drawn.curves) {
            const bool of_a = off(c.at(0.5), a, 300) < 0.2;
            CHECK((of_a || off(c.at(0.5), b, 250) < 0.2));
            for (int k = 0; k <= 8; ++k) CHECK(off(c.at(k / 8.0), of_a ? a : b, of_a ? 300 : 250) < 0.2);
            crossings += off(c.start(), a, 300) < 0.2 && off(c.start(), b, 250) < 0.2;
        }
        CHECK(crossings == 2);
        CHECK(again.broken_again(2.0) == "");
        CHECK(again.wrong_places(both, 2000, 2.0, 7) == 0);  // cells: the arcs are the curves' own
    }
}

TEST_CASE("a curve that crosses itself ends where it does", "[fill][boundary]")
{
    const outline loop = drawn_by([](auto& to) {
        to.move({100, 100});
        to.cubic({1500, 900}, {-500, 900}, {900, 100});
        to.line({500, 20});
        to.close();
    });
    test::redrawn_glyph again;
    REQUIRE(again.make(loop, 1000.0, 1e-2) == error::none);
    CHECK(again.found().straight_edges() == 0);
    CHECK(again.wrong_places(loop, 2000, 8.0, 3) == 0);
}

TEST_CASE("glyphs that were moved and merged are pieces of moved curves", "[fill][boundary]")
{
    const outline disc = drawn_by([](auto& to) { add_disc(to, {400, 400}, 300); });
    const double tolerance = 2e-3;
    const auto cells = grid::fitting(1000.0, {{-2000.0, -2000.0}, {2000.0, 2000.0}});
    REQUIRE(cells);
    contours loops;
    workspace space;
    REQUIRE(discretise(disc, certified{}, tolerance * 1000.0, *cells, loops));
    const auto one = fill(loops, fill_rule::non_zero, space);
    REQUIRE(one);
    region_union joined;
    joined.begin(*cells);
    REQUIRE(joined.add(*one, 1.0, 0, 0));
    REQUIRE(joined.add(*one, 1.0, 123456, 20001));
    const auto both = joined.join(space);
    REQUIRE(both);
    boundary_curves curves;
    outline drawn;
    REQUIRE(curves.find(*both, drawn));
    CHECK(curves.straight_edges() == 0);
    CHECK(curves.meetings() == 2);
    const point a{400, 400}, b = a + point{123456 / cells->cells, 20001 / cells->cells};
    for (const curve& c : drawn.curves)
        for (int k = 0; k <= 8; ++k) CHECK((off(c.at(k / 8.0), a, 300) < 0.2 || off(c.at(k / 8.0), b, 300) < 0.2));
}

TEST_CASE("edges without curves become lines", "[fill][boundary]")
{
    test::dice d{5};
    for (int round = 0; round < 200; ++round) {
        const test::shape s{"polygon", {test::random_polygon(3 + d.roll(12), 40, d)}};
        contours loops = test::contours_of(s);
        loops.grid = grid{.cells = 1.0};
        workspace space;
        const auto filled = fill(loops, fill_rule::non_zero, space);
        REQUIRE(filled);
        boundary_curves curves;
        outline drawn;
        REQUIRE(curves.find(*filled, drawn));
        CHECK(curves.straight_edges() == filled->points().size());
        CHECK(drawn.curves.size() == filled->points().size());
        for (std::uint32_t k = 0; k < drawn.contour_count(); ++k)
            for (std::uint32_t i = drawn.starts[k]; i < drawn.starts[k + 1]; ++i)
                CHECK(drawn.curves[i].end() ==
                      drawn.curves[i + 1 < drawn.starts[k + 1] ? i + 1 : drawn.starts[k]].start());
    }
}

TEST_CASE("memory that fails leaves no curves, and nothing is allocated after warm-up", "[fill][boundary]")
{
    const outline both = drawn_by([&](auto& to) {
        add_disc(to, {400, 400}, 300);
        add_disc(to, {700, 430}, 250);
    });
    test::redrawn_glyph again;
    REQUIRE(again.make(both, 1000.0, 1e-3) == error::none);
    std::size_t failed = 0;
    for (std::size_t n = 1;; ++n) {
        test::counting_memory counted{.fail_at = n};
        boundary_curves curves{counted.source()};
        outline out{counted.source()};
        if (const auto done = curves.find(again.filled, out); done) break;
        CHECK(out.curves.empty());
        CHECK(out.contour_count() == 0);
        ++failed;
    }
    CHECK(failed >= 3);
    test::counting_memory counted;
    boundary_curves curves{counted.source()};
    outline out{counted.source()};
    REQUIRE(curves.find(again.filled, out));
    const std::size_t before = counted.requests;
    REQUIRE(curves.find(again.filled, out));
    CHECK(counted.requests == before);
    REQUIRE(curves.find(region{}, out));
    CHECK(out.curves.empty());
}
