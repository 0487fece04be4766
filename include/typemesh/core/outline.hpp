// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/fill_rule.hpp>

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

}  // namespace typemesh::inline TYPEMESH_ABI
