// SPDX-License-Identifier: MIT

#include <typemesh/extrude/shared_normals.hpp>

#include "walls.hpp"

using namespace typemesh;
using namespace meshes;

TEST_CASE("shared normals are the sum of a cap and two walls, as far as these parts are on", "[extrude]")
{
    for (const auto& s : shapes::all())
        for (unsigned bits = 0; bits < 8; ++bits) {
            const extruded<shared_normals> how{
                .front = (bits & 1u) != 0, .back = (bits & 2u) != 0, .side = (bits & 4u) != 0};
            INFO(s.name << ", switches " << bits);
            const built b = build(s, how);
            for (std::uint32_t i = 0; i < s.points(); ++i) {
                const walls w = at(s, i);
                const point sum = how.side ? w.before + w.after : point{};
                if (how.front || how.side) check_equal(b.vertices[i].normal, sum, how.front ? 1.0 : 0.0);
                if (how.back || how.side)
                    check_equal(b.vertices[b.first_vertex(part::back) + i].normal, sum, how.back ? -1.0 : 0.0);
            }
        }
}
