// SPDX-License-Identifier: MIT
#include "sewn.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <utility>

namespace text_to_mesh {
namespace {

/// A triangle's edge, and the places of its ends, the smaller first.
struct edge {
    std::array<std::uint32_t, 2> places;
    std::array<std::uint32_t, 2> vertices;
};

/// Numbers the places of the vertices; one where two solids touch has two numbers.
std::vector<std::uint32_t> places_of(const model& mesh)
{
    std::vector<unsigned> solid(mesh.vertices.size());
    for (const model::part& p : mesh.parts)
        for (std::size_t i = 0; i < p.index_count; ++i) solid[mesh.indices[p.first_index + i]] = p.solid;
    std::map<std::pair<unsigned, std::array<float, 3>>, std::uint32_t> seen;
    std::vector<std::uint32_t> places;
    places.reserve(mesh.vertices.size());
    for (const model_vertex& v : mesh.vertices) {
        const std::array<float, 3> at{v.position[0], v.position[1], v.position[2]};
        const std::pair place{solid[places.size()], at};
        places.push_back(seen.emplace(place, static_cast<std::uint32_t>(seen.size())).first->second);
    }
    return places;
}

std::vector<edge> edges_of(const model& mesh)
{
    const std::vector<std::uint32_t> places = places_of(mesh);
    std::vector<edge> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        for (std::size_t i = 0; i < 3; ++i) {
            std::uint32_t a = mesh.indices[t + i], b = mesh.indices[t + (i + 1) % 3];
            if (places[b] < places[a]) std::swap(a, b);
            edges.push_back({{places[a], places[b]}, {a, b}});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const edge& a, const edge& b) { return a.places < b.places; });
    return edges;
}

}  // namespace

std::vector<std::uint32_t> sewn_vertices(const model& mesh)
{
    std::vector<std::uint32_t> first(mesh.vertices.size());  // a vertex that each has become one with
    std::iota(first.begin(), first.end(), 0u);
    const auto found = [&](std::uint32_t v) {
        while (first[v] != v) v = first[v] = first[first[v]];
        return v;
    };
    const std::vector<edge> edges = edges_of(mesh);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        for (end = i; end < edges.size() && edges[end].places == edges[i].places;) ++end;
        for (std::size_t side = 0; end - i == 2 && side < 2; ++side)
            first[found(edges[i].vertices[side])] = found(edges[i + 1].vertices[side]);
    }
    for (std::uint32_t v = 0; v < first.size(); ++v) first[v] = found(v);
    return first;
}

std::optional<merged_indices> manifold_of(const model& mesh)
{
    const std::vector<std::uint32_t> sewn = sewn_vertices(mesh);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    edges.reserve(mesh.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        edges.emplace_back(sewn[mesh.indices[i]], sewn[mesh.indices[next]]);
    }
    std::sort(edges.begin(), edges.end());
    if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return {};
    for (const auto& [from, to] : edges)
        if (!std::binary_search(edges.begin(), edges.end(), std::pair{to, from})) return {};
    merged_indices merged;
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        if (sewn[mesh.indices[i]] == mesh.indices[i]) continue;
        merged.places.push_back(static_cast<std::uint32_t>(i));
        merged.vertices.push_back(sewn[mesh.indices[i]]);
    }
    return merged;
}

model sewn(const model& mesh)
{
    const std::vector<std::uint32_t> first = sewn_vertices(mesh);
    model out = mesh;
    out.vertices.clear();
    std::vector<std::uint32_t> number(first.size());
    for (std::uint32_t v = 0; v < first.size(); ++v) {
        if (first[v] != v) continue;
        number[v] = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.push_back(mesh.vertices[v]);
    }
    for (std::uint32_t& i : out.indices) i = number[first[i]];
    return out;
}

}  // namespace text_to_mesh
