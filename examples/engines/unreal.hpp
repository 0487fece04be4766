// SPDX-License-Identifier: MIT
#pragma once

// Unreal Engine: the vertex buffers of a static mesh's level of detail (position, tangent basis, texture coordinates,
// colour, each in its own buffer) and its indices. Left-handed, z up, centimetres; text runs along +y and faces -x, so
// that a camera that looks along +x reads it. v downwards, normal maps with green down: TangentY points where v grows.
//
// Winding: Epic's page on face winding says that the cross product of consecutive vertices opposes the normal; so
// frame::winding is -1 here.
//
// Include StaticMeshResources.h first.
//
//     auto plan = mesher.plan(text_view{text}, engines::unreal::options(100.0));        // an em is a metre
//     engines::unreal::write(*plan, LODResources.VertexBuffers, indices);               // TArray<uint32>
//     LODResources.IndexBuffer.SetIndices(indices, EIndexBufferStride::AutoDetect);
//     // LODResources.Sections: one FStaticMeshSection for each of plan->parts(), FirstIndex and NumTriangles from
//     // plan->range(part)

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <cstdint>
#include <type_traits>

namespace engines::unreal {

[[nodiscard]] inline typemesh::text_options options(double centimetres_per_em) noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::left_handed_z_up;
    o.frame.winding = -1;
    o.unit = typemesh::output_unit::pixels;
    o.pixels_per_em = centimetres_per_em;
    return o;
}

/// A sink over FStaticMeshVertexBuffers, through their setters. Indices is a TArray of uint32 or uint16.
template <class Buffers, class Indices>
class static_mesh_sink {
public:
    static constexpr auto wants = typemesh::attribute::position | typemesh::attribute::normal |
                                  typemesh::attribute::tangent | typemesh::attribute::uv;

    static_mesh_sink(Buffers& buffers, Indices& indices) noexcept : buffers_{&buffers}, indices_{&indices} {}

    typemesh::error begin(typemesh::mesh_size exact) noexcept
    {
        using number = typename Indices::ElementType;
        if (exact.indices() > 0x7FFF'FFFFu) return typemesh::error::too_large;  // TArray counts with int32
        if (sizeof(number) == 2 && exact.vertices > 0xFFFF) return {typemesh::error::index_overflow, exact.vertices};
        buffers_->PositionVertexBuffer.Init(static_cast<std::uint32_t>(exact.vertices));
        buffers_->StaticMeshVertexBuffer.Init(static_cast<std::uint32_t>(exact.vertices), 1);
        indices_->SetNumUninitialized(static_cast<std::int32_t>(exact.indices()));
        next_vertex_ = 0;
        next_index_ = indices_->GetData();
        return {};
    }
    void vertex(const typemesh::surface_point<wants>& s) noexcept
    {
        using vector = std::remove_reference_t<decltype(buffers_->PositionVertexBuffer.VertexPosition(0))>;
        using vector2 = std::remove_cvref_t<decltype(buffers_->StaticMeshVertexBuffer.GetVertexUV(0, 0))>;
        const typemesh::vec3 n = s.normal;
        const typemesh::vec4 t = s.tangent;
        const vector x{t.x, t.y, t.z}, z{n.x, n.y, n.z};
        const vector y{t.w * (n.y * t.z - n.z * t.y), t.w * (n.z * t.x - n.x * t.z), t.w * (n.x * t.y - n.y * t.x)};
        buffers_->PositionVertexBuffer.VertexPosition(next_vertex_) = vector{s.position.x, s.position.y, s.position.z};
        buffers_->StaticMeshVertexBuffer.SetVertexTangents(next_vertex_, x, y, z);
        buffers_->StaticMeshVertexBuffer.SetVertexUV(next_vertex_, 0, vector2{s.uv.x, s.uv.y});
        ++next_vertex_;
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        using number = typename Indices::ElementType;
        for (const std::uint32_t i : {a, b, c}) *next_index_++ = static_cast<number>(i);
    }
    void end() noexcept {}

private:
    Buffers* buffers_;
    Indices* indices_;
    std::uint32_t next_vertex_ = 0;
    typename Indices::ElementType* next_index_ = nullptr;
};

template <class Plan, class Buffers, class Indices>
[[nodiscard]] typemesh::result<void> write(const Plan& plan, Buffers& buffers, Indices& indices) noexcept
{
    return plan.write(static_mesh_sink<Buffers, Indices>{buffers, indices});
}

}  // namespace engines::unreal
