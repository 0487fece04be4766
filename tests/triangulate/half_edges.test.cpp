// SPDX-License-Identifier: MIT

#include "half_edge_mesh.hpp"
#include "support/catch.hpp"

#include <array>

using namespace typemesh;
using detail::half_edges;

namespace {

bool strictly_convex(const half_edges& e, std::uint32_t h)
{
    const std::uint32_t g = e.twin(h);
    const grid_point p = e.place(h), q = e.place(g), r = e.place(half_edges::previous(h)),
                     s = e.place(half_edges::previous(g));
    return orientation(s, r, p) > 0 && orientation(r, s, q) > 0;
}

}  // namespace

TEST_CASE("a sweep leaves half-edges with matching twins that cover the region", "[triangulate][half_edges]")
{
    for (const test::shape& s : test::generated_regions()) {
        if (!test::is_region(s.loops)) continue;
        const test::numbered_shape given{s};
        const test::half_edge_mesh m{given.points, given.loops};
        INFO(s.name);
        CHECK(test::broken_mesh(m, given.loops) == "");
        if (given.points.size() < 1500) CHECK(test::broken_cover(m, given.loops) == "");
    }
}

TEST_CASE("any number of flips leaves a mesh of the same region", "[triangulate][half_edges]")
{
    test::dice d{8};
    std::size_t flipped = 0;
    for (int round = 0; round < 1500; ++round) {
        const int width = 4 + d.roll(14), n = 4 + d.roll((std::min)(width * width / 3, 40));
        const test::shape s{"random polygon " + std::to_string(round), {test::random_polygon(n, width, d)}};
        if (!test::is_region(s.loops)) continue;
        const test::numbered_shape given{s};
        test::half_edge_mesh m{given.points, given.loops};
        INFO(s);
        for (int k = 0; k < 12; ++k) {
            const std::uint32_t h =
                4 * static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(m.mesh.end() / 4))) +
                static_cast<std::uint32_t>(d.roll(3));
            if (m.mesh.is_boundary(h) || !strictly_convex(m.mesh, h)) continue;
            const std::uint32_t g = m.mesh.twin(h), r = m.mesh.origin(half_edges::previous(h)),
                                other = m.mesh.origin(half_edges::previous(g)), p = m.mesh.origin(h),
                                q = m.mesh.origin(g);
            m.mesh.flip(h);
            ++flipped;
            // As in the drawing above flip().
            const std::array<std::uint32_t, 4> diagonal{
                m.mesh.origin(half_edges::next(h)), m.mesh.origin(half_edges::next(half_edges::next(h))),
                m.mesh.origin(half_edges::next(g)), m.mesh.origin(half_edges::next(half_edges::next(g)))};
            REQUIRE(diagonal == std::array<std::uint32_t, 4>{other, r, r, other});
            REQUIRE(m.mesh.origin(h) == p);
            REQUIRE(m.mesh.origin(g) == q);
        }
        REQUIRE(test::broken_mesh(m, given.loops) == "");
        REQUIRE(test::broken_cover(m, given.loops) == "");
    }
    CHECK(flipped > 1000);
}

TEST_CASE("an ear or a dent inserts a point into the boundary", "[triangulate][half_edges]")
{
    test::dice d{9};
    int ears = 0, dents = 0;
    for (int round = 0; round < 30'000 && (ears < 1000 || dents < 300); ++round) {
        const auto given = test::random_point_less(d);
        if (!given) continue;
        test::half_edge_mesh m{given->all.points, given->loops};
        const std::uint32_t h = m.mesh.boundary_from(given->before), p = given->left_out;
        const grid_point a = m.mesh.place(h), b = m.mesh.place(half_edges::next(h)),
                         c = m.mesh.place(half_edges::previous(h)), at = given->all.points[p];
        if (orientation(a, at, b) > 0) {
            m.mesh.add_ear(h, p);
            ++ears;
        } else if (orientation(b, c, at) > 0 && orientation(c, a, at) > 0) {
            const std::uint32_t from_b = m.mesh.dent(h, p);
            REQUIRE(m.mesh.place(from_b) == b);
            REQUIRE(m.mesh.place(half_edges::next(from_b)) == c);
            ++dents;
        } else {
            continue;  // beyond the triangle: see delaunay_flips
        }
        INFO(test::shape({"with point " + std::to_string(p), {given->all.points}}));
        REQUIRE(test::broken_mesh(m, given->all.loops) == "");
        REQUIRE(test::broken_cover(m, given->all.loops) == "");
    }
    CHECK(ears >= 1000);
    CHECK(dents >= 300);
}

TEST_CASE("write() writes one triangle for every four places", "[triangulate][half_edges]")
{
    const test::numbered_shape given{{"square", {test::square(0, 0, 7)}}};
    const test::half_edge_mesh m{given.points, given.loops};
    REQUIRE(m.mesh.end() == 8);
    const std::vector<triangle> written = m.triangles();
    for (std::uint32_t t = 0; t < 2; ++t)
        CHECK(written[t] == triangle{m.mesh.origin(4 * t), m.mesh.origin(4 * t + 1), m.mesh.origin(4 * t + 2)});
}
