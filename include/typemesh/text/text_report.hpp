// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A report on a text's glyphs: which glyphs are not in the mesh, and why, and which glyphs have another form than
/// requested. A text is built even if glyphs were lost.
struct text_report {
    std::uint32_t glyphs = 0;   ///< the number of glyphs in the run, including blank and missing glyphs
    std::uint32_t blank = 0;    ///< the number of glyphs without an outline, such as spaces, or without a filled area
    std::uint32_t refused = 0;  ///< the number of glyphs left out because they cannot be built; a merged group counts
                                ///< as one
    error first_refusal;        ///< the reason for the first of them, with glyph and cluster; none if refused == 0
    std::uint32_t missing = 0;  ///< the number of glyphs that the font lacks; emoji that are drawn in parts count
    cluster_id first_missing = no_cluster;
    std::uint32_t parted = 0;              ///< the number of missing emoji that are drawn in parts: families, flags,
                                           ///< skin tones
    cluster_id first_parted = no_cluster;  ///< the position of the first of these emoji in the text
    std::uint32_t invalid_units = 0;       ///< the number of places of the text that were not valid UTF and were read
                                           ///< as U+FFFD
    cluster_id first_invalid_unit = no_cluster;
    std::uint32_t unbroken = 0;  ///< the number of runs of text whose words only a dictionary can find: see glyph_run
    cluster_id first_unbroken = no_cluster;
    std::uint32_t off_path = 0;              ///< the number of glyphs for which a path has no room: see on_path.hpp
    cluster_id first_off_path = no_cluster;  ///< the lowest position of such a glyph in the text

    /// The number of glyphs whose bevels are narrower than requested, or whose edges moved less, because the full width
    /// was not proven simple. A merged group counts as one. They are the plan.glyphs() for which built->is_narrowed().
    /// With bevel_mode::fit or fit_text, bevels count if they became less than half as wide.
    std::uint32_t narrowed = 0;
    cluster_id first_narrowed = no_cluster;

    /// The number of corners that touched and were separated or joined, in all glyphs of the mesh; see
    /// text_options::corners. With outward bevels, corners that would have touched and made the bevels narrower also
    /// count.
    std::uint64_t corners_moved = 0;
    std::uint32_t touching = 0;              ///< the number of glyphs in which some corners could not be separated or
                                             ///< joined, or front and back may meet inside the outline, because
                                             ///< walls have no room to be as high as they should
    cluster_id first_touching = no_cluster;  ///< position of the first of them
    /// The number of glyphs' components, smaller than the tolerance, whose bevels meet in a ridge in spite of
    /// bevel_mode::fit.
    std::uint32_t lost_caps = 0;
    cluster_id first_lost_cap = no_cluster;  ///< position of the first of them
    /// The number of triangles of refined caps that miss the refiner's aim, such as its least angle: see
    /// refined_cap::kept. A glyph counts as often as it occurs.
    std::uint32_t kept_triangles = 0;
    cluster_id first_kept_triangle = no_cluster;  ///< position of the first glyph with one

    /// True if nothing was lost: every glyph of the text that has an outline is in the mesh, and no place was read as
    /// U+FFFD. Glyphs without an outline do not count. If a damaged font has lost the outline of a letter, only `blank`
    /// shows it.
    [[nodiscard]] constexpr bool complete() const noexcept
    {
        return refused == 0 && missing == 0 && invalid_units == 0 && off_path == 0;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
