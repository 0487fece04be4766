// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/shape_options.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <concepts>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A font's own metrics for lines, in font units, y up.
///
///     ascender  ----------------   positive            horizontal: the distance between baselines is
///     baseline  --A-g----------   0                    ascender - descender + gap
///     descender ----------------   negative            vertical: x to the right; columns stand that far apart, or
///                                                      further: see line_reach_of()
struct line_metrics {
    double ascender = 0.0;
    double descender = 0.0;
    double gap = 0.0;
};

/// Turns text into glyphs at pen positions: HarfBuzz, or something of your own.
///
///     s.units_per_em()                    as in outline_source; of the same font
///     s.metrics(direction)                the font's line metrics, for horizontal or vertical lines
///     s.shape(text, first, last, o, run)  appends the glyphs of text[first, last), one line without line breaks (or a
///                                         segment of one between two tabs: see shape_line()), to run.glyphs, in
///                                         drawing order, with the pen starting at (0, 0), and returns the pen's
///                                         offset: {advance x, advance y} in font units; horizontal lines always run to
///                                         the right, vertical lines down. o.direction is the line's, letters keep
///                                         their own. Clusters count from the start of `text`, in its
///                                         units. Flags missing glyphs and calls run.note_missing() for each; calls
///                                         run.note_invalid_units() where the text is not valid UTF.
///                                         Glyphs that are not simply drawn by the source's first face refer to
///                                         a look: run.number_of(look).
///
/// Fails  error::needs_shaping: the shaper is not made for this script, or for a line of both directions: it draws
///                              nothing in the wrong order
///        error::out_of_memory; the run may then hold some of the line's glyphs
template <class S>
concept shaper = requires(S& s, text_view text, std::size_t i, const shape_options& o, glyph_run& run) {
    { s.units_per_em() } noexcept -> std::convertible_to<double>;
    { s.metrics(o.direction) } noexcept -> std::same_as<line_metrics>;
    { s.shape(text, i, i, o, run) } noexcept -> std::same_as<result<point>>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
