// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/touching.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A filled area of the plane, proven valid. Its boundary cycles have the interior on their left: outer loops are
/// counter-clockwise, holes clockwise. No two edges cross or overlap, no point lies inside an edge, there are no
/// spikes, and consecutive points are distinct. Cycles may pass through a point more than once (see is_touching), each
/// time along a separate sector of the interior.
///
///     +-------------<-----------+      points, edges, starts, curves as in contours
///     |  outer      +--->--+    |
///     v             | hole |    ^      n points, h holes, c outer loops are filled by exactly
///     |             +--<---+    |      n + 2h - 2c triangles over these points
///     +------------->-----------+
///
/// outer_of() (fill/outer_of.hpp) finds the outer loop around a hole.
///
/// A region is a view: it refers to the contours that were proven, which must outlive it. Who makes a region
/// calls proven(): fill, proving triangulators, and stages that change a region in steps that keep all this. The caller
/// of proven() guarantees everything above.
class region {
public:
    region() noexcept = default;

    [[nodiscard]] static region proven(const contours& loops, std::uint32_t holes, std::uint32_t outers,
                                       bool touching = false) noexcept
    {
        region r;
        r.points_ = loops.points.view();
        r.edges_ = loops.edges.view();
        r.starts_ = loops.starts.view();
        r.order_ = loops.order();
        r.curves_ = loops.curves;
        r.grid_ = loops.grid;
        r.tolerance_ = loops.tolerance;
        r.holes_ = holes;
        r.outers_ = outers;
        r.touching_ = touching;
        r.corners_ = loops.corners;
        return r;
    }

    [[nodiscard]] array_view<const grid_point> points() const noexcept { return points_; }
    [[nodiscard]] array_view<const contour_edge> edges() const noexcept { return edges_; }
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return starts_; }
    /// The order of the points, as in contours::order(). It is empty if the points have not been sorted.
    [[nodiscard]] array_view<const std::uint32_t> order() const noexcept { return order_; }
    [[nodiscard]] array_view<const curve> curves() const noexcept { return curves_; }
    /// The grid on which its points lie.
    [[nodiscard]] typemesh::grid grid() const noexcept { return grid_; }

    /// The limit for the distance between edges and curves, except at crossings, in cells. 0: unknown (the loops were
    /// made by hand, or by a discretiser that keeps no tolerance).
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    [[nodiscard]] std::uint32_t holes() const noexcept { return holes_; }
    /// The number of outer loops. The other loops are holes.
    [[nodiscard]] std::uint32_t outers() const noexcept { return outers_; }
    [[nodiscard]] std::uint32_t loop_count() const noexcept
    {
        return starts_.empty() ? 0u : static_cast<std::uint32_t>(starts_.size() - 1);
    }

    /// Whether the cycles pass through any point more than once. If not, all points are distinct.
    [[nodiscard]] bool is_touching() const noexcept { return touching_; }

    /// How to treat corners that touch: see contours.
    [[nodiscard]] typemesh::touching corners() const noexcept { return corners_; }

    /// The number of triangles, n + 2h - 2c. It is below 2^32 for every region that fits into 32-bit memory.
    [[nodiscard]] std::uint32_t triangle_count() const noexcept
    {
        return static_cast<std::uint32_t>(points_.size()) + 2 * holes_ - 2 * outers_;
    }

private:
    array_view<const grid_point> points_;
    array_view<const contour_edge> edges_;
    array_view<const std::uint32_t> starts_;
    array_view<const std::uint32_t> order_;
    array_view<const curve> curves_;
    typemesh::grid grid_;
    double tolerance_ = 0.0;
    std::uint32_t holes_ = 0;
    std::uint32_t outers_ = 0;
    bool touching_ = false;
    typemesh::touching corners_ = typemesh::touching::keep;
};

}  // namespace typemesh::inline TYPEMESH_ABI
