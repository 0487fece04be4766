// SPDX-License-Identifier: MIT

#include <typemesh/offset/sweep_inwards.hpp>

#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/filled_shape.hpp"
#include "support/kinetic.hpp"
#include "support/letters.hpp"
#include "support/regions.hpp"

#include <cstdint>
#include <vector>

namespace {

using namespace typemesh;

constexpr int cells = 4096;

struct swept_polygons {
    contours loops;
    workspace space;
    workspace::scope scratch{space};
    triangle_list triangles;
    swept_region out{scratch.source()};
    region filled;

    swept_polygons(const std::vector<test::polyline>& polygons, const std::vector<double>& levels,
                   double mitre_limit = 0.0)
        : loops{test::contours_of(polygons)}
    {
        const auto made = fill(loops, fill_rule::non_zero, space);
        REQUIRE(made);
        filled = *made;
        REQUIRE(!monotone{}(filled, space, triangles));
        REQUIRE(!sweep_inwards(filled, triangles.view(), {levels, mitre_limit, 0.0}, scratch, out));
    }

    [[nodiscard]] double twice_swept() const
    {
        double sum = 0.0;
        for (const triangle t : out.triangles) {
            const auto area = orientation(out.nodes[t.a].at, out.nodes[t.b].at, out.nodes[t.c].at);
            REQUIRE(area > 0);
            sum += static_cast<double>(area);
        }
        return sum;
    }
};

test::polyline rectangle(int x, int y, int width, int height)
{
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

/// A bar of 100 x 60 with a notch from above, of this half width at the top and down to this height.
test::polyline notched_bar(int half_width, int tip)
{
    return test::scaled({{0, 0}, {100, 0}, {100, 60}, {50 + half_width, 60}, {50, tip}, {50 - half_width, 60}, {0, 60}},
                        cells);
}

void open_cells(detail::wavefront& front)
{
    for (std::uint32_t s = 0; s < front.mesh.segments.size(); ++s) {
        const auto& one = front.mesh.segments[s];
        front.ends_of[s] = front.outlines.open(one.line, front.node_of[one.from], front.node_of[one.to]);
    }
}

}  // namespace

TEST_CASE("a square's boundary sweeps four trapezoids and leaves a square")
{
    const swept_polygons s{{rectangle(0, 0, 100 * cells, 100 * cells)}, {0.0, 10.0 * cells}};
    CHECK(s.out.cap.points.size() == 4);
    for (const grid_point p : s.out.cap.points) {
        CHECK((p.x == 10 * cells || p.x == 90 * cells));
        CHECK((p.y == 10 * cells || p.y == 90 * cells));
    }
    CHECK(s.out.triangles.size() == 8);
    CHECK(s.twice_swept() == 2.0 * (100.0 * 100.0 - 80.0 * 80.0) * cells * cells);
    CHECK(s.out.first_loss < 0.0);
}

TEST_CASE("a rectangle is swept completely, and its roof has a ridge")
{
    const swept_polygons s{{rectangle(0, 0, 100 * cells, 20 * cells)}, {0.0, 30.0 * cells}};
    CHECK(s.out.cap.points.empty());
    CHECK(s.twice_swept() == 2.0 * 100.0 * 20.0 * cells * cells);
    CHECK(s.out.nodes.size() == 6);  // the corners and the ridge's two ends
    CHECK(s.out.first_loss == Approx(10.0 * cells).margin(1.0));
}

TEST_CASE("a reflex corner splits what it runs into")
{
    const swept_polygons s{{notched_bar(10, 20)}, {0.0, 16.0 * cells}};
    CHECK(s.out.cap.contour_count() == 2);
    CHECK(s.twice_swept() > 0.0);
}

TEST_CASE("a reflex corner sharper than the limit is joined, so that its cap has no spike")
{
    const test::polyline bar = notched_bar(2, 30);
    const swept_polygons spike{{bar}, {0.0, 1.5 * cells}}, joined{{bar}, {0.0, 1.5 * cells}, 2.0};
    const auto lowest = [](const swept_polygons& s) {
        std::int32_t y = 60 * cells;
        for (const grid_point p : s.out.cap.points)
            if (p.y > 2 * cells && p.y < y) y = p.y;
        return 30.0 - static_cast<double>(y) / cells;
    };
    CHECK(lowest(spike) > 20.0);
    CHECK(lowest(joined) <= 2.0 * 1.5);
    CHECK(lowest(joined) >= 1.5);
    CHECK(!joined.out.joins.empty());
    CHECK(joined.twice_swept() > 0.0);
}

TEST_CASE("a hole of a few cells keeps its round joins and grows to a disc")
{
    // Its tips are so close that edges meet their round joins while these are short.
    const test::polyline needle{{-7, -8}, {-5, -3}, {-8, -8}, {-4, -1}};
    for (const int turn : {0, 1, 2, 3}) {
        test::polyline hole;
        for (const grid_point p : needle)
            hole.push_back(turn == 0   ? p
                           : turn == 1 ? grid_point{-p.y, p.x}
                           : turn == 2 ? grid_point{-p.x, -p.y}
                                       : grid_point{p.y, -p.x});
        constexpr double width = 1000.0, pi = 3.14159265358979;
        const swept_polygons s{{rectangle(-2 * cells, -2 * cells, 4 * cells, 4 * cells), hole}, {0.0, width}, 1.0};
        REQUIRE(s.out.cap.contour_count() == 2);
        const double hollow = -0.5 * static_cast<double>(inspect::doubled_area(s.out.cap)) +
                              4.0 * (2.0 * cells - width) * (2.0 * cells - width);
        CHECK(hollow > pi * width * width);
        CHECK(hollow < pi * (1.01 * width + 10.0) * (1.01 * width + 10.0));
    }
}

TEST_CASE("no hole of a few cells is lost: it grows by the distance, whatever its joins run into")
{
    test::dice d{11};
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
        const int reach = 2 + d.roll(14), corners = 3 + d.roll(9);
        test::polyline hole;
        for (int k = 0; k < corners; ++k)
            hole.push_back({d.roll(2 * reach + 1) - reach, d.roll(2 * reach + 1) - reach});
        constexpr double width = 300.0, pi = 3.14159265358979;
        test::filled_shape f{{"", {rectangle(-1000, -1000, 2000, 2000), hole}}, fill_rule::even_odd};
        if (f.filled.loop_count() == 1) continue;  // all its points lie on a line
        triangle_list triangles;
        REQUIRE(!monotone{}(f.filled, f.space, triangles));
        workspace::scope scratch{f.space};
        swept_region out{scratch.source()};
        const double levels[] = {0.0, width};
        if (sweep_inwards(f.filled, triangles.view(), {levels, 1.0, 0.0}, scratch, out)) {
            ++refused;
            continue;
        }
        CHECK(out.cap.contour_count() == 2);
        const double hollow =
            4.0 * (1000.0 - width) * (1000.0 - width) - 0.5 * static_cast<double>(inspect::doubled_area(out.cap));
        CHECK(hollow > pi * (width - 1.0) * (width - 1.0));
    }
    CHECK(refused <= 2);
}

