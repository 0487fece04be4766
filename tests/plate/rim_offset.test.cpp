// SPDX-License-Identifier: MIT
#include <typemesh/plate/impl/rim_offset.hpp>
#include <typemesh/plate/layer_arrangement.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "plate/rim_boxes.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <cstdint>

using namespace typemesh;
using detail::rim_offset;
using detail::rim_section;

namespace {

/// Twice the area of the strips between an outline and its offset.
std::int64_t doubled_strips(rim_offset& made)
{
    std::int64_t sum = 0;
    const auto at = made.strip_vertices();
    for (const bevel_triangle& t : made.strip_triangles())
        sum += orientation(at[t.corners.a].at, at[t.corners.b].at, at[t.corners.c].at);
    return sum;
}

}  // namespace

TEST_CASE("an outline, its offset and the strips between them have areas that add up in integers", "[rim_offset]")
{
    test::rim_boxes boxes;
    contours loops;
    rim_offset made;
    // A frame: its bevel moves both outlines, and the fillet around it moves them the other way.
    const auto ring = boxes.cells.trace(test::rim_boxes::plate & ~test::rim_boxes::pocket, boxes.space, loops);
    REQUIRE(ring);
    const std::int64_t whole = boxes.cells.doubled_area(test::rim_boxes::plate & ~test::rim_boxes::pocket);
    for (const rim_section section : {rim_section::chamfer, rim_section::round, rim_section::fillet}) {
        const auto reached = made.plan(*ring, section, 0.05f, 2.0, monotone{});
        REQUIRE(reached);
        CHECK(*reached == 0.05f);
        const std::int64_t strips = doubled_strips(made);
        CHECK(strips > 0);
        CHECK(made.doubled_area() == whole + (section == rim_section::fillet ? strips : -strips));
    }
    // Steiner's formula: A + P r + pi r^2 around the outer outline, A - P r within the pocket's, which is convex.
    const double around = 1000.0 * 1000.0 + 4000.0 * 50.0 + 3.14159265 * 50.0 * 50.0, within = 300.0 * 300.0;
    CHECK(0.5 * static_cast<double>(made.doubled_area()) == Catch::Approx(around - within).epsilon(5e-4));
}

TEST_CASE("an offset narrower than the grid allows has no strips", "[rim_offset]")
{
    test::rim_boxes boxes;
    contours loops;
    rim_offset made;
    const auto box = boxes.cells.trace(test::rim_boxes::plate, boxes.space, loops);
    REQUIRE(box);
    for (const rim_section section : {rim_section::chamfer, rim_section::fillet}) {
        const auto reached = made.plan(*box, section, 0.003f, 0.0, monotone{});  // three cells
        REQUIRE(reached);
        CHECK(*reached == 0.0f);
    }
}
