// SPDX-License-Identifier: MIT
#pragma once

// The room inspect/ checks the laws that a mesh obeys, for tests of code that uses meshes. Its functions return numbers
// in small structures, which a test compares. They throw nothing themselves and compile without exceptions. Their
// memory comes from std::vector: if it runs out, std::vector throws or, without exceptions, ends the program. The
// functions are plain and independent of the code under test, not fast, and are not part of <typemesh/typemesh.hpp>.

#include <typemesh/core/finite.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// A position or a direction of a mesh, in the mesh's own unit and axes.
struct place {
    double x = 0.0;
    double y = 0.0;
    double z = 0.0;

    friend constexpr place operator-(place a, place b) noexcept { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
};

[[nodiscard]] constexpr double dot(place a, place b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] constexpr place cross(place a, place b) noexcept
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Converts anything with members x, y, z, or otherwise elements [0], [1], [2]: floats or doubles of any library.
template <class Vector>
[[nodiscard]] constexpr place to_place(const Vector& v) noexcept
{
    if constexpr (requires { static_cast<double>(v.x) + static_cast<double>(v.y) + static_cast<double>(v.z); })
        return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
    else
        return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// The default access to a vertex's position: its member `position`, or the vertex itself.
struct position_member {
    template <class Vertex>
    [[nodiscard]] constexpr decltype(auto) operator()(const Vertex& v) const noexcept
    {
        if constexpr (requires { v.position; })
            return (v.position);
        else
            return (v);
    }
};

/// A view of a mesh of triangles: two arrays of the caller, which must outlive the view.
///
///     inspect::mesh_view mesh{vertices, indices};                    // a member `position`, or positions themselves
///     inspect::mesh_view mesh{vertices, indices, &my_vertex::place};
///     inspect::mesh_view mesh{vertices, indices, [](const my_vertex& v) { return unpack(v); }};
///
///     vertices    any array that converts to a std::span, with fewer than 2^32 - 1 vertices
///     indices     three per triangle, of any integer type; one or two extra indices at the end are ignored
///     position    a member or a function; to_place() must accept its result
template <class Vertex, std::integral Index, class Position = position_member>
class mesh_view {
public:
    template <class Vertices, class Indices>
    constexpr mesh_view(const Vertices& vertices, const Indices& indices, Position position = {}) noexcept
        : vertices_{vertices}, indices_{indices}, position_{std::move(position)}
    {
    }

    [[nodiscard]] constexpr std::size_t vertex_count() const noexcept { return vertices_.size(); }
    [[nodiscard]] constexpr std::size_t triangle_count() const noexcept { return indices_.size() / 3; }
    [[nodiscard]] constexpr const Vertex& vertex(std::size_t i) const noexcept { return vertices_[i]; }
    [[nodiscard]] constexpr place position(std::size_t vertex) const noexcept
    {
        return to_place(std::invoke(position_, vertices_[vertex]));
    }

    /// The indices of a triangle's vertices, unchecked: see is_drawable().
    [[nodiscard]] constexpr std::array<std::size_t, 3> corners(std::size_t triangle) const noexcept
    {
        const auto at = [&](std::size_t k) noexcept { return static_cast<std::size_t>(indices_[3 * triangle + k]); };
        return {at(0), at(1), at(2)};
    }

    /// Whether all three are indices of vertices. Negative indices are not.
    [[nodiscard]] constexpr bool has_vertices(const std::array<std::size_t, 3>& corners) const noexcept
    {
        for (const std::size_t v : corners)
            if (v >= vertex_count()) return false;
        return true;
    }

    /// Whether these vertices exist and their positions are finite. Other triangles have no edges, no area and no
    /// normal; structures that count them say so.
    [[nodiscard]] bool is_drawable(const std::array<std::size_t, 3>& corners) const noexcept
    {
        if (!has_vertices(corners)) return false;
        for (const std::size_t v : corners) {
            const place p = position(v);
            if (!is_finite(p.x) || !is_finite(p.y) || !is_finite(p.z)) return false;
        }
        return true;
    }

private:
    std::span<const Vertex> vertices_;
    std::span<const Index> indices_;
    Position position_;
};

namespace detail {
template <class Array>
using element_of = std::remove_cv_t<typename decltype(std::span{std::declval<const Array&>()})::element_type>;
}

template <class Vertices, class Indices>
mesh_view(const Vertices&, const Indices&) -> mesh_view<detail::element_of<Vertices>, detail::element_of<Indices>>;
template <class Vertices, class Indices, class Position>
mesh_view(const Vertices&, const Indices&, Position)
    -> mesh_view<detail::element_of<Vertices>, detail::element_of<Indices>, Position>;

/// The distinct positions of the triangles' vertices: vertices at equal positions share a place. -0 equals 0; other
/// positions are never merged.
struct welded_places {
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;

    std::vector<std::uint32_t> of;  ///< the place of each vertex; `none` if no drawable triangle uses it
    std::vector<place> at;          ///< the places, by x, then y, then z
};

/// Cost   O(vertices), and O(n log n) for the n vertices that triangles use
template <class Vertex, class Index, class Position>
[[nodiscard]] welded_places weld(const mesh_view<Vertex, Index, Position>& mesh)
{
    struct corner {
        place at;
        std::uint32_t vertex;
    };
    const auto comes_before = [](const place& a, const place& b) noexcept {
        if (a.x < b.x || b.x < a.x) return a.x < b.x;
        if (a.y < b.y || b.y < a.y) return a.y < b.y;
        return a.z < b.z;
    };
    welded_places welded;
    welded.of.assign(mesh.vertex_count(), welded_places::none);
    std::vector<corner> used;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto corners = mesh.corners(t);
        if (!mesh.is_drawable(corners)) continue;
        for (const std::size_t v : corners) {
            if (welded.of[v] != welded_places::none) continue;
            welded.of[v] = 0;
            used.push_back({mesh.position(v), static_cast<std::uint32_t>(v)});
        }
    }
    std::sort(used.begin(), used.end(), [&](const corner& a, const corner& b) { return comes_before(a.at, b.at); });
    for (const corner& c : used) {
        if (welded.at.empty() || comes_before(welded.at.back(), c.at)) welded.at.push_back(c.at);
        welded.of[c.vertex] = static_cast<std::uint32_t>(welded.at.size() - 1);
    }
    return welded;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
