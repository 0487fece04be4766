// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <concepts>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A font's line metrics, in font units, y up.
///
///     ascender  ----------------   positive            horizontal: the distance between baselines is
///     baseline  --A-g----------   0                    ascender - descender + gap
///     descender ----------------   negative            vertical: x to the right; columns are that far apart, or
///                                                      further: see line_reach_of()
struct line_metrics {
    double ascender = 0.0;
    double descender = 0.0;
    double gap = 0.0;
};

/// Turns text into glyphs at pen positions: HarfBuzz, or your own shaper.
///
///     s.units_per_em()                    as in outline_source; for the same font
///     s.metrics(direction)                the font's line metrics, for horizontal or vertical lines
///     s.shape(text, first, last, o, run)  appends the glyphs of text[first, last) to run.glyphs in drawing order. The
///                                         pen starts at (0, 0). The text is one line without line breaks, or a segment
///                                         of a line between two tabs: see shape_line(). It returns the pen's offset:
///                                         {advance x, advance y} in font units. Horizontal lines always run to the
///                                         right, vertical lines down. o.direction is the direction of the line;
///                                         letters keep their own. Clusters count from the start of `text`, in its
///                                         units. It flags missing glyphs and calls run.note_missing() for each. It
///                                         calls run.note_invalid_units() where the text is not valid UTF.
///                                         Glyphs that need more than the source's first face, unchanged, refer to
///                                         a look: run.number_of(look).
///
/// Fails  error::needs_shaping: the shaper does not support this script, or a line of both directions. It never draws
///                              in the wrong order.
///        error::out_of_memory; the run may then have some of the line's glyphs
template <class S>
concept shaper = requires(S& s, text_view text, std::size_t i, const shape_options& o, glyph_run& run) {
    { s.units_per_em() } noexcept -> std::convertible_to<double>;
    { s.metrics(o.direction) } noexcept -> std::same_as<line_metrics>;
    { s.shape(text, i, i, o, run) } noexcept -> std::same_as<result<point>>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
