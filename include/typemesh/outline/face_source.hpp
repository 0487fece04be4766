// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/bar_face.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An outline source with several faces, numbered from 0. The glyph styles of a glyph_run choose among the faces. Where
/// only an outline_source is needed, face 0 is used.
///
///     s.face_count()                the number of faces; at least 1
///     s.units_per_em(face)          as in outline_source, for one face; face < face_count()
///     s.fill(face)
///     s.outline(face, id, sink)
///     s.variation_key(face)         only if the source has a variation_key(): the number of one face
template <class S>
concept face_source = outline_source<S> && requires(S& s, std::uint32_t face, glyph_id id, ignore_outline& sink) {
    { s.face_count() } noexcept -> std::convertible_to<std::uint32_t>;
    { s.units_per_em(face) } noexcept -> std::convertible_to<double>;
    { s.fill(face) } noexcept -> std::same_as<fill_rule>;
    { s.outline(face, id, sink) } noexcept -> std::same_as<error>;
};

/// The number of faces of an outline source: one if the source has no face_count().
template <outline_source Source>
[[nodiscard]] std::uint32_t face_count_of(Source& source) noexcept
{
    if constexpr (face_source<Source>)
        return source.face_count();
    else
        return 1;
}

/// The font units per em of one face: face < face_count_of(source), or bar_face.
template <outline_source Source>
[[nodiscard]] double units_per_em_of(Source& source, std::uint32_t face) noexcept
{
    if (face == bar_face) return source.units_per_em();
    if constexpr (face_source<Source>)
        return source.units_per_em(face);
    else
        return source.units_per_em();
}

/// The fill rule of one face.
template <outline_source Source>
[[nodiscard]] fill_rule fill_of(Source& source, std::uint32_t face) noexcept
{
    if (face == bar_face) return fill_rule::non_zero;
    if constexpr (face_source<Source>)
        return source.fill(face);
    else
        return source.fill();
}
/// Draws one outline of a face. Fails as the source does.
template <outline_source Source, outline_sink Sink>
error outline_of(Source& source, std::uint32_t face, glyph_id id, Sink& sink) noexcept
{
    if (face == bar_face) return draw_bar(sink, id), error{};
    if constexpr (face_source<Source>)
        return source.outline(face, id, sink);
    else
        return source.outline(id, sink);
}

/// The key of one face's variation, like the key that variation_of() gives for a whole source.
template <class Source>
[[nodiscard]] std::uint64_t variation_of(const Source& source, std::uint32_t face) noexcept
{
    if (face == bar_face) return 0;
    if constexpr (requires {
                      { source.variation_key(face) } noexcept -> std::convertible_to<std::uint64_t>;
                  })
        return source.variation_key(face);
    else
        return variation_of(source);
}

/// Maps every point of an outline. Curves that shrink to a point are dropped, and so are contours in which no other
/// curve is left.
///
/// Fails  error::outline_not_finite; the content of `out` is then meaningless
inline error map_outline(const affine& map, outline& out) noexcept
{
    std::uint32_t first = 0, kept = 0, contours = 0;
    out.bounds = {};
    for (std::uint32_t k = 0, count = out.contour_count(); k < count; ++k) {
        const std::uint32_t last = out.starts[k + 1], begin = kept;
        for (; first < last; ++first) {
            curve c = out.curves[first];
            bool is_point = true;
            for (std::uint32_t i = 0; i <= c.degree; ++i) {
                c.p[i] = map(c.p[i]);
                if (!is_finite(c.p[i].x) || !is_finite(c.p[i].y)) return error::outline_not_finite;
                is_point = is_point && c.p[i] == c.p[0];
            }
            if (is_point) continue;
            for (std::uint32_t i = 0; i <= c.degree; ++i) out.bounds.add(c.p[i]);
            out.curves[kept++] = c;
        }
        if (kept != begin) out.starts[++contours] = kept;
    }
    out.curves.truncate(kept);
    out.starts.truncate(contours == 0 ? 0 : contours + 1);
    return {};
}

/// One face of an outline source as a source of its own. Its outlines are mapped, and the caller chooses the units. The
/// original source and the map must outlive it.
template <outline_source Source>
class mapped_face {
public:
    /// Without a map (null), outlines stay unchanged.
    mapped_face(Source& source, std::uint32_t face, const affine* map, double units_per_em) noexcept
        : source_{&source}, map_{map}, units_per_em_{units_per_em}, face_{face}
    {
    }

    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_of(*source_, face_); }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        if (map_ == nullptr) return outline_of(*source_, face_, id, sink);
        detail::mapping_sink<Sink> through{sink, *map_};
        return outline_of(*source_, face_, id, through);
    }

    /// Gives the result of record() for the mapped outline, but maps after recording. The source thus draws into only
    /// one type of sink.
    error record(glyph_id id, typemesh::outline& out) noexcept
    {
        outline_recorder recorder{out};
        if (error e = outline_of(*source_, face_, id, recorder)) return e;
        out.rule = fill();
        if (error e = recorder.finish()) return e;
        return map_ == nullptr ? error{} : map_outline(*map_, out);
    }

private:
    Source* source_;
    const affine* map_;
    double units_per_em_;
    std::uint32_t face_;
};

template <outline_source Source>
result<void> record(mapped_face<Source>& face, glyph_id id, outline& out) noexcept
{
    return face.record(id, out);
}

}  // namespace typemesh::inline TYPEMESH_ABI
