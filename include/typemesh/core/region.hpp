// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>

#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A filled area of the plane, proven: boundary walks with the interior on the left, outer loops counter-clockwise,
/// holes clockwise, no two edges crossing or overlapping, no spike, no repeated neighbour. A point may be visited more
/// than once (see is_touching), by walks that each keep to their own sector of interior there; no point lies within
/// another's edge.
///
///     +-------------<-----------+      points, edges, starts, curves as in contours
///     |  outer      +--->--+    |
///     v             | hole |    ^      n points, h holes, c outer loops are filled by exactly
///     |             +--<---+    |      n + 2h - 2c triangles over these points
///     +------------->-----------+
///
/// Which hole lies in which outer loop is told by outer_of() (fill/outer_of.hpp).
///
/// A view: it refers to the contours it was proven from and ends with them. Only fill and a triangulator that proves
/// make one; proven() is their door, and the promise above is what passes through it.
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
        r.curves_ = loops.curves;
        r.grid_ = loops.grid;
        r.tolerance_ = loops.tolerance;
        r.holes_ = holes;
        r.outers_ = outers;
        r.touching_ = touching;
        return r;
    }

    [[nodiscard]] std::span<const grid_point> points() const noexcept { return points_; }
    [[nodiscard]] std::span<const contour_edge> edges() const noexcept { return edges_; }
    [[nodiscard]] std::span<const std::uint32_t> starts() const noexcept { return starts_; }
    [[nodiscard]] std::span<const curve> curves() const noexcept { return curves_; }
    [[nodiscard]] typemesh::grid grid() const noexcept { return grid_; }

    /// In cells: how far the edges may be from their curves, crossings apart; 0: nobody says (loops made by hand,
    /// discretisers that keep no tolerance).
    [[nodiscard]] double tolerance() const noexcept { return tolerance_; }
    [[nodiscard]] std::uint32_t holes() const noexcept { return holes_; }
    [[nodiscard]] std::uint32_t outers() const noexcept { return outers_; }
    [[nodiscard]] std::uint32_t loop_count() const noexcept
    {
        return starts_.empty() ? 0u : static_cast<std::uint32_t>(starts_.size() - 1);
    }

    /// Whether the walks come through some point more than once. If not, all points are different.
    [[nodiscard]] bool is_touching() const noexcept { return touching_; }

    /// n + 2h - 2c, below 2^32 for every region that fits into memory of 32-bit numbers.
    [[nodiscard]] std::uint32_t triangle_count() const noexcept
    {
        return static_cast<std::uint32_t>(points_.size()) + 2 * holes_ - 2 * outers_;
    }

private:
    std::span<const grid_point> points_;
    std::span<const contour_edge> edges_;
    std::span<const std::uint32_t> starts_;
    std::span<const curve> curves_;
    typemesh::grid grid_;
    double tolerance_ = 0.0;
    std::uint32_t holes_ = 0;
    std::uint32_t outers_ = 0;
    bool touching_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
