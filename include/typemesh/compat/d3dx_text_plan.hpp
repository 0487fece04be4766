// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/text/text_plan.hpp>
#include <typemesh/vertex/array_sink.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The fields of Windows' GLYPHMETRICSFLOAT in its order: 24 bytes that may be copied into one. In output units.
///
///         origin ->+--------+                 origin        the box's upper left corner, seen from the pen
///                  | #    # |  box_height     box_*         the box around the glyph, 0 for a blank one
///                  | ##  ## |                 advance_x, y  from this pen position to the next character's
///     pen ---->o   +--------+      o <- the next character's
///              |<-- advance_x ---->|
struct d3dx_glyph_metrics {
    float box_width = 0.0f;   ///< gmfBlackBoxX
    float box_height = 0.0f;  ///< gmfBlackBoxY
    vec2 origin = {};         ///< gmfptGlyphOrigin
    float advance_x = 0.0f;   ///< gmfCellIncX
    float advance_y = 0.0f;   ///< gmfCellIncY
};
static_assert(sizeof(d3dx_glyph_metrics) == 24);

/// A text planned by d3dx_text: first its sizes, then its vertices, indices and metrics, as often as you like.
///
/// Move-only. It refers to its d3dx_text as a text_plan refers to its mesher.
template <extruder Extruder>
class d3dx_text_plan {
public:
    d3dx_text_plan(text_plan<Extruder>&& made, double unit_per_font_unit, std::size_t text_size, bool vertical) noexcept
        : plan_{std::move(made)}, unit_{unit_per_font_unit}, text_size_{text_size}, vertical_{vertical}
    {
    }

    /// The exact numbers of vertices and triangles that write() will write.
    [[nodiscard]] mesh_size size() const noexcept { return plan_.size(); }

    /// The number of metrics: one per unit of the text (16 bits in UTF-16), as in Direct3D.
    [[nodiscard]] std::size_t metrics_size() const noexcept { return text_size_; }

    /// The range of the cap at z = -extrusion, which the viewer sees.
    [[nodiscard]] mesh_range front() const noexcept { return plan_.range(part::back); }
    /// The range of the cap at z = 0.
    [[nodiscard]] mesh_range back() const noexcept { return plan_.range(part::front); }
    /// The walls' range.
    [[nodiscard]] mesh_range sides() const noexcept { return plan_.range(part::side); }
    /// The bevels around both caps, if the extruder makes bevels.
    [[nodiscard]] mesh_range front_bevel() const noexcept
        requires(part_count_of<Extruder> == 5)
    {
        return plan_.range(part::back_bevel);
    }
    [[nodiscard]] mesh_range back_bevel() const noexcept
        requires(part_count_of<Extruder> == 5)
    {
        return plan_.range(part::front_bevel);
    }

    /// The text_mesher's own plan: ranges of glyphs, bounds, the shaped text. Its part::front is the cap at z = 0.
    [[nodiscard]] const text_plan<Extruder>& text() const noexcept { return plan_; }

    /// The report: which glyphs are not in the mesh, and why.
    [[nodiscard]] const text_report& report() const noexcept { return plan_.report(); }

    /// Fills two arrays of the caller: the first size().vertices and size().indices() elements.
    ///
    /// Fails  error::buffer_too_small (count = the number of elements that the array needs)
    ///        error::index_overflow: 16-bit indices can number 65,535 vertices; use 32-bit ones for more
    /// Nothing is written then.
    template <class Vertex, std::size_t V, class Index, std::size_t I>
    result<void> write(std::span<Vertex, V> vertices, std::span<Index, I> indices) const noexcept
    {
        return plan_.write(into(vertices, indices));
    }

    /// Writes the mesh into any sink.
    template <class Sink>
        requires mesh_sink<std::remove_reference_t<Sink>>
    result<void> write(Sink&& sink) const noexcept
    {
        return plan_.write(sink);
    }
    template <array_without_sink Vertices, array_without_sink Indices>
    result<void> write(Vertices&&, Indices&&) const noexcept
    {
        return refuse_arrays<Vertices>();
    }

    /// Writes the metrics, one for each unit of the text. A character's metrics are at its first unit. Units without a
    /// glyph of their own get zeros: the other units of a character, later letters of a ligature, line breaks. A
    /// glyph's advance is the step to the next glyph, so it includes kerning.
    ///
    /// Fails  error::buffer_too_small: `out` has fewer than metrics_size() elements, the error's `count`; nothing is
    ///        written then
    result<void> metrics(std::span<d3dx_glyph_metrics> out) const noexcept
    {
        if (out.size() < text_size_) return error{error::buffer_too_small, text_size_};
        for (std::size_t i = 0; i < text_size_; ++i) out[i] = {};

        const glyph_run& run = plan_.run();
        for (const text_line& line : run.lines) {
            const auto glyphs = run.letters_of(line);
            const auto begin = static_cast<std::size_t>(glyphs.data() - run.glyphs.data());
            for (std::size_t i = 0, next = 0; i < glyphs.size(); i = next) {
                const cluster_id cluster = glyphs[i].cluster;
                const point pen = glyphs[i].origin;
                while (next < glyphs.size() && glyphs[next].cluster == cluster) ++next;
                const box ink = ink_of(begin + i, begin + next);
                d3dx_glyph_metrics m;
                const point step =
                    next < glyphs.size() ? glyphs[next].origin - pen : rest_of(line, pen - glyphs.front().origin);
                if (!ink.empty()) {
                    m.box_width = in_output(ink.width());
                    m.box_height = in_output(ink.height());
                    m.origin = {in_output(ink.low.x - pen.x), in_output(ink.high.y - pen.y)};
                }
                (vertical_ ? m.advance_y : m.advance_x) = in_output(vertical_ ? step.y : step.x);
                if (cluster < text_size_) out[cluster] = m;
            }
        }
        return {};
    }

private:
    [[nodiscard]] float in_output(double font_units) const noexcept { return static_cast<float>(font_units * unit_); }

    /// The box of the drawn part of the run's glyphs [first, last), in font units.
    [[nodiscard]] box ink_of(std::size_t first, std::size_t last) const noexcept
    {
        const auto drawn = plan_.glyphs();
        box ink;
        for (const style_id style : plan_.styles()) {
            const glyph_span own = plan_.glyphs_of(style);
            std::size_t g =
                first_where(own.first, own.last, [&](std::size_t k) noexcept { return drawn[k].glyph >= first; });
            for (; g < own.last && drawn[g].glyph < last; ++g) ink.merge(text_glyphs::ink_of(drawn[g]));
        }
        return ink;
    }

    /// The step from the last pen position of a line to the end of its white space. `gone` is the step from the line's
    /// first pen position to its last.
    [[nodiscard]] point rest_of(const text_line& line, point gone) const noexcept
    {
        const double all = line.advance + line.hanging;
        return vertical_ ? point{0.0, 0.0 - all - gone.y} : point{all - gone.x, 0.0};
    }

    text_plan<Extruder> plan_;
    double unit_;
    std::size_t text_size_;
    bool vertical_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
