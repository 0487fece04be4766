// SPDX-License-Identifier: MIT

// The laws for swept regions notice every fault that is planted in a correct one.

#include <typemesh/fill/fill.hpp>
#include <typemesh/offset/swept_region.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"
#include "support/swept_laws.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// A square swept inwards by hand, in two bands: 12 nodes on three concentric squares.
struct swept_square {
    contours loops = test::contours_of(std::vector<test::polyline>{test::square(0, 0, 1000)});
    workspace space;
    region filled;
    swept_region swept;

    swept_square()
    {
        const auto r = fill(loops, fill_rule::non_zero, space);
        REQUIRE(r);
        filled = *r;
        bool fits = true;
        for (const std::int32_t d : {0, 100, 300}) {
            fits = fits && swept.levels.push_back(d);
            const grid_point corners[4] = {{d, d}, {1000 - d, d}, {1000 - d, 1000 - d}, {d, 1000 - d}};
            for (const grid_point p : corners) fits = fits && swept.nodes.push_back({p, static_cast<float>(d)});
        }
        for (std::uint32_t level = 0; level < 3; ++level) {
            fits = fits && swept.at_level.push_back(4 * level);
            for (std::uint32_t i = 0; i < 4; ++i) {
                const std::uint32_t a = 4 * level + i, b = 4 * level + (i + 1) % 4;
                fits = fits && swept.edges_at.push_back({i, a, b});
                if (level == 2) {
                    fits = fits && swept.cap.points.push_back(swept.nodes[a].at) && swept.cap.edges.push_back({});
                    continue;
                }
                fits = fits && swept.cells.push_back({i, level, static_cast<std::uint32_t>(swept.triangles.size())}) &&
                       swept.triangles.push_back({a, b, b + 4}) && swept.triangles.push_back({a, b + 4, a + 4});
            }
        }
        fits = fits && swept.cells.push_back({0, 0, static_cast<std::uint32_t>(swept.triangles.size())}) &&
               swept.at_level.push_back(12) && swept.cap.starts.push_back(0) && swept.cap.starts.push_back(4);
        REQUIRE(fits);
    }

    [[nodiscard]] std::string broken() const { return test::swept_laws{filled, swept}.broken(); }
};

/// The first law that a square swept by hand breaks after this fault was planted.
std::string broken_by(const std::function<void(swept_region&)>& fault)
{
    swept_square s;
    fault(s.swept);
    return s.broken();
}

}  // namespace

TEST_CASE("a square swept by hand obeys the laws of swept regions", "[offset]")
{
    const swept_square s;
    const test::swept_laws laws{s.filled, s.swept};
    CHECK(laws.broken() == "");
    CHECK(laws.doubled_areas() == std::vector<std::int64_t>{2'000'000, 2 * 800 * 800, 2 * 400 * 400});
    CHECK(laws.farthest_off_plane() <= 0.0);
    CHECK(laws.loops_at(2) == std::vector<test::polyline>{{{300, 300}, {700, 300}, {700, 700}, {300, 700}}});
}

TEST_CASE("the laws notice each fault that is planted in a swept region", "[offset]")
{
    using s = swept_region;
    CHECK(broken_by([](s& r) { r.levels[1] = 300.0; }) == "the levels do not rise");
    CHECK(broken_by([](s& r) { r.nodes[1].at.x += 1; }) == "the first nodes are not the region's points");
    CHECK(broken_by([](s& r) { r.cells.truncate(8); }) == "the last cell is no sentinel");
    CHECK(broken_by([](s& r) { r.cells[2].band = 1; }) == "the cells are not ordered by band");
    CHECK(broken_by([](s& r) { r.cells[2].edge = 4; }) == "a cell has no edge");
    CHECK(broken_by([](s& r) { r.triangles[3].b = 12; }) == "a triangle has no nodes");
    CHECK(broken_by([](s& r) { r.at_level.truncate(3); }) ==
          "the edges at levels do not begin and end where they should");
    CHECK(broken_by([](s& r) { r.edges_at[5].edge = 4; }) == "an edge at a level has no ends");
    CHECK(broken_by([](s& r) { CHECK(r.joins.push_back({0, {2.0f, 0.0f}})); }) ==
          "a join has no point or no direction");

    CHECK(broken_by([](s& r) { r.nodes[10].distance = 301.0f; }) == "a node is not within the width");
    CHECK(broken_by([](s& r) { std::swap(r.triangles[7].a, r.triangles[7].b); }) ==
          "a triangle is flat or turned over");
    CHECK(broken_by([](s& r) { r.triangles[7].a = r.triangles[7].b; }) == "a triangle is flat or turned over");
    CHECK(broken_by([](s& r) { r.nodes[5].distance = 104.0f; }) == "a triangle reaches out of its band");
    CHECK(broken_by([](s& r) {
              r.nodes[9].at.y += 9;
              r.cap.points[1].y += 9;
          }) == "a triangle leaves the plane of its face");
    CHECK(broken_by([](s& r) { r.cells[5].edge = 0; }) == "a triangle leaves the plane of its face");

    CHECK(broken_by([](s& r) { r.triangles[6] = r.triangles[7]; }) == "two triangles have the same side");
    CHECK(broken_by([](s& r) {
              CHECK(r.nodes.push_back(r.nodes[5]));  // a crack: two nodes at one place
              r.triangles[0].c = r.triangles[1].b = 12;
          }) == "the triangles are not bounded by the region and the last level");
    CHECK(broken_by([](s& r) {
              r.cap.points.truncate(3);
              r.cap.edges.truncate(3);
              r.cap.starts[1] = 3;
          }) == "the edges at the last level are not the cap's");
    CHECK(broken_by([](s& r) {
              r.edges_at.truncate(11);
              r.at_level[3] = 11;
          }) == "the triangles are not bounded by the region and the last level");
    CHECK(broken_by([](s& r) { r.edges_at[5].edge = 2; }) == "an edge at a level is not the face's within");
    CHECK(broken_by([](s& r) { r.edges_at[9].edge = 2; }) == "an edge at a level is not the face's without");
    CHECK(broken_by([](s& r) { r.edges_at[5] = r.edges_at[4]; }) ==
          "the edges at a level are not what parts its bands");
    CHECK(broken_by([](s& r) { r.cap.points[0].x += 1; }) == "the edges at the last level are not the cap's");
}

TEST_CASE("a cap that fill() would change breaks a law", "[offset]")
{
    const auto broken_by_loops = [](const std::vector<test::polyline>& loops) {
        return test::broken_cap(test::contours_of(loops));
    };
    CHECK(broken_by_loops({test::square(0, 0, 10), test::square(10, 10, 10)}) == "");
    CHECK(broken_by_loops({{{0, 0}, {10, 0}, {10, 10}, {20, 10}, {20, 20}, {10, 20}, {10, 10}, {0, 10}}}) ==
          "the cap is no region: filled, it has other loops");
    CHECK(broken_by_loops({{{0, 0}, {10, 10}, {10, 0}, {0, 10}}}) ==
          "the cap is no region: filled, it has other loops");
    CHECK(broken_by_loops({}) == "");
    swept_square s;
    s.swept.cap.edges.truncate(3);
    CHECK(s.broken() == "the cap's edges and points differ in number");
}
