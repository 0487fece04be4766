// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

struct glyph_run;  // of the room layout, which this room does not see

/// A step between the font and everything else: turns each glyph's outline into another one, at its place in the text.
/// bend/warped.hpp is the library's own.
///
///     s(drawn, place, tolerance, most, out)
///                            the new outline, with at most `most` curves, into `out`, which is empty; `tolerance` is
///                            the text's own, in em. Returns the tolerance that is left for flattening: less than
///                            `tolerance` by the step's own error. A curve ends exactly where the next one begins
///     s.refused(text)        the error with which it refuses its options, or a text whose pens fill this box, in em,
///                            or none
///     s.place(run, units_per_em, stands)
///                            optional, returns an error: where the glyphs of a run stand. Fills in `stands`, one for
///                            each glyph. Glyphs that are not warped are only moved and turned: they are built once
///                            and cached as without the step. The step draws the warped ones at their places in the
///                            run, and drawn_place::stand is the glyph's own. In texts that are merged, whose corners
///                            are changed, or whose solids are bent, it draws the turned ones as well
///     s.cache_key()          not needed: glyphs with such a step are built at their places and not cached
template <class S>
concept outline_step =
    requires(const S& s, const outline& drawn, const drawn_place& at, std::uint32_t most, outline& out) {
        { s(drawn, at, 1.0, most, out) } noexcept -> std::same_as<result<double>>;
        { s.refused(at.text) } noexcept -> std::same_as<error>;
    };

/// A step that also says where glyphs stand.
template <class S>
concept placing_step = outline_step<S> && requires(const S& s, const glyph_run& run, glyph_stand* stands) {
    { s.place(run, 1.0, stands) } noexcept -> std::same_as<error>;
};

/// A step that changes nothing: outlines are used as they are drawn.
struct no_outline_step {};

}  // namespace typemesh::inline TYPEMESH_ABI
