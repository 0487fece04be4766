// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/edge_bisection.hpp>

#include <typemesh/refine/impl/delaunay_refinement.hpp>

#include <limits>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::edge_bisection;
using detail::refinable_mesh;

namespace {

/// Measures widths, heights or both: x / across and y / up, or the length of (x / across, y / up). 0: that direction
/// does not matter.
struct extent_measure {
    double per_x = 0.0;
    double per_y = 0.0;

    [[nodiscard]] double length(grid_point p, grid_point q) const noexcept
    {
        return std::hypot(per_x * (double(p.x) - q.x), per_y * (double(p.y) - q.y));
    }
    [[nodiscard]] detail::extents extents() const noexcept
    {
        if (per_x > 0.0 && per_y > 0.0) return detail::extents::both;
        return per_y > 0.0 ? detail::extents::heights : detail::extents::widths;
    }
    [[nodiscard]] double edge(grid_point p, grid_point q) const noexcept { return length(p, q); }
    [[nodiscard]] double triangle(grid_point p, grid_point q, grid_point r) const noexcept
    {
        return (std::max)({length(p, q), length(q, r), length(r, p)});
    }
};

/// The square of a box's extent, as an error of bending is.
struct box_measure : extent_measure {
    [[nodiscard]] double triangle(grid_point p, grid_point q, grid_point r) const noexcept
    {
        const double w = per_x * ((std::max)({p.x, q.x, r.x}) - (std::min)({p.x, q.x, r.x})),
                     h = per_y * ((std::max)({p.y, q.y, r.y}) - (std::min)({p.y, q.y, r.y}));
        return w * w + h * h;
    }
};

/// Why a triangle or an edge that is too large may stay: the middle of its longest edge would be within four cells of
/// another point, or only slivers of a cell lie beside it.
template <class Measure>
std::size_t needlessly_large(const test::refined_result& cap, const Measure& measure, std::size_t& kept)
{
    const std::vector<grid_point> all = cap.points();
    std::size_t needless = 0;
    const auto judge = [&](grid_point p, grid_point q) {
        ++kept;
        const grid_point middle{std::int32_t((std::int64_t{p.x} + q.x) >> 1),
                                std::int32_t((std::int64_t{p.y} + q.y) >> 1)};
        std::int64_t nearest = std::numeric_limits<std::int64_t>::max();
        for (const grid_point r : all) nearest = (std::min)(nearest, squared_distance(middle, r));
        needless += nearest > 36;  // four cells, and a cell of rounding in each direction
    };
    for (const triangle t : cap.triangles) {
        const grid_point corner[] = {all[t.a], all[t.b], all[t.c]};
        if (measure.triangle(corner[0], corner[1], corner[2]) <= 1.0) continue;
        int longest = 0;
        double greatest = -1.0;
        for (int k = 0; k < 3; ++k) {
            const double size = measure.length(corner[k], corner[(k + 1) % 3]);
            if (size > greatest) {
                greatest = size;
                longest = k;
            }
        }
        judge(corner[longest], corner[(longest + 1) % 3]);
    }
    for (std::size_t loop = 0; loop + 1 < cap.loops.starts.size(); ++loop)
        for (std::uint32_t i = cap.loops.starts[loop]; i < cap.loops.starts[loop + 1]; ++i) {
            const std::uint32_t next = i + 1 < cap.loops.starts[loop + 1] ? i + 1 : cap.loops.starts[loop];
            if (measure.edge(all[i], all[next]) > 1.0) judge(all[i], all[next]);
        }
    return needless;
}

box extent_of(const test::shape& s)
{
    box b;
    for (const test::polyline& l : s.loops)
        for (const grid_point p : l) b.add(point{double(p.x), double(p.y)});
    return b;
}

bool is_for_bisection(const test::shape& s)
{
    return inspect::is_region(test::loops_of(s)) && s.loops[0].size() <= 1000 && s.name != "comb of 700 teeth";
}

}  // namespace

