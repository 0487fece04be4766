// SPDX-License-Identifier: MIT
#pragma once

// Unity: a native plugin writes into the arrays of Mesh.MeshData. Left-handed, y up, front faces clockwise as the
// viewer sees them; v upwards; bitangent = w * cross(normal, tangent).
//
// The byte size of every attribute is a multiple of 4, the attributes come in the order of UnityEngine's enumeration:
//
//     stream 0    Position  Float32 x 3                       12 bytes
//     stream 1    Normal    SNorm16 x 4     at 0              24 bytes per vertex
//                 Tangent   SNorm16 x 4     at 8
//                 Color     UNorm8  x 4     at 16
//                 TexCoord0 Float16 x 2     at 20
//
//     // C#: size first, then the same pointers to the plugin
//     var data = Mesh.AllocateWritableMeshData(1);
//     data[0].SetVertexBufferParams(vertexCount,
//         new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3, 0),
//         new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.SNorm16, 4, 1),
//         new VertexAttributeDescriptor(VertexAttribute.Tangent, VertexAttributeFormat.SNorm16, 4, 1),
//         new VertexAttributeDescriptor(VertexAttribute.Color, VertexAttributeFormat.UNorm8, 4, 1),
//         new VertexAttributeDescriptor(VertexAttribute.TexCoord0, VertexAttributeFormat.Float16, 2, 1));
//     data[0].SetIndexBufferParams(indexCount, IndexFormat.UInt16);
//     Write(data[0].GetVertexData<byte>(0).GetUnsafePtr(), data[0].GetVertexData<byte>(1).GetUnsafePtr(), ...);
//     data[0].subMeshCount = partCount;                       // plan.parts(): front, back, side, bevels if there are any
//     for (...) data[0].SetSubMesh(i, new SubMeshDescriptor(firstIndex, indexCount));       // plan.range(part)
//
// The bounds must be set by the caller (MeshUpdateFlags.DontRecalculateBounds): plan.bounds().

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/colour.hpp>
#include <typemesh/vertex/computed_stream.hpp>
#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/normalised.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace engines::unity {

/// The pointers of one Mesh.MeshData, as spans over what GetVertexData<byte> and GetIndexData<byte> return.
struct mesh_data {
    std::span<std::byte> stream0;
    std::span<std::byte> stream1;
    std::span<std::byte> indices;
    bool wide = false;  ///< IndexFormat.UInt32; else UInt16, and 65,535 vertices at most
};

struct snorm16x4 {
    typemesh::snorm16 x, y, z, w = 0.0f;
};
struct half2 {
    typemesh::half u, v;
};
inline constexpr std::size_t stream0_bytes = 12, stream1_bytes = 24;
static_assert(sizeof(snorm16x4) == 8 && sizeof(half2) == 4);

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::left_handed_y_up;
    o.frame.uv = typemesh::uv_origin::bottom_left;
    return o;
}

/// Writes a plan; `colours` has one for each part, all of them white by default.
template <class Plan>
[[nodiscard]] typemesh::result<void> write(const Plan& plan, const mesh_data& to,
                                           const typemesh::part_colours<>& colours = {
                                               {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}) noexcept
{
    using namespace typemesh;
    struct float3 {
        float x, y, z;
    };
    const auto into_indices = [&]<class Index>(std::span<Index> indices) noexcept {
        return plan.write(
            stream_sink{indices, stream<attribute::position, float3>::in(to.stream0, 0, stream0_bytes),
                        stream<attribute::normal, snorm16x4>::in(to.stream1, 0, stream1_bytes),
                        stream<attribute::tangent, snorm16x4>::in(to.stream1, 8, stream1_bytes),
                        computed_stream<attribute::part, rgba8>(
                            to.stream1, 16, stream1_bytes,
                            [colours](const surface_point<attribute::part>& s) noexcept { return colours(s.part); }),
                        stream<attribute::uv, half2>::in(to.stream1, 20, stream1_bytes)});
    };
    if (to.wide)
        return into_indices(std::span{reinterpret_cast<std::uint32_t*>(to.indices.data()), to.indices.size() / 4});
    return into_indices(std::span{reinterpret_cast<std::uint16_t*>(to.indices.data()), to.indices.size() / 2});
}

}  // namespace engines::unity
