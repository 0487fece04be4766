// SPDX-License-Identifier: MIT
#pragma once

// Direct3D 11 (and 12, whose input elements are the same): the vertex of 32 bytes, and one of 28 with a tangent as
// well, written into mapped buffers. Left-handed, y up; front faces clockwise as the viewer sees them
// (FrontCounterClockwise = FALSE, the default); v downwards, normal maps with green down: bitangent = w * cross(normal,
// tangent).
//
// Include <d3d11.h> first.
//
//     D3D11_MAPPED_SUBRESOURCE v, i;                  // dynamic buffers: Map(..., D3D11_MAP_WRITE_DISCARD, 0, &v)
//     if (const auto written = engines::direct3d11::fill<engines::direct3d11::packed_vertex>(
//             *plan, v.pData, vertex_bytes, i.pData, index_bytes, DXGI_FORMAT_R32_UINT); !written) return written.error();

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/normalised.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace engines::direct3d11 {

struct vertex {
    float position[3];
    float normal[3];
    float uv[2];
};
static_assert(sizeof(vertex) == 32);

inline constexpr D3D11_INPUT_ELEMENT_DESC layout[] = {
    {"POSITION", 0, DXGI_FORMAT_R32G32B32_FLOAT, 0, 0, D3D11_INPUT_PER_VERTEX_DATA, 0},
    {"NORMAL", 0, DXGI_FORMAT_R32G32B32_FLOAT, 0, 12, D3D11_INPUT_PER_VERTEX_DATA, 0},
    {"TEXCOORD", 0, DXGI_FORMAT_R32G32_FLOAT, 0, 24, D3D11_INPUT_PER_VERTEX_DATA, 0},
};

/// Normals and tangents to 1/127; texture coordinates to 1/2048 of a tile within [0, 1], 1/512 up to 4.
struct packed_vertex {
    float position[3];
    typemesh::snorm8 normal[4];
    typemesh::snorm8 tangent[4];
    typemesh::half uv[2];
    std::uint32_t cluster;  ///< position in the text, for colouring or picking
};
static_assert(sizeof(packed_vertex) == 28);

inline constexpr D3D11_INPUT_ELEMENT_DESC packed_layout[] = {
    {"POSITION", 0, DXGI_FORMAT_R32G32B32_FLOAT, 0, 0, D3D11_INPUT_PER_VERTEX_DATA, 0},
    {"NORMAL", 0, DXGI_FORMAT_R8G8B8A8_SNORM, 0, 12, D3D11_INPUT_PER_VERTEX_DATA, 0},
    {"TANGENT", 0, DXGI_FORMAT_R8G8B8A8_SNORM, 0, 16, D3D11_INPUT_PER_VERTEX_DATA, 0},
    {"TEXCOORD", 0, DXGI_FORMAT_R16G16_FLOAT, 0, 20, D3D11_INPUT_PER_VERTEX_DATA, 0},
    {"CLUSTER", 0, DXGI_FORMAT_R32_UINT, 0, 24, D3D11_INPUT_PER_VERTEX_DATA, 0},
};

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::left_handed_y_up;
    return o;
}

}  // namespace engines::direct3d11

template <>
struct typemesh::vertex_traits<engines::direct3d11::vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    engines::direct3d11::vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}, {s.uv.x, s.uv.y}};
    }
};

template <>
struct typemesh::vertex_traits<engines::direct3d11::packed_vertex> {
    static constexpr auto wants =
        attribute::position | attribute::normal | attribute::tangent | attribute::uv | attribute::cluster;
    engines::direct3d11::packed_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z},
                {s.normal.x, s.normal.y, s.normal.z, 0.0f},
                {s.tangent.x, s.tangent.y, s.tangent.z, s.tangent.w},
                {s.uv.x, s.uv.y},
                s.cluster};
    }
};

namespace engines::direct3d11 {

/// Writes a plan into mapped memory of so many bytes; format is DXGI_FORMAT_R16_UINT or DXGI_FORMAT_R32_UINT.
template <class Vertex, class Plan>
[[nodiscard]] typemesh::result<void> fill(const Plan& plan, void* vertices, std::size_t vertex_bytes, void* indices,
                                          std::size_t index_bytes, DXGI_FORMAT format) noexcept
{
    const std::span where{static_cast<Vertex*>(vertices), vertex_bytes / sizeof(Vertex)};
    if (format == DXGI_FORMAT_R16_UINT) {
        return plan.write(typemesh::into(where, std::span{static_cast<std::uint16_t*>(indices), index_bytes / 2}));
    }
    return plan.write(typemesh::into(where, std::span{static_cast<std::uint32_t*>(indices), index_bytes / 4}));
}

}  // namespace engines::direct3d11
