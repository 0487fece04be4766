// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/vertex_traits.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The vertex of D3DXCreateText's meshes: D3DFVF_XYZ | D3DFVF_NORMAL, 24 bytes.
struct d3dx_vertex {
    vec3 position;
    vec3 normal;
};
static_assert(sizeof(d3dx_vertex) == 24);

/// The vertex of D3DXCreateText's meshes with texture coordinates, v = 0 at the top: D3DFVF_XYZ | D3DFVF_NORMAL |
/// D3DFVF_TEX1, 32 bytes.
struct d3dx_textured_vertex {
    vec3 position;
    vec3 normal;
    vec2 uv;
};
static_assert(sizeof(d3dx_textured_vertex) == 32);

/// Writes position and normal.
template <>
struct vertex_traits<d3dx_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal;
    d3dx_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal}; }
};

/// Writes position, normal and texture coordinates.
template <>
struct vertex_traits<d3dx_textured_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    d3dx_textured_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal, s.uv};
    }
};

static_assert(mesh_vertex<d3dx_vertex> && mesh_vertex<d3dx_textured_vertex>);

}  // namespace typemesh::inline TYPEMESH_ABI
