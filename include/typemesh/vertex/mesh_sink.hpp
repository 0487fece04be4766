// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh {

/// How much a mesh holds, exactly. Both stay below 2^32.
struct mesh_size {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;

    [[nodiscard]] constexpr std::uint64_t indices() const noexcept { return 3 * triangles; }
    friend constexpr bool operator==(const mesh_size&, const mesh_size&) noexcept = default;
};

/// Where finished geometry goes: two arrays, a mapped GPU buffer, a file.
///
///     S::wants             the attributes it takes
///     s.begin(exact)       comes first, with the exact sizes; it alone can fail, and then nothing else is called
///     s.vertex(p)          exactly exact.vertices times: vertex 0, 1, 2, ...; p is a surface_point<S::wants>
///     s.triangle(a, b, c)  exactly exact.triangles times, after all vertices: numbers below exact.vertices
///     s.end()              comes last
template <class S>
concept mesh_sink = requires(S& s, mesh_size exact, const surface_point<S::wants>& p, std::uint32_t v) {
    { S::wants } -> std::convertible_to<attribute>;
    { s.begin(exact) } noexcept -> std::same_as<error>;
    { s.vertex(p) } noexcept;
    { s.triangle(v, v, v) } noexcept;
    { s.end() } noexcept;
};

/// A sink over memory that already holds a mesh, and that can write a stretch of it anew: begin_at() in place of begin().
///
///     s.begin_at(whole, first_vertex, first_index)   what follows goes to these places of a mesh of that size, for which
///                                                    the memory must have room; vertices, then triangles, then end(), as
///                                                    many as the caller knows there are
template <class S>
concept patching_sink = mesh_sink<S> && requires(S& s, mesh_size whole, std::uint32_t first) {
    { s.begin_at(whole, first, first) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh
