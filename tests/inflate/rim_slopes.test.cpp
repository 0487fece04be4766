// SPDX-License-Identifier: MIT

#include <typemesh/inflate/impl/rim_slopes.hpp>
#include <typemesh/refine/delaunay_refined.hpp>

#include "inflated_shape.hpp"

using namespace typemesh;
using inflating::at;

namespace {

/// A square with sides of half an em, refined and solved, and the slopes at its boundary.
struct sloping_square {
    test::filled_shape filled{
        {"", {{at(0, 0), at(0.5, 0), at(0.5, 0.5), at(0, 0.5)}}}, fill_rule::non_zero, {512.0, 1000.0}};
    detail::delaunay_refinement refinement;
    test::refined_result cap;
    detail::rim_slopes slopes;

    explicit sloping_square(float max_edge)
    {
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(filled.filled, space, given));
        REQUIRE_FALSE(delaunay_refined{.max_edge = max_edge}(filled.filled, given.view(), refinement, cap.out()));
        detail::membrane_system system;
        REQUIRE(system.solve({cap.loops.points.view(), cap.inner.view(), cap.triangles.view()}));
        REQUIRE(slopes.measure(system, mesh(), filled.filled.starts(), cap.loops.points.size()));
    }
    [[nodiscard]] const detail::refinable_mesh& mesh() const { return refinement.mesh(); }
};

}  // namespace

TEST_CASE("the slope in the middle of a square's side is the series', and small at its corners", "[inflate]")
{
    const sloping_square square{0.05f};
    double middle = 0.0;
    for (std::uint32_t v = 0; v < square.mesh().vertex_count(); ++v) {
        if (square.mesh().at(v).boundary == detail::refinable_mesh::none) continue;
        const double slope = square.slopes.data()[v];
        CHECK(slope > 0.0);
        middle = (std::max)(middle, slope);
        if (v < 4) CHECK(slope < 0.05 * inflating::em);
    }
    CHECK(middle == Catch::Approx(0.3375 * 0.5 * inflating::em).epsilon(0.03));  // of the torsion of a square
}

TEST_CASE("edges are halved until none is longer than the slopes ask for, and new points have slopes", "[inflate]")
{
    sloping_square square{0.2f};
    const double least = 0.002 * inflating::em;
    const std::uint32_t before = square.mesh().vertex_count();
    REQUIRE_FALSE(square.slopes.shorten(square.refinement, square.filled.filled.starts(), least));
    const detail::refinable_mesh& mesh = square.mesh();
    CHECK(mesh.vertex_count() > before + 4);
    std::size_t too_long = 0, without = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.at(v).boundary == detail::refinable_mesh::none) continue;
        const std::uint32_t next = mesh.next_on_boundary(v);
        const double slope = (std::max)(square.slopes.data()[v], square.slopes.data()[next]),
                     length = std::sqrt(double(squared_distance(mesh.place(v), mesh.place(next))));
        too_long += length > slope && length > 2.0 * least;
        without += !(square.slopes.data()[v] > 0.0);
    }
    CHECK(too_long == 0);
    CHECK(without == 0);
}

TEST_CASE("the slopes of a straight stroke are half its width on coarse triangles as well", "[inflate]")
{
    for (const double width : {0.04, 0.05, 0.1}) {
        CAPTURE(width);
        const double half = 0.5 * width;
        const test::filled_shape stroke{{"", {{at(-0.6, -half), at(0.6, -half), at(0.6, half), at(-0.6, half)}}},
                                        fill_rule::non_zero,
                                        {512.0, 1000.0}};
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(stroke.filled, space, given));
        detail::delaunay_refinement refinement;
        auto limits = detail::refinement_limits::from(25.0, 0.03 * inflating::em, 10'000);
        limits.boundary_only = true;
        REQUIRE_FALSE(refinement.run(stroke.filled, given.view(), limits));
        test::refined_result cap;
        REQUIRE_FALSE(refinement.write(cap.out()));
        detail::membrane_system system;
        REQUIRE(system.solve({cap.loops.points.view(), cap.inner.view(), cap.triangles.view()}));
        detail::rim_slopes slopes;
        REQUIRE(slopes.measure(system, refinement.mesh(), stroke.filled.starts(), cap.loops.points.size()));
        double most = 0.0, least = 1e300;
        std::uint32_t v = 0;
        do {
            if (std::abs(refinement.mesh().place(v).x) < 0.4 * inflating::em) {
                most = (std::max)(most, slopes.data()[v]);
                least = (std::min)(least, slopes.data()[v]);
            }
            v = refinement.mesh().next_on_boundary(v);
        } while (v != 0);
        CHECK(most < 1.25 * half * inflating::em);  // where the triangles change: 1.63 and 0.73 without means
        CHECK(least > 0.80 * half * inflating::em);
    }
}
