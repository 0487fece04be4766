// SPDX-License-Identifier: MIT
//
// resolve()'s result depends only on the set of the contours' edges, and is the one that snap rounding defines.

#include <typemesh/fill/resolve.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"
#include "support/snapped.hpp"

using namespace typemesh;

namespace {

/// Small grids, where nearly every point lies beside some edge, and long thin shapes.
test::shape crowded(test::dice& d)
{
    const int kind = d.roll(5), width = 3 + d.roll(12), length = 20 + d.roll(400);
    const int count = 1 + d.roll(3);
    test::shape s = test::random_polylines(d, count, 3, count == 1 ? 9 : 5, [&](const test::polyline&, int n) {
        if (kind == 2) return grid_point{(n % 2) * length + d.roll(4), d.roll(9)};
        const int across[] = {width, 40, 0, 3, length}, up[] = {width, 40, 0, length, length};
        const std::int32_t x = d.roll(across[kind]);
        return grid_point{x, d.roll(up[kind])};
    });
    if (d.roll(6) == 0) s.loops.push_back(s.loops[0]);
    if (d.roll(12) == 0) s.loops.push_back(test::reversed(s.loops[0]));
    if (d.roll(8) == 0) {  // a spike
        test::polyline& l = s.loops[0];
        const auto at = static_cast<std::size_t>(d.roll(static_cast<int>(l.size())));
        const grid_point p = l[at];
        l.insert(l.begin() + static_cast<std::ptrdiff_t>(at), {p, {d.roll(width), d.roll(width)}});
    }
    return s;
}

/// The same edges: every contour begins elsewhere, the contours are in another order, and all of them, or under
/// even_odd any of them, run the other way.
test::shape disguised(test::shape s, fill_rule rule, test::dice& d)
{
    const bool all = d.roll(2) == 0;
    for (test::polyline& l : s.loops) {
        std::rotate(l.begin(), l.begin() + d.roll(static_cast<int>(l.size())), l.end());
        if (rule == fill_rule::even_odd ? d.roll(2) == 0 : all) std::reverse(l.begin(), l.end());
    }
    for (std::size_t i = s.loops.size(); i > 1; --i)
        std::swap(s.loops[i - 1], s.loops[static_cast<std::size_t>(d.roll(static_cast<int>(i)))]);
    return s;
}

std::vector<std::vector<test::oracle::place>> region_of(const test::shape& s, fill_rule rule, resolve_effort& effort)
{
    contours loops = test::contours_of(s);
    workspace space;
    const auto made = resolve(loops, rule, space, {.effort = &effort});
    REQUIRE(made);
    return test::oracle::cyclic(test::oracle::loops_of(*made));
}

}  // namespace

TEST_CASE("The region has the boundary that snap rounding defines", "[fill][resolve]")
{
    test::dice d{111};
    std::uint32_t quick = 0, rounded = 0;
    for (int i = 0; i < 6000; ++i) {
        const test::shape s = crowded(d);
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            const auto given = test::loops_of(s);
            contours loops = test::contours_of(s);
            workspace space;
            resolve_effort effort;
            const auto made = resolve(loops, rule, space, {.effort = &effort});
            INFO(s);
            REQUIRE(made);
            (effort.rounds == 0 ? quick : rounded) += 1;
            bool twice = false;
            const auto edges = test::oracle::edges_of(test::oracle::loops_of(*made), twice);
            REQUIRE_FALSE(twice);
            REQUIRE(edges == test::oracle::boundary_of(test::oracle::snapped(given, rule), rule));
        }
    }
    CHECK(quick > 1000);  // both ways are tested
    CHECK(rounded > 1000);
}

TEST_CASE("Edges that cancel the rest of a cut edge do not hide its crossings", "[fill][resolve]")
{
    // From (2, 9) to (3, 18) run the rest of an edge that is cut in (2, 9), and three whole edges; all four cancel.
    const test::shape s{
        "a rest among whole edges",
        {{{2, 9}, {3, 18}, {2, 9}, {4, 18}, {0, 6}}, {{1, 0}, {3, 18}, {2, 9}, {1, 4}, {1, 0}, {2, 9}}}};
    contours loops = test::contours_of(s);
    workspace space;
    const auto made = resolve(loops, fill_rule::non_zero, space);
    REQUIRE(made);
    bool twice = false;
    const auto edges = test::oracle::edges_of(test::oracle::loops_of(*made), twice);
    CHECK(edges == test::oracle::boundary_of(test::oracle::snapped(test::loops_of(s), fill_rule::non_zero),
                                             fill_rule::non_zero));
}

TEST_CASE("The region does not depend on the start, direction or order of contours", "[fill][resolve]")
{
    test::dice d{112};
    for (int i = 0; i < 6000; ++i) {
        const test::shape s = crowded(d);
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            const test::shape other = disguised(s, rule, d);
            resolve_effort effort;
            INFO(s);
            INFO(other);
            REQUIRE(region_of(s, rule, effort) == region_of(other, rule, effort));
        }
    }
}

TEST_CASE("Triangles at crossings two cells apart do not depend on a contour's start", "[fill][resolve]")
{
    test::polyline l{{8, 6}, {1, 10}, {11, 3}, {3, 10}, {6, 10}, {8, 5}};
    std::vector<std::vector<std::vector<std::pair<std::int32_t, std::int32_t>>>> all;
    for (std::size_t begin = 0; begin < l.size(); ++begin) {
        std::rotate(l.begin(), l.begin() + 1, l.end());
        contours loops = test::contours_of({l});
        workspace space;
        const auto made = resolve(loops, fill_rule::non_zero, space);
        REQUIRE(made);
        triangle_list out;
        REQUIRE_FALSE(constrained_delaunay{}(*made, space, out));
        auto& triangles = all.emplace_back();
        for (const triangle t : out) {
            auto& corners = triangles.emplace_back();
            for (const std::uint32_t i : {t.a, t.b, t.c})
                corners.emplace_back(made->points()[i].x, made->points()[i].y);
            std::sort(corners.begin(), corners.end());
        }
        std::sort(triangles.begin(), triangles.end());
        CHECK(triangles == all[0]);
    }
}

TEST_CASE("A spike that cancels leaves its points on the boundary, in both directions", "[fill][resolve]")
{
    const test::polyline notched{{0, 0}, {8, 0}, {8, 8}, {4, 8}, {4, 0}, {4, 8}, {0, 8}};
    for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
        resolve_effort effort;
        const auto region = region_of({"notched", {notched}}, rule, effort);
        REQUIRE(region.size() == 1);
        CHECK(region[0].size() == 6);
        CHECK(region_of({"reversed", {test::reversed(notched)}}, rule, effort) == region);
    }
}
