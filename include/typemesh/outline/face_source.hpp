// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/variation_key.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An outline source of several faces, numbered from 0: what the looks of a glyph_run choose from. As an outline_source
/// it is its face 0.
///
///     s.face_count()                how many there are; at least 1
///     s.units_per_em(face)          as an outline_source's, of one face; face < face_count()
///     s.fill(face)
///     s.outline(face, id, sink)
///     s.variation_key(face)         only if there is a variation_key(); see variation_key.hpp
template <class S>
concept face_source = outline_source<S> && requires(S& s, std::uint32_t face, glyph_id id, ignore_outline& sink) {
    { s.face_count() } noexcept -> std::convertible_to<std::uint32_t>;
    { s.units_per_em(face) } noexcept -> std::convertible_to<double>;
    { s.fill(face) } noexcept -> std::same_as<fill_rule>;
    { s.outline(face, id, sink) } noexcept -> std::same_as<error>;
};

/// How many faces an outline source has: one, if it says nothing of faces.
template <outline_source Source>
[[nodiscard]] std::uint32_t face_count_of(Source& source) noexcept
{
    if constexpr (face_source<Source>)
        return source.face_count();
    else
        return 1;
}

/// The font units to an em of one face. face < face_count_of(source).
template <outline_source Source>
[[nodiscard]] double units_per_em_of(Source& source, std::uint32_t face) noexcept
{
    if constexpr (face_source<Source>)
        return source.units_per_em(face);
    else
        return static_cast<void>(face), source.units_per_em();
}

/// The fill rule of one face, and one of its outlines.
template <outline_source Source>
[[nodiscard]] fill_rule fill_of(Source& source, std::uint32_t face) noexcept
{
    if constexpr (face_source<Source>)
        return source.fill(face);
    else
        return static_cast<void>(face), source.fill();
}
template <outline_source Source, outline_sink Sink>
error outline_of(Source& source, std::uint32_t face, glyph_id id, Sink& sink) noexcept
{
    if constexpr (face_source<Source>)
        return source.outline(face, id, sink);
    else
        return static_cast<void>(face), source.outline(id, sink);
}

/// variation_of() of one face.
template <class Source>
[[nodiscard]] std::uint64_t variation_of(const Source& source, std::uint32_t face) noexcept
{
    if constexpr (requires { { source.variation_key(face) } noexcept -> std::convertible_to<std::uint64_t>; })
        return source.variation_key(face);
    else
        return static_cast<void>(face), variation_of(source);
}

/// One face of an outline source as a source by itself, its outlines drawn through a map, in units that the caller
/// names. The source and the map must outlive it.
template <outline_source Source>
class mapped_face {
public:
    /// Without a map (null) outlines stay as they are.
    mapped_face(Source& source, std::uint32_t face, const affine* map, double units_per_em) noexcept
        : source_{&source}, map_{map}, units_per_em_{units_per_em}, face_{face}
    {
    }

    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_of(*source_, face_); }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        mapping_sink<Sink> through{sink, map_};
        return outline_of(*source_, face_, id, through);
    }

private:
    template <outline_sink Sink>
    struct mapping_sink {
        Sink& to;
        const affine* map;

        [[nodiscard]] point at(point p) const noexcept { return map == nullptr ? p : (*map)(p); }
        void move(point p) noexcept { to.move(at(p)); }
        void line(point p) noexcept { to.line(at(p)); }
        void quadratic(point c, point p) noexcept { to.quadratic(at(c), at(p)); }
        void cubic(point c1, point c2, point p) noexcept { to.cubic(at(c1), at(c2), at(p)); }
        void close() noexcept { to.close(); }
    };

    Source* source_;
    const affine* map_;
    double units_per_em_;
    std::uint32_t face_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
