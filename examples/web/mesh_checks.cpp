// SPDX-License-Identifier: MIT
#include "mesh_checks.hpp"

#include <typemesh/inspect/closedness.hpp>

#include <algorithm>
#include <span>

namespace typemesh_web {
namespace {

struct place {
    float x, y, z;
};

/// The mesh with some of its triangles.
auto view_of(const mesh_arrays& mesh, std::span<const std::uint32_t> index)
{
    static_assert(sizeof(place) == 3 * sizeof(float));
    const auto* places = reinterpret_cast<const place*>(mesh.position.data());
    return typemesh::inspect::mesh_view{std::span{places, mesh.vertices()}, index};
}

bool is_seen_from_front(std::uint32_t name, bool letter) { return letter ? name == 5 : name == 0 || name == 3; }

}  // namespace

std::uint32_t open_edges(const mesh_arrays& mesh)
{
    const auto found = typemesh::inspect::check_closedness(view_of(mesh, mesh.index.view()));
    return static_cast<std::uint32_t>(found.unmatched_edges);
}

void contours_of(const mesh_arrays& mesh, std::vector<float>& segments)
{
    segments.clear();
    for (const bool letter : {false, true}) {
        std::vector<std::uint32_t> index;
        for (const web_part& p : mesh.parts) {
            if (!is_seen_from_front(p.name, letter)) continue;
            const auto* first = mesh.index.data() + p.first_index;
            index.insert(index.end(), first, first + p.index_count);
        }
        const auto places = typemesh::inspect::weld(view_of(mesh, index));
        std::vector<std::uint64_t> edges;  // from << 32 | to
        for (std::size_t i = 0; i < index.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            edges.push_back(std::uint64_t{places.of[index[i]]} << 32 | places.of[index[next]]);
        }
        std::sort(edges.begin(), edges.end());
        for (const std::uint64_t edge : edges) {
            if (std::binary_search(edges.begin(), edges.end(), edge << 32 | edge >> 32)) continue;
            for (const std::uint64_t end : {edge >> 32, edge & 0xFFFF'FFFFu}) {
                const auto& at = places.at[static_cast<std::size_t>(end)];
                for (const double v : {at.x, at.y, at.z}) segments.push_back(static_cast<float>(v));
            }
        }
    }
}

std::uint64_t hash_of(const mesh_arrays& mesh)
{
    std::uint64_t hash = 0xCBF2'9CE4'8422'2325u;
    const auto add = [&hash](std::span<const std::byte> bytes) {
        for (const std::byte b : bytes) hash = (hash ^ static_cast<std::uint64_t>(b)) * 0x100'0000'01B3u;
    };
    add(std::as_bytes(std::span{mesh.position.view()}));
    add(std::as_bytes(std::span{mesh.normal.view()}));
    add(std::as_bytes(std::span{mesh.uv.view()}));
    add(std::as_bytes(std::span{mesh.index.view()}));
    return hash;
}

}  // namespace typemesh_web
