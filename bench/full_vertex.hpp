// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/vertex_traits.hpp>

namespace bench {

/// The vertex of 32 bytes that benchmarks write: position, normal, texture coordinates.
struct full_vertex {
    typemesh::vec3 position, normal;
    typemesh::vec2 uv;
};
static_assert(sizeof(full_vertex) == 32);

}  // namespace bench

template <>
struct typemesh::vertex_traits<bench::full_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    bench::full_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};
