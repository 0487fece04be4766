// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One glyph's closed contours as curves, in font units.
///
///     curves   [ curves of the first contour | of the second | ... ]
///     starts   [ 0 | first curve of each further contour | ... | curves.size() ]; empty if there is no contour
///
/// In a contour each curve begins where the previous one ends, and the last one ends where the first began.
struct outline {
    buffer<curve> curves;
    buffer<std::uint32_t> starts;
    box bounds;  ///< the bounding box of all control points
    fill_rule rule = fill_rule::non_zero;

    explicit outline(memory source = heap()) noexcept : curves{source}, starts{source} {}

    [[nodiscard]] std::uint32_t contour_count() const noexcept
    {
        return starts.empty() ? 0u : static_cast<std::uint32_t>(starts.size() - 1);
    }
    void clear() noexcept
    {
        curves.clear();
        starts.clear();
        bounds = {};
    }
};

/// Where an outline step lets a glyph of a run stand: moved and turned as a whole, or warped. See outline_step.hpp.
struct glyph_stand {
    point origin = {};         ///< the place of the glyph's own origin, in font units
    point right = {1.0, 0.0};  ///< the direction of its own x axis: a unit vector. Exactly {1, 0}: it is not turned
    double start = 0.0;        ///< for the step itself, if it warps the glyph
    double stretch = 1.0;      ///< likewise
    bool warped = false;       ///< whether the step warps it; `origin` and `right` then say where it stands roughly
    bool left_out = false;     ///< whether there is no place for it, so that it is not drawn
};

/// The place of a glyph's outline in the text, for steps that depend on it.
struct drawn_place {
    point origin = {};         ///< the glyph's own origin, relative to the text's, in em
    double em_per_unit = 0.0;  ///< em per font unit
    box text = {};             ///< from the first pen position of the text to its last, lowest and highest baseline
                               ///< included, in em; empty: unknown
    const glyph_stand* stand = nullptr;  ///< its stand, if the step has a place()
};

}  // namespace typemesh::inline TYPEMESH_ABI
