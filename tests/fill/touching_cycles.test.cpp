// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/touching_cycles.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <tuple>

using namespace typemesh;

namespace {

/// The directed edges with their curves, sorted.
auto edges_of(const contours& loops)
{
    std::vector<std::tuple<int, int, int, int, std::uint32_t>> all;
    for (std::uint32_t c = 0; c < loops.contour_count(); ++c)
        for (std::uint32_t begin = loops.starts[c], end = loops.starts[c + 1], i = begin; i < end; ++i) {
            const grid_point a = loops.points[i], b = loops.points[i + 1 < end ? i + 1 : begin];
            all.emplace_back(a.x, a.y, b.x, b.y, loops.edges[i].curve);
        }
    std::sort(all.begin(), all.end());
    return all;
}

bool equal(const contours& a, const contours& b)
{
    return std::ranges::equal(a.points, b.points) && std::ranges::equal(a.starts, b.starts) &&
           std::ranges::equal(a.edges, b.edges, {}, &contour_edge::curve, &contour_edge::curve);
}

}  // namespace

TEST_CASE("link() keeps every directed edge, changes nothing the second time, and can be undone",
          "[fill][touching_cycles]")
{
    test::dice d{611};
    int linked = 0, changed = 0;
    for (int i = 0; i < 100'000; ++i) {
        const int width = 3 + d.roll(6), count = 1 + d.roll(3);
        const test::shape s = test::random_polylines(d, count, 1, 8, width);
        const contours given = test::contours_of(s);
        contours loops = test::contours_of(s);
        workspace space;
        workspace::scope scratch{space};
        touching_cycles cycles, again;
        INFO(s);
        if (const error e = cycles.link(loops, scratch, space)) {
            REQUIRE(e == error::crossing_contours);
            REQUIRE(equal(loops, given));
            continue;
        }
        ++linked;
        changed += !equal(loops, given);
        REQUIRE(edges_of(loops) == edges_of(given));
        const std::vector<grid_point> first{loops.points.begin(), loops.points.end()};
        REQUIRE_FALSE(again.link(loops, scratch, space));
        REQUIRE(std::ranges::equal(first, loops.points));
        cycles.undo(loops);
        REQUIRE(equal(loops, given));
        cycles.undo(loops);  // nothing
        REQUIRE(equal(loops, given));
    }
    CHECK(linked > 1000);
    CHECK(changed > 100);
}

TEST_CASE("Contours without equal points are not relinked", "[fill][touching_cycles]")
{
    for (const test::shape& s : {test::shape{"a square", {test::square(0, 0, 9)}}, test::shape{"nothing", {}}}) {
        contours loops = test::contours_of(s);
        workspace space;
        workspace::scope scratch{space};
        touching_cycles cycles;
        CHECK(cycles.link(loops, scratch, space) == error::crossing_contours);
    }
}
