// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/vertex/attribute.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Replaces an attribute that was not requested: using it is a compile error that names this type.
template <attribute A>
struct not_in_wants {
    template <class T, attribute Asked = A>
    constexpr operator T() const noexcept
    {
        static_assert(Asked == attribute::none,
                      "typemesh: not_in_wants: this attribute is used but not requested; add it to your `wants`.");
        return T{};
    }
};

namespace detail {

// One layer per attribute, each derived from the previous one. A wanted attribute is a member; any other is a static
// member, which takes no space. The layers are a chain, not a list of bases, because every ABI lays out an empty base
// without padding when it is the only one.

template <attribute Wants, bool = has(Wants, attribute::position)>
struct with_position {
    vec3 position{};
};
template <attribute Wants>
struct with_position<Wants, false> {
    static constexpr not_in_wants<attribute::position> position{};
};

template <attribute Wants, bool = has(Wants, attribute::normal)>
struct with_normal : with_position<Wants> {
    vec3 normal{};
};
template <attribute Wants>
struct with_normal<Wants, false> : with_position<Wants> {
    static constexpr not_in_wants<attribute::normal> normal{};
};

template <attribute Wants, bool = has(Wants, attribute::uv)>
struct with_uv : with_normal<Wants> {
    vec2 uv{};
};
template <attribute Wants>
struct with_uv<Wants, false> : with_normal<Wants> {
    static constexpr not_in_wants<attribute::uv> uv{};
};

template <attribute Wants, bool = has(Wants, attribute::tangent)>
struct with_tangent : with_uv<Wants> {
    vec4 tangent{};
};
template <attribute Wants>
struct with_tangent<Wants, false> : with_uv<Wants> {
    static constexpr not_in_wants<attribute::tangent> tangent{};
};

template <attribute Wants, bool = has(Wants, attribute::curve)>
struct with_curve : with_tangent<Wants> {
    vec3 curve{-1.0f, 0.0f, 0.0f};
};
template <attribute Wants>
struct with_curve<Wants, false> : with_tangent<Wants> {
    static constexpr not_in_wants<attribute::curve> curve{};
};

template <attribute Wants, bool = has(Wants, attribute::glyph)>
struct with_glyph : with_curve<Wants> {
    glyph_id glyph = no_glyph;
};
template <attribute Wants>
struct with_glyph<Wants, false> : with_curve<Wants> {
    static constexpr not_in_wants<attribute::glyph> glyph{};
};

template <attribute Wants, bool = has(Wants, attribute::cluster)>
struct with_cluster : with_glyph<Wants> {
    cluster_id cluster = no_cluster;
};
template <attribute Wants>
struct with_cluster<Wants, false> : with_glyph<Wants> {
    static constexpr not_in_wants<attribute::cluster> cluster{};
};

template <attribute Wants, bool = has(Wants, attribute::style)>
struct with_style : with_cluster<Wants> {
    style_id style = no_style;
};
template <attribute Wants>
struct with_style<Wants, false> : with_cluster<Wants> {
    static constexpr not_in_wants<attribute::style> style{};
};

template <attribute Wants, bool = has(Wants, attribute::letter)>
struct with_letter : with_style<Wants> {
    std::uint32_t letter = not_a_letter;
};
template <attribute Wants>
struct with_letter<Wants, false> : with_style<Wants> {
    static constexpr not_in_wants<attribute::letter> letter{};
};

template <attribute Wants, bool = has(Wants, attribute::word)>
struct with_word : with_letter<Wants> {
    std::uint32_t word = not_a_letter;
};
template <attribute Wants>
struct with_word<Wants, false> : with_letter<Wants> {
    static constexpr not_in_wants<attribute::word> word{};
};

template <attribute Wants, bool = has(Wants, attribute::line)>
struct with_line : with_word<Wants> {
    std::uint32_t line = not_a_letter;
};
template <attribute Wants>
struct with_line<Wants, false> : with_word<Wants> {
    static constexpr not_in_wants<attribute::line> line{};
};

template <attribute Wants, bool = has(Wants, attribute::pivot)>
struct with_pivot : with_line<Wants> {
    vec3 pivot{};
};
template <attribute Wants>
struct with_pivot<Wants, false> : with_line<Wants> {
    static constexpr not_in_wants<attribute::pivot> pivot{};
};

template <attribute Wants, bool = has(Wants, attribute::extent)>
struct with_extent : with_pivot<Wants> {
    vec3 extent{};
};
template <attribute Wants>
struct with_extent<Wants, false> : with_pivot<Wants> {
    static constexpr not_in_wants<attribute::extent> extent{};
};

template <attribute Wants, bool = has(Wants, letter_attributes)>
struct with_letter_data : with_extent<Wants> {};
template <attribute Wants>
struct with_letter_data<Wants, false> : with_style<Wants> {
    static constexpr not_in_wants<attribute::letter> letter{};
    static constexpr not_in_wants<attribute::word> word{};
    static constexpr not_in_wants<attribute::line> line{};
    static constexpr not_in_wants<attribute::pivot> pivot{};
    static constexpr not_in_wants<attribute::extent> extent{};
};

template <attribute Wants, bool = has(Wants, attribute::part)>
struct with_part : with_letter_data<Wants> {
    typemesh::part part{};
};
template <attribute Wants>
struct with_part<Wants, false> : with_letter_data<Wants> {
    static constexpr not_in_wants<attribute::part> part{};
};

}  // namespace detail

