// SPDX-License-Identifier: MIT

#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/refine/quadtree_refined.hpp>

#include <limits>
#include <string>

#include "support/refined_shape.hpp"

using namespace typemesh;

namespace {

/// A disc of four quadratic curves around the origin, flattened to `pieces` edges a curve; its em has 1024 units of 512
/// cells.
struct flattened_disc {
    std::vector<curve> curves;
    contours loops;
    region filled;

    explicit flattened_disc(int pieces, double radius = 400.0)
    {
        loops.grid = {512.0, 1024.0};
        REQUIRE(loops.starts.push_back(0));
        const point corner[] = {{radius, 0.0}, {0.0, radius}, {-radius, 0.0}, {0.0, -radius}};
        for (std::uint32_t k = 0; k < 4; ++k) {
            const point from = corner[k], to = corner[(k + 1) % 4];
            curves.push_back(curve::from(quadratic{from, from + to, to}));
            for (int i = 0; i < pieces; ++i) {
                const double t0 = double(i) / pieces, t1 = double(i + 1) / pieces;
                REQUIRE(loops.points.push_back(loops.grid.snap(curves.back().at(t0))));
                REQUIRE(loops.edges.push_back({k, float(t0), float(t1)}));
            }
        }
        REQUIRE(loops.starts.push_back(std::uint32_t(loops.points.size())));
        loops.curves = curves;
        filled = region::proven(loops, 0, 1);
    }
};

template <class Refiner>
error refine_with(const Refiner& how, const region& r, test::refined_result& out)
{
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(r, space, given));
    typename Refiner::scratch scratch;
    return how(r, given.view(), scratch, out.out());
}

}  // namespace

TEST_CASE("cuts of a curve lie on the curve and on lines of the squares", "[refine]")
{
    for (const int pieces : {1, 2, 3, 5}) {
        CAPTURE(pieces);
        const flattened_disc d{pieces};
        test::refined_result out;
        REQUIRE_FALSE(refine_with(quadtree_refined{0.05f}, d.filled, out));
        CHECK(test::broken_refinement(d.filled, out) == "");
        CHECK(out.kept == 0);
        const auto width = std::int32_t(0.6 * 0.05f * 512.0 * 1024.0) / 64 * 64;
        double farthest = 0.0;
        std::size_t on_lines = 0;
        for (std::size_t i = 0; i < out.loops.points.size(); ++i) {
            const contour_edge e = out.loops.edges[i];
            const point on = d.loops.grid.cells * d.curves[e.curve].at(double(e.t0));
            const grid_point p = out.loops.points[i];
            farthest = (std::max)(farthest, std::hypot(on.x - p.x, on.y - p.y));
            on_lines += p.x % (width / 2) == 0 || p.y % (width / 2) == 0;
        }
        CHECK(farthest < 0.9);  // half a cell's diagonal, a float's t, and the line, which may lie between two cells
        CHECK(on_lines > 60);
        CHECK(on_lines > out.loops.points.size() / 2);
    }
}

TEST_CASE("squares are as wide on every glyph, and no edge is longer than the longest", "[refine]")
{
    for (const float longest : {0.2f, 0.1f, 0.03f}) {
        const double em = 512.0 * 1024.0;
        std::int32_t width = std::int32_t(0.6 * double(longest) * em);
        width -= width % 64;
        for (const double radius : {300.0, 333.3, 400.0}) {
            CAPTURE(longest, radius);
            const flattened_disc d{4, radius};
            test::refined_result out;
            REQUIRE_FALSE(refine_with(quadtree_refined{longest}, d.filled, out));
            const std::vector<grid_point> p = out.points();
            double found = 0.0;
            for (const auto& [edge, apex] : test::edges_of(out))
                found = (std::max)(found, std::sqrt(double(squared_distance(p[edge.first], p[edge.second]))));
            CHECK(found / em <= double(longest));
            CHECK(found / em > 0.5 * double(longest));
            // Every point of the lattice that is a square's width away from the outline is there.
            std::size_t wanted = 0, there = 0;
            for (const grid_point q : out.inner) there += q.x % width == 0 && q.y % width == 0;
            for (std::int32_t x = -40 * width; x <= 40 * width; x += width)
                for (std::int32_t y = -40 * width; y <= 40 * width; y += width)
                    wanted += std::hypot(x, y) < 512.0 * radius - width;
            CHECK(there >= wanted);
            CHECK(wanted > 4);
        }
    }
}

TEST_CASE("squares need up to half as many triangles again as Delaunay refinement", "[refine]")
{
    for (const float longest : {0.2f, 0.1f, 0.05f, 0.02f}) {
        CAPTURE(longest);
        const flattened_disc d{8};
        test::refined_result squares, others;
        REQUIRE_FALSE(refine_with(quadtree_refined{longest}, d.filled, squares));
        REQUIRE_FALSE(refine_with(delaunay_refined{.max_edge = longest}, d.filled, others));
        CHECK(2 * squares.triangles.size() < 3 * others.triangles.size());
        CHECK(2 * squares.triangles.size() > others.triangles.size());
    }
}

TEST_CASE("a quadtree's options that are out of range are refused by name", "[refine]")
{
    const flattened_disc d{2};
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    struct refused {
        quadtree_refined how;
        const char* option;
    };
    for (const refused& r :
         {refused{{.max_edge = 0.0f}, "max_edge"}, refused{{.max_edge = -0.1f}, "max_edge"},
          refused{{.max_edge = infinite}, "max_edge"}, refused{{.max_edge = nan}, "max_edge"},
          refused{{.max_edge = 1e-5f}, "max_edge"}, refused{{.max_points = 1u << 29}, "max_points"}}) {
        test::refined_result out;
        const error e = refine_with(r.how, d.filled, out);
        CAPTURE(r.option);
        CHECK(e == error::bad_option);
        CHECK(std::string(e.option) == r.option);
    }
    CHECK(quadtree_refined{.max_edge = 0.0f}.refused_options() == error::bad_option);
    CHECK_FALSE(
        quadtree_refined{.max_edge = 1e-5f}.refused_options());  // fits no glyph of this em, but of a larger one
    test::refined_result out;
    CHECK(refine_with(quadtree_refined{.max_edge = 0.01f, .max_points = 100}, d.filled, out) == error::too_many_points);
    CHECK_FALSE(quadtree_refined{}.cache_key() == quadtree_refined{.max_edge = 0.06f}.cache_key());
    CHECK_FALSE(quadtree_refined{}.cache_key() == quadtree_refined{.max_points = 7}.cache_key());
    // A greatest length beyond the grid is no limit: only the shape decides.
    for (const float longest : {1000.0f, 3e38f}) {
        REQUIRE_FALSE(refine_with(quadtree_refined{longest}, d.filled, out));
        CHECK(test::broken_refinement(d.filled, out) == "");
        CHECK(out.triangles.size() < 200);
    }
    contours loops;
    REQUIRE((loops.points.append(d.filled.points()) && loops.edges.append(d.filled.edges()) &&
             loops.starts.append(d.filled.starts())));
    loops.grid.units_per_em = 0.0;
    CHECK(std::string(refine_with(quadtree_refined{}, region::proven(loops, 0, 1), out).option) == "units_per_em");
}
