// SPDX-License-Identifier: MIT
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/discretise/two_lines.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include "discretise/curves.hpp"

using namespace typemesh;
using namespace test;

namespace {

/// A source of closed contours, each a list of curves.
outline outline_of(const std::vector<std::vector<curve>>& contours_given, memory source = heap())
{
    outline o{source};
    bool fits = o.starts.push_back(0);
    for (const auto& contour : contours_given) {
        for (const curve& c : contour) {
            fits = fits && o.curves.push_back(c);
            for (std::uint32_t i = 0; i <= c.degree; ++i) o.bounds.add(c.p[i]);
        }
        fits = fits && o.starts.push_back(static_cast<std::uint32_t>(o.curves.size()));
    }
    if (!fits) throw std::runtime_error("no memory for the test's own outline");
    return o;
}

std::vector<curve> polygon(const std::vector<point>& corners)
{
    std::vector<curve> lines;
    for (std::size_t i = 0; i < corners.size(); ++i)
        lines.push_back(curve::from(corners[i], corners[(i + 1) % corners.size()]));
    return lines;
}

/// Emits the given points, and keeps the tolerance that it got.
struct scripted {
    std::vector<emitted> inner;
    mutable double given = 0.0;

    template <class Curve, class Put>
    void operator()(const Curve& c, double tolerance, Put&& put) const noexcept
    {
        given = tolerance;
        for (const emitted& e : inner) put(e.p, e.t);
        put(c.at(1.0), 1.0);
    }
};

std::vector<grid_point> points(const contours& c) { return {c.points.begin(), c.points.end()}; }

std::string edges(const contours& c)
{
    std::ostringstream out;
    for (const contour_edge& e : c.edges) out << e.curve << ':' << e.t0 << '-' << e.t1 << ' ';
    return out.str();
}

/// A quadratic from (0, 0) to (20, 0) with its peak at (10, 10), and one line back, or two past (10, -5).
const curve bow = curve::from(quadratic{{0, 0}, {10, 20}, {20, 0}});
const std::vector<curve> bow_and_line{bow, curve::from({20, 0}, {0, 0})};
const std::vector<curve> bow_and_corner{bow, curve::from({20, 0}, {10, -5}), curve::from({10, -5}, {0, 0})};

/// Names the promise of contours that is broken, or nothing.
std::string broken_law(const contours& c)
{
    if (c.points.size() != c.edges.size()) return "the numbers of edges and points differ";
    if (c.starts.empty() ? !c.points.empty() : c.starts[0] != 0 || c.starts.back() != c.points.size())
        return "the starts do not frame the points";
    for (std::uint32_t k = 0; k < c.contour_count(); ++k) {
        const std::uint32_t first = c.starts[k], n = c.starts[k + 1] - first;
        if (n < 3) return "fewer than three points";
        for (std::uint32_t i = 0; i < n; ++i) {
            const contour_edge e = c.edges[first + i], next = c.edges[first + (i + 1) % n];
            if (c.points[first + i] == c.points[first + (i + 1) % n]) return "equal neighbours";
            if (!(e.t0 <= e.t1)) return "t descends along an edge";
            if (i + 1 < n && next.curve < e.curve) return "the curves are out of order";
            if (next.curve == e.curve && i + 1 < n && next.t0 < e.t1) return "t descends along a curve";
            const point start = c.curves[e.curve].at(static_cast<double>(e.t0)),
                        end = c.curves[e.curve].at(static_cast<double>(e.t1));
            const double close = 1e-3 + 2.0 * c.grid.snap_error();
            if (length(start - c.grid.place(c.points[first + i])) > close) return "an edge starts off its point";
            if (length(end - c.grid.place(c.points[first + (i + 1) % n])) > close) return "an edge ends off its point";
        }
    }
    return "";
}

const grid coarse{1.0};  // a grid of whole units

}  // namespace

TEST_CASE("a polygon of lines becomes its corners, without the closing point", "[discretise]")
{
    const outline o = outline_of({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), polygon({{2, 2}, {2, 5}, {5.25, 2}})});
    contours out;
    REQUIRE(discretise(o, certified{}, 1.0, grid{4.0}, out));
    CHECK(points(out) == std::vector<grid_point>{{0, 0}, {40, 0}, {40, 40}, {0, 40}, {8, 8}, {8, 20}, {21, 8}});
    CHECK(edges(out) == "0:0-1 1:0-1 2:0-1 3:0-1 4:0-1 5:0-1 6:0-1 ");
    CHECK(std::vector<std::uint32_t>(out.starts.begin(), out.starts.end()) == std::vector<std::uint32_t>{0, 4, 7});
    CHECK(out.curves.data() == o.curves.data());
    CHECK(out.curves.size() == 7);
    CHECK(out.grid.cells == 4.0);
    CHECK(broken_law(out) == "");
}

