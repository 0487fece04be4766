// SPDX-License-Identifier: MIT

#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/two_lines.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/oracle.hpp"
#include "support/unproving.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using path = std::vector<curve>;

constexpr double pi = 3.14159265358979323846;
constexpr double usual_tolerance = 2.5;  // of an em of 1000 units

outline outline_of(const std::vector<path>& contours)
{
    outline o;
    (void)o.starts.push_back(0);
    for (const path& contour : contours) {
        for (const curve& c : contour) {
            (void)o.curves.push_back(c);
            for (std::uint32_t i = 0; i <= c.degree; ++i) o.bounds.add(c.p[i]);
        }
        (void)o.starts.push_back(static_cast<std::uint32_t>(o.curves.size()));
    }
    return o;
}

path turned(const path& given, double angle, bool mirrored)
{
    const double c = std::cos(angle), s = std::sin(angle);
    path all = given;
    for (curve& q : all)
        for (point& p : q.p) {
            if (mirrored) p.x = -p.x;
            p = {c * p.x - s * p.y, s * p.x + c * p.y};
        }
    return all;
}

path reversed(path given)
{
    std::reverse(given.begin(), given.end());
    for (curve& c : given) std::reverse(c.p, c.p + c.degree + 1);
    return given;
}

/// A circle of `pieces` cubics, counter-clockwise from `start` on.
path circle(point centre, double radius, int pieces = 4, double start = 0.0)
{
    path all;
    const double step = 2 * pi / pieces, arm = 4.0 / 3.0 * std::tan(step / 4);
    const auto on = [&](double a) { return centre + radius * point{std::cos(a), std::sin(a)}; };
    const auto along = [&](double a) { return radius * arm * point{-std::sin(a), std::cos(a)}; };
    const point first = on(start);
    for (int i = 0; i < pieces; ++i) {
        const double a = start + step * i, b = start + step * (i + 1);
        const point p = i == 0 ? first : all.back().end(), q = i + 1 == pieces ? first : on(b);
        all.push_back(curve::from(cubic{p, p + along(a), q - along(b), q}));
    }
    return all;
}

path box_path(double left, double bottom, double right, double top)
{
    const point a{left, bottom}, b{right, bottom}, c{right, top}, d{left, top};
    return {curve::from(a, b), curve::from(b, c), curve::from(c, d), curve::from(d, a)};
}

/// Closed by lines over a box below (or above) it.
path bow(const quadratic& q, double base)
{
    const point r{q.p2.x, base}, l{q.p0.x, base};
    return {curve::from(q), curve::from(q.p2, r), curve::from(r, l), curve::from(l, q.p0)};
}

struct segment {
    point from, to;
};

/// The curves themselves, as chords off by a hundredth of the tolerance at most, in cells (Wang's bound).
std::vector<segment> dense(const outline& o, double cells, double tolerance)
{
    std::vector<segment> all;
    for (const curve& c : o.curves) {
        double bend = 0.0;
        for (std::uint32_t k = 0; k + 2 <= c.degree; ++k)
            bend = (std::max)(bend, length(c.p[k] + c.p[k + 2] - 2.0 * c.p[k + 1]));
        const int n = 1 + static_cast<int>(std::sqrt(c.degree * (c.degree - 1) * bend / (8.0 * 0.01 * tolerance)));
        point from = cells * c.start();
        for (int i = 1; i <= n; ++i) {  // one chord ends where the next begins, to the bit
            const point to = cells * (i == n ? c.end() : c.at(double(i) / n));
            all.push_back({from, to});
            from = to;
        }
    }
    return all;
}

double distance(point q, const segment& s)
{
    const point along = s.to - s.from;
    const double square = dot(along, along);
    const double t = square == 0 ? 0 : (std::clamp)(dot(q - s.from, along) / square, 0.0, 1.0);
    return length(q - s.from - t * along);
}

/// What a builder makes of an outline.
struct capped {
    cap_builder builder;
    region made;
    double cells = 0;

    template <class Discretiser = certified, class Triangulator = monotone>
    capped(const outline& o, fill_rule rule, double tolerance = usual_tolerance, const Discretiser& how = {},
           const Triangulator& cut = {})
    {
        no_observer nobody;
        const auto fitting = grid::fitting(1000, o.bounds);
        REQUIRE(fitting);
        cells = fitting->cells;
        const auto filled = builder.build(o, tolerance, *fitting, {rule}, cap_policies{how, cut, nobody});
        REQUIRE(filled);
        made = *filled;
    }

