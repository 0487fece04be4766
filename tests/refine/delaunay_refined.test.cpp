// SPDX-License-Identifier: MIT

#include <typemesh/refine/delaunay_refined.hpp>

#include <array>
#include <limits>
#include <optional>

#include "support/refined_shape.hpp"

using namespace typemesh;
using Catch::Approx;

namespace {

/// A disc of four quadratic curves, flattened to `pieces` edges a curve; its em has 1024 units of 512 cells.
struct disc {
    std::vector<curve> curves;
    contours loops;
    region filled;

    explicit disc(int pieces, bool clockwise_hole = false)
    {
        loops.grid = {512.0, 1024.0};
        loops.tolerance = 512.0 * 1024.0 / 5.0;  // even for one edge a curve
        add(400.0, pieces, false);
        if (clockwise_hole) add(200.0, pieces, true);
        loops.curves = curves;
        filled = region::proven(loops, clockwise_hole ? 1 : 0, 1);
    }

private:
    void add(double radius, int pieces, bool backwards)
    {
        const std::uint32_t first = std::uint32_t(loops.points.size());
        if (first == 0) REQUIRE(loops.starts.push_back(0));
        const point corner[] = {{radius, 0.0}, {0.0, radius}, {-radius, 0.0}, {0.0, -radius}};
        for (int k = 0; k < 4; ++k) {
            const point from = corner[backwards ? (4 - k) % 4 : k], to = corner[backwards ? 3 - k : (k + 1) % 4];
            curves.push_back(curve::from(quadratic{from, from + to, to}));
            for (int i = 0; i < pieces; ++i) {
                const double t0 = double(i) / pieces, t1 = double(i + 1) / pieces;
                REQUIRE(loops.points.push_back(loops.grid.snap(curves.back().at(t0))));
                REQUIRE(loops.edges.push_back({std::uint32_t(curves.size() - 1), float(t0), float(t1)}));
            }
        }
        REQUIRE(loops.starts.push_back(std::uint32_t(loops.points.size())));
    }
};

error refine(const delaunay_refined& how, const region& r, test::refined_result& out)
{
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(r, space, given));
    delaunay_refined::scratch scratch;
    return how(r, given.view(), scratch, out.out());
}

}  // namespace

TEST_CASE("points that are added to a curve's edges lie on the curve, inside and outside the old outline", "[refine]")
{
    for (const bool hole : {false, true}) {
        for (const int pieces : {2, 3, 5}) {  // with one edge a curve, points inside stand between chord and curve
            CAPTURE(hole, pieces);
            const disc d{pieces, hole};
            test::refined_result out;
            REQUIRE_FALSE(refine({.min_angle = 20.0f, .max_edge = 0.05f}, d.filled, out));
            CHECK(test::broken_refinement(d.filled, out) == "");
            CHECK(out.loops.points.size() > d.filled.points().size() + 20);
            double farthest = 0.0;
            for (std::size_t i = 0; i < out.loops.points.size(); ++i) {
                const contour_edge e = out.loops.edges[i];
                const point on = d.loops.grid.cells * d.curves[e.curve].at(double(e.t0));
                const grid_point p = out.loops.points[i];
                farthest = (std::max)(farthest, std::hypot(on.x - p.x, on.y - p.y));
            }
            CHECK(farthest < 0.72);  // half a cell's diagonal, and a float's t
        }
    }
}

/// A triangle with some of its edges curved.
struct curved_triangle {
    std::vector<curve> curves;
    contours loops;
    region filled;

    /// A control point for each edge, in cells; the middle of a straight edge for a straight one.
    curved_triangle(const std::array<grid_point, 3>& corner, const std::array<std::optional<point>, 3>& control)
    {
        loops.grid = {512.0, 1024.0};
        REQUIRE(loops.starts.push_back(0));
        for (std::uint32_t k = 0; k < 3; ++k) {
            const point from = loops.grid.place(corner[k]), to = loops.grid.place(corner[(k + 1) % 3]);
            curves.push_back(control[k] ? curve::from(quadratic{from, (1.0 / 512.0) * *control[k], to})
                                        : curve::from(from, to));
            REQUIRE(loops.points.push_back(corner[k]));
            REQUIRE(loops.edges.push_back({k, 0.0f, 1.0f}));
        }
        REQUIRE(loops.starts.push_back(3));
        loops.curves = curves;
        filled = region::proven(loops, 0, 1);
    }
};

