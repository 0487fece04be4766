// SPDX-License-Identifier: MIT
//
// What resolve() makes depends on the set of the contours' edges alone, and is what snap rounding is defined to be.

#include <typemesh/fill/resolve.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"
#include "support/snapped.hpp"

using namespace typemesh;

namespace {

/// Small grids, where nearly every point lies beside some edge, and long thin shapes.
test::shape crowded(test::dice& d, int i)
{
    test::shape s{"shape " + std::to_string(i), {}};
    const int kind = d.roll(5), width = 3 + d.roll(12), length = 20 + d.roll(400);
    const int count = 1 + d.roll(3);
    for (int c = 0; c < count; ++c) {
        test::polyline l;
        for (int n = 3 + d.roll(count == 1 ? 9 : 5); n > 0; --n) {
            if (kind == 0)
                l.push_back({d.roll(width), d.roll(width)});
            else if (kind == 1)
                l.push_back({d.roll(40), d.roll(40)});
            else if (kind == 2)
                l.push_back({(n % 2) * length + d.roll(4), d.roll(9)});
            else if (kind == 3)
                l.push_back({d.roll(3), d.roll(length)});
            else
                l.push_back({d.roll(length), d.roll(length)});
        }
        s.loops.push_back(l);
    }
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

/// The same edges: every contour begun elsewhere, the contours in another order, all run the other way or, where
/// even_odd counts, any of them.
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

TEST_CASE("The region is bounded by what snap rounding is defined to make of the edges", "[fill][resolve]")
{
    test::dice d{111};
    std::uint32_t quick = 0, rounded = 0;
    for (int i = 0; i < 6000; ++i) {
        const test::shape s = crowded(d, i);
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

TEST_CASE("What crosses the rest of a cut edge is sought, though whole edges upon that rest cancel it",
          "[fill][resolve]")
{
    // From (2, 9) to (3, 18): the rest of one edge that is cut in (2, 9), and three whole edges; all four cancel.
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

TEST_CASE("The region does not depend on where contours begin, on their direction, or on their order",
          "[fill][resolve]")
{
    test::dice d{112};
    for (int i = 0; i < 6000; ++i) {
        const test::shape s = crowded(d, i);
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            const test::shape other = disguised(s, rule, d);
            resolve_effort effort;
            INFO(s);
            INFO(other);
            REQUIRE(region_of(s, rule, effort) == region_of(other, rule, effort));
        }
    }
}

TEST_CASE("The triangles of crossings within two cells of each other do not depend on where a contour begins",
          "[fill][resolve]")
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

TEST_CASE(
    "A spike that cancels leaves the point where it stood, and those where it ends on the boundary, whichever "
    "way it is run",
    "[fill][resolve]")
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
