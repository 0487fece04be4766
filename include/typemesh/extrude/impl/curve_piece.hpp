// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>

#include <algorithm>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A piece of a region's boundary that follows one curve: an arc of a conic with its control triangle, or a straight
/// edge.
///
///             control                   the interior lies on the left of the way from `start` to `end`
///              /   \         .
///             / ___ \        .          convex arc: the control point lies on the right; concave: on the left
///            /.-   -.\       .
///      start ---------> end             a straight piece has no control point
struct curve_piece {
    grid_point start;
    grid_point control;
    grid_point end;
    float weight = 0.0f;      ///< of the conic: 1 for a parabola; 0 if the piece is straight
    std::uint32_t first = 0;  ///< the first of the region's edges that the piece replaces; all are of one curve
    std::uint32_t last = 0;   ///< the edge after the last one; if there is one edge, the piece may be a part of it
    float t0 = 0.0f;          ///< the curve's parameter at `start`
    float t1 = 1.0f;          ///< and at `end`
    bool begins_loop = false;
    bool is_part = false;   ///< whether the piece is only a part of its edge
    bool is_fresh = true;   ///< whether it has not yet been compared with the others
    std::uint8_t fate = 0;  ///< the decision of a round: see curved_boundary

    [[nodiscard]] bool is_straight() const noexcept { return !(weight > 0.0f); }

    /// Twice the signed area of the control triangle, positive if the arc is convex; 0 if the piece is straight.
    [[nodiscard]] std::int64_t doubled_area() const noexcept
    {
        return is_straight() ? 0 : orientation(start, control, end);
    }
};

/// The corners of a piece's triangle, or the ends of a straight piece.
struct piece_corners {
    grid_point at[3];
    std::uint32_t count;

    explicit piece_corners(const curve_piece& p) noexcept
        : at{p.start, p.end, p.control}, count{p.is_straight() ? 2u : 3u}
    {
    }

    /// Whether pieces may meet at this point.
    [[nodiscard]] bool is_end(grid_point p) const noexcept { return p == at[0] || p == at[1]; }

    /// Whether p lies in the triangle or on its edges.
    [[nodiscard]] bool holds(grid_point p) const noexcept
    {
        if (count < 3) return false;
        const std::int64_t a = orientation(at[0], at[1], p), b = orientation(at[1], at[2], p),
                           c = orientation(at[2], at[0], p);
        return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
    }
};

/// Whether two closed segments have a point in common. Exact.
[[nodiscard]] inline bool segments_meet(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    const std::int64_t abc = orientation(a, b, c), abd = orientation(a, b, d);
    if ((abc > 0 && abd > 0) || (abc < 0 && abd < 0)) return false;
    const std::int64_t cda = orientation(c, d, a), cdb = orientation(c, d, b);
    if ((cda > 0 && cdb > 0) || (cda < 0 && cdb < 0)) return false;
    const auto overlap = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) noexcept {
        return (std::min)(p, q) <= (std::max)(r, s) && (std::min)(r, s) <= (std::max)(p, q);
    };
    return overlap(a.x, b.x, c.x, d.x) && overlap(a.y, b.y, c.y, d.y);
}

/// Whether two segments that leave one point have more points in common.
[[nodiscard]] inline bool rays_overlap(grid_point from, grid_point a, grid_point b) noexcept
{
    if (orientation(from, a, b) != 0) return false;
    const std::int64_t x = (std::int64_t{a.x} - from.x) * (std::int64_t{b.x} - from.x),
                       y = (std::int64_t{a.y} - from.y) * (std::int64_t{b.y} - from.y);
    return x + y > 0;
}

/// Whether the control triangles of two pieces have a point in common, apart from ends of both. Edges and corners count
/// as parts of the triangles. Exact.
[[nodiscard]] inline bool pieces_meet(const curve_piece& p, const curve_piece& q) noexcept
{
    const piece_corners a{p}, b{q};
    const auto may_share = [&](grid_point v) noexcept { return a.is_end(v) && b.is_end(v); };
    const std::uint32_t a_edges = a.count == 3 ? 3 : 1, b_edges = b.count == 3 ? 3 : 1;
    for (std::uint32_t i = 0; i < a_edges; ++i) {
        const grid_point s = a.at[i], e = a.at[(i + 1) % a.count];
        for (std::uint32_t k = 0; k < b_edges; ++k) {
            const grid_point f = b.at[k], g = b.at[(k + 1) % b.count];
            bool meet = false;
            if (s == f && may_share(s))
                meet = rays_overlap(s, e, g);
            else if (s == g && may_share(s))
                meet = rays_overlap(s, e, f);
            else if (e == f && may_share(e))
                meet = rays_overlap(e, s, g);
            else if (e == g && may_share(e))
                meet = rays_overlap(e, s, f);
            else
                meet = segments_meet(s, e, f, g);
            if (meet) return true;
        }
    }
    // Their edges do not meet: one lies in the other if any of its corners does.
    for (std::uint32_t i = 0; i < a.count; ++i)
        if (!may_share(a.at[i])) {
            if (b.holds(a.at[i])) return true;
            break;
        }
    for (std::uint32_t k = 0; k < b.count; ++k)
        if (!may_share(b.at[k])) return a.holds(b.at[k]);
    return false;
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
