// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/right_triangles.hpp>

#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::is_right_or_less;
using detail::radical_weights;
using detail::refinable_mesh;
using detail::right_triangles;

TEST_CASE("a right angle may be larger by what a cell and a half explain, and no more", "[refine]")
{
    CHECK(is_right_or_less(1000, 0, 0, 1000));
    CHECK(is_right_or_less(1000, 0, -3, 1000));
    CHECK_FALSE(is_right_or_less(1000, 0, -4, 1000));
    CHECK(is_right_or_less(-4, 1000, 1000, 0) == is_right_or_less(1000, 0, -4, 1000));
    CHECK(is_right_or_less(3, 0, -3, 1));
}

TEST_CASE("a divided triangle is six right ones, and its boundary moves inwards by less than a cell", "[refine]")
{
    const test::filled_shape shape{test::shape{"obtuse", {{{1, 2}, {90'000, 777}, {30'000, 20'000}}}}};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
    refinable_mesh mesh;
    radical_weights weights;
    REQUIRE(mesh.open(shape.filled, given.view()));
    REQUIRE(weights.open(mesh));
    REQUIRE(weights.settle(1000, 1.0));
    right_triangles parts;
    REQUIRE(parts.divide(mesh, weights, detail::boundary_cutter{}));
    CHECK(parts.count(mesh).points == 7);
    CHECK(parts.count(mesh).obtuse == 0);
    test::refined_result out;
    REQUIRE_FALSE(parts.write(mesh, shape.filled, out.out()));
    CHECK(test::broken_refinement(shape.filled, out) == "");
    CHECK(out.triangles.size() == 6);
    CHECK(out.inner.size() == 1);
    REQUIRE(out.loops.points.size() == 6);
    for (std::size_t i = 0; i < 6; i += 2) {
        const grid_point p = out.loops.points[i], f = out.loops.points[i + 1], q = out.loops.points[(i + 2) % 6];
        const std::int64_t off = orientation(p, q, f);
        CHECK(off >= 0);
        CHECK(double(off) < std::sqrt(2.0 * double(squared_distance(p, q))));
        const contour_edge before = out.loops.edges[i], after = out.loops.edges[i + 1];
        CHECK(before.t1 == after.t0);
        const double share = std::sqrt(double(squared_distance(p, f)) / double(squared_distance(p, q)));
        CHECK(double(before.t1) ==
              Catch::Approx(double(before.t0) + share * (double(after.t1) - double(before.t0))).margin(1e-3));
        CHECK(before.t0 == shape.filled.edges()[i / 2].t0);
        CHECK(after.t1 == shape.filled.edges()[i / 2].t1);
    }
}

TEST_CASE("triangles of a few cells remain whole, and those beside them valid", "[refine]")
{
    for (const std::int32_t width : {1, 2, 3, 4, 6, 10}) {
        CAPTURE(width);
        const test::filled_shape shape{
            test::shape{"sliver", {{{0, 0}, {9000, 0}, {9000 + width, width}, {4000, 8000}, {2000, width}}}}};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        refinable_mesh mesh;
        radical_weights weights;
        REQUIRE(mesh.open(shape.filled, given.view()));
        REQUIRE(weights.open(mesh));
        (void)weights.settle(100, 0.3);
        right_triangles parts;
        REQUIRE(parts.divide(mesh, weights, detail::boundary_cutter{}));
        test::refined_result out;
        REQUIRE_FALSE(parts.write(mesh, shape.filled, out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        const test::wide_corners wide = test::wide_corners_of(out);
        CHECK(parts.count(mesh).obtuse == wide.above);
        CHECK(parts.count(mesh).points == out.points().size());
    }
}

TEST_CASE("where the nearest cell would turn a triangle, a centre lies in another cell around its place", "[refine]")
{
    // The nearest cell to the centre of the triangle on the left lies on the line between two feet.
    const test::filled_shape shape{test::shape{"few cells", {{{0, 0}, {8, 5}, {-6, 12}, {-11, 2}}}}};
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
    refinable_mesh mesh;
    radical_weights weights;
    REQUIRE(mesh.open(shape.filled, given.view()));
    REQUIRE(weights.open(mesh));
    right_triangles parts;
    REQUIRE(parts.divide(mesh, weights, detail::boundary_cutter{}));
    CHECK(parts.count(mesh).points == 4 + 5 + 2);
    CHECK(parts.count(mesh).obtuse == 0);
    test::refined_result out;
    REQUIRE_FALSE(parts.write(mesh, shape.filled, out.out()));
    CHECK(test::broken_refinement(shape.filled, out) == "");
    CHECK(test::wide_corners_of(out).above == 0);
}
