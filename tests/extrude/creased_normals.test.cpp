// SPDX-License-Identifier: MIT

#include <typemesh/extrude/creased_normals.hpp>

#include "walls.hpp"

using namespace typemesh;
using namespace meshes;

TEST_CASE("creased normals double the corners of the polygon, and each wall has its own normal", "[extrude]")
{
    for (const float crease : {1.0f, 10.0f, 30.0f, 75.0f, 100.0f})
        for (const auto& s : shapes::all()) {
            INFO(s.name << " creased at " << crease);
            const built b = build(s, extruded<creased_normals>{.texture = texture_mapping::box, .normals = {crease}});
            std::uint32_t hard = 0;
            for (std::uint32_t i = 0; i < s.points(); ++i) {
                const walls w = at(s, i);
                CHECK(b.sides[i].doubled == (w.degrees > static_cast<double>(crease)));
                hard += b.sides[i].doubled;
                const vec2 before = b.sides[i].before, after = b.sides[i].after;
                if (b.sides[i].doubled) {
                    check_equal({before.x, before.y, 0.0f}, w.before, 0.0);
                    check_equal({after.x, after.y, 0.0f}, w.after, 0.0);
                } else {
                    check_equal({before.x, before.y, 0.0f}, w.before + w.after, 0.0);
                    CHECK(before == after);
                }
            }
            CHECK(b.announced.vertices == 4 * s.points() + 2 * hard);
        }
    const extruded<creased_normals> square{.texture = texture_mapping::box, .normals = {90.0f}};
    for (const auto& side : build(shapes::rectangle(), square).sides) CHECK_FALSE(side.doubled);
}