TEST_CASE("points that fall on one grid point become one, and edges keep their curve and t", "[discretise]")
{
    contours out;
    REQUIRE(discretise(outline_of({bow_and_line}), two_lines{}, 1.0, coarse, out));
    CHECK(points(out) == std::vector<grid_point>{{0, 0}, {10, 10}, {20, 0}});
    CHECK(edges(out) == "0:0-0.5 0:0.5-1 1:0-1 ");
    // Between two corners, and at the start of the contour.
    scripted how{{{{9.9, 10.2}, 0.25}, {{10.1, 9.8}, 0.375}, {{9.6, 9.6}, 0.5}, {{15, 5}, 0.75}}};
    REQUIRE(discretise(outline_of({bow_and_line}), how, 1.0, coarse, out));
    CHECK(points(out) == std::vector<grid_point>{{0, 0}, {10, 10}, {15, 5}, {20, 0}});
    CHECK(edges(out) == "0:0-0.25 0:0.5-0.75 0:0.75-1 1:0-1 ");
    how = {{{{0.2, 0.3}, 0.125}, {{10, 10}, 0.5}, {{20.3, 0.2}, 0.875}}};
    REQUIRE(discretise(outline_of({bow_and_line}), how, 1.0, coarse, out));
    CHECK(points(out) == std::vector<grid_point>{{0, 0}, {10, 10}, {20, 0}});
    CHECK(edges(out) == "0:0.125-0.5 0:0.5-0.875 1:0-1 ");
}

TEST_CASE("curves that fall on one grid point leave no edge", "[discretise]")
{
    const outline o = outline_of({{
        curve::from({0, 0}, {0.2, 0.2}),
        curve::from({0.2, 0.2}, {10, 0}),
        curve::from(cubic{{10, 0}, {10.1, 0.1}, {10.2, 0.1}, {10.2, 0}}),
        curve::from({10.2, 0}, {10, 10}),
        curve::from({10, 10}, {0.3, 0.3}),
        curve::from({0.3, 0.3}, {0, 0}),
    }});
    contours out;
    REQUIRE(discretise(o, two_lines{}, 1.0, coarse, out));
    CHECK(points(out) == std::vector<grid_point>{{0, 0}, {10, 0}, {10, 10}});
    CHECK(edges(out) == "1:0-1 3:0-1 4:0-1 ");
}

TEST_CASE("contours with fewer than three points left are dropped", "[discretise]")
{
    const outline o = outline_of({
        polygon({{3, 3}}),                        // an anchor
        polygon({{0, 0}, {10, 0}}),               // there and back
        polygon({{5, 5}, {5.2, 5}, {5.2, 5.2}}),  // smaller than a cell
        polygon({{0, 0}, {10, 0}, {5, 5}}),       // a triangle that stays
        {},                                       // nothing
        polygon({{0, 0}, {10, 0}, {10.2, 0.2}}),  // there and back after snapping
        {curve::from(quadratic{{7, 7}, {7, 7}, {7, 7}})},
    });
    contours out;
    REQUIRE(discretise(o, certified{}, 2.0, coarse, out));
    CHECK(points(out) == std::vector<grid_point>{{0, 0}, {10, 0}, {5, 5}});
    CHECK(out.contour_count() == 1);
    CHECK(edges(out) == "6:0-1 7:0-1 8:0-1 ");
}

TEST_CASE("an empty outline replaces the contours by none", "[discretise]")
{
    const outline square = outline_of({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}})}), nothing;
    contours out;
    REQUIRE(discretise(square, certified{}, 1.0, grid{}, out));
    REQUIRE(discretise(nothing, certified{}, 1.0, grid{}, out));
    CHECK(out.contour_count() == 0);
    CHECK(out.points.empty());
    CHECK(out.edges.empty());
}

TEST_CASE("the discretiser gets the tolerance less the snap, but at least the snap", "[discretise]")
{
    const outline o = outline_of({bow_and_corner});  // a flat contour would get finer chords
    const scripted how;
    contours out;
    const double snap = grid{}.snap_error();
    REQUIRE(discretise(o, how, 1.0, grid{}, out));
    CHECK(how.given == 1.0 - snap);
    for (const double tolerance : {1.9 * snap, snap, 0.1 * snap, 1e-300}) {
        REQUIRE(discretise(o, how, tolerance, grid{}, out));
        CHECK(how.given == snap);
    }
}

