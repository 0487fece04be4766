// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include "support/executors.hpp"

#include <typemesh/text/text_chunks.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/growing_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

/// All ways of writing a plan write the same: glyph by glyph, by several workers, in streams, in chunks, as instances.
namespace fuzz::plan_laws {

using namespace typemesh;

/// A vertex with all attributes, without a gap between its bytes.
struct compared_vertex {
    vec3 position, normal;
    vec2 uv;
    vec4 tangent;
    std::uint32_t glyph, cluster, part, style;
};

}  // namespace fuzz::plan_laws

template <>
struct typemesh::vertex_traits<fuzz::plan_laws::compared_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent |
                                  attribute::glyph | attribute::cluster | attribute::part | attribute::style;
    fuzz::plan_laws::compared_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position,
                s.normal,
                s.uv,
                s.tangent,
                s.glyph,
                s.cluster,
                static_cast<std::uint32_t>(s.part),
                static_cast<std::uint32_t>(s.style)};
    }
};

namespace fuzz::plan_laws {

struct compared_mesh {
    std::vector<compared_vertex> vertices;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] bool equals(const compared_mesh& other) const
    {
        return indices == other.indices && vertices.size() == other.vertices.size() &&
               (vertices.empty() ||
                std::memcmp(vertices.data(), other.vertices.data(), vertices.size() * sizeof(compared_vertex)) == 0);
    }
    /// A mesh of the same size with other bytes.
    [[nodiscard]] compared_mesh blotted() const
    {
        compared_mesh m;
        m.vertices.resize(vertices.size(), compared_vertex{{9, 9, 9}, {}, {}, {}, 1, 2, 3, 4});
        m.indices.resize(indices.size(), 0xFFFF'FFFFu);
        return m;
    }
    [[nodiscard]] auto sink() { return into(std::span{vertices}, std::span{indices}); }
};

/// Spans of glyphs, written from the last to the first, and equal shares by several workers.
template <class Plan>
broken_law of_pieces(const Plan& plan, const compared_mesh& whole, values& in)
{
    compared_mesh pieces = whole.blotted();
    for (std::size_t last = plan.glyphs().size(); last > 0;) {
        const std::size_t first = last - (std::min)(last, std::size_t{1} + in.below(4));
        if (!plan.write(glyph_span{first, last}, pieces.sink())) return "some glyphs cannot be written";
        last = first;
    }
    if (!pieces.equals(whole)) return "glyphs one by one are not the mesh";
    compared_mesh shares = whole.blotted();
    test::scrambled_workers several{1 + in.below(5), in.byte()};
    if (!plan.write(shares.sink(), several)) return "several workers cannot write";
    return shares.equals(whole) ? "" : "several workers write another mesh";
}

/// Each attribute in an array of its own; 16-bit indices if they suffice, or else an error.
template <class Plan>
broken_law of_streams(const Plan& plan, const compared_mesh& whole)
{
    const std::size_t count = whole.vertices.size();
    std::vector<vec3> positions(count), normals(count);
    std::vector<vec2> uvs(count);
    std::vector<vec4> tangents(count);
    std::vector<std::uint32_t> clusters(count);
    std::vector<std::uint8_t> parts(count);
    std::vector<std::uint16_t> indices(whole.indices.size());
    stream_sink sink{std::span{indices},
                     stream<attribute::position, vec3>{positions},
                     stream<attribute::normal, vec3>{normals},
                     stream<attribute::uv, vec2>{uvs},
                     stream<attribute::tangent, vec4>{tangents},
                     stream<attribute::cluster, std::uint32_t>{clusters},
                     stream<attribute::part, std::uint8_t>{parts}};
    const error e = plan.write(sink).error();
    if (count > 0x1'0000) return e == error::index_overflow ? "" : "16-bit indices have numbered too many vertices";
    if (e) return "streams cannot be written";
    for (std::size_t i = 0; i < count; ++i) {
        const compared_vertex& v = whole.vertices[i];
        const compared_vertex w{positions[i], normals[i], uvs[i], tangents[i], v.glyph, clusters[i], parts[i], v.style};
        if (std::memcmp(&v, &w, sizeof v) != 0) return "streams hold other vertices";
    }
    return std::equal(indices.begin(), indices.end(), whole.indices.begin()) ? "" : "streams have other indices";
}

/// Ranges of glyphs and styles cover each part, and a triangle leads to its glyph.
template <class Plan>
broken_law of_ranges(const Plan& plan, const compared_mesh& whole)
{
    std::uint32_t vertex = 0, index = 0;
    for (const part p : plan.parts()) {
        for (const style_id s : plan.styles()) {
            const mesh_range styled = plan.range(s, p);
            if (styled.first_vertex != vertex || styled.first_index != index) return "ranges leave a gap";
            for (std::size_t g = plan.glyphs_of(s).first; g < plan.glyphs_of(s).last; ++g) {
                const mesh_range r = plan.range(g, p);
                if (r.first_vertex != vertex || r.first_index != index) return "ranges of glyphs leave a gap";
                vertex += r.vertex_count;
                index += r.index_count;
                for (std::uint32_t i = r.first_vertex; i < vertex; ++i)
                    if (whole.vertices[i].style != static_cast<std::uint32_t>(s) ||
                        whole.vertices[i].part != static_cast<std::uint32_t>(p))
                        return "a vertex has another part or style than its range";
                for (std::uint32_t i = r.first_index; i < index; i += 3)
                    if (plan.hit(p, (i - plan.range(p).first_index) / 3).glyph != g)
                        return "a triangle leads to another glyph";
            }
        }
    }
    return vertex == whole.vertices.size() && index == whole.indices.size() ? "" : "ranges do not cover the mesh";
}

/// Each different glyph once, moved to its instances, is the mesh except for rounding.
template <class Plan>
broken_law of_instances(const Plan& plan, const compared_mesh& whole)
{
    compared_mesh once;
    if (!plan.write_meshes(into(once.vertices, once.indices))) return "meshes cannot be written";
    if (once.vertices.size() != plan.meshes_size().vertices) return "meshes have another size than stated";
    double farthest = 0.0;
    for (const compared_mesh* m : {&whole, static_cast<const compared_mesh*>(&once)})
        for (const compared_vertex& v : m->vertices)
            for (const float x : {v.position.x, v.position.y, v.position.z})
                farthest = (std::max)(farthest, std::fabs(double(x)));
    const double allowed = 4.0 * 0x1p-23 * farthest;
    broken_law broken;
    std::size_t count = 0;
    std::vector<bool> seen(plan.glyphs().size(), false);
    plan.write_instances([&](const glyph_instance& i) {
        ++count;
        if (i.glyph >= seen.size() || seen[i.glyph]) {
            broken = "a glyph has two instances";
            return;
        }
        seen[i.glyph] = true;
        for (const part p : plan.parts()) {
            const mesh_range here = plan.range(i.glyph, p), there = plan.mesh_part(i.mesh, p);
            if (here.vertex_count != there.vertex_count || here.index_count != there.index_count) {
                broken = "an instance has another size than its glyph";
                return;
            }
            for (std::uint32_t k = 0; k < here.vertex_count; ++k) {
                const compared_vertex &v = whole.vertices[here.first_vertex + k],
                                      &w = once.vertices[there.first_vertex + k];
                const double off = (std::max)({std::fabs(double(w.position.x) + i.translation.x - v.position.x),
                                               std::fabs(double(w.position.y) + i.translation.y - v.position.y),
                                               std::fabs(double(w.position.z) + i.translation.z - v.position.z)});
                if (!(off <= allowed)) broken = "an instance is not where its glyph is";
                if (std::memcmp(&v.normal, &w.normal, sizeof v.normal) != 0) broken = "an instance has other normals";
            }
        }
    });
    return count != seen.size() ? "the numbers of instances and glyphs differ" : broken;
}

/// Triangles by their corners, however the vertices are numbered.
using compared_triangles = std::vector<std::array<compared_vertex, 3>>;

inline void add_triangles(const compared_mesh& m, compared_triangles& all)
{
    for (std::size_t i = 0; i + 2 < m.indices.size(); i += 3)
        all.push_back({m.vertices[m.indices[i]], m.vertices[m.indices[i + 1]], m.vertices[m.indices[i + 2]]});
}

/// Chunks are no larger than wanted, contain the mesh's triangles, and are the same one by one and all at once.
template <class Plan>
broken_law of_chunks(const Plan& plan, const compared_mesh& whole, values& in)
{
    text_chunks chunks;
    const std::uint32_t most = 3 + in.below(600);
    if (!chunks.cut(plan, most)) return "a plan cannot be cut";
    compared_mesh all;
    std::vector<std::uint16_t> small(chunks.size().indices());
    all.vertices.resize(chunks.size().vertices);
    if (!chunks.write(plan, into(std::span{all.vertices}, std::span{small}))) return "chunks cannot be written";
    all.indices.assign(small.begin(), small.end());
    compared_triangles drawn, wanted;
    std::uint32_t vertex = 0, index = 0;
    for (std::size_t k = 0; k < chunks.view().size(); ++k) {
        const text_chunk& c = chunks.view()[k];
        compared_mesh one, same;
        if (!chunks.write(plan, k, into(one.vertices, one.indices))) return "a chunk cannot be written";
        if (one.vertices.size() > most) return "a chunk is too large";
        if (c.range().first_vertex != vertex || c.range().first_index != index) return "chunks leave a gap";
        if (!(mesh_size{one.vertices.size(), one.indices.size() / 3} == c.size()))
            return "a chunk has another size than stated";
        same.vertices.assign(all.vertices.begin() + vertex, all.vertices.begin() + vertex + c.range().vertex_count);
        same.indices.assign(all.indices.begin() + index, all.indices.begin() + index + c.range().index_count);
        if (!one.equals(same)) return "a chunk by itself differs from the same chunk among all";
        for (const std::uint32_t i : one.indices)
            if (i >= one.vertices.size()) return "an index is beyond its chunk";
        add_triangles(one, drawn);
        vertex += c.range().vertex_count;
        index += c.range().index_count;
    }
    add_triangles(whole, wanted);
    const auto before = [](const auto& a, const auto& b) { return std::memcmp(&a, &b, sizeof a) < 0; };
    std::sort(wanted.begin(), wanted.end(), before);
    std::sort(drawn.begin(), drawn.end(), before);
    if (wanted.size() != drawn.size()) return "chunks have more or fewer triangles than the mesh";
    if (!wanted.empty() && std::memcmp(wanted.data(), drawn.data(), wanted.size() * sizeof wanted[0]) != 0)
        return "chunks have other triangles than the mesh";
    return {};
}

/// One of all ways of writing, chosen by a byte.
template <class Plan>
broken_law of_writing(const Plan& plan, values& in)
{
    compared_mesh whole;
    if (!plan.write(into(whole.vertices, whole.indices))) return "write failed";
    switch (in.byte() & 7) {
    case 0:
    case 1: return of_pieces(plan, whole, in);
    case 2: return of_streams(plan, whole);
    case 3: return of_ranges(plan, whole);
    case 4: return of_instances(plan, whole);
    case 5: return of_chunks(plan, whole, in);
    default: return {};
    }
}

}  // namespace fuzz::plan_laws