TEST_CASE("a wavefront that loses a hole stops, and does not report a lack of memory", "[offset]")
{
    detail::wavefront front{heap()};
    test::set_up(front,
                 {"frame", {rectangle(0, 0, 9000, 9000), {{4000, 4000}, {4000, 5000}, {5000, 5000}, {5000, 4000}}}});
    for (auto& v : front.mesh.vertices) {
        const bool in_hole = v.moves.start.x % (9000 * detail::place_one) != 0;
        if (in_hole) v.moves.speed.of = {-v.moves.speed.of.x, -v.moves.speed.of.y};  // the wrong direction for a hole
    }
    open_cells(front);
    constexpr std::int64_t end = 3000 * detail::time_one;
    REQUIRE(front.start(end));
    CHECK_FALSE(front.advance(end, 0));
    CHECK_FALSE(front.has_failed());
}

TEST_CASE("a wavefront that reaches its limit of flips stops, and does not report a lack of memory", "[offset]")
{
    const test::shape plate = test::circle_with_holes(24, 5);
    constexpr std::int64_t end = (std::int64_t{1} << 20) * detail::time_one;
    for (const bool ends : {false, true}) {
        detail::wavefront front{heap()};
        test::set_up(front, plate);
        open_cells(front);
        if (!ends) front.flips_a_triangle = 0;
        REQUIRE(front.start(end));
        CHECK(front.advance(end, 0) == ends);
        CHECK_FALSE(front.has_failed());
        CHECK(test::broken_link(front.mesh).empty());
    }
}
