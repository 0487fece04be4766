// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/vertex/surface_point.hpp>

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// The exact size of a mesh; both numbers are below 2^32 in every mesh that is written.
struct mesh_size {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;

    [[nodiscard]] constexpr std::uint64_t indices() const noexcept { return 3 * triangles; }
    /// Whether 32 bits can number its vertices and its indices.
    [[nodiscard]] constexpr bool fits_32_bits() const noexcept
    {
        return vertices <= 0xFFFF'FFFFu && indices() <= 0xFFFF'FFFFu;
    }
    friend constexpr mesh_size operator+(const mesh_size& a, const mesh_size& b) noexcept
    {
        return {a.vertices + b.vertices, a.triangles + b.triangles};
    }
    friend constexpr bool operator==(const mesh_size&, const mesh_size&) noexcept = default;
};

namespace detail {
template <class T>
concept nothing_or_error = std::same_as<T, void> || std::same_as<T, error>;
}  // namespace detail

/// A destination for finished geometry: two arrays, a mapped GPU buffer, a file.
///
///     S::wants             the attributes that it wants
///     s.begin(exact)       comes first, with the exact sizes; if it fails, nothing else is called
///     s.vertex(p)          exactly exact.vertices times: vertex 0, 1, 2, ...; p is a surface_point<S::wants>
///     s.triangle(a, b, c)  exactly exact.triangles times, after all vertices: numbers below exact.vertices
///     s.end()              comes last; returns nothing or an error, for example error::not_written
template <class S>
concept mesh_sink = requires(S& s, mesh_size exact, const surface_point<S::wants>& p, std::uint32_t v) {
    { S::wants } -> std::convertible_to<attribute>;
    { s.begin(exact) } noexcept -> std::same_as<error>;
    { s.vertex(p) } noexcept;
    { s.triangle(v, v, v) } noexcept;
    { s.end() } noexcept -> detail::nothing_or_error;
};

/// Ends a sink, whichever form its end() has.
template <mesh_sink S>
error end_of(S& s) noexcept
{
    if constexpr (std::same_as<decltype(s.end()), error>)
        return s.end();
    else
        return s.end(), error{};
}

/// An array or a container of the caller, passed where a sink is needed.
template <class A>
concept array_without_sink =
    !mesh_sink<std::remove_reference_t<A>> && (std::is_array_v<std::remove_reference_t<A>> || requires(A& a) {
        a.data();
        a.size();
    });

/// Makes the compiler report a forgotten into() in one sentence. It is for overloads that take arrays where a sink is
/// needed.
template <class A>
constexpr error refuse_arrays() noexcept
{
    static_assert(sizeof(A) == 0,
                  "typemesh: vertices and indices go together into one sink: "
                  "`into(vertices, indices)`, of two std::vector or two std::span.");
    return error::bad_option;
}

}  // namespace typemesh::inline TYPEMESH_ABI
