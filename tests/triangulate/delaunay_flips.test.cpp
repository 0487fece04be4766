// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/delaunay_flips.hpp>
#include <typemesh/triangulate/impl/delaunay_slabs.hpp>

#include "half_edge_mesh.hpp"
#include "support/catch.hpp"
#include "support/delaunay.hpp"
#include "support/delaunay_shapes.hpp"

using namespace typemesh;
using detail::delaunay_flips;

namespace {

constexpr std::uint64_t plenty = 1'000'000;

/// The Delaunay triangles of a region, made by slabs, which share no code with flips.
std::vector<test::oracle::placed_triangle> by_slabs(const std::vector<test::polyline>& loops)
{
    contours given = test::contours_of(loops);
    workspace space;
    const result<region> filled = fill(given, fill_rule::non_zero, space);
    if (!filled) return {};
    std::vector<triangle> made(filled->triangle_count());
    if (detail::delaunay_slabs{}.run(*filled, space, made.data())) return {};
    return test::oracle::as_set(filled->points(), made);
}

std::vector<test::oracle::placed_triangle> placed(const test::half_edge_mesh& m)
{
    return test::oracle::as_set(m.points(), m.triangles());
}

std::vector<test::polyline> placed(const test::half_edge_mesh& m, const test::numbered_loops& loops)
{
    std::vector<test::polyline> all;
    for (const auto& l : loops) {
        all.emplace_back();
        for (const std::uint32_t v : l) all.back().push_back(m.points()[v]);
    }
    return all;
}

}  // namespace

TEST_CASE("flips everywhere make the same triangles as slabs", "[triangulate][delaunay_flips]")
{
    for (const test::shape& s : test::delaunay_shapes()) {
        if (!test::is_region(s.loops)) continue;
        const test::numbered_shape given{s};
        if (given.points.size() > 1000) continue;
        test::half_edge_mesh m{given.points, given.loops};
        delaunay_flips flips{m.mesh, m.points(), plenty};
        REQUIRE(flips.open(m.scratch(), m.mesh.end() / 4));
        INFO(s.name);
        REQUIRE(flips.everywhere());
        CHECK(test::broken_mesh(m, given.loops) == "");
        CHECK((placed(m) == by_slabs(s.loops)));
    }
}

TEST_CASE("every sufficient budget of flips gives the same mesh, and a smaller one is reported",
          "[triangulate][delaunay_flips]")
{
    const test::shape s{"star", {test::star(40, 1000, 5)}};
    REQUIRE(test::is_region(s.loops));
    const test::numbered_shape given{s};
    const auto wanted = by_slabs(s.loops);
    bool sufficed = false;
    for (std::uint64_t budget = 0; budget < 200; ++budget) {
        test::half_edge_mesh m{given.points, given.loops};
        delaunay_flips flips{m.mesh, m.points(), budget};
        REQUIRE(flips.open(m.scratch(), m.mesh.end() / 4));
        const bool done = flips.everywhere();
        INFO("budget " << budget);
        CHECK((done || !sufficed));
        if (done) CHECK((placed(m) == wanted));
        CHECK(test::broken_mesh(m, given.loops) == "");
        sufficed = done;
        if (budget == 0) CHECK_FALSE(done);
    }
    CHECK(sufficed);
}

TEST_CASE("a point inserted into the boundary leaves the Delaunay triangles of all", "[triangulate][delaunay_flips]")
{
    test::dice d{10};
    int outside = 0, inside = 0, beyond = 0, given_up = 0;
    for (int round = 0; round < 100'000 && (outside < 1500 || inside < 700 || beyond < 150); ++round) {
        const auto given = test::random_point_less(d);
        if (!given) continue;
        test::half_edge_mesh m{given->all.points, given->loops};
        delaunay_flips flips{m.mesh, m.points(), plenty};
        REQUIRE(flips.open(m.scratch(), given->all.points.size()));
        REQUIRE(flips.everywhere());
        REQUIRE((placed(m) == by_slabs(placed(m, given->loops))));

        using detail::half_edges;
        const std::uint32_t h = m.mesh.boundary_from(given->before);
        const grid_point a = m.mesh.place(h), b = m.mesh.place(half_edges::next(h)),
                         c = m.mesh.place(half_edges::previous(h)), at = given->all.points[given->left_out];
        const bool ear = orientation(a, at, b) > 0,
                   dent = !ear && orientation(b, c, at) > 0 && orientation(c, a, at) > 0;
        INFO(test::shape({"with point " + std::to_string(given->left_out), {given->all.points}}));
        const bool done = flips.insert(given->before, given->left_out);
        outside += ear;
        inside += dent;
        beyond += !ear && !dent;
        if (!ear && !dent && !done) {  // it may give up there, which is rare
            ++given_up;
            continue;
        }
        REQUIRE(done);
        REQUIRE(test::broken_mesh(m, given->all.loops) == "");
        REQUIRE((placed(m) == by_slabs(placed(m, given->all.loops))));
    }
    CHECK(outside >= 1500);
    CHECK(inside >= 700);
    CHECK(beyond >= 150);
    CHECK(given_up <= beyond / 20);
}

TEST_CASE("a point that the boundary hides is refused", "[triangulate][delaunay_flips]")
{
    // From the bottom edge to a point above the notch: the region between would have to pass through the notch.
    //
    //      5-----4   3-----2        The point 6, to come between 0 and 1, lies on the far side of the notch's tip 7.
    //      |      \ /      |
    //      |    6  7       |
    //      0---------------1
    const std::vector<grid_point> points{{0, 0}, {100, 0}, {100, 40}, {60, 40}, {40, 40}, {0, 40}, {50, 60}, {50, 20}};
    const test::numbered_loops loops{{0, 1, 2, 3, 7, 4, 5}};
    test::half_edge_mesh m{points, loops};
    delaunay_flips flips{m.mesh, m.points(), plenty};
    REQUIRE(flips.open(m.scratch(), points.size()));
    REQUIRE(flips.everywhere());
    CHECK_FALSE(flips.insert(0, 6));
}