    const triangle_list& triangles() const { return builder.triangles(); }
    const refinement_effort& effort() const { return builder.effort(); }
};

/// What is broken of the laws that hold for all curves; empty: nothing.
std::string broken_law(const capped& c, const outline& o, double tolerance, fill_rule rule)
{
    if (c.made.points().empty()) return {};
    if (std::string s = test::oracle::broken_law(c.made, c.triangles().view()); !s.empty()) return s;
    const auto kept = test::oracle::loops_of(c.made);
    if (std::string s = test::oracle::broken_cycle(kept); !s.empty()) return s;
    const auto curves = dense(o, c.cells, tolerance);
    const double allowed = 1.01 * tolerance * c.cells + 1.5;  // 1.5 cells: crossings are rounded
    for (const auto l : kept)
        for (std::size_t i = 0; i < l.size(); ++i)
            for (const double share : {0.0, 0.5, 0.8}) {
                const grid_point a = l[i], b = l[(i + 1) % l.size()];
                const point q = lerp(point{double(a.x), double(a.y)}, point{double(b.x), double(b.y)}, share);
                double nearest = 1e300;
                for (const segment& s : curves) nearest = (std::min)(nearest, distance(q, s));
                if (nearest > allowed) return "the boundary is farther than the tolerance from all curves";
            }
    std::mt19937 random{7};
    std::uniform_real_distribution<double> share{-0.05, 1.05};
    for (int i = 0; i < 300; ++i) {
        point q = c.cells * (o.bounds.low + point{share(random) * o.bounds.width(), share(random) * o.bounds.height()});
        if (i % 3 != 0 && !curves.empty()) {  // beside a curve
            const segment& s = curves[random() % curves.size()];
            const point along = s.to - s.from, across{-along.y, along.x};
            const double size = length(across);
            if (size == 0) continue;
            q = s.from + ((i % 2 != 0 ? 1.0 : -1.0) * (1.0 + share(random)) * allowed / size) * across;
        }
        const grid_point p{static_cast<std::int32_t>(std::lround(q.x)), static_cast<std::int32_t>(std::lround(q.y))};
        q = {double(p.x), double(p.y)};
        double nearest = 1e300;
        std::int32_t winding = 0;
        for (const segment& s : curves) {
            nearest = (std::min)(nearest, distance(q, s));
            const double left = cross(s.to - s.from, q - s.from);
            if (s.from.y <= q.y && s.to.y > q.y && left > 0) ++winding;
            if (s.to.y <= q.y && s.from.y > q.y && left < 0) --winding;
        }
        if (nearest <= allowed) continue;
        if (test::oracle::winding(kept, p) != (is_filled(rule, winding) ? 1 : 0)) return "a place is filled wrongly";
    }
    return {};
}

/// The points where the boundary changes from a curve of one contour to one of another, in font units.
std::vector<point> changes(const capped& c, const outline& o)
{
    const auto contour_of = [&](std::uint32_t curve) {
        std::uint32_t k = 0;
        while (o.starts[k + 1] <= curve) ++k;
        return k;
    };
    std::vector<point> all;
    for (std::size_t l = 0; l + 1 < c.made.starts().size(); ++l) {
        const std::uint32_t begin = c.made.starts()[l], end = c.made.starts()[l + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const std::uint32_t before = i == begin ? end - 1 : i - 1;
            if (contour_of(c.made.edges()[before].curve) != contour_of(c.made.edges()[i].curve))
                all.push_back(c.made.grid().place(c.made.points()[i]));
        }
    }
    return all;
}

constexpr double angles[] = {0.0, 0.3, 1.1, 2.0, pi / 2};

}  // namespace

TEST_CASE("a circle inside another one never crosses it if they are at least 1/10 tolerance apart", "[cap_builder]")
{
    for (const double room : {0.1, 0.2, 0.35, 0.5, 0.8, 1.0, 1.4, 2.0, 3.0})
        for (const double angle : angles)
            for (const int pieces : {3, 4, 7}) {
                const path inner = circle({0, 0}, 400 - room * usual_tolerance, pieces, angle);
                const outline o = outline_of({circle({0, 0}, 400), inner});
                const capped c{o, fill_rule::even_odd};
                INFO(room << " tolerances, turned by " << angle << ", " << pieces << " pieces");
                // Cubics are off a circle by up to 400 * 0.0014 units (3 pieces) or 400 * 0.00028 (4): not all pairs
                // are nested.
                if (pieces != 3 || room >= 0.35) {
                    CHECK(c.made.outers() == 1);
                    CHECK(c.made.holes() == 1);
                    CHECK(changes(c, o).empty());
                }
                CHECK(broken_law(c, o, usual_tolerance, fill_rule::even_odd) == "");
                CHECK(c.effort().rounds <= 6);
            }
}