TEST_CASE("a curve that bulges beyond the circle of its edge's triangle leaves a Delaunay mesh", "[refine]")
{
    const curved_triangle t{{{{152640, 60033}, {-91905, -50580}, {-45935, -92414}}},
                            {point{-65047.961, 155062.816}, {}, {}}};
    test::refined_result out;
    REQUIRE_FALSE(refine({.min_angle = 12.5f, .max_edge = 0.26f}, t.filled, out));
    CHECK(test::broken_refinement(t.filled, out) == "");
    CHECK(test::is_delaunay(out));
}

TEST_CASE("between two curves that meet at 5 degrees, no angle is smaller than theirs", "[refine]")
{
    const curved_triangle t{{{{119076, 118418}, {-172663, -19400}, {-34780, -62942}}},
                            {point{40821.474, -75817.519}, point{-101666.786, -95777.777}, {}}};
    test::refined_result out;
    REQUIRE_FALSE(refine({.min_angle = 12.5f}, t.filled, out));
    CHECK(test::broken_refinement(t.filled, out) == "");
    CHECK(test::corners_below(out, 5.0) == 0);  // at 5.2 degrees the curves meet in a corner
    CHECK(out.kept == 0);
    CHECK(out.triangles.size() < 3000);
}

TEST_CASE("edges that have moved away from their curves are refined where they are", "[refine]")
{
    // Bold letters: their edges keep the names of the curves, for normals, but lie elsewhere.
    for (const double moved : {0.9, 0.99, 1.1}) {
        disc d{6};
        for (grid_point& p : d.loops.points)
            p = {std::int32_t(std::lround(moved * p.x)), std::int32_t(std::lround(moved * p.y))};
        d.filled = region::proven(d.loops, 0, 1);
        const auto area = [](const contours& loops) {
            return double(inspect::doubled_area(inspect::loops_of(region::proven(loops, 0, 1))[0]));
        };
        test::refined_result out;
        REQUIRE_FALSE(refine({.max_edge = 0.02f}, d.filled, out));
        CHECK(test::broken_refinement(d.filled, out) == "");
        CHECK(area(out.loops) == Approx(area(d.loops)).epsilon(1e-4));
    }
}

TEST_CASE("where a curve's point lies beyond another edge, the new point lies on the chord", "[refine]")
{
    // The lower edge stands for a curve that dips by 50 units. The wall of a slot is 20 units below the edge.
    //
    //      +-----------------+
    //      |                 |
    //      a---.         .---b      the edge from a to b; dots: its curve
    //      +----- . . . -----+
    //      |                 |      the region is a C, open on the left between a and the wall below
    disc d{1};
    const point a{0, 0}, b{400, 0};
    d.curves = {curve::from(quadratic{a, {200, -100}, b})};
    d.loops.clear();
    d.loops.tolerance = 512.0 * 60.0;
    REQUIRE(d.loops.starts.push_back(0));
    const point corners[] = {a, b, {400, -20}, {0, -20}, {0, -200}, {500, -200}, {500, 300}, {0, 300}};
    for (const point p : corners) {
        REQUIRE(d.loops.points.push_back(d.loops.grid.snap(p)));
        REQUIRE(d.loops.edges.push_back({d.loops.edges.empty() ? 0u : 1u, 0.0f, 1.0f}));
    }
    REQUIRE(d.loops.starts.push_back(8));
    d.loops.curves = d.curves;
    d.filled = region::proven(d.loops, 0, 1);
    test::refined_result out;
    REQUIRE_FALSE(refine({.max_edge = 0.02f}, d.filled, out));
    CHECK(test::broken_refinement(d.filled, out) == "");
    std::size_t on_chord = 0, below = 0;
    for (std::size_t i = 1; i < out.loops.points.size() && out.loops.edges[i].curve == 0; ++i) {
        const grid_point p = out.loops.points[i];
        on_chord += p.y == 0;
        below += p.y < 0 && p.x > 0 && p.x < 400 * 512;
    }
    CHECK(on_chord >= 1);
    CHECK(below >= 1);  // near the ends of the curve there is room
}

