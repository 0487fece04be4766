// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/surroundings.hpp>

#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/fill.hpp>

#include <cmath>

#include "shapes.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

/// The points, from the first one that is given, lie on the curves of their edges.
void check_on_curves(const contours& loops, std::uint32_t first)
{
    for (std::uint32_t i = first; i < loops.points.size(); ++i) {
        const contour_edge& e = loops.edges[i];
        CHECK(length(loops.curves[e.curve].at(double(e.t0)) - loops.grid.place(loops.points[i])) < 0.01);
    }
}

}  // namespace

TEST_CASE("the surroundings are a frame with the region as its hole, and each edge runs along its curve in reverse",
          "[surroundings]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        contours around;
        REQUIRE_FALSE(surround(s.made(), 1000.0, around));
        REQUIRE(around.points.size() == s.points() + 4);
        REQUIRE(around.contour_count() == s.contour_count() + 1);
        const double frame =
            double(around.points[2].x - around.points[0].x) * (around.points[2].y - around.points[0].y);
        CHECK(shapes::area_of(around) == Catch::Approx(frame - shapes::area_of(s.loops)));
        check_on_curves(around, 4);

        workspace space;
        const auto filled = fill(around, fill_rule::non_zero, space);
        REQUIRE(filled);
        CHECK(filled->points().size() == s.points() + 4);
        const std::uint32_t first = frame_of(*filled);
        grid_point lowest = filled->points()[first];
        for (std::uint32_t i = 0; i < 4; ++i) lowest.y = (std::min)(lowest.y, filled->points()[first + i].y);
        for (const grid_point p : filled->points()) CHECK(p.y >= lowest.y);

        const double whole = shapes::area_of(around);
        leave_frame(around);
        CHECK(around.contour_count() == s.contour_count());
        CHECK(around.points.size() == s.points());
        CHECK(around.edges.size() == s.points());
        CHECK(shapes::area_of(around) == Catch::Approx(frame - whole));
        CHECK(shapes::area_of(around) == Catch::Approx(shapes::area_of(s.loops)));
        check_on_curves(around, 0);
    }
}

TEST_CASE("a loop that is turned twice is unchanged", "[surroundings]")
{
    for (const auto& s : shapes::all()) {
        contours loops;
        REQUIRE(append_loops(s.made(), loops));
        for (int times = 0; times < 2; ++times)
            for (std::uint32_t k = 0; k < loops.contour_count(); ++k) turn_loop(loops, k);
        for (std::uint32_t i = 0; i < s.points(); ++i) {
            CHECK(loops.points[i] == s.loops.points[i]);
            CHECK(loops.edges[i].curve == s.loops.edges[i].curve);
            CHECK(loops.edges[i].t1 == s.loops.edges[i].t1);  // NOLINT
        }
    }
}

TEST_CASE("corners move as far as their mitres or the limit, rounded up to whole distances", "[surroundings]")
{
    const auto with_tip = [](double half_width) {  // at the height of 100
        return shapes::shape{"tip", {shapes::polygon({{-half_width, 0}, {half_width, 0}, {0, 100}})}};
    };
    const double mitre = std::hypot(100.0, 10.0) / 10.0;  // 10.05
    CHECK(mitre == Catch::Approx(10.05).margin(0.01));
    CHECK(farthest_way(with_tip(10).made(), 7.0, 0.0) == 7.0 * 11.0);        // NOLINT
    CHECK(farthest_way(with_tip(10).made(), 7.0, 100.0) == 7.0 * 11.0);      // NOLINT
    CHECK(farthest_way(with_tip(10).made(), 7.0, 4.0) == 7.0 * 4.0);         // NOLINT
    CHECK(farthest_way(with_tip(10).made(), 7.0, 1.0) == 7.0 * 2.0);         // NOLINT
    CHECK(farthest_way(shapes::rectangle().made(), 7.0, 0.0) == 7.0 * 2.0);  // NOLINT
    CHECK(farthest_way(region{}, 7.0, 0.0) == 7.0 * 2.0);                    // NOLINT
}

TEST_CASE("surroundings beyond the grid are refused, and an empty region has empty surroundings", "[surroundings]")
{
    contours around;
    CHECK(surround(shapes::rectangle().made(), grid::reach / 2.0, around) == error::outline_beyond_grid);
    CHECK(surround(shapes::rectangle().made(), 1e300, around) == error::outline_beyond_grid);
    CHECK_FALSE(surround(region{}, 100.0, around));
    CHECK(around.points.empty());
    contours nothing;
    leave_frame(nothing);
    CHECK(nothing.starts.empty());
}
