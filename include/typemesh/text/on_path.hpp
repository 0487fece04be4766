// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/along_path.hpp>
#include <typemesh/bend/plane_path.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/glyph/outline_step.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/text/impl/path_letters.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Where on a path a text stands: its start at the path's start, its middle in the middle, or its end at the end.
enum class path_anchor : std::uint8_t { start, middle, end };

/// The side of a path on which letters stand. On the right, the path is walked from its end, so that letters are
/// upright there: its end is the start for path_anchor.
enum class path_side : std::uint8_t { left, right };

/// Whether a text keeps its length, or is spread over the whole path.
enum class path_fit : std::uint8_t { keep, spread };

/// Which letters are warped, and not turned as a whole.
enum class path_warp : std::uint8_t {
    automatic,  ///< letters of joined scripts (placed_glyph::joined), so that their joins hold
    never,
    always,
};

/// How a text stands on a path.
struct path_options {
    path_anchor anchor = path_anchor::start;  ///< where the text stands
    double offset = 0.0;                      ///< the way along the path from there, in em
    path_side side = path_side::left;         ///< on which side letters stand
    path_fit fit = path_fit::keep;            ///< whether the text is spread over the path; anchor is then ignored
    path_warp warp = path_warp::automatic;    ///< which letters are warped
};

/// Text on a path (bend/plane_path.hpp). A mesher takes it in place of a warp, for texts and for runs of any layout:
///
///     plane_path ring;
///     ring.circle({0, 0}, 2.0);
///     text_mesher mesher{font, on_path{&ring, {.anchor = path_anchor::middle}}};
///
///             I N              A letter is turned as a whole: the middle of its cluster's advance touches the path,
///          R       G           and its baseline is the tangent there. Marks turn with their base, ligatures as one.
///         .-~-----~-.          Letters are built once and cached, and instances gain a rotation.
///
/// Letters of joined scripts are warped instead, outline by outline, as warped{along_path} does, and so are underlines
/// and other bars. Each of these is built at its own place, without a cache; the turned letters beside them are cached
/// all the same. With text_options::merge or corners, and in bent solids, every glyph is built at its place. On a path
/// that is one line, nothing is warped.
///
/// Joins of warped letters hold where their outlines overlap or share corners. Edges along the line that only abut,
/// such as a vowel sign's on a headline, meet within the tolerance.
///
/// The text is anchored as one block: its lines keep their places relative to each other. Their heights become
/// distances from the path, so lines above the first one stand farther out, at the same angles. Directions of reading
/// do not matter: the left end of a line comes first.
///
/// A glyph whose middle lies beyond an end of the path, or beyond a full round of a closed one, is left out, and the
/// report counts it (text_report::off_path).
///
/// Textures cover the flat text, and turn with its letters. Warped letters have the textures that warped{} gives them.
///
/// Fails  error::bad_option: there is no path, it is empty or has failed ("path"), or offset is not finite or above
///        2^20 ("offset"), or the text has columns ("direction"); as the path's failure()
///        error::folds_over: a warped letter lies on a corner, or reaches the centre of a bend
///        as warped does
/// Cost   O(glyphs log pieces); nothing is allocated here
struct on_path {
    const plane_path* path = nullptr;  ///< must outlive the plan, and must not change before it is written
    path_options how = {};             ///< how the text stands on it

    /// See option_bits. Turned letters are cached as without the path; warped ones are not cached.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    /// See outline_step.
    [[nodiscard]] error refused(const box&) const noexcept
    {
        if (error e = along_path{path}.refused_options()) return e;
        return is_finite(how.offset) && std::fabs(how.offset) <= 0x1p20 ? error{} : error::bad("offset");
    }

    /// See placing_step.
    [[nodiscard]] error place(const glyph_run& run, double units_per_em, glyph_stand* stands) const noexcept
    {
        const detail::path_letters letters{run, units_per_em};
        if (letters.has_columns()) return error::bad("direction");
        const detail::text_extent text = letters.extent();
        const double all = path->length(), length = (text.high - text.low) / units_per_em;
        along_path way{path, 0.0, 1.0, how.side == path_side::right};
        if (how.fit == path_fit::spread && length > 0x1p-20) way.stretch = all / length;
        const double rest = how.fit == path_fit::spread         ? 0.0
                            : how.anchor == path_anchor::start  ? 0.0
                            : how.anchor == path_anchor::middle ? 0.5 * (all - length)
                                                                : all - length;
        way.start = rest + how.offset - way.stretch * (text.low / units_per_em);
        const bool bends = !path->is_straight();
        letters.stand(way, stands);
        for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
            const placed_glyph& g = run.glyphs[i];
            stands[i].warped = bends && !stands[i].left_out &&
                               (g.cluster == no_cluster || how.warp == path_warp::always ||
                                (how.warp == path_warp::automatic && g.joined));
        }
        return {};
    }

    /// See outline_step.
    [[nodiscard]] result<double> operator()(const outline& drawn, const drawn_place& at, double tolerance,
                                            std::uint32_t most, outline& out) const noexcept
    {
        const glyph_stand stand = at.stand != nullptr ? *at.stand : glyph_stand{.warped = true};
        if (stand.warped) {
            const warped<along_path> step{{path, stand.start, stand.stretch, how.side == path_side::right}};
            return step(drawn, at, tolerance, most, out);
        }
        if (error e = detail::turn_outline(drawn, stand, (1.0 / at.em_per_unit) * at.origin, most, out)) return e;
        return tolerance;
    }
};
static_assert(placing_step<on_path>);

}  // namespace typemesh::inline TYPEMESH_ABI
