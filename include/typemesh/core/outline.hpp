// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/glyph_stand.hpp>
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

/// The place of a glyph's outline in the text, for steps that depend on it.
struct drawn_place {
    point origin = {};         ///< the glyph's own origin, relative to the text's, in em
    double em_per_unit = 0.0;  ///< em per font unit
    box text = {};             ///< from the first pen position of the text to its last, lowest and highest baseline
                               ///< included, in em; empty: unknown
    const glyph_stand* stand = nullptr;  ///< its stand, if the step has a place()
};

}  // namespace typemesh::inline TYPEMESH_ABI
