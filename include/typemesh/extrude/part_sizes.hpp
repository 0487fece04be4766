// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh {

/// One number for each part.
struct part_counts {
    std::uint32_t of[3] = {};

    [[nodiscard]] constexpr std::uint32_t operator[](part p) const noexcept { return of[static_cast<std::size_t>(p)]; }
    [[nodiscard]] constexpr std::uint32_t& operator[](part p) noexcept { return of[static_cast<std::size_t>(p)]; }

    /// Part by part, modulo 2^32.
    friend constexpr part_counts operator+(const part_counts& a, const part_counts& b) noexcept
    {
        return {{a.of[0] + b.of[0], a.of[1] + b.of[1], a.of[2] + b.of[2]}};
    }
    friend constexpr part_counts operator-(const part_counts& a, const part_counts& b) noexcept
    {
        return {{a.of[0] - b.of[0], a.of[1] - b.of[1], a.of[2] - b.of[2]}};
    }
    friend constexpr bool operator==(const part_counts&, const part_counts&) noexcept = default;

    /// All parts together.
    [[nodiscard]] constexpr std::uint64_t total() const noexcept { return std::uint64_t{of[0]} + of[1] + of[2]; }

    /// Where each part begins when the parts lie behind one another, the first at `first`; modulo 2^32.
    [[nodiscard]] constexpr part_counts starts(std::uint32_t first = 0) const noexcept
    {
        return {{first, first + of[0], first + of[0] + of[1]}};
    }
};

/// How many vertices and triangles a shape gives to each part.
struct part_sizes {
    part_counts vertices;
    part_counts triangles;

    friend constexpr part_sizes operator+(const part_sizes& a, const part_sizes& b) noexcept
    {
        return {a.vertices + b.vertices, a.triangles + b.triangles};
    }
    friend constexpr part_sizes operator-(const part_sizes& a, const part_sizes& b) noexcept
    {
        return {a.vertices - b.vertices, a.triangles - b.triangles};
    }
    friend constexpr bool operator==(const part_sizes&, const part_sizes&) noexcept = default;

    /// All parts together.
    [[nodiscard]] constexpr mesh_size total() const noexcept { return {vertices.total(), triangles.total()}; }

    /// Where each part begins when the parts lie behind one another from 0 on.
    [[nodiscard]] constexpr part_sizes starts() const noexcept { return {vertices.starts(), triangles.starts()}; }

    /// Where one part lies when the parts lie behind one another, from a place on that is given.
    ///
    ///     vertices    [ ... | front | back | side ]       indices likewise; total().fits_32_bits() must hold
    ///                  first ^
    [[nodiscard]] constexpr mesh_range range(part p, std::uint32_t first_vertex = 0,
                                             std::uint32_t first_index = 0) const noexcept
    {
        const part_sizes at = starts();
        return {first_vertex + at.vertices[p], vertices[p], first_index + 3 * at.triangles[p], 3 * triangles[p]};
    }
};

}  // namespace typemesh
