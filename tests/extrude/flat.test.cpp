// SPDX-License-Identifier: MIT

#include <typemesh/extrude/flat.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;

static_assert(extruder<flat>);

TEST_CASE("flat has only the front, with N vertices and n + 2h - 2c triangles at z = 0", "[extrude]")
{
    for (const frame& f : frames())
        for (const auto& s : shapes::all()) {
            INFO(s.name);
            const built b = build(s, flat{}, in_em(f));
            CHECK(b.announced == mesh_size{s.points(), s.made().triangle_count()});
            CHECK(b.sides.empty());
            CHECK(b.in_order);
            for (const auto& t : b.triangles) {
                CHECK(f.winding * meshes::dot(face_normal(b, t), wide(f.toward)) > 0.99);
            }
            for (const auto& v : b.vertices) {
                CHECK(v.normal == f.toward);
                CHECK(meshes::dot(wide(v.position), wide(f.toward)) == Catch::Approx(0.0).margin(1e-6));
            }
        }
    CHECK(flat{}.heights().low == 0.0);
    CHECK(flat{}.heights().high == 0.0);
}

TEST_CASE("flat equals the front of extruded, to the bit", "[extrude]")
{
    for (const auto texture : texture_mappings)
        for (const auto& s : shapes::all()) {
            const built front = build(s, extruded<>{.back = false, .side = false, .texture = texture});
            check_same(build(s, flat{.texture = texture}), front);
        }
}
