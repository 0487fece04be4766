// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A report of what happened to a text's glyphs: which are not in the mesh, and why; which are in it in another form
/// than requested. A text is built even if glyphs were lost.
struct text_report {
    std::uint32_t glyphs = 0;   ///< in the run, including blank and missing ones
    std::uint32_t blank = 0;    ///< without an outline, such as spaces, or with no filled area
    std::uint32_t refused = 0;  ///< left out because they cannot be built; a merged group counts as one
    error first_refusal;        ///< why, with glyph and cluster; none if refused == 0
    std::uint32_t missing = 0;  ///< the font lacks them; emoji that were split into parts count
    cluster_id first_missing = no_cluster;
    std::uint32_t parted = 0;              ///< missing emoji that are drawn in parts: families, flags, skin tones
    cluster_id first_parted = no_cluster;  ///< position of the first in the text
    std::uint32_t invalid_units = 0;       ///< places of the text that were not valid UTF and were read as U+FFFD
    cluster_id first_invalid_unit = no_cluster;
    std::uint32_t unbroken = 0;  ///< runs of text whose words only a dictionary can find: see glyph_run
    cluster_id first_unbroken = no_cluster;

    /// Glyphs of the mesh whose bevels are narrower, or whose edges moved less, than requested, because the full width
    /// was not proven. A merged group counts as one. They are the plan.glyphs() whose built->is_narrowed(). With
    /// bevel_mode::fit or fit_text, bevels count if they became less than half as wide.
    std::uint32_t narrowed = 0;
    cluster_id first_narrowed = no_cluster;

    /// Corners that touched and were parted or joined, over all glyphs of the mesh; see text_options::corners. For
    /// outward bevels it also counts corners that would have touched and made the bevels narrower.
    std::uint64_t corners_moved = 0;
    std::uint32_t touching = 0;              ///< glyphs in which some corners could not be parted or joined
    cluster_id first_touching = no_cluster;  ///< position of the first of them
    /// Pieces of glyphs, smaller than the tolerance, whose bevels meet in a ridge in spite of bevel_mode::fit.
    std::uint32_t lost_caps = 0;
    cluster_id first_lost_cap = no_cluster;  ///< position of the first of them

    /// True if nothing was lost: every glyph of the text is in the mesh, and no place was read as U+FFFD.
    [[nodiscard]] constexpr bool complete() const noexcept
    {
        return refused == 0 && missing == 0 && invalid_units == 0;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
