// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/touching.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How many points a glyph's contours may have, unless the caller says otherwise: see text_options::max_points.
inline constexpr std::uint32_t default_most_points = 1'000'000;

/// Where a straight edge comes from: its first point lies at t0 of `curve`, its second at t1. t0 > t1 where the contour
/// has been reversed and runs against its curve. The two differ, however short the edge, as long as floats can tell
/// them apart.
struct contour_edge {
    std::uint32_t curve = 0;
    float t0 = 0.0f;
    float t1 = 1.0f;
};

/// Closed polylines on the grid: what a discretiser makes of curves by flattening them, and what fill reads. Nothing is
/// proven about them; see region.
///
///     points   [ first contour | second contour | ... ]            each contour's last point is joined to its first
///     edges    edges[i] runs from points[i] to the next point of the same contour
///     starts   [ 0 | first point of each further contour | ... | points.size() ]
///     curves   the curves that the edges refer to
///
/// Every contour has at least 3 points and no two equal neighbours.
struct contours {
    buffer<grid_point> points;
    buffer<contour_edge> edges;
    buffer<std::uint32_t> starts;
    array_view<const curve> curves;  ///< not owned: the outline's
    typemesh::grid grid;
    double tolerance = 0.0;                   ///< in cells: how far the edges may be from their curves; 0: unknown
    std::uint32_t max_points = 0xFFFF'FFFFu;  ///< discretise() refuses to put in more; clear() leaves this alone

    /// What is to become of corners that touch, in regions made of these loops and of what moves away from them; see
    /// fill/corner_parting.hpp. clear() leaves this alone.
    touching corners = touching::keep;

    explicit contours(memory source = heap()) noexcept : points{source}, edges{source}, starts{source}, order_{source}
    {
    }

    [[nodiscard]] std::uint32_t contour_count() const noexcept
    {
        return starts.empty() ? 0u : static_cast<std::uint32_t>(starts.size() - 1);
    }
    void clear() noexcept
    {
        points.clear();
        edges.clear();
        starts.clear();
        curves = {};
        tolerance = 0.0;
        forget_order();
    }

    /// The indices of the points in the order of a left-to-right sweep: by x, then y, then index. Empty unless they
    /// have been sorted (see sort_points() in sweep/impl/sweep_order.hpp) since their number last changed and since
    /// clear() or forget_order(). After moving points one of these must be called; this is asserted.
    [[nodiscard]] array_view<const std::uint32_t> order() const noexcept
    {
        if (order_.size() != points.size()) return {};
        TYPEMESH_ASSERT(is_in_order(),
                        "the points of contours were moved after they had been sorted: call clear() "
                        "or forget_order()");
        return order_.view();
    }
    void forget_order() noexcept { order_.clear(); }

    /// An array for the order of `size` points, to be filled in; null, and no order, when memory runs out.
    [[nodiscard]] std::uint32_t* new_order(std::size_t size) noexcept
    {
        order_.clear();
        return order_.append(size);
    }

private:
    [[nodiscard]] bool is_in_order() const noexcept
    {
        for (std::size_t i = 0; i < order_.size(); ++i) {
            if (order_[i] >= points.size()) return false;
            if (i == 0) continue;
            const grid_point p = points[order_[i - 1]], q = points[order_[i]];
            if (!lexicographic_less(p, q) && !(p == q && order_[i - 1] < order_[i])) return false;
        }
        return true;
    }

    buffer<std::uint32_t> order_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
