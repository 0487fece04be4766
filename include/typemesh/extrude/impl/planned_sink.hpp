// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/extrude/solid.hpp>
#include <typemesh/vertex/bounds3.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A sink between an extruder and the real sink, for the vertices of one part of a solid. It counts them, discards more
/// than were planned, so that no sink is written past its end, and checks their positions. Without asserts it only
/// forwards them.
template <mesh_sink Sink>
struct planned_vertices {
    static constexpr attribute wants = Sink::wants;

    Sink& sink;
    std::uint32_t planned;
    bounds3 bounds = {};  ///< filled in builds with asserts
    std::uint32_t emitted = 0;

    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>& v) noexcept
    {
        if constexpr (has(wants, attribute::position)) {
            TYPEMESH_ASSERT(bounds.holds(v.position), "an extruder emitted a vertex outside the bounds that it states");
        }
        bool due = true;
        TYPEMESH_ASSERT((due = emitted++ < planned),
                        "an extruder emitted more vertices of a part than its plan() reported");
        if (due) sink.vertex(v);
    }
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
    void end() noexcept {}
};

/// The same for the triangles of one part, whose corners must be vertices of the solid.
template <mesh_sink Sink>
struct planned_triangles {
    static constexpr attribute wants = Sink::wants;

    Sink& sink;
    const part_sizes& sizes;
    const first_vertices& first;
    std::uint32_t planned;
    std::uint32_t emitted = 0;

    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>&) noexcept {}
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        bool due = true;
        TYPEMESH_ASSERT((due = emitted++ < planned),
                        "an extruder emitted more triangles of a part than its plan() reported");
        if (!due) return;
        TYPEMESH_ASSERT((due = numbers(a) && numbers(b) && numbers(c)),
                        "an extruder emitted a triangle with a corner that is not a vertex of its solid");
        if (due) sink.triangle(a, b, c);
    }
    void end() noexcept {}

    /// Whether a number belongs to a vertex of the solid.
    [[nodiscard]] bool numbers(std::uint32_t v) const noexcept
    {
        for (const part p : all_parts)
            if (v - first[p] < sizes.vertices[p]) return true;  // below first[p] the difference wraps
        return false;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