TEST_CASE("two bows stay apart even if they pass each other at less than the tolerance", "[cap_builder]")
{
    // Two bows, one from below, one from above: between their crowns there is `gap`.
    for (const double gap : {0.1, 0.3, 0.6, 1.0, 1.7, 3.0})
        for (const double height : {20.0, 60.0, 200.0})
            for (const double shift : {0.0, 13.0, 90.0})
                for (const double angle : angles) {
                    const quadratic below{{500, 0}, {250, 2 * height}, {0, 0}};
                    const double top = height + gap * usual_tolerance;
                    const quadratic above{
                        {shift, top + height}, {250 + shift, top - height}, {500 + shift, top + height}};
                    const outline o = outline_of({turned(bow(below, -100), angle, false),
                                                  turned(bow(above, top + 2 * height + 100), angle, false)});
                    const capped c{o, fill_rule::non_zero};
                    INFO("gap " << gap << ", height " << height << ", shift " << shift << ", angle " << angle);
                    CHECK(c.made.outers() == 2);
                    CHECK(c.made.holes() == 0);
                    CHECK(broken_law(c, o, usual_tolerance, fill_rule::non_zero) == "");
                }
}

TEST_CASE("a shallow crossing is found within four tolerances of where the curves cross", "[cap_builder]")
{
    // Equal circles whose centres lie left and right of x = 0 cross on x = 0 only.
    for (const double degrees : {1.0, 2.0, 4.0, 10.0, 25.0, 60.0, 120.0}) {
        const double radius = 400, apart = radius * std::sin(degrees * pi / 360);
        for (const int pieces : {2, 3, 4, 6, 9})
            for (const double start : {0.0, 0.2, 0.9}) {
                const path right = circle({apart, 0}, radius, pieces, start);
                path left = reversed(right);
                for (curve& q : left)
                    for (point& p : q.p) p.x = -p.x;  // mirrored
                const outline o = outline_of({right, left});
                const capped c{o, fill_rule::non_zero};
                INFO(degrees << " degrees, " << pieces << " pieces from " << start);
                CHECK(broken_law(c, o, usual_tolerance, fill_rule::non_zero) == "");
                std::vector<double> crossings;  // y where the right circle comes through x = 0
                for (const curve& q : right)
                    for (int i = 0; i < 4096; ++i) {
                        const point a = q.at(i / 4096.0), b = q.at((i + 1) / 4096.0);
                        if ((a.x < 0) != (b.x < 0)) crossings.push_back(a.y + (b.y - a.y) * a.x / (a.x - b.x));
                    }
                // Two cubics are no good circle: mirrored ones cross where they please, all of it on x = 0 by symmetry
                // only for curves that are functions of x there. The others are circles to 0.15 %.
                if (pieces < 4 && degrees < 10) continue;
                const auto found = changes(c, o);
                const double allowed = 4 * usual_tolerance + 3 / c.cells;
                const auto is_near = [&](point p, double y) { return length(p - point{0, y}) <= allowed; };
                for (const point p : found)  // near a crossing chords may cross three times
                    CHECK(std::any_of(crossings.begin(), crossings.end(), [&](double y) { return is_near(p, y); }));
                for (const double y : crossings)
                    CHECK(std::any_of(found.begin(), found.end(), [&](point p) { return is_near(p, y); }));
            }
    }
}

TEST_CASE("tangent circles, kissing quadratics and a line on a circle obey the laws at every distance", "[cap_builder]")
{
    for (const double d : {-3.0, -1.0, -0.3, -0.1, 0.0, 0.1, 0.3, 1.0, 3.0}) {
        const double gap = d * usual_tolerance;
        const std::vector<std::vector<path>> shapes = {
            {circle({0, 0}, 250), circle({500 + gap, 0}, 250)},          // outside each other
            {circle({0, 0}, 250), circle({100 + gap, 0}, 150)},          // inside
            {circle({0, 0}, 250), box_path(250 + gap, -300, 400, 300)},  // a line tangent to a circle
            {circle({0, 0}, 250, 4, 0.4), box_path(-400, -300, -250 - gap, 300)},
            {bow({{500, 0}, {250, 200}, {0, 0}}, -50), bow({{0, 200 + gap}, {250, 0 + gap}, {500, 200 + gap}}, 300)},
            {bow({{500, 0}, {250, 200}, {0, 0}}, -50), bow({{500, gap}, {250, 200 + gap}, {0, gap}}, -60)},
        };
        for (std::size_t k = 0; k < shapes.size(); ++k)
            for (const double angle : angles)
                for (const bool mirrored : {false, true}) {
                    std::vector<path> paths;
                    for (const path& p : shapes[k]) paths.push_back(turned(p, angle, mirrored));
                    const outline o = outline_of(paths);
                    for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
                        const capped c{o, rule};
                        INFO("shape " << k << " at " << d << " tolerances, " << angle << ", mirrored " << mirrored);
                        CHECK(broken_law(c, o, usual_tolerance, rule) == "");
                        if (d >= 0.1 && k != 1 && k != 5) CHECK(c.made.outers() == 2);
                    }
                }
    }
}

