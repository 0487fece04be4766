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

/// The default limit for the number of points in a glyph's contours: see text_options::max_points.
inline constexpr std::uint32_t default_max_points = 1'000'000;

/// The curve from which a straight edge comes: the edge's first point lies at t0 of `curve`, its second point at t1. If
/// the contour has been reversed, its edges run against their curves, and t0 > t1. t0 and t1 are distinct even for very
/// short edges, as long as floats can represent the difference.
struct contour_edge {
    std::uint32_t curve = 0;
    float t0 = 0.0f;
    float t1 = 1.0f;
};

/// Closed polylines on the grid. A discretiser makes them from curves, and fill reads them. Nothing is proven about
/// them; see region.
///
///     points   [ first contour | second contour | ... ]            the last edge of a contour ends at its first point
///     edges    edges[i] runs from points[i] to the next point of the same contour
///     starts   [ 0 | first point of each further contour | ... | points.size() ]
///     curves   the curves that the edges refer to
///
/// Every contour has at least 3 points, and its neighbouring points are distinct.
struct contours {
    buffer<grid_point> points;
    buffer<contour_edge> edges;
    buffer<std::uint32_t> starts;
    array_view<const curve> curves;  ///< the curves, which the outline owns
    typemesh::grid grid;
    double tolerance = 0.0;                   ///< the limit for the distance between edges and curves, in cells; 0:
                                              ///< unknown
    std::uint32_t max_points = 0xFFFF'FFFFu;  ///< the limit for discretise(); clear() does not change it

    /// How to treat corners that touch, in regions made of these loops or of their offsets: see
    /// fill/corner_parting.hpp. clear() does not change it.
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

    /// The indices of the points in the order of a left-to-right sweep: by x, then y, then index. It is empty until a
    /// stage that needs the order has sorted them. A change in the number of points, clear() and forget_order() make it
    /// empty again. Call forget_order() or clear() after moving points; otherwise an assertion fails.
    [[nodiscard]] array_view<const std::uint32_t> order() const noexcept
    {
        if (order_.size() != points.size()) return {};
        TYPEMESH_ASSERT(is_in_order(),
                        "the points of contours were moved after they had been sorted: call clear() "
                        "or forget_order()");
        return order_.view();
    }
    void forget_order() noexcept { order_.clear(); }

    /// An array for the order of `size` points, which the caller fills in. Returns null when out of memory; then there
    /// is no order.
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