TEST_CASE("bisection keeps every law for measures of width, height and both, in all positions of a shape", "[refine]")
{
    edge_bisection bisection;
    test::refined_result out;
    std::size_t needless = 0, kept = 0, triangles = 0;
    for (const test::shape& s : test::generated_regions()) {
        if (!is_for_bisection(s)) continue;
        for (const test::shape& position : test::in_positions(s, {0.0, 33.0})) {
            if (!inspect::is_region(test::loops_of(position))) continue;
            const test::filled_shape shape{position};
            workspace space;
            triangle_list given;
            REQUIRE_FALSE(monotone{}(shape.filled, space, given));
            const box around = extent_of(position);
            const double w = 1.0 / around.width(), h = 1.0 / around.height(), least = (std::min)(w, h);
            for (const extent_measure m : {extent_measure{9.0 * w, 0.0}, extent_measure{0.0, 14.0 * h},
                                           extent_measure{5.0 * least, 5.0 * least}, extent_measure{12.0 * w, h}}) {
                INFO(position.name << ", " << m.per_x / w << " by " << m.per_y / h);
                for (const bool of_box : {false, true}) {
                    CAPTURE(of_box);
                    const box_measure boxes{m};
                    if (of_box)
                        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), boxes, 100'000));
                    else
                        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 100'000));
                    REQUIRE_FALSE(bisection.write(out.out()));
                    CHECK(test::broken_refinement(shape.filled, out) == "");
                    CHECK(test::is_delaunay(out, m.extents()));
                    const std::size_t found =
                        of_box ? needlessly_large(out, boxes, kept) : needlessly_large(out, m, kept);
                    CHECK(found == 0);
                    needless += found;
                    triangles += out.triangles.size();
                }
            }
        }
    }
    CAPTURE(triangles, kept, needless);
    CHECK(triangles > 100'000);
    CHECK(kept * 50 < triangles);
}

TEST_CASE("random polygons are bisected lawfully, however narrow they are", "[refine]")
{
    edge_bisection bisection;
    test::refined_result out;
    test::dice d{61};
    std::size_t needless = 0, kept = 0, triangles = 0, too_near = 0;
    for (int round = 0; round < 300; ++round) {
        const int width = 5 + d.roll(60);
        test::shape s{"random polygon",
                      {test::random_polygon(6 + d.roll((std::min)(width * width / 4, 120)), width, d)}};
        const std::int32_t factor = 1 + d.roll(3) * d.roll(3000);
        for (grid_point& p : s.loops[0]) p = {factor * p.x, factor * p.y};
        if (!inspect::is_region(test::loops_of(s))) continue;
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(shape.filled, space, given));
        const double large = 1.0 / (double(factor) * width);
        const extent_measure m{d.roll(4) == 0 ? 0.0 : (1 + d.roll(20)) * large,
                               d.roll(4) == 0 ? 0.0 : (1 + d.roll(20)) * large};
        INFO(s << m.per_x << ' ' << m.per_y);
        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 100'000));
        REQUIRE_FALSE(bisection.write(out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        CHECK(test::is_delaunay(out, m.extents()));
        const std::size_t found = needlessly_large(out, m, kept);
        CHECK(found == 0);
        needless += found;
        triangles += out.triangles.size();
        const std::vector<grid_point> p = out.points();
        for (std::size_t i = out.loops.points.size(); i < p.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) too_near += squared_distance(p[i], p[k]) < 16;
    }
    CAPTURE(triangles, kept, needless, too_near);
    CHECK(triangles > 10'000);
    CHECK(too_near * 300 < triangles);  // only the corners of the triangle around a new point are asked
}

TEST_CASE("a measure of one direction needs fewer points than a mesh of short edges, and hardly any inside", "[refine]")
{
    struct blind : extent_measure {  // does not say on what it depends
        [[nodiscard]] static detail::extents extents() noexcept { return detail::extents::both; }
    };
    edge_bisection bisection;
    detail::delaunay_refinement refinement;
    test::refined_result out;
    std::size_t inner = 0, needed = 0, without = 0;
    for (const test::shape& s : {test::circle_with_holes(60, 3), test::shape{"circle", {test::circle(100, 1'000'000)}},
                                 test::shape{"star", {test::star(60, 1'000'000, 1)}}}) {
        INFO(s.name);
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        for (const double edge : {200'000.0, 60'000.0, 20'000.0}) {
            const auto longest = static_cast<std::int64_t>(edge);
            const detail::refinement_limits limits{0.36, 1.35, longest * longest, 1'000'000};  // 20 degrees
            REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits));
            const std::uint32_t even = refinement.mesh().vertex_count();
            CAPTURE(edge, even);
            for (const extent_measure m : {extent_measure{1.0 / edge, 0.0}, extent_measure{0.0, 1.0 / edge}}) {
                REQUIRE_FALSE(bisection.run(shape.filled, given.view(), blind{m}, 1'000'000));
                without += bisection.mesh().vertex_count();
                REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 1'000'000));
                REQUIRE_FALSE(bisection.write(out.out()));
                CHECK(5 * bisection.mesh().vertex_count() < 3 * even);
                needed += bisection.mesh().vertex_count();
                inner += out.inner.size();
            }
        }
    }
    CAPTURE(needed, inner, without);
    CHECK(20 * inner < needed);
    CHECK(2 * needed < without);
}

