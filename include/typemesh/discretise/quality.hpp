// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/finite.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The smoothness of curves: the greatest distance between a curve and its chords, in em. Multiplied by the font's
/// units per em, it is a tolerance in font units.
///
/// normal, high and best are modelled on presets of the thesis ("Study of mesh generation and optimization techniques
/// applied to parametric forms", J. Vandenbergh, 2020): on real fonts, 99 of 100 chords of a preset are within about
/// this error. low replaces the two lines per curve of the thesis. thesis_quality has the presets themselves.
/// `certified` keeps these tolerances on all chords, with 19 to 40 % fewer chords than the presets.
namespace quality {

inline constexpr double low = 1.0 / 100;
inline constexpr double normal = 1.0 / 160;
inline constexpr double high = 1.0 / 800;
inline constexpr double best = 1.0 / 16000;

}  // namespace quality

/// The tolerance in em for an error of at most `error_in_pixels` if one em is drawn `pixels_per_em` large. A quarter of
/// a pixel is hard to see.
///
/// The result is 0 if either number is not positive and finite; discretise() rejects 0 with error::bad_tolerance.
[[nodiscard]] inline double tolerance_for_pixels(double pixels_per_em, double error_in_pixels = 0.25) noexcept
{
    if (!is_finite(pixels_per_em) || !is_finite(error_in_pixels)) return 0.0;
    if (!(pixels_per_em > 0.0) || !(error_in_pixels > 0.0)) return 0.0;
    const double tolerance = error_in_pixels / pixels_per_em;
    return is_finite(tolerance) ? tolerance : 0.0;
}

}  // namespace typemesh::inline TYPEMESH_ABI
