// SPDX-License-Identifier: MIT

#include <typemesh/extrude/cap_normals.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;

TEST_CASE("cap normals have 2N vertices, each with its cap's normal and tangent, with or without walls", "[extrude]")
{
    for (const frame& f : frames()) {
        const vec3 front = f.toward, back{-front.x, -front.y, -front.z};
        for (const auto& s : shapes::all()) {
            INFO(s.name);
            const built b = build(s, extruded<cap_normals>{}, in_em(f));
            const built caps = build(s, extruded<averaged_normals>{}, in_em(f));
            CHECK(b.announced.vertices == 2 * s.points());
            CHECK(b.sides.empty());
            CHECK(open_edges(b) == 0);
            for (std::uint32_t i = 0; i < 2 * s.points(); ++i) {
                CHECK(b.vertices[i].normal == (i < s.points() ? front : back));
                CHECK(b.vertices[i].position == caps.vertices[i].position);
                CHECK(b.vertices[i].tangent == caps.vertices[i].tangent);
            }
        }
    }
}

TEST_CASE("cap normals stay whole where caps are switched off", "[extrude]")
{
    for (const auto& s : shapes::all()) {
        const built walls = build(s, extruded<cap_normals>{.front = false, .back = false});
        CHECK(walls.announced.vertices == 2 * s.points());
        CHECK(walls.announced.triangles == 2 * s.points());
        for (std::uint32_t i = 0; i < 2 * s.points(); ++i)
            CHECK(walls.vertices[i].normal == vec3{0.0f, 0.0f, i < s.points() ? 1.0f : -1.0f});
        CHECK(build(s, extruded<cap_normals>{.side = false}).announced.vertices == 2 * s.points());
        CHECK(build(s, extruded<cap_normals>{.back = false, .side = false}).announced.vertices == s.points());
    }
}
