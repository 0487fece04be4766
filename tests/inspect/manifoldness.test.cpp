// SPDX-License-Identifier: MIT
#include <typemesh/core/point.hpp>
#include <typemesh/inspect/manifoldness.hpp>

#include "support/catch.hpp"

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

using namespace typemesh;
using inspect::check_manifoldness;
using inspect::manifoldness;

namespace {

struct triangles {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;

    /// A tetrahedron whose corners are these, the fourth on the left of the first three.
    void add(vec3 a, vec3 b, vec3 c, vec3 d)
    {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const vec3 v : {a, b, c, d}) vertices.push_back(v);
        for (const std::uint32_t i : {0u, 2u, 1u, 0u, 1u, 3u, 1u, 2u, 3u, 2u, 0u, 3u}) indices.push_back(first + i);
    }
    [[nodiscard]] manifoldness check() const { return check_manifoldness(inspect::mesh_view{vertices, indices}); }
};

triangles tetrahedron()
{
    triangles t;
    t.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    return t;
}

}  // namespace

TEST_CASE("a tetrahedron is manifold, and so are two separate ones", "[manifoldness]")
{
    CHECK(triangles{}.check().is_manifold());
    triangles t = tetrahedron();
    CHECK(t.check().is_manifold());
    t.add({5, 0, 0}, {6, 0, 0}, {5, 1, 0}, {5, 0, 1});
    CHECK(t.check().is_manifold());
}

TEST_CASE("two tetrahedra are crowded at a common edge, and pinched at a common point", "[manifoldness]")
{
    triangles edge = tetrahedron();
    edge.add({0, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1});
    CHECK(edge.check().crowded_edges == 1);
    CHECK_FALSE(edge.check().is_manifold());

    triangles point = tetrahedron();
    point.add({0, 0, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1});
    CHECK(point.check().crowded_edges == 0);
    CHECK(point.check().pinched_points == 1);
    CHECK_FALSE(point.check().is_manifold());
}

TEST_CASE("holes, triangles turned over and bad corners are counted", "[manifoldness]")
{
    triangles open = tetrahedron();
    open.indices.resize(9);
    CHECK(open.check().open_edges == 3);

    triangles turned = tetrahedron();
    std::swap(turned.indices[0], turned.indices[1]);
    CHECK(turned.check().open_edges == 3);

    triangles flat = tetrahedron();
    flat.indices[1] = flat.indices[0];
    CHECK(flat.check().bad_triangles == 1);

    triangles none = tetrahedron();
    none.vertices[3].x = std::numeric_limits<float>::quiet_NaN();
    CHECK(none.check().bad_triangles == 3);

    triangles beyond = tetrahedron();
    beyond.indices[0] = 9;
    CHECK(beyond.check().bad_triangles == 1);
}