TEST_CASE("random pairs of curves that run close to each other obey the laws", "[cap_builder]")
{
    std::mt19937 random{11};
    std::uniform_real_distribution<double> any{-500, 500}, little{-3 * usual_tolerance, 3 * usual_tolerance};
    std::uint32_t refined = 0;
    for (int i = 0; i < 300; ++i) {
        const auto place = [&] { return point{std::round(any(random)), std::round(any(random))}; };
        const auto beside = [&](point p) { return p + point{little(random), little(random)}; };
        path a, b;
        const point start = place();
        const point start_beside = beside(start);
        point p = start, q = start_beside;
        const int n = 2 + static_cast<int>(random() % 3);
        for (int k = 0; k < n; ++k) {
            const point c0 = place(), c1 = place(), e = k + 1 == n ? start : place();
            const point f = k + 1 == n ? start_beside : beside(e);
            a.push_back(curve::from(cubic{p, c0, c1, e}));
            b.push_back(curve::from(cubic{q, beside(c0), beside(c1), f}));
            p = e, q = f;
        }
        const outline o = outline_of({a, i % 2 == 0 ? b : reversed(b)});
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            const capped c{o, rule};
            refined += c.effort().rounds != 0;
            CHECK(c.effort().rounds <= 12);
            INFO("pair " << i);
            CHECK(broken_law(c, o, usual_tolerance, rule) == "");
        }
    }
    CHECK(refined > 20);
}

TEST_CASE("curves that coincide are not made finer", "[cap_builder]")
{
    const path a = circle({0, 0}, 300), shifted = circle({300, 100}, 300, 4, 0.3);
    for (const auto& shape : {std::vector<path>{a, a, shifted}, std::vector<path>{a, reversed(a), shifted}}) {
        const outline o = outline_of(shape);
        const capped c{o, fill_rule::non_zero};
        CHECK(c.effort().rounds == 0);
        CHECK(broken_law(c, o, usual_tolerance, fill_rule::non_zero) == "");
    }
}

TEST_CASE("ninety-six slightly moved copies of a contour are made finer in at most five rounds", "[cap_builder]")
{
    // The chords of each two copies cross where the curves pass each other; to make them finer makes new ones do so.
    for (const double shift : {0.02, 0.05}) {
        std::vector<path> copies;
        for (int i = 0; i < 96; ++i) copies.push_back(circle({shift * i, shift * i}, 300));
        const outline o = outline_of(copies);
        const auto fitting = grid::fitting(1000, o.bounds);
        REQUIRE(fitting);
        INFO("moved by " << shift);
        workspace space;
        contours loops;
        cap_builder caps;
        no_observer nobody;
        resolve_effort once;
        REQUIRE(discretise(o, certified{}, usual_tolerance, *fitting, loops));
        REQUIRE(resolve(loops, fill_rule::non_zero, space, {.effort = &once}));

        const refinement_effort& effort = caps.effort();
        const auto built = [&](std::uint32_t max_pieces) {
            return caps.build(o, usual_tolerance, *fitting, {.max_pieces = max_pieces},
                              cap_policies{certified{}, monotone{}, nobody});
        };
        REQUIRE(built(default_max_pieces));
        CHECK(effort.rounds >= 1);
        CHECK(effort.rounds <= 5);  // none falls into fewer pieces than the first, four times that is the bound
        CHECK(effort.pieces >= std::uint64_t{once.pieces} * (effort.rounds + 1));

        for (std::uint32_t most = once.pieces / 2; most < 8 * once.pieces; most += once.pieces) {
            const auto made = built(most);
            if (!made) CHECK(made.error() == error::too_many_pieces);
            CHECK(effort.pieces <= 3 * std::uint64_t{most});  // as much as allowed, one round more, and the last
        }
    }
}