TEST_CASE("in a rectangle, a measure of widths adds columns of two points and none inside", "[refine]")
{
    const test::filled_shape shape{
        test::shape{"rectangle", {{{0, 0}, {1 << 20, 0}, {1 << 20, 1 << 21}, {0, 1 << 21}}}}};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
    edge_bisection bisection;
    test::refined_result out;
    for (const int columns : {1, 2, 4, 16, 64}) {
        const extent_measure m{double(columns) / (1 << 20), 0.0};
        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 100'000));
        REQUIRE_FALSE(bisection.write(out.out()));
        CHECK(out.inner.empty());
        CHECK(out.loops.points.size() == std::size_t(2 * (columns + 1)));
        CHECK(out.triangles.size() == std::size_t(2 * columns));
    }
    REQUIRE_FALSE(bisection.run(shape.filled, given.view(), extent_measure{}, 4));
    CHECK(bisection.mesh().vertex_count() == 4);  // nothing is too large, so nothing is added
}

TEST_CASE("bisection needs no more points than it is allowed, and says so", "[refine]")
{
    edge_bisection bisection;
    const test::filled_shape shape{test::circle_with_holes(60, 3)};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    const auto given_points = static_cast<std::uint32_t>(shape.filled.points().size());
    CHECK_FALSE(bisection.run(shape.filled, given.view(), extent_measure{}, given_points));
    CHECK(bisection.run(shape.filled, given.view(), extent_measure{}, given_points - 1).count == given_points - 1);
    for (const double edge : {3e5, 1e5, 3e4}) {
        const extent_measure m{1.0 / edge, 0.5 / edge};
        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 1'000'000));
        const std::uint32_t needed = bisection.mesh().vertex_count();
        CAPTURE(edge, needed);
        CHECK_FALSE(bisection.run(shape.filled, given.view(), m, needed));
        for (const std::uint32_t allowed : {needed - 1, needed - 2, given_points, 0u}) {
            CHECK(bisection.run(shape.filled, given.view(), m, allowed) == error::too_many_points);
            CHECK(bisection.mesh().vertex_count() <= (std::max)(allowed, given_points) + 1);
        }
    }
}

