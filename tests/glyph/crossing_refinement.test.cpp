// SPDX-License-Identifier: MIT

// What a crossing_refinement says of single intersections; what cap_builder makes of it is in cap_builder_curves.test.cpp.

#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/glyph/impl/crossing_refinement.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace typemesh;

namespace {

constexpr double font_tolerance = 2.0;  // font units, of an em of 1000
const grid cells{512.0};

/// Two contours: each a curve, closed by a line.
outline two_curves(const curve& a, const curve& b)
{
    outline o;
    bool fits = o.starts.push_back(0);
    for (const curve& c : {a, b}) {
        fits = fits && o.curves.push_back(c) && o.curves.push_back(curve::from(c.end(), c.start())) &&
               o.starts.push_back(static_cast<std::uint32_t>(o.curves.size()));
        for (std::uint32_t i = 0; i <= c.degree; ++i) o.bounds.add(c.p[i]);
    }
    REQUIRE(fits);
    return o;
}

intersection::edge whole_chord(const outline& o, std::uint32_t i)
{
    return {cells.snap(o.curves[i].start()), cells.snap(o.curves[i].end()), {i, 0.0f, 1.0f}};
}

/// One that looks at these curves.
struct refinement {
    outline shape;
    workspace space;
    workspace::scope scratch{space};
    crossing_refinement filter;

    refinement(const curve& a, const curve& b) : shape{two_curves(a, b)}
    {
        REQUIRE(filter.open(scratch, shape, font_tolerance, cells));
    }
};

grid_point to_cells(point p)
{
    return {static_cast<std::int32_t>(std::lround(p.x)), static_cast<std::int32_t>(std::lround(p.y))};
}

/// Where two edges cross within both, away from their ends.
bool cross_inside(const intersection::edge& a, const intersection::edge& b, point& at)
{
    const point u{double(a.to.x) - a.from.x, double(a.to.y) - a.from.y},
        v{double(b.to.x) - b.from.x, double(b.to.y) - b.from.y},
        w{double(b.from.x) - a.from.x, double(b.from.y) - a.from.y};
    const double d = cross(u, v);
    if (d == 0.0) return false;
    const double t = cross(w, v) / d, s = cross(w, u) / d;
    at = point{double(a.from.x), double(a.from.y)} + t * u;
    return t > 0.0 && t < 1.0 && s > 0.0 && s < 1.0;
}

/// The nearest that two curves come to each other within `reach` cells of a place, in cells: by trying everything.
double nearest_beside(const curve& a, const curve& b, point place, double reach)
{
    std::vector<point> of_a, of_b;
    constexpr int n = 4000;
    for (int i = 0; i <= n; ++i)
        for (auto& [c, all] : {std::pair{&a, &of_a}, std::pair{&b, &of_b}}) {
            const point p = cells.cells * c->at(double(i) / n);
            if (length(p - place) <= reach) all->push_back(p);
        }
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < of_a.size(); ++i) {
        const point along = of_a[i + 1] - of_a[i];
        for (std::size_t k = 0; k < of_b.size(); ++k) {
            const point from_a = of_b[k] - of_a[i];
            const double t = (std::clamp)(dot(from_a, along) / dot(along, along), 0.0, 1.0);
            nearest = (std::min)(nearest, length(from_a - t * along));
            if (k == 0) continue;
            const point step = of_b[k] - of_b[k - 1];  // the pieces cross: both have their ends on two sides
            if (cross(along, from_a) * cross(along, from_a - step) <= 0.0 &&
                cross(step, from_a) * cross(step, from_a - along) <= 0.0)
                return 0.0;
        }
    }
    return nearest;
}

}  // namespace

TEST_CASE("a crossing of lines stands, and so does the end of a line on a curve", "[glyph][crossing_refinement]")
{
    const curve up = curve::from(point{0, 0}, point{500, 1}), down = curve::from(point{0, 1}, point{500, 0});
    refinement lines{up, down};
    const intersection::edge a = whole_chord(lines.shape, 0), b = whole_chord(lines.shape, 2);
    CHECK(lines.filter({a, b, {250 * 512, 256}}));

    refinement ends{curve::from(quadratic{{0, 0}, {250, 3}, {500, 0}}), curve::from(point{500, 0}, point{400, 100})};
    CHECK(ends.filter({whole_chord(ends.shape, 0), whole_chord(ends.shape, 2), {500 * 512, 0}}));
}

