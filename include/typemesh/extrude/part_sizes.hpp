// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/mesh_sink.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One number for each part.
struct part_counts {
    std::uint32_t of[max_parts] = {};  ///< the numbers, indexed by the part's number

    [[nodiscard]] constexpr std::uint32_t operator[](part p) const noexcept { return of[number_of(p)]; }
    [[nodiscard]] constexpr std::uint32_t& operator[](part p) noexcept { return of[number_of(p)]; }

    /// Adds part by part, modulo 2^32.
    friend constexpr part_counts operator+(const part_counts& a, const part_counts& b) noexcept
    {
        part_counts sum;
        for (std::size_t i = 0; i < max_parts; ++i) sum.of[i] = a.of[i] + b.of[i];
        return sum;
    }
    friend constexpr part_counts operator-(const part_counts& a, const part_counts& b) noexcept
    {
        part_counts rest;
        for (std::size_t i = 0; i < max_parts; ++i) rest.of[i] = a.of[i] - b.of[i];
        return rest;
    }
    friend constexpr bool operator==(const part_counts&, const part_counts&) noexcept = default;

    /// The sum over all parts.
    [[nodiscard]] constexpr std::uint64_t total() const noexcept
    {
        std::uint64_t sum = 0;
        for (const std::uint32_t count : of) sum += count;
        return sum;
    }

    /// The start of each part if the parts are consecutive and the first begins at `first`; modulo 2^32.
    [[nodiscard]] constexpr part_counts starts(std::uint32_t first = 0) const noexcept
    {
        part_counts begin;
        for (std::size_t i = 0; i < max_parts; first += of[i++]) begin.of[i] = first;
        return begin;
    }

private:
    static constexpr std::size_t number_of(part p) noexcept
    {
        TYPEMESH_ASSERT(static_cast<std::size_t>(p) < max_parts, "there are only eight parts: use 0 to 7");
        return static_cast<std::size_t>(p);
    }
};

/// The numbers of vertices and triangles of a solid in each part.
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

    /// The size of all parts together.
    [[nodiscard]] constexpr mesh_size total() const noexcept { return {vertices.total(), triangles.total()}; }

    /// The start of each part if the parts are consecutive from 0.
    [[nodiscard]] constexpr part_sizes starts() const noexcept { return {vertices.starts(), triangles.starts()}; }

    /// The range of one part if the parts are consecutive from a given position.
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

}  // namespace typemesh::inline TYPEMESH_ABI
