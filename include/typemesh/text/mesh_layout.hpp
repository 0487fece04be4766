// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/extrude.hpp>
#include <typemesh/text/text_shapes.hpp>
#include <typemesh/vertex/ranged_sink.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh {

/// Where each of some neighbouring glyphs of a text lies, when these alone make a mesh, and how they are written there.
///
///     vertices   [ front: first glyph ... last glyph | back: ... | side: ... ]
///     indices    [ front: first glyph ... last glyph | back: ... | side: ... ]
///
/// Refers to the text's shapes. Glyphs are numbered as in the whole text; vertices from 0 on.
class mesh_layout {
public:
    /// The glyphs [first, last).
    mesh_layout(const text_shapes& all, std::size_t first, std::size_t last) noexcept
        : all_{&all}, first_{first}, last_{last}, before_{before(first)}, starts_{starts_between(before_, before(last))}
    {
    }

    [[nodiscard]] std::size_t first_glyph() const noexcept { return first_; }
    [[nodiscard]] std::size_t last_glyph() const noexcept { return last_; }

    [[nodiscard]] mesh_size size() const noexcept
    {
        const part_sizes end = before(last_);
        mesh_size sum;
        for (const part p : all_parts) {
            sum.vertices += end.vertices[p] - before_.vertices[p];
            sum.triangles += end.triangles[p] - before_.triangles[p];
        }
        return sum;
    }

    /// Where the share of the glyphs [first, last) in a part lies; by default that of all.
    [[nodiscard]] mesh_range range(part p, std::size_t first, std::size_t last) const noexcept
    {
        const part_sizes from = before(first), to = before(last);
        return {starts_.vertices[p] + from.vertices[p] - before_.vertices[p], to.vertices[p] - from.vertices[p],
                3 * (starts_.triangles[p] + from.triangles[p] - before_.triangles[p]),
                3 * (to.triangles[p] - from.triangles[p])};
    }
    [[nodiscard]] mesh_range range(part p) const noexcept { return range(p, first_, last_); }

    /// Emits the glyphs' vertices of one part.
    template <extruder Extruder, mesh_sink Sink>
    void vertices(part p, std::size_t first, std::size_t last, const Extruder& how, Sink& sink) const noexcept
    {
        for (std::size_t g = first; g < last; ++g) {
            const shape_record& s = all_->records[g];
            write_vertices(p, s.shape->form(), how, all_->place(s), sink);
        }
    }

    /// Emits the glyphs' triangles of one part.
    template <extruder Extruder, mesh_sink Sink>
    void triangles(part p, std::size_t first, std::size_t last, const Extruder& how, Sink& sink) const noexcept
    {
        const bool turned = all_->placed.frame.turns_triangles();
        for (std::size_t g = first; g < last; ++g) {
            const shape_record& s = all_->records[g];
            first_vertices at;
            for (const part q : all_parts) at[q] = starts_.vertices[q] + s.before.vertices[q] - before_.vertices[q];
            write_triangles(p, s.shape->form(), how, at, turned, sink);
        }
    }

    /// Emits everything: all vertices, then all triangles.
    template <extruder Extruder, mesh_sink Sink>
    void everything(const Extruder& how, Sink& sink) const noexcept
    {
        for (const part p : all_parts) vertices(p, first_, last_, how, sink);
        for (const part p : all_parts) triangles(p, first_, last_, how, sink);
    }

    /// Emits share `k` of `shares`, which are about equal in what they cost: whole glyphs of one part or of several,
    /// each part's as a stretch of its own. All shares together are the mesh.
    template <extruder Extruder, ranged_sink Sink>
    void share(std::size_t k, std::size_t shares, const Extruder& how, const Sink& sink) const noexcept
    {
        const std::uint64_t all = work(before_, before(last_));
        const std::uint64_t begin = all / shares * k + all % shares * k / shares,
                            end = all / shares * (k + 1) + all % shares * (k + 1) / shares;
        std::uint64_t start = 0;  // the work of the parts before
        for (const part p : all_parts) {
            const std::uint64_t of_part = work(before_, before(last_), p);
            const std::size_t from = glyph_at(p, begin > start ? begin - start : 0),
                              to = glyph_at(p, end > start ? end - start : 0);
            start += of_part;
            if (from >= to) continue;
            auto piece = sink.stretch(range(p, from, to));
            vertices(p, from, to, how, piece);
            triangles(p, from, to, how, piece);
        }
    }

private:
    /// The counts of all glyphs of the text before this one.
    [[nodiscard]] part_sizes before(std::size_t glyph) const noexcept
    {
        return glyph < all_->records.size() ? all_->records[glyph].before : all_->totals;
    }

    /// Where each part begins.
    static part_sizes starts_between(const part_sizes& from, const part_sizes& to) noexcept
    {
        part_sizes starts, sum;
        for (const part p : all_parts) {
            starts.vertices[p] = sum.vertices[part::front];
            starts.triangles[p] = sum.triangles[part::front];
            sum.vertices[part::front] += to.vertices[p] - from.vertices[p];
            sum.triangles[part::front] += to.triangles[p] - from.triangles[p];
        }
        return starts;
    }

    /// A vertex costs about as much as four triangles.
    static std::uint64_t work(const part_sizes& from, const part_sizes& to, part p) noexcept
    {
        return std::uint64_t{4} * (to.vertices[p] - from.vertices[p]) + (to.triangles[p] - from.triangles[p]);
    }
    static std::uint64_t work(const part_sizes& from, const part_sizes& to) noexcept
    {
        std::uint64_t sum = 0;
        for (const part p : all_parts) sum += work(from, to, p);
        return sum;
    }

    /// The first glyph with at least so much work of its part before it, or the last.
    [[nodiscard]] std::size_t glyph_at(part p, std::uint64_t wanted) const noexcept
    {
        std::size_t low = first_, high = last_;
        while (low < high) {
            const std::size_t middle = low + (high - low) / 2;
            if (work(before_, before(middle), p) < wanted) low = middle + 1;
            else high = middle;
        }
        return low;
    }

    const text_shapes* all_;
    std::size_t first_;
    std::size_t last_;
    part_sizes before_;
    part_sizes starts_;
};

}  // namespace typemesh