TEST_CASE("a corner just beside a curve stays apart from it at every tolerance", "[cap_builder]")
{
    // As in glyph 4312 of Mplus1Code-SemiBold: 0.7 units between the corner and the curve. At some tolerances a chord
    // comes through the corner, to half a cell: then it and the box's lower edge, which it leaves along, cancel.
    const path below{curve::from(cubic{{550, 99}, {489, 64}, {407, 28}, {318, 0}}), curve::from({318, 0}, {318, -100}),
                     curve::from({318, -100}, {550, -100}), curve::from({550, -100}, {550, 99})};
    const outline o = outline_of({below, box_path(200, 19, 372, 478)});
    for (int i = 0; i < 1000; ++i) {
        const double coarse = 1.25 + 0.01 * i;
        const capped c{o, fill_rule::non_zero, coarse};
        INFO("tolerance " << coarse);
        CHECK(c.made.outers() == 2);
        CHECK(changes(c, o).empty());
    }
}

TEST_CASE("steep crossings and crossing lines make no curve finer, anywhere on their chords", "[cap_builder]")
{
    for (int i = 0; i < 200; ++i) {
        const double x = 200 + 0.9 * i;
        const outline o =
            outline_of({circle({0, 0}, 300, 4, 0.01 * i), circle({x, 40}, 300), box_path(-350, -20, 700, 20)});
        const capped c{o, fill_rule::non_zero};
        CHECK(c.effort().rounds == 0);
    }
}

TEST_CASE("a contour whose curves have an area is kept at every tolerance", "[cap_builder]")
{
    for (const double coarse : {1.0, 10.0, 100.0, 1000.0}) {
        for (const int pieces : {2, 3, 4})
            for (const double radius : {0.05, 1.0, 30.0}) {
                const outline o = outline_of({circle({10, 20}, radius, pieces, 0.7)});
                const capped c{o, fill_rule::non_zero, coarse};
                INFO("tolerance " << coarse << ", radius " << radius << ", pieces " << pieces);
                CHECK(c.made.outers() == 1);
                CHECK(c.made.triangle_count() >= 1);
            }
        const outline lens = outline_of(
            {{curve::from(quadratic{{0, 0}, {50, 1}, {100, 0}}), curve::from(quadratic{{100, 0}, {50, -1}, {0, 0}})}});
        const capped c{lens, fill_rule::non_zero, coarse};
        CHECK(c.made.outers() == 1);
    }
    const curve there = curve::from(quadratic{{0, 0}, {50, 100}, {100, 0}});
    const outline nothing = outline_of({{there, reversed({there})[0]}});  // there and back
    const capped c{nothing, fill_rule::non_zero, 100.0};
    CHECK(c.made.points().empty());
}

TEST_CASE(
    "a discretiser without a tolerance is not called again, and triangulators that prove nothing get the same region",
    "[cap_builder]")
{
    const outline o = outline_of({circle({0, 0}, 400), circle({0, 0}, 399, 5, 0.3)});
    constexpr auto rule = fill_rule::even_odd;
    const capped lines{o, rule, usual_tolerance, two_lines{}}, proving{o, rule};
    const capped halves{o, rule, usual_tolerance, adaptive_subdivision{.distance = 0.5}};
    const capped plain{o, rule, usual_tolerance, certified{}, test::unproving{}};
    CHECK(lines.effort().rounds == 0);
    CHECK(halves.effort().rounds == 0);
    CHECK(proving.effort().rounds > 0);
    CHECK(test::oracle::doubled_area(test::oracle::loops_of(proving.made)) ==
          test::oracle::doubled_area(test::oracle::loops_of(plain.made)));
}

TEST_CASE("memory that fails while curves are made finer gives an error and no triangles", "[cap_builder]")
{
    const outline o = outline_of({circle({0, 0}, 400), circle({0, 0}, 399, 5, 0.3)});
    std::size_t failures = 0;
    for (std::size_t allowed = 1;; ++allowed) {
        test::counting_memory heap;
        heap.fail_at = allowed;
        cap_builder caps{heap.source()};
        no_observer nobody;
        const auto made = caps.build(o, usual_tolerance, grid{}, {fill_rule::even_odd},
                                     cap_policies{certified{}, monotone{}, nobody});
        if (made) break;
        ++failures;
        CHECK(made.error().code == error::out_of_memory);
        CHECK(caps.triangles().empty());
        REQUIRE(allowed < 1000);
    }
    CHECK(failures > 3);
}
