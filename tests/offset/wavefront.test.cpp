// SPDX-License-Identifier: MIT

#include <typemesh/offset/sweep_inwards.hpp>

#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/kinetic.hpp"
#include "support/regions.hpp"

#include <cstdint>
#include <vector>

namespace {

using namespace typemesh;

constexpr int cells = 4096;

struct swept {
    contours loops;
    workspace space;
    workspace::scope scratch{space};
    triangle_list triangles;
    swept_region out{scratch.source()};
    region filled;

    swept(const std::vector<test::polyline>& polygons, const std::vector<double>& levels, double mitre_limit = 0.0)
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

}  // namespace

TEST_CASE("a square's boundary sweeps four trapezoids and leaves a square")
{
    const swept s{{rectangle(0, 0, 100 * cells, 100 * cells)}, {0.0, 10.0 * cells}};
    CHECK(s.out.cap.points.size() == 4);
    for (const grid_point p : s.out.cap.points) {
        CHECK((p.x == 10 * cells || p.x == 90 * cells));
        CHECK((p.y == 10 * cells || p.y == 90 * cells));
    }
    CHECK(s.out.triangles.size() == 8);
    CHECK(s.twice_swept() == 2.0 * (100.0 * 100.0 - 80.0 * 80.0) * cells * cells);
    CHECK(s.out.first_loss < 0.0);
}

TEST_CASE("a rectangle is swept wholly: its roof has a ridge")
{
    const swept s{{rectangle(0, 0, 100 * cells, 20 * cells)}, {0.0, 30.0 * cells}};
    CHECK(s.out.cap.points.empty());
    CHECK(s.twice_swept() == 2.0 * 100.0 * 20.0 * cells * cells);
    CHECK(s.out.nodes.size() == 6);  // the corners and the ridge's two ends
    CHECK(s.out.first_loss == Approx(10.0 * cells).margin(1.0));
}

TEST_CASE("a reflex corner splits what it runs into")
{
    // a bar with a notch from above that reaches the lower edge's level after 10 cells * 4096
    const test::polyline bar{{0, 0},
                             {100 * cells, 0},
                             {100 * cells, 60 * cells},
                             {60 * cells, 60 * cells},
                             {50 * cells, 20 * cells},
                             {40 * cells, 60 * cells},
                             {0, 60 * cells}};
    const swept s{{bar}, {0.0, 16.0 * cells}};
    CHECK(s.out.cap.contour_count() == 2);
    CHECK(s.twice_swept() > 0.0);
}

TEST_CASE("a reflex corner sharper than the limit is joined, and its cap is without a spike")
{
    const test::polyline bar{{0, 0},
                             {100 * cells, 0},
                             {100 * cells, 60 * cells},
                             {52 * cells, 60 * cells},
                             {50 * cells, 30 * cells},
                             {48 * cells, 60 * cells},
                             {0, 60 * cells}};
    const swept spike{{bar}, {0.0, 1.5 * cells}}, joined{{bar}, {0.0, 1.5 * cells}, 2.0};
    const auto lowest = [](const swept& s) {
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

TEST_CASE("a wavefront whose flips reach their limit stops, and says that memory has not run out", "[offset]")
{
    const test::shape plate = test::circle_with_holes(24, 5);
    constexpr std::int64_t end = (std::int64_t{1} << 20) * detail::time_one;
    for (const bool ends : {false, true}) {
        detail::wavefront front{heap()};
        test::set_up(front, plate);
        for (std::uint32_t s = 0; s < front.mesh.segments.size(); ++s) {
            const auto& one = front.mesh.segments[s];
            front.ends_of[s] = front.outlines.open(one.line, front.node_of[one.from], front.node_of[one.to]);
        }
        if (!ends) front.flips_a_triangle = 0;
        REQUIRE(front.start(end));
        CHECK(front.advance(end, 0) == ends);
        CHECK_FALSE(front.has_failed());
        CHECK(test::broken_link(front.mesh).empty());
    }
}