TEST_CASE("the refined outline of a disc approaches the disc's curves", "[refine]")
{
    double before = 1e300;
    for (const float longest : {0.3f, 0.1f, 0.03f, 0.01f}) {
        const disc d{1};
        test::refined_result out;
        REQUIRE_FALSE(refine({.max_edge = longest}, d.filled, out));
        double farthest = 0.0;  // of the middles of edges from their curves
        for (std::size_t i = 0; i < out.loops.points.size(); ++i) {
            const contour_edge e = out.loops.edges[i];
            const grid_point p = out.loops.points[i], q = out.loops.points[i + 1 < out.loops.points.size() ? i + 1 : 0];
            const point on = d.loops.grid.cells * d.curves[e.curve].at(0.5 * (double(e.t0) + double(e.t1)));
            farthest =
                (std::max)(farthest, std::hypot(on.x - 0.5 * (double(p.x) + q.x), on.y - 0.5 * (double(p.y) + q.y)));
        }
        CHECK(farthest < 0.5 * before);
        before = farthest;
    }
}

TEST_CASE("the longest edge is in em, whatever the grid", "[refine]")
{
    const disc d{3};
    for (const float longest : {0.2f, 0.1f, 0.03f}) {
        test::refined_result out;
        REQUIRE_FALSE(refine({.max_edge = longest}, d.filled, out));
        const std::vector<grid_point> p = out.points();
        double found = 0.0;
        for (const auto& [edge, apex] : test::edges_of(out))
            found = (std::max)(found, std::sqrt(double(squared_distance(p[edge.first], p[edge.second]))));
        CHECK(found / (512.0 * 1024.0) <= double(longest));
        CHECK(found / (512.0 * 1024.0) > 0.5 * double(longest));
    }
}

TEST_CASE("options that are out of range are refused by name", "[refine]")
{
    const disc d{2};
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    struct row {
        delaunay_refined how;
        const char* option;
    };
    for (const row& r : {row{{.min_angle = -1.0f}, "min_angle"}, row{{.min_angle = 33.5f}, "min_angle"},
                         row{{.min_angle = nan}, "min_angle"}, row{{.max_edge = -0.1f}, "max_edge"},
                         row{{.max_edge = infinite}, "max_edge"}, row{{.max_edge = nan}, "max_edge"},
                         row{{.max_edge = 1e-5f}, "max_edge"}, row{{.max_points = 1u << 29}, "max_points"}}) {
        test::refined_result out;
        const error e = refine(r.how, d.filled, out);
        CAPTURE(r.option);
        CHECK(e == error::bad_option);
        CHECK(std::string(e.option) == r.option);
    }
    test::refined_result out;
    CHECK(refine({.max_edge = 0.01f, .max_points = 100}, d.filled, out) == error::too_many_points);
    CHECK_FALSE(delaunay_refined{}.cache_key() == delaunay_refined{.min_angle = 26.0f}.cache_key());
    CHECK_FALSE(delaunay_refined{}.cache_key() == delaunay_refined{.max_edge = 1.0f}.cache_key());
}

TEST_CASE("without an aim, refinement only makes the triangles Delaunay and empties the edges' circles", "[refine]")
{
    const test::filled_shape shape{test::shape{"square", {test::square(0, 0, 1 << 20)}}};
    test::refined_result out;
    REQUIRE_FALSE(refine({.min_angle = 0.0f}, shape.filled, out));
    CHECK(out.triangles.size() == 2);
    CHECK(out.inner.empty());
}
