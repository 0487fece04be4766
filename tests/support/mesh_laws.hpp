// SPDX-License-Identifier: MIT
#pragma once

// Laws that every mesh must obey, on plain arrays as a user holds them.

#include <typemesh/core/point.hpp>
#include <typemesh/vertex/vertex_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <unordered_map>
#include <utility>
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

struct closedness {
    std::size_t unmatched_edges = 0;   ///< directed edges not met by their reverse equally often
    std::size_t crowded_edges = 0;     ///< undirected edges with more than two faces
    std::size_t crowded_slanted = 0;   ///< those among them that are not parallel to the depth
    std::size_t zero_area = 0;         ///< triangles with two equal corners after welding
};

/// Welds vertices with equal positions and matches the edges of some triangles.
///
/// `depth_axis` tells along which coordinate (0, 1, 2) the text is extruded.
inline closedness examine(std::span<const full_vertex> vertices, std::span<const std::uint32_t> indices,
                          int depth_axis = 2)
{
    struct key {
        std::uint32_t x, y, z;
        bool operator==(const key&) const = default;
    };
    struct hash {
        std::size_t operator()(const key& k) const
        {
            return (k.x * 0x9E3779B97F4A7C15ull) ^ (k.y * 0xC2B2AE3D27D4EB4Full) ^ (k.z * 0x165667B19E3779F9ull);
        }
    };
    const auto bits = [](float f) {
        f += 0.0f;  // -0 and 0 are one place
        std::uint32_t b;
        std::memcpy(&b, &f, sizeof b);
        return b;
    };
    std::unordered_map<key, std::uint32_t, hash> places;
    std::vector<std::uint32_t> place_of(vertices.size(), ~0u);
    std::vector<typemesh::vec3> at;
    for (const std::uint32_t i : indices) {
        if (place_of[i] != ~0u) continue;
        const typemesh::vec3 p = vertices[i].position;
        const auto [found, fresh] =
            places.try_emplace(key{bits(p.x), bits(p.y), bits(p.z)}, static_cast<std::uint32_t>(at.size()));
        if (fresh) at.push_back(p);
        place_of[i] = found->second;
    }
    closedness result;
    std::vector<std::uint64_t> edges;
    edges.reserve(indices.size());
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::uint32_t t[3] = {place_of[indices[i]], place_of[indices[i + 1]], place_of[indices[i + 2]]};
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) ++result.zero_area;
        for (int k = 0; k < 3; ++k) edges.push_back(std::uint64_t{t[k]} << 32 | t[(k + 1) % 3]);
    }
    std::sort(edges.begin(), edges.end());
    const auto count = [&](std::uint64_t e) {
        const auto range = std::equal_range(edges.begin(), edges.end(), e);
        return range.second - range.first;
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        if (i > 0 && edges[i] == edges[i - 1]) continue;
        const std::uint64_t reverse = edges[i] << 32 | edges[i] >> 32;
        const auto here = count(edges[i]), back = count(reverse);
        if (here != back) result.unmatched_edges += static_cast<std::size_t>(here > back ? here - back : 0);
        if (here > 1 && edges[i] < reverse) {
            ++result.crowded_edges;
            const typemesh::vec3 a = at[edges[i] >> 32], b = at[edges[i] & 0xFFFF'FFFFu];
            const bool moves[3] = {a.x != b.x, a.y != b.y, a.z != b.z};
            for (int k = 0; k < 3; ++k)
                if (k != depth_axis && moves[k]) {
                    ++result.crowded_slanted;
                    break;
                }
        }
    }
    return result;
}

inline closedness examine(const full_mesh& m, int depth_axis = 2) { return examine(m.vertices, m.indices, depth_axis); }

/// The volume that a closed mesh encloses; negative when it is inside out (in a right-handed frame).
inline double volume(std::span<const full_vertex> vertices, std::span<const std::uint32_t> indices)
{
    double sum = 0.0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const typemesh::vec3 a = vertices[indices[i]].position, b = vertices[indices[i + 1]].position,
                             c = vertices[indices[i + 2]].position;
        sum += cross_product(b, c).along(a) / 6.0;
    }
    return sum;
}

}  // namespace test

template <>
struct typemesh::vertex_traits<test::full_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    test::full_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};
