// SPDX-License-Identifier: MIT
#pragma once

// Direct3D 9: vertices of 32 bytes (position, normal, texture coordinates) and indices of 16 or 32 bits, straight into
// locked buffers. Left-handed, y up, front faces clockwise as the viewer sees them (D3DCULL_CCW, the default).
//
// Include <d3d9.h> first.
//
//     auto plan = mesher.plan("Hello world!", engines::direct3d9::options());
//     device->CreateVertexBuffer(UINT(32 * plan->size().vertices), D3DUSAGE_WRITEONLY, engines::direct3d9::fvf, D3DPOOL_DEFAULT, &vb, nullptr);
//     device->CreateIndexBuffer(UINT(2 * plan->size().indices()), D3DUSAGE_WRITEONLY, D3DFMT_INDEX16, D3DPOOL_DEFAULT, &ib, nullptr);
//     if (const auto written = engines::direct3d9::fill(*plan, *vb, *ib); !written) return written.error();

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/array_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace engines::direct3d9 {

struct vertex {
    float x, y, z;
    float nx, ny, nz;
    float tu, tv;
};
static_assert(sizeof(vertex) == 32);

inline constexpr DWORD fvf = D3DFVF_XYZ | D3DFVF_NORMAL | D3DFVF_TEX1;

/// The same as a vertex declaration.
inline constexpr D3DVERTEXELEMENT9 declaration[] = {
    {0, 0, D3DDECLTYPE_FLOAT3, D3DDECLMETHOD_DEFAULT, D3DDECLUSAGE_POSITION, 0},
    {0, 12, D3DDECLTYPE_FLOAT3, D3DDECLMETHOD_DEFAULT, D3DDECLUSAGE_NORMAL, 0},
    {0, 24, D3DDECLTYPE_FLOAT2, D3DDECLMETHOD_DEFAULT, D3DDECLUSAGE_TEXCOORD, 0},
    {0xFF, 0, D3DDECLTYPE_UNUSED, 0, 0, 0},  // D3DDECL_END()
};

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::left_handed_y_up;
    return o;
}

}  // namespace engines::direct3d9

template <>
struct typemesh::vertex_traits<engines::direct3d9::vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    engines::direct3d9::vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z, s.uv.x, s.uv.y};
    }
};

namespace engines::direct3d9 {

/// Writes a plan into two buffers; their sizes and the format of the indices are their own.
///
/// Fails  as array_sink does; error::refused_by_user if a buffer cannot be locked. Nothing is written then.
template <class Plan>
[[nodiscard]] typemesh::result<void> fill(const Plan& plan, IDirect3DVertexBuffer9& vertices,
                                          IDirect3DIndexBuffer9& indices) noexcept
{
    D3DVERTEXBUFFER_DESC vertices_are{};
    D3DINDEXBUFFER_DESC indices_are{};
    if (vertices.GetDesc(&vertices_are) < 0 || indices.GetDesc(&indices_are) < 0)
        return typemesh::error::refused_by_user;
    void *vertices_at = nullptr, *indices_at = nullptr;
    if (vertices.Lock(0, 0, &vertices_at, 0) < 0) return typemesh::error::refused_by_user;
    if (indices.Lock(0, 0, &indices_at, 0) < 0) {
        (void)vertices.Unlock();
        return typemesh::error::refused_by_user;
    }
    const std::span where{static_cast<vertex*>(vertices_at), vertices_are.Size / sizeof(vertex)};
    const auto write = [&]<class Index>(Index* at) noexcept {
        return plan.write(typemesh::into(where, std::span{at, indices_are.Size / sizeof(Index)}));
    };
    const auto written = indices_are.Format == D3DFMT_INDEX16 ? write(static_cast<std::uint16_t*>(indices_at))
                                                              : write(static_cast<std::uint32_t*>(indices_at));
    (void)indices.Unlock();
    (void)vertices.Unlock();
    return written;
}

}  // namespace engines::direct3d9
