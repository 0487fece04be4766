// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/surface_point.hpp>

#include <concepts>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// Makes one of your vertices from a surface point.
///
///     W::wants    the attributes that it wants, known at compile time; no other is computed
///     w(s)        your vertex, from a surface_point<W::wants>; noexcept
///
/// A writer may have state (a colour, a box to quantise to): pass the writer to the sink.
template <class W>
concept vertex_writer = requires(const W& w, const surface_point<W::wants>& s) {
    { W::wants } -> std::convertible_to<attribute>;
    { w(s) } noexcept;
    requires !std::is_void_v<decltype(w(s))>;
};

/// The default writer of a vertex type: specialise it once for your vertex.
///
///     template <>
///     struct typemesh::vertex_traits<my_vertex> {
///         static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
///         my_vertex operator()(const surface_point<wants>& s) const noexcept
///         {
///             return {s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z, s.uv.x, s.uv.y};
///         }
///     };
///     static_assert(typemesh::mesh_vertex<my_vertex>);   // an error then shows here, in your file
template <class Vertex>
struct vertex_traits;

/// A position alone is a ready vertex: `std::vector<vec3>` needs no traits of yours.
template <>
struct vertex_traits<vec3> {
    static constexpr auto wants = attribute::position;
    constexpr vec3 operator()(const surface_point<wants>& s) const noexcept { return s.position; }
};

/// A type with its own vertex_traits.
template <class V>
concept mesh_vertex = vertex_writer<vertex_traits<V>> &&
                      requires(const vertex_traits<V>& w, const surface_point<vertex_traits<V>::wants>& s) {
                          { w(s) } -> std::convertible_to<V>;
                      };

}  // namespace typemesh::inline TYPEMESH_ABI