/// One point of the mesh's surface, with only the attributes in `Wants`.
///
///     position   vec3   in the output's unit and frame (text_options)
///     normal     vec3   unit length, outward, in the same frame
///     uv         vec2   texture coordinates (see extrude/texture.hpp)
///     tangent    vec4   x, y, z: unit length, perpendicular to the normal, the direction in which u grows; w: +1 or
///                       -1, so that v grows along w * cross(normal, tangent) (see extrude/texture_tangent.hpp)
///     curve      vec3   a place beside a curve that a shader draws: inside where x * |x| < y * z (see
///                       extrude/flat_curved.hpp). All other extruders leave it at (-1, 0, 0), which is inside
///     glyph      glyph_id     the number in its font of the glyph that the point belongs to; no_glyph if unknown
///     cluster    cluster_id   the glyph's position in the caller's text; no_cluster if unknown
///     part       part         front, back, side, or a further part of the extruder
///     style      style_id     the glyph's style (layout/glyph_style.hpp); no_style if unknown
///     letter     uint32_t     the number of its letter in reading order; not_a_letter for underlines, and if unknown
///     word, line uint32_t     the numbers of the letter's word and of its line; not_a_letter if unknown, and the word
///                             also for an underline that does not go with exactly one word
///     pivot      vec3         the place about which its letter turns, in the output's unit and frame
///     extent     vec3         the width, height and depth of its letter, in the output's unit (text/text_letter.hpp)
///
/// Other attributes take no space and are never computed.
template <attribute Wants>
struct surface_point : detail::with_part<Wants> {};

/// A copy of the point with fewer attributes; Fewer must be a subset of Wants.
template <attribute Fewer, attribute Wants>
[[nodiscard]] constexpr surface_point<Fewer> only(const surface_point<Wants>& s) noexcept
{
    static_assert((Fewer | Wants) == Wants, "typemesh: this surface point does not have a requested attribute");
    surface_point<Fewer> fewer;
    if constexpr (has(Fewer, attribute::position)) fewer.position = s.position;
    if constexpr (has(Fewer, attribute::normal)) fewer.normal = s.normal;
    if constexpr (has(Fewer, attribute::uv)) fewer.uv = s.uv;
    if constexpr (has(Fewer, attribute::tangent)) fewer.tangent = s.tangent;
    if constexpr (has(Fewer, attribute::curve)) fewer.curve = s.curve;
    if constexpr (has(Fewer, attribute::glyph)) fewer.glyph = s.glyph;
    if constexpr (has(Fewer, attribute::cluster)) fewer.cluster = s.cluster;
    if constexpr (has(Fewer, attribute::part)) fewer.part = s.part;
    if constexpr (has(Fewer, attribute::style)) fewer.style = s.style;
    if constexpr (has(Fewer, attribute::letter)) fewer.letter = s.letter;
    if constexpr (has(Fewer, attribute::word)) fewer.word = s.word;
    if constexpr (has(Fewer, attribute::line)) fewer.line = s.line;
    if constexpr (has(Fewer, attribute::pivot)) fewer.pivot = s.pivot;
    if constexpr (has(Fewer, attribute::extent)) fewer.extent = s.extent;
    return fewer;
}

}  // namespace typemesh::inline TYPEMESH_ABI
