// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/plate/stencil_wishes.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How a text and its plate are combined.
///
///        .--.            .--.
///     ---+  +---      ---.  .---      ---.  .---      ---.##.---
///                        '--'            |  |            '##'
///     ----------      ----------      ---'  '---      ----------
///      standing        engraved          cut             inlay
///
/// Standing letters may reach beyond the plate; they then go down to its back.
enum class plate_style : std::uint8_t { standing, engraved, cut, inlay };

/// The options of a name_plate. Lengths are in em.
struct plate_options {
    plate_style style = plate_style::standing;
    float margin = 0.2f;     ///< the distance from the letters' box to the rim; it may be negative
    float radius = 0.1f;     ///< of the plate's corners; at most half of its shorter side is used
    float thickness = 0.1f;  ///< of the plate
    float depth = 0.05f;     ///< the height of standing letters above the plate, or the depth of engraved letters and
        ///< of inlays; at the plate's thickness or more, these go through it. Cut letters ignore it
    float bevel = 0.0f;         ///< the width and depth of the bevels along the rims: of the plate, above and below, of
                                ///< the faces of standing letters, and of the edges of engraved and cut letters, but
                                ///< not of an inlay; 0: none. What does not fit becomes narrower: name_plate::rims()
    float fillet = 0.0f;        ///< the radius of the fillet at the foot of standing letters, likewise; 0: none
    bool round_bevels = false;  ///< whether bevels are quarters of a circle; otherwise they are chamfers of 45 degrees
    bool mirrored = false;      ///< whether everything is mirrored from left to right: a stamp
    bool fill_counters = false;  ///< whether a plate that follows an outline has no holes
    float ring_hole = 0.0f;      ///< the radius of a keyring's hole at the left end of the plate; 0: no hole
    float ring_width = 0.06f;    ///< the width of the ring around this hole; the ring overlaps the plate by this width
    float bridge_width = 0.0f;   ///< the width of the bridges of a stencil (plate_style::cut), never wider than
                                 ///< the plate's longer side; 0: none
    std::uint32_t bridges = 2;   ///< the number of bridges per island, 1 to 8 (stencil_wishes)
    touching corners = touching::part;  ///< part: corners that touch are separated, so that the mesh is strictly
                                        ///< 2-manifold; keep: they stay as drawn. join is as part, except within a
                                        ///< silhouette
    std::uint32_t max_pieces = default_max_pieces;  ///< see resolve()

    /// The refusal of an option outside its range, or none.
    [[nodiscard]] error refused() const noexcept
    {
        const auto is_length = [](float v) noexcept { return is_finite(as_double(v)) && v >= 0.0f && v <= 1000.0f; };
        if (!is_finite(as_double(margin)) || !(margin >= -1000.0f && margin <= 1000.0f)) return error::bad("margin");
        if (!is_length(radius)) return error::bad("radius");
        if (!is_length(thickness) || !(thickness > 0.0f)) return error::bad("thickness");
        if (!is_length(depth) || !(depth > 0.0f)) return error::bad("depth");
        if (!is_length(bevel)) return error::bad("bevel");
        if (!is_length(fillet)) return error::bad("fillet");
        if (!is_length(ring_hole)) return error::bad("ring_hole");
        if (!is_length(ring_width) || !(ring_width > 0.0f)) return error::bad("ring_width");
        if (!is_length(bridge_width)) return error::bad("bridge_width");
        if (bridges < 1 || bridges > stencil_wishes::max_per_island) return error::bad("bridges");
        return {};
    }

    /// The room that a plate needs around its text, in em.
    [[nodiscard]] constexpr double room() const noexcept
    {
        return (margin > 0.0f ? as_double(margin) : 0.0) + 2.0 * (as_double(ring_hole) + as_double(ring_width)) + 0.5;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
