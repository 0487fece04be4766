// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How the stroke of an open path ends.
enum class stroke_cap : std::uint8_t {
    butt,   ///< at the path's end
    round,  ///< in half a disc around the end
    square  ///< half a width beyond the end
};

/// How the stroke goes around a corner.
enum class stroke_join : std::uint8_t {
    mitre,  ///< the outer edges meet in a tip; if that is farther away than the limit, bevel
    round,  ///< a disc around the corner
    bevel   ///< the corner is cut off
};

/// The shape of a stroke, as in SVG 2, section 13.5.
struct stroke_style {
    double width = 0.05;                    ///< of the whole stroke, in em; positive
    stroke_cap cap = stroke_cap::butt;      ///< the ends of open paths
    stroke_join join = stroke_join::mitre;  ///< the corners
    double mitre_limit = 4.0;               ///< the greatest length of a mitre, in widths; at least 1

    /// The lengths of dashes and gaps in turn, in em, which the caller keeps. An odd number of them is repeated. Empty,
    /// or all 0: no gaps.
    array_view<const double> dashes = {};
    double dash_offset = 0.0;  ///< where in the pattern a path begins, in em

    /// The error for options out of range, or none.
    [[nodiscard]] error refused() const noexcept
    {
        if (!is_finite(width) || !(width > 0.0)) return error::bad("width");
        if (!is_finite(mitre_limit) || !(mitre_limit >= 1.0)) return error::bad("mitre_limit");
        if (!is_finite(dash_offset)) return error::bad("dash_offset");
        for (const double length : dashes)
            if (!is_finite(length) || !(length >= 0.0)) return error::bad("dashes");
        return {};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
