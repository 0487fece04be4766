// SPDX-License-Identifier: MIT
#pragma once

// Godot 4: the arrays of an ArrayMesh surface, from a GDExtension (godot-cpp) or a module. Right-handed, y up, front
// faces clockwise as the viewer sees them: frame::winding is -1. v downwards, normal maps with green up: the fourth
// number of a tangent is negated.
//
// Include godot_cpp/classes/array_mesh.hpp and the packed arrays' headers first.
//
//     godot::Array arrays;
//     if (const auto written = engines::godot_mesh::write(*plan, arrays); !written) return written.error();
//     mesh->add_surface_from_arrays(godot::Mesh::PRIMITIVE_TRIANGLES, arrays);
//     // or one surface per part, for materials of their own: the same vertices, and slices of ARRAY_INDEX by plan->range(part)

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/computed_stream.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace engines::godot_mesh {

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_y_up;
    o.frame.winding = -1;
    return o;
}

/// Fills ARRAY_VERTEX, ARRAY_NORMAL, ARRAY_TANGENT, ARRAY_TEX_UV and ARRAY_INDEX.
template <class Plan>
[[nodiscard]] typemesh::result<void> write(const Plan& plan, godot::Array& arrays)
{
    using namespace typemesh;
    const mesh_size size = plan.size();
    if (size.indices() > 0x7FFF'FFFFu) return error::too_large;  // PackedInt32Array holds signed numbers
    const auto n = static_cast<std::int64_t>(size.vertices);

    godot::PackedVector3Array places, normals;
    godot::PackedFloat32Array tangents;
    godot::PackedVector2Array uvs;
    godot::PackedInt32Array numbers;
    places.resize(n), normals.resize(n), tangents.resize(4 * n), uvs.resize(n);
    numbers.resize(static_cast<std::int64_t>(size.indices()));

    struct float4 {
        float x, y, z, w;
    };
    const std::span all_tangents{reinterpret_cast<float4*>(tangents.ptrw()), size.vertices};
    const std::span indices{numbers.ptrw(), size.indices()};
    if (const auto written = plan.write(stream_sink{
            indices, stream<attribute::position, godot::Vector3>{places.ptrw(), size.vertices},
            stream<attribute::normal, godot::Vector3>{normals.ptrw(), size.vertices},
            computed_stream<attribute::tangent>(all_tangents,
                                                [](const surface_point<attribute::tangent>& s) noexcept {
                                                    return float4{s.tangent.x, s.tangent.y, s.tangent.z, -s.tangent.w};
                                                }),
            stream<attribute::uv, godot::Vector2>{uvs.ptrw(), size.vertices}});
        !written)
        return written.error();

    arrays.resize(godot::Mesh::ARRAY_MAX);
    arrays[godot::Mesh::ARRAY_VERTEX] = places;
    arrays[godot::Mesh::ARRAY_NORMAL] = normals;
    arrays[godot::Mesh::ARRAY_TANGENT] = tangents;
    arrays[godot::Mesh::ARRAY_TEX_UV] = uvs;
    arrays[godot::Mesh::ARRAY_INDEX] = numbers;
    return {};
}

}  // namespace engines::godot_mesh