TEST_CASE("all intersections of a curve that is drawn twice stand, in both directions", "[glyph][crossing_refinement]")
{
    const cubic c{{0, 0}, {100, 400}, {400, -300}, {500, 10}};
    for (const cubic& again : {c, cubic{c.p3, c.p2, c.p1, c.p0}}) {
        refinement same{curve::from(c), curve::from(again)};
        const intersection::edge a = whole_chord(same.shape, 0), b = whole_chord(same.shape, 2);
        for (const double share : {0.1, 0.5, 0.9})
            CHECK(same.filter({a, b,
                               to_cells(lerp(point{double(a.from.x), double(a.from.y)},
                                             point{double(a.to.x), double(a.to.y)}, share))}));
        CHECK(same.filter.is_content());
    }
    refinement moved{curve::from(c), curve::from(cubic{c.p0, c.p1, c.p2 + point{0, 1e-3}, c.p3})};
    const intersection::edge a = whole_chord(moved.shape, 0), b = whole_chord(moved.shape, 2);
    (void)moved.filter({a, b, {128'000, 2560}});  // may stand, for it comes near, but by looking
    CHECK(moved.filter.effort().unsettled == 0);
}

TEST_CASE("every clear intersection stands, and those that stand lie near a common point of the curves",
          "[glyph][crossing_refinement]")
{
    test::dice d{77};
    const auto somewhere = [&](double size) { return point{size * d.fraction(), size * d.fraction()}; };
    int stood = 0, refused = 0, clear = 0;
    for (int round = 0; round < 3000; ++round) {
        // Two flat bows, nearly on top of each other: their chords cross by chance.
        const point from = somewhere(300.0), to = from + point{200.0 + 300.0 * d.fraction(), 100.0 * d.fraction()};
        const auto beside = [&](point p, double by) { return p + somewhere(by) - point{by / 2, by / 2}; };
        const double apart = 12.0 * d.fraction();
        const curve a = curve::from(quadratic{from, beside(lerp(from, to, 0.5), 60.0), to});
        const curve b =
            d.roll(2) == 0
                ? curve::from(quadratic{beside(a.p[0], apart), beside(a.p[1], 2 * apart), beside(a.p[2], apart)})
                : curve::from(quadratic{beside(a.p[2], apart), beside(a.p[1], 2 * apart), beside(a.p[0], apart)});
        refinement r{a, b};
        contours chords;
        REQUIRE(discretise(r.shape, certified{}, font_tolerance, cells, chords));
        std::vector<intersection::edge> of[2];
        for (std::uint32_t contour = 0; contour < 2; ++contour)
            for (std::uint32_t i = chords.starts[contour]; i < chords.starts[contour + 1]; ++i) {
                const std::uint32_t next = i + 1 == chords.starts[contour + 1] ? chords.starts[contour] : i + 1;
                if (chords.edges[i].curve % 2 == 0)
                    of[contour].push_back({chords.points[i], chords.points[next], chords.edges[i]});
            }
        for (const auto& e : of[0])
            for (const auto& f : of[1]) {
                point at;
                if (!cross_inside(e, f, at)) continue;
                const bool stands = r.filter({e, f, to_cells(at)});
                const double allowed = crossing_refinement::farthest * font_tolerance * cells.cells;
                INFO("round " << round << " at " << at.x << ", " << at.y);
                if (stands) {
                    ++stood;
                    REQUIRE(nearest_beside(a, b, at, allowed + 4.0) < 1.5);
                } else {
                    ++refused;
                    // Refused is what has no common point anywhere near, or one at the edge of what is allowed.
                    const bool is_clear = nearest_beside(a, b, at, 0.3 * allowed) < 0.2;
                    clear += is_clear;
                }
            }
    }
    CHECK(stood > 300);
    CHECK(refused > 100);
    CHECK(clear == 0);
}

TEST_CASE("curves that pass each other are halved until no chords can cross, at most six times",
          "[glyph][crossing_refinement]")
{
    // Two bows 0.3 units apart; the intersection is one that chords of a coarse polygon would have.
    const curve low = curve::from(quadratic{{0, 0}, {250, 100}, {500, 0}}),
                high = curve::from(quadratic{{0, 0.3}, {250, 100.3}, {500, 0.3}});
    refinement r{low, high};
    const intersection m{whole_chord(r.shape, 0), whole_chord(r.shape, 2), {128'000, 25'600}};
    std::uint32_t before = 0;
    for (std::uint32_t round = 1;; ++round) {
        REQUIRE(round <= crossing_refinement::max_halvings + 1u);
        if (r.filter(m)) break;
        REQUIRE_FALSE(r.filter.is_content());
        CHECK(r.filter.effort().rounds == round);
        const auto halvings = r.filter.halvings();
        CHECK(halvings[0] > before);
        CHECK(halvings[0] == halvings[2]);
        CHECK(halvings[0] <= crossing_refinement::max_halvings);
        CHECK((halvings[1] == 0 && halvings[3] == 0));  // lines
        before = halvings[0];
    }
    CHECK(before == crossing_refinement::max_halvings);
    CHECK(r.filter.effort().unsettled == 1);
    CHECK(r.filter.effort().curves == 2);
    CHECK(r.filter.is_content());
}

TEST_CASE("a wide gap needs no more halvings than a narrow one", "[glyph][crossing_refinement]")
{
    std::uint32_t last = crossing_refinement::max_halvings;
    for (const double gap : {0.05, 0.1, 0.25, 0.5, 1.0, 2.0, 3.9}) {
        refinement r{curve::from(quadratic{{0, 0}, {250, 100}, {500, 0}}),
                     curve::from(quadratic{{0, gap}, {250, 100 + gap}, {500, gap}})};
        REQUIRE_FALSE(r.filter({whole_chord(r.shape, 0), whole_chord(r.shape, 2), {128'000, 25'600}}));
        REQUIRE_FALSE(r.filter.is_content());
        const std::uint32_t now = r.filter.halvings()[0];
        INFO("gap " << gap);
        CHECK(now >= 1);
        CHECK(now <= last);
        // The strips of both curves then fit into the gap, or they are halved as often as they may be.
        CHECK((now == crossing_refinement::max_halvings || 2.0 * font_tolerance / double(1u << now) <= gap * 1.01));
        last = now;
    }
    CHECK(last == 1);
}