TEST_CASE("contours know the tolerance that they keep, in cells, or 0", "[discretise]")
{
    const outline o = outline_of({bow_and_corner});
    contours out;
    REQUIRE(discretise(o, certified{}, 1.5, grid{}, out));
    CHECK(out.tolerance == 1.5 * 512.0);
    const std::uint8_t halvings[] = {3, 0, 0};
    REQUIRE(discretise(o, certified{}, 1.5, grid{}, out, halvings));
    CHECK(out.tolerance == 1.5 * 512.0);
    REQUIRE(discretise(o, certified{}, 1e-300, grid{}, out));
    CHECK(out.tolerance == 2.0 * grid{}.snap_error() * 512.0);
    REQUIRE(discretise(o, two_lines{}, 1.5, grid{}, out));
    CHECK(out.tolerance == 0.0);
    REQUIRE(discretise(o, certified{}, 1.5, grid{}, out));
    out.clear();
    CHECK(out.tolerance == 0.0);
}

TEST_CASE("a curve's halvings halve its tolerance, and that of no other curve", "[discretise]")
{
    const auto arch = [](double x) -> std::vector<curve> {
        return {curve::from(quadratic{{x, 0}, {x + 300, 600}, {x + 600, 0}}), curve::from({x + 600, 0}, {x, 0})};
    };
    const outline o = outline_of({arch(0), arch(700)});
    contours plain, finer;
    REQUIRE(discretise(o, certified{}, 4.0, grid{}, plain));
    for (std::uint8_t times = 0; times <= 6; ++times) {
        const std::uint8_t halvings[] = {0, 0, times, times};
        REQUIRE(discretise(o, certified{}, 4.0, grid{}, finer, halvings));
        contours same;
        REQUIRE(discretise(o, certified{}, 4.0 / (1 << times), grid{}, same));
        CHECK(finer.starts[1] == plain.starts[1]);
        CHECK(finer.points.size() - finer.starts[1] == same.points.size() - same.starts[1]);
    }
}

TEST_CASE("only a contour that would be flat and has an area is drawn finer", "[discretise]")
{
    const curve up = curve::from(quadratic{{0, 0}, {5, 4}, {10, 0}});
    const curve down = curve::from(quadratic{{10, 0}, {5, -4}, {0, 0}});
    const curve back = curve::from(quadratic{{10, 0}, {5, 4}, {0, 0}});
    const curve wide = curve::from(quadratic{{50, 0}, {80, 60}, {110, 0}}), base = curve::from({110, 0}, {50, 0});
    contours out, single;
    REQUIRE(discretise(outline_of({{wide, base}}), certified{}, 8.0, grid{}, single));
    REQUIRE(single.points.size() >= 3);
    REQUIRE(discretise(outline_of({{up, down}, {wide, base}}), certified{}, 8.0, grid{}, out));
    REQUIRE(out.contour_count() == 2);
    CHECK(out.starts[1] >= 3);
    CHECK(out.points.size() - out.starts[1] == single.points.size());
    REQUIRE(discretise(outline_of({{up, back}}), certified{}, 8.0, grid{}, out));
    CHECK(out.contour_count() == 0);  // there and back
}

