// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/shaper.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A bar that a font suggests. Its upper edge is `top` em above the baseline.
struct bar_metrics {
    double top = 0.0;
    double thickness = 0.0;  ///< the height of the bar, in em
};

/// The size and rise that a font suggests for superscripts or subscripts.
struct script_metrics {
    double size = 1.0;  ///< the size relative to normal letters
    double rise = 0.0;  ///< the rise of their baseline; negative for subscripts
};

/// The font's suggestions for bars, superscripts and subscripts. Lengths are in em.
struct face_metrics {
    bar_metrics underline{-0.1, 0.05};
    bar_metrics strike_through{0.28, 0.05};
    script_metrics superscript{0.65, 0.35};
    script_metrics subscript{0.65, -0.15};
};

/// The number of a shaper's faces: s.face_count(), or one.
template <class Shaper>
[[nodiscard]] std::uint32_t shaper_faces(const Shaper& s) noexcept
{
    if constexpr (requires {
                      { s.face_count() } -> std::convertible_to<std::uint32_t>;
                  })
        return s.face_count();
    else
        return static_cast<void>(s), 1u;
}

/// Returns the metrics multiplied by a factor, for other units.
[[nodiscard]] constexpr line_metrics scaled(const line_metrics& m, double factor) noexcept
{
    return {factor * m.ascender, factor * m.descender, factor * m.gap};
}

/// The suggestions of one of a shaper's faces, or of its only face. If the shaper has none, returns the defaults.
///
///     s.suggested_metrics()        for a shaper of one face      s.suggested_metrics(face)      of several faces
template <class Shaper>
[[nodiscard]] face_metrics face_metrics_of([[maybe_unused]] const Shaper& s,
                                           [[maybe_unused]] std::uint32_t face) noexcept
{
    if constexpr (requires {
                      { s.suggested_metrics(face) } noexcept -> std::same_as<face_metrics>;
                  })
        return s.suggested_metrics(face);
    else if constexpr (requires {
                           { s.suggested_metrics() } noexcept -> std::same_as<face_metrics>;
                       })
        return s.suggested_metrics();
    else
        return {};
}

/// The line metrics of one of a shaper's faces, in units of the first face: s.metrics(direction, face), or the metrics
/// of the first face.
template <class Shaper>
[[nodiscard]] line_metrics line_metrics_of(Shaper& s, direction d, [[maybe_unused]] std::uint32_t face) noexcept
{
    if constexpr (requires {
                      { s.metrics(d, face) } noexcept -> std::same_as<line_metrics>;
                  })
        return s.metrics(d, face);
    else
        return s.metrics(d);
}

/// How far a line in one face of a shaper extends to both sides of its baseline, in units of the first face. These
/// distances follow the face's metrics, but a column is at least wide enough for letters of the face that lie on their
/// side in it. Vertical metrics often cover only an ideograph: half an em to each side and no gap.
template <class Shaper>
[[nodiscard]] line_metrics line_reach_of(Shaper& s, direction d, std::uint32_t face = 0) noexcept
{
    line_metrics reach = line_metrics_of(s, d, face);
    if (d != direction::top_to_bottom) return reach;
    const line_metrics turned = line_metrics_of(s, direction::left_to_right, face);
    const double middle = column_middle_of(s);
    if (turned.ascender - middle > reach.ascender) reach.ascender = turned.ascender - middle;
    if (turned.descender - middle < reach.descender) reach.descender = turned.descender - middle;
    if (turned.gap > reach.gap) reach.gap = turned.gap;
    return reach;
}

}  // namespace typemesh::inline TYPEMESH_ABI
