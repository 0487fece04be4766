// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/text_shapes.hpp>
#include <typemesh/vertex/mesh_sink.hpp>

#include <cstdint>
#include <span>
#include <type_traits>

namespace typemesh {

/// A stretch of the output: vertices [first_vertex, first_vertex + vertex_count), indices likewise.
struct mesh_range {
    std::uint32_t first_vertex = 0;
    std::uint32_t vertex_count = 0;
    std::uint32_t first_index = 0;
    std::uint32_t index_count = 0;
};

/// A text, meshed and measured but not yet written: exact sizes first, then write() as often as you like.
///
///     vertices   [ front: glyph 0, glyph 1, ... | back: ... | side: ... ]       each part in one piece, so that it can
///     indices    [ front: glyph 0, glyph 1, ... | back: ... | side: ... ]       be drawn with a material of its own
///
/// Move-only. It refers to its mesher, which must outlive it; a move of the mesher ends it, and so does the mesher's
/// next plan() (using it then is asserted). Only glyphs that have triangles are counted among glyphs().
template <extruder Extruder>
class text_plan {
public:
    text_plan(const text_shapes& shapes, const glyph_run& run, const Extruder& extruder) noexcept
        : shapes_{&shapes}, run_{&run}, extruder_{extruder}, generation_{shapes.generation.number}
    {
    }
    text_plan(text_plan&&) noexcept = default;
    text_plan& operator=(text_plan&&) noexcept = default;

    /// Exactly how many vertices and triangles write() will emit.
    [[nodiscard]] mesh_size size() const noexcept
    {
        const part_counts vertices = fresh().totals.vertices, triangles = fresh().totals.triangles;
        mesh_size all;
        for (const part p : all_parts) {
            all.vertices += vertices[p];
            all.triangles += triangles[p];
        }
        return all;
    }

    /// Where one part lies in the output.
    [[nodiscard]] mesh_range range(part p) const noexcept { return range_between(p, {}, fresh().totals); }

    /// Where one glyph's share of a part lies. glyph < glyphs().size().
    [[nodiscard]] mesh_range range(std::size_t glyph, part p) const noexcept
    {
        const shape_record& s = fresh().records[glyph];
        return range_between(p, s.before, s.shape->sizes());
    }

    /// The glyphs in the mesh, in drawing order.
    [[nodiscard]] std::span<const shape_record> glyphs() const noexcept { return fresh().records.view(); }

    /// What is not in the mesh, and why.
    [[nodiscard]] const text_report& report() const noexcept { return fresh().report; }

    /// The shaped text behind the mesh: every glyph with its place and cluster, every line.
    [[nodiscard]] const glyph_run& run() const noexcept
    {
        (void)fresh();
        return *run_;
    }

    /// The box around all vertices; exact for frames whose axes lie along the coordinate axes, else it may be larger.
    [[nodiscard]] bounds3 bounds() const noexcept { return fresh().bounds; }

    /// N and H of the four vertex counts 2N, 4N and 4N + 2H: contour points, and those among them with doubled side
    /// vertices. Cost: O(glyphs), and O(points) for H.
    [[nodiscard]] std::uint64_t contour_points() const noexcept
    {
        std::uint64_t points = 0;
        for (const shape_record& s : fresh().records) points += s.shape->form().points.size();
        return points;
    }
    [[nodiscard]] std::uint64_t hard_edges() const noexcept
    {
        std::uint64_t hard = 0;
        for (const shape_record& r : fresh().records)
            for (const side_point& s : r.shape->form().sides)
                hard += s.doubled && !(s.seam && s.before == s.after) ? 1u : 0u;
        return hard;
    }

    /// Emits every vertex and every triangle once, in ascending order. Only the sink's begin() can fail; nothing is
    /// allocated.
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    error write(Sink&& sink) const noexcept
    {
        const text_shapes& all = fresh();
        if (error e = sink.begin(size())) return e;

        for (const part p : all_parts)
            for (const shape_record& s : all.records) write_vertices(p, s.shape->form(), extruder_, all.place(s), sink);

        part_counts start;
        start[part::back] = all.totals.vertices[part::front];
        start[part::side] = start[part::back] + all.totals.vertices[part::back];
        const bool turned = all.placed.frame.turns_triangles();
        for (const part p : all_parts) {
            for (const shape_record& s : all.records) {
                first_vertices first;
                for (const part q : all_parts) first[q] = start[q] + s.before.vertices[q];
                write_triangles(p, s.shape->form(), extruder_, first, turned, sink);
            }
        }
        sink.end();
        return {};
    }

private:
    const text_shapes& fresh() const noexcept
    {
        TYPEMESH_ASSERT(shapes_->generation.number == generation_,
                        "this text_plan is stale: its mesher has made another plan or was moved since");
        return *shapes_;
    }

    [[nodiscard]] mesh_range range_between(part p, const part_sizes& before, const part_sizes& sizes) const noexcept
    {
        mesh_range r{before.vertices[p], sizes.vertices[p], 3 * before.triangles[p], 3 * sizes.triangles[p]};
        for (const part q : all_parts) {
            if (q >= p) break;
            r.first_vertex += shapes_->totals.vertices[q];
            r.first_index += 3 * shapes_->totals.triangles[q];
        }
        return r;
    }

    const text_shapes* shapes_;
    const glyph_run* run_;
    Extruder extruder_;
    std::uint64_t generation_;
};

}  // namespace typemesh