TEST_CASE("a measure that is never content, or no number, ends", "[refine]")
{
    struct never_content {
        double size = 0.0;
        [[nodiscard]] detail::extents extents() const noexcept { return detail::extents::both; }
        [[nodiscard]] double edge(grid_point, grid_point) const noexcept { return size; }
        [[nodiscard]] double length(grid_point, grid_point) const noexcept { return size; }
        [[nodiscard]] double triangle(grid_point, grid_point, grid_point) const noexcept { return size; }
    };
    edge_bisection bisection;
    test::refined_result out;
    for (const test::shape& s : {test::shape{"square", {test::square(0, 0, 100)}}, test::square_with_holes(1, 7, 200),
                                 test::shape{"star", {test::star(20, 150, 1)}}}) {
        INFO(s.name);
        if (!inspect::is_region(test::loops_of(s))) continue;
        const test::filled_shape shape{s};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(monotone{}(shape.filled, space, given));
        for (const double size : {2.0, HUGE_VAL, std::nan("")}) {
            CAPTURE(size);
            const error e = bisection.run(shape.filled, given.view(), never_content{size}, 100'000);
            REQUIRE_FALSE(e);
            REQUIRE_FALSE(bisection.write(out.out()));
            CHECK(test::broken_refinement(shape.filled, out) == "");
            CHECK(out.triangles.size() > 100);  // also what is no number is too large
        }
        CHECK(bisection.run(shape.filled, given.view(), never_content{std::nan("")}, 40) == error::too_many_points);
    }
}

TEST_CASE("points that bisection adds to a curve's edges lie on the curve", "[refine]")
{
    // A disc of four quadratic curves, each flattened to two edges.
    std::vector<curve> curves;
    contours loops;
    loops.grid = {512.0, 1024.0};
    loops.tolerance = 512.0 * 100.0;
    const point corner[] = {{400.0, 0.0}, {0.0, 400.0}, {-400.0, 0.0}, {0.0, -400.0}};
    REQUIRE(loops.starts.push_back(0));
    for (std::uint32_t k = 0; k < 4; ++k) {
        const point from = corner[k], to = corner[(k + 1) % 4];
        curves.push_back(curve::from(quadratic{from, from + to, to}));
        for (const float t : {0.0f, 0.5f}) {
            REQUIRE(loops.points.push_back(loops.grid.snap(curves[k].at(double(t)))));
            REQUIRE(loops.edges.push_back({k, t, t + 0.5f}));
        }
    }
    REQUIRE(loops.starts.push_back(8));
    loops.curves = curves;
    const region filled = region::proven(loops, 0, 1);
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(filled, space, given));
    edge_bisection bisection;
    test::refined_result out;
    for (const double edge : {1e5, 2e4, 5e3}) {
        REQUIRE_FALSE(bisection.run(filled, given.view(), extent_measure{1.0 / edge, 0.0}, 1'000'000));
        REQUIRE_FALSE(bisection.write(out.out()));
        CHECK(test::broken_refinement(filled, out) == "");
        CHECK(test::is_delaunay(out, detail::extents::widths));
        CHECK(double(out.loops.points.size()) > 800'000.0 / edge);
        double farthest = 0.0;
        for (std::size_t i = 0; i < out.loops.points.size(); ++i) {
            const contour_edge e = out.loops.edges[i];
            const point on = loops.grid.cells * curves[e.curve].at(double(e.t0));
            farthest = (std::max)(farthest, std::hypot(on.x - out.loops.points[i].x, on.y - out.loops.points[i].y));
        }
        CHECK(farthest < 0.72);
    }
}

TEST_CASE("bisection without memory says so, and asks for none once it is warm", "[refine]")
{
    const test::filled_shape shape{test::circle_with_holes(60, 3)};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    const extent_measure m{1.0 / 90'000.0, 0.0};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        edge_bisection bisection{memory.source()};
        test::refined_result out{memory.source()};
        error e = bisection.run(shape.filled, given.view(), m, 100'000);
        if (!e) e = bisection.write(out.out());
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
        memory.fail_at = 0;
        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 100'000));
        REQUIRE_FALSE(bisection.write(out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        const std::size_t warm = memory.requests;
        REQUIRE_FALSE(bisection.run(shape.filled, given.view(), m, 100'000));
        REQUIRE_FALSE(bisection.write(out.out()));
        CHECK(memory.requests == warm);
    }
}
