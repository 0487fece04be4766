// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/text/impl/lettered_sink.hpp>
#include <typemesh/text/impl/text_glyphs.hpp>
#include <typemesh/vertex/ranged_sink.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The layout of several consecutive glyphs of a text in a mesh of only these glyphs, and how they are written there.
///
///     vertices   [ front: first glyph ... last glyph | back: ... | side: ... ]
///     indices    [ front: first glyph ... last glyph | back: ... | side: ... ]
///
/// Refers to the text's built glyphs. Glyphs are numbered as in the whole text; vertices from 0.
class mesh_layout {
public:
    /// The glyphs [first, last).
    mesh_layout(const text_glyphs& all, std::size_t first, std::size_t last) noexcept
        : all_{&all}, first_{first}, last_{last}, before_{before(first)}, starts_{sizes().starts()}
    {
    }

    [[nodiscard]] std::size_t first_glyph() const noexcept { return first_; }
    [[nodiscard]] std::size_t last_glyph() const noexcept { return last_; }

    /// The size of the mesh in each part, and in total.
    [[nodiscard]] part_sizes sizes() const noexcept { return before(last_) - before_; }
    [[nodiscard]] mesh_size size() const noexcept { return sizes().total(); }

    /// The range of the glyphs [first, last) in a part; by default of all glyphs.
    [[nodiscard]] mesh_range range(part p, std::size_t first, std::size_t last) const noexcept
    {
        const part_sizes from = before(first), at = starts_ + (from - before_), own = before(last) - from;
        return {at.vertices[p], own.vertices[p], 3 * at.triangles[p], 3 * own.triangles[p]};
    }
    [[nodiscard]] mesh_range range(part p) const noexcept { return range(p, first_, last_); }

    /// Emits the glyphs' vertices of one part.
    template <extruder Extruder, mesh_sink Sink>
    void vertices(part p, std::size_t first, std::size_t last, const Extruder& how, Sink& sink) const noexcept
    {
        if (range(p, first, last).vertex_count == 0) return;
        for (std::size_t g = first; g < last; ++g) {
            const drawn_glyph& s = all_->records[g];
            detail::write_letter(*all_, g, sink, [&](auto& to, const placement& at) noexcept {
                write_vertices(p, s.built->template planned<Extruder>(), how, at, to);
            });
        }
    }

    /// Emits the glyphs' triangles of one part.
    template <extruder Extruder, mesh_sink Sink>
    void triangles(part p, std::size_t first, std::size_t last, const Extruder& how, Sink& sink) const noexcept
    {
        if (range(p, first, last).index_count == 0) return;
        const bool turned = all_->placed.frame.turns_triangles();
        for (std::size_t g = first; g < last; ++g) {
            const drawn_glyph& s = all_->records[g];
            const first_vertices at = starts_.vertices + (s.before.vertices - before_.vertices);
            const bool mirrored = turned != detail::mirrors_letter(*all_, g, sink);
            write_triangles(p, s.built->planned<Extruder>(), how, at, mirrored, detail::unmoved(sink));
        }
    }

    /// Emits everything: all vertices, then all triangles.
    template <extruder Extruder, mesh_sink Sink>
    void everything(const Extruder& how, Sink& sink) const noexcept
    {
        for (const part p : parts_of<Extruder>) vertices(p, first_, last_, how, sink);
        for (const part p : parts_of<Extruder>) triangles(p, first_, last_, how, sink);
    }

    /// Emits share `k` of `shares`, which have about the same cost: whole glyphs of one or several parts, with a
    /// separate subrange for each part. All shares together are the mesh.
    template <extruder Extruder, ranged_sink Sink>
    void share(std::size_t k, std::size_t shares, const Extruder& how, const Sink& sink) const noexcept
    {
        const part_sizes own = sizes();
        std::uint64_t all = 0;
        for (const part p : parts_of<Extruder>) all += work(own, p);
        const std::uint64_t begin = all / shares * k + all % shares * k / shares,
                            end = all / shares * (k + 1) + all % shares * (k + 1) / shares;
        std::uint64_t start = 0;  // the work of the previous parts
        for (const part p : parts_of<Extruder>) {
            const std::size_t from = glyph_at(p, begin > start ? begin - start : 0),
                              to = glyph_at(p, end > start ? end - start : 0);
            start += work(own, p);
            if (from >= to) continue;
            auto piece = sink.subrange(range(p, from, to));
            vertices(p, from, to, how, piece);
            triangles(p, from, to, how, piece);
        }
    }

private:
    /// The counts of all preceding glyphs of the text.
    [[nodiscard]] part_sizes before(std::size_t glyph) const noexcept
    {
        return glyph < all_->records.size() ? all_->records[glyph].before : all_->totals;
    }

    /// A vertex costs about as much as four triangles.
    static std::uint64_t work(const part_sizes& some, part p) noexcept
    {
        return std::uint64_t{4} * some.vertices[p] + some.triangles[p];
    }

    /// The first glyph with at least that much work of its part before it, or the last.
    [[nodiscard]] std::size_t glyph_at(part p, std::uint64_t wanted) const noexcept
    {
        return first_where(first_, last_,
                           [&](std::size_t g) noexcept { return work(before(g) - before_, p) >= wanted; });
    }

    const text_glyphs* all_;
    std::size_t first_;
    std::size_t last_;
    part_sizes before_;
    part_sizes starts_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
