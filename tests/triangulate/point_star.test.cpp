// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/impl/point_star.hpp>

#include "half_edge_mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using detail::half_edges;
using detail::point_star;

namespace point_star_test {

/// Half a circle, and point 5, which will come between its ends and lies in the circle of every triangle.
///
///      0 --- 5 --- 4     The triangles are 0 1 2, 0 2 3, 0 3 4.
///       \          3
///        1 ---- 2
struct fan {
    std::vector<grid_point> points{{-100, 0}, {-50, -95}, {50, -95}, {95, -60}, {100, 0}, {0, -1}};
    test::numbered_loops before{{0, 1, 2, 3, 4}}, after{{0, 1, 2, 3, 4, 5}};
    test::half_edge_mesh m{points, before};
    std::int64_t flips_left = 100;

    /// Inserts point 5 and visits the two opposite edges, with limited room; returns how many edges are left open.
    std::size_t close(std::size_t room)
    {
        const std::uint32_t h = m.mesh.boundary_from(4);
        const point_star star{m.mesh, points[5]};
        const seen_point a = star.origin(h), b = star.origin(half_edges::next(h)),
                         c = star.origin(half_edges::previous(h));
        std::vector<point_star::open_edge> open(room);
        open[0] = {a, c.cross(a), half_edges::previous(h)};
        open[1] = {c, b.cross(c), m.mesh.dent(h, 5)};
        return star.close(b, open.data(), 2, room, flips_left);
    }

    /// How many triangles have point 5.
    [[nodiscard]] int around() const
    {
        int count = 0;
        for (const triangle& t : m.triangles()) count += t.a == 5 || t.b == 5 || t.c == 5;
        return count;
    }
};

}  // namespace point_star_test

TEST_CASE("a star takes in every triangle whose circle contains its point", "[triangulate][point_star]")
{
    point_star_test::fan f;
    CHECK(f.close(8) == 0);
    CHECK(test::broken_mesh(f.m, f.after) == "");
    CHECK(f.around() == 4);  // one at each opposite edge
    CHECK(f.flips_left == 98);
}

TEST_CASE("a star without room for a flip leaves a mesh and its open edges", "[triangulate][point_star]")
{
    point_star_test::fan f;
    CHECK(f.close(2) == 2);
    CHECK(test::broken_mesh(f.m, f.after) == "");
    CHECK(f.around() == 2);
    CHECK(f.flips_left == 100);
}
