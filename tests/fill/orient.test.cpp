// SPDX-License-Identifier: MIT

#include <typemesh/fill/orient.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// Edges of contours_of() carry the index of their first point. After turning, edge i must lie between the places of
/// point i and the next one, with t0 and t1 swapped.
bool edges_follow(const contours& now, const contours& before)
{
    for (std::uint32_t c = 0; c < now.contour_count(); ++c) {
        const std::uint32_t begin = now.starts[c], end = now.starts[c + 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const contour_edge e = now.edges[i];
            const std::uint32_t next = e.curve + 1 < end ? e.curve + 1 : begin;
            const grid_point from = before.points[e.curve], to = before.points[next];
            const grid_point a = now.points[i], b = now.points[i + 1 < end ? i + 1 : begin];
            if (!(e.t0 < e.t1 ? a == from && b == to : a == to && b == from)) return false;
        }
    }
    return true;
}

}  // namespace

TEST_CASE("orient() turns clockwise outlines and keeps others", "[fill][orient]")
{
    for (const test::shape& s : test::generated_regions()) {
        INFO(s.name);
        const contours given = test::contours_of(s), clockwise = test::contours_of(test::reversed(s));
        contours left = test::contours_of(s), turned = test::contours_of(test::reversed(s));
        orient(left);
        CHECK(std::ranges::equal(left.points, given.points));
        orient(turned);
        CHECK(std::ranges::equal(turned.points, given.points));
        CHECK(edges_follow(turned, clockwise));
        CHECK(turned.edges[0].t0 == 0.75f);
        CHECK(test::oracle::doubled_area(test::oracle::loops_of(turned)) > 0);
    }
}

TEST_CASE("orient() sums areas beyond 64 bits exactly", "[fill][orient]")
{
    // 600 of the largest squares clockwise, as many counter-clockwise, and one small square that decides.
    test::shape s{"many", {}};
    for (int i = 0; i < 600; ++i) {
        s.loops.push_back(test::square(-(1 << 28), -(1 << 28), 1 << 29));
        s.loops.push_back(test::reversed(s.loops.back()));
    }
    std::stable_sort(s.loops.begin(), s.loops.end(),
                     [](auto& a, auto& b) { return test::oracle::doubled_area(a) < test::oracle::doubled_area(b); });
    s.loops.push_back(test::square(0, 0, 1));
    contours c = test::contours_of(s);
    orient(c);
    CHECK(c.points.back() == grid_point{0, 1});
    std::reverse(s.loops.back().begin(), s.loops.back().end());
    c = test::contours_of(s);
    orient(c);
    CHECK(c.points.back() == grid_point{0, 1});  // turned
}

TEST_CASE("a contour that is turned twice is unchanged", "[fill][orient]")
{
    for (int n = 0; n < 8; ++n) {
        test::polyline l = test::circle(8, 100);
        l.resize(static_cast<std::size_t>(n));
        const contours before = test::contours_of({l});
        contours c = test::contours_of({l});
        reverse_contour(c.points.view(), c.edges.view());
        CHECK(edges_follow(c, before));
        reverse_contour(c.points.view(), c.edges.view());
        CHECK(std::ranges::equal(c.points, before.points));
        for (std::size_t i = 0; i < c.edges.size(); ++i) {
            CHECK(c.edges[i].curve == before.edges[i].curve);
            CHECK(c.edges[i].t0 == before.edges[i].t0);
        }
    }
}

TEST_CASE("orient() accepts contours without points", "[fill][orient]")
{
    contours none;
    orient(none);
    CHECK(none.points.empty());
    contours hollow = test::contours_of({test::polyline{}, test::polyline{}});
    orient(hollow);
    CHECK(hollow.contour_count() == 2);
}
