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

    sloping_square()
    {
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(filled.filled, space, given));
        REQUIRE_FALSE(delaunay_refined{.max_edge = 0.05f}(filled.filled, given.view(), refinement, cap.out()));
        detail::membrane_system system;
        REQUIRE(system.solve({cap.loops.points.view(), cap.inner.view(), cap.triangles.view()}));
        REQUIRE(slopes.measure(system, mesh(), filled.filled.starts(), cap.loops.points.size()));
    }
    [[nodiscard]] const detail::refinable_mesh& mesh() const { return refinement.mesh(); }
};

}  // namespace

TEST_CASE("the slope in the middle of a square's side is the series', and small at its corners", "[inflate]")
{
    const sloping_square square;
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
    sloping_square square;
    const double least = 0.002 * inflating::em;
    const std::uint32_t before = square.mesh().vertex_count();
    REQUIRE_FALSE(square.slopes.shorten(square.refinement, square.filled.filled.starts(), 0.25, least));
    const detail::refinable_mesh& mesh = square.mesh();
    CHECK(mesh.vertex_count() > before + 20);
    std::size_t too_long = 0, without = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.at(v).boundary == detail::refinable_mesh::none) continue;
        const std::uint32_t next = mesh.next_on_boundary(v);
        const double slope = (std::max)(square.slopes.data()[v], square.slopes.data()[next]),
                     length = std::sqrt(double(squared_distance(mesh.place(v), mesh.place(next))));
        too_long += length > 0.25 * slope && length > 2.0 * least;
        without += !(square.slopes.data()[v] > 0.0);
    }
    CHECK(too_long == 0);
    CHECK(without == 0);
}