TEST_CASE("a tolerance that is not positive and finite is refused", "[discretise]")
{
    const double bad = GENERATE(0.0, -0.0, -1.0, std::numeric_limits<double>::infinity(),
                                -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
    const outline o = outline_of({polygon({{0, 0}, {10, 0}, {10, 10}})});
    contours out;
    REQUIRE(discretise(o, certified{}, 1.0, grid{}, out));
    CHECK(discretise(o, certified{}, bad, grid{}, out).error().code == error::bad_tolerance);
    CHECK(out.points.empty());
    CHECK(out.contour_count() == 0);
}

TEST_CASE("edges of real fonts' curves stay within the tolerance on the grid", "[discretise]")
{
    const std::uint32_t degree = GENERATE(2u, 3u);
    const double em_share = GENERATE(1.0 / 100, 1.0 / 800, 1.0 / 16000);
    for (const font_curve& f : font_curves(degree)) {
        const outline o = outline_of({{f.c, curve::from(f.c.end(), f.c.start())}});
        const auto g = grid::fitting(f.units_per_em, o.bounds);
        REQUIRE(g);
        contours out;
        const double tolerance = em_share * f.units_per_em;
        REQUIRE(discretise(o, certified{}, tolerance, *g, out));
        INFO(f.c);
        REQUIRE(broken_law(out) == "");
        for (std::size_t i = 0; i < out.edges.size(); ++i) {
            const contour_edge e = out.edges[i];
            if (e.curve != 0) continue;
            const point a = g->place(out.points[i]), b = g->place(out.points[(i + 1) % out.points.size()]);
            for (int k = 0; k <= 32; ++k) {
                const double t =
                    static_cast<double>(e.t0) + (static_cast<double>(e.t1) - static_cast<double>(e.t0)) * k / 32.0;
                REQUIRE(distance_to_segment(f.c.at(t), a, b) <= tolerance + 1e-3 * g->snap_error());  // t is a float
            }
        }
    }
}

TEST_CASE("random and degenerate contours keep their promises", "[discretise]")
{
    std::mt19937 dice{5};
    for (int i = 0; i < 2000; ++i) {
        std::vector<curve> contour;
        for (int k = 0; k < 4; ++k) {
            curve c = random_curve(dice, 1u + static_cast<std::uint32_t>(dice() % 3u));
            if (dice() % 4u == 0)
                for (point& p : c.p) p = 0.002 * p;
            if (!contour.empty()) {
                const point move = contour.back().end() - c.p[0];
                for (std::uint32_t j = 0; j <= c.degree; ++j) c.p[j] = c.p[j] + move;
                c.p[0] = contour.back().end();
            }
            contour.push_back(c);
        }
        contour.push_back(curve::from(contour.back().end(), contour.front().start()));
        const outline o = outline_of({contour});
        contours out;
        REQUIRE(discretise(o, certified{}, 1.0, grid{(i & 1) != 0 ? 1.0 : 64.0}, out));
        for (const curve& c : contour) UNSCOPED_INFO(c);
        REQUIRE(broken_law(out) == "");
    }
}

TEST_CASE("a failed request leaves empty contours that can be used again", "[discretise]")
{
    std::vector<curve> circle;
    for (int i = 0; i < 40; ++i) {
        const double x = 1000.0 * i;
        circle.push_back(curve::from(quadratic{{x, 0}, {x + 500, 2000}, {x + 1000, 0}}));
    }
    circle.push_back(curve::from(circle.back().end(), {0, -5000}));
    circle.push_back(curve::from({0, -5000}, {0, 0}));
    const outline o = outline_of({circle, polygon({{0, -1000}, {100, -1000}, {0, -2000}})});

    std::size_t requests = 0;
    for (std::size_t n = 1;; ++n) {
        counting_memory counted{.fail_at = n};
        contours out{counted.source()};
        const error e = discretise(o, certified{}, 0.01, grid{64.0}, out).error();
        if (!e) {
            requests = n - 1;
            break;
        }
        INFO("request " << n);
        REQUIRE(e.code == error::out_of_memory);
        REQUIRE(out.points.empty());
        REQUIRE(out.edges.empty());
        REQUIRE(out.contour_count() == 0);
        counted.fail_at = 0;
        REQUIRE(discretise(o, certified{}, 0.01, grid{64.0}, out));
        REQUIRE(broken_law(out) == "");
    }
    CHECK(requests > 4);  // it did grow on the way
}

TEST_CASE("contours get at most max_points points", "[discretise]")
{
    const outline o =
        outline_of({{curve::from(quadratic{{0, 0}, {500, 1000}, {1000, 0}}), curve::from({1000, 0}, {0, 0})},
                    {curve::from(cubic{{0, -9}, {0, -900}, {900, -900}, {900, -9}}), curve::from({900, -9}, {0, -9})}});
    contours all;
    REQUIRE(discretise(o, certified{}, 0.01, grid{}, all));
    const auto points = static_cast<std::uint32_t>(all.points.size());
    REQUIRE(points > 20);
    counting_memory counted;
    contours out{counted.source()};
    for (std::uint32_t most = 0; most <= points + 2; ++most) {
        INFO(most << " of " << points << " points allowed");
        out.max_points = most;
        const error e = discretise(o, certified{}, 0.01, grid{}, out).error();
        REQUIRE(bool(e) == (most < points));
        if (e) REQUIRE((e == error::too_many_points && e.count == most && out.points.empty() && out.edges.empty()));
        if (!e) REQUIRE(broken_law(out) == "");
    }
    // Only what is allowed counts, not what a curve could need.
    counting_memory little;
    contours few{little.source()};
    few.max_points = 4;
    REQUIRE(discretise(o, certified{}, 1e-9, grid{0x1p16}, few) == error::too_many_points);
    CHECK(little.peak < 1024);
}

TEST_CASE("discretise() allocates nothing once its contours have grown", "[discretise]")
{
    counting_memory counted;
    const outline o = outline_of(
        {{curve::from(cubic{{0, 0}, {1000, 2000}, {2000, 2000}, {3000, 0}}), curve::from({3000, 0}, {0, 0})}});
    contours out{counted.source()};
    REQUIRE(discretise(o, certified{}, 0.01, grid{64.0}, out));
    const std::size_t before = counted.requests;
    REQUIRE(discretise(o, certified{}, 0.01, grid{64.0}, out));
    REQUIRE(discretise(o, certified{}, 1.0, grid{64.0}, out));
    CHECK(counted.requests == before);
}
