// SPDX-License-Identifier: MIT
#pragma once

// Meshes in plain arrays, as a user stores them, and their laws.

#include <typemesh/core/point.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/vertex/vertex_traits.hpp>

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace test {

/// A vertex with everything.
struct full_vertex {
    typemesh::vec3 position, normal;
    typemesh::vec2 uv;
};

/// A mesh as a user holds it.
struct full_mesh {
    std::vector<full_vertex> vertices;
    std::vector<std::uint32_t> indices;
};

inline typemesh::vec3 subtract(typemesh::vec3 a, typemesh::vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline double dot(typemesh::vec3 a, typemesh::vec3 b)
{
    return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
}

/// The cross product in double precision, as three doubles.
struct cross_product {
    double x, y, z;
    cross_product(typemesh::vec3 a, typemesh::vec3 b)
        : x{double(a.y) * b.z - double(a.z) * b.y},
          y{double(a.z) * b.x - double(a.x) * b.z},
          z{double(a.x) * b.y - double(a.y) * b.x}
    {
    }
    [[nodiscard]] double along(typemesh::vec3 n) const { return x * n.x + y * n.y + z * n.z; }
    [[nodiscard]] double length() const { return std::sqrt(x * x + y * y + z * z); }
};

using typemesh::inspect::closedness;

/// Whether triangles are closed, with vertices at equal positions welded.
inline closedness examine(std::span<const full_vertex> vertices, std::span<const std::uint32_t> indices,
                          int depth_axis = 2)
{
    return check_closedness(typemesh::inspect::mesh_view{vertices, indices}, depth_axis);
}
inline closedness examine(const full_mesh& m, int depth_axis = 2) { return examine(m.vertices, m.indices, depth_axis); }

/// The volume inside a closed mesh; negative if it is inside out (in a right-handed frame).
inline double volume(std::span<const full_vertex> vertices, std::span<const std::uint32_t> indices)
{
    return measure(typemesh::inspect::mesh_view{vertices, indices}).volume;
}

}  // namespace test

template <>
struct typemesh::vertex_traits<test::full_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    test::full_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};
