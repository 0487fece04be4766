// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/item_shaper.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A bar that a font suggests: its upper edge lies `top` above the baseline.
struct bar_metrics {
    double top = 0.0;
    double thickness = 0.0;  ///< from top to bottom, in em
};

/// Small letters that a font suggests.
struct script_metrics {
    double size = 1.0;  ///< times the other letters'
    double rise = 0.0;  ///< of their baseline; negative for subscripts
};

/// What a font says of what is set with its letters. Lengths are in em.
struct face_metrics {
    bar_metrics underline{-0.1, 0.05};
    bar_metrics strike_through{0.28, 0.05};
    script_metrics superscript{0.65, 0.35};
    script_metrics subscript{0.65, -0.15};
};

/// The same in other units.
[[nodiscard]] constexpr line_metrics scaled(const line_metrics& m, double factor) noexcept
{
    return {factor * m.ascender, factor * m.descender, factor * m.gap};
}

/// Of a shaper's faces, or of the only one: its own, if it has any.
///
///     s.suggested_metrics()        of a shaper of one face      s.suggested_metrics(face)      of several
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

/// The metrics of one of a shaper's faces for lines, in units of the first: s.metrics(direction, face), or the first
/// one's.
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

/// How far a line of one of a shaper's faces reaches to both sides, in units of the first: as its metrics say, but a
/// column at least as far as letters of the face that lie on their side in it. Vertical metrics are often those of an
/// ideograph alone: half an em to each side and no gap.
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
