// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/region.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Facts about closed polylines on the grid, found by brute force: slow, plain, and without any code of the stages under
// test.

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// A closed polyline: its last point is joined to its first. |coordinate| <= 2^28.
using loop = std::span<const grid_point>;

/// The contours of an array of points, one by one.
[[nodiscard]] inline std::vector<loop> loops_of(std::span<const grid_point> points,
                                                std::span<const std::uint32_t> starts)
{
    std::vector<loop> loops;
    for (std::size_t i = 0; i + 1 < starts.size(); ++i)
        loops.push_back(points.subspan(starts[i], starts[i + 1] - starts[i]));
    return loops;
}
[[nodiscard]] inline std::vector<loop> loops_of(const contours& c)
{
    return loops_of(c.points.view(), c.starts.view());
}
[[nodiscard]] inline std::vector<loop> loops_of(const region& r) { return loops_of(r.points(), r.starts()); }

/// The side of the line from a to b on which c lies: -1 right of it, 0 on it, 1 left of it. Exact for
/// |coordinate| <= 2^29.
[[nodiscard]] constexpr int side(grid_point a, grid_point b, grid_point c) noexcept
{
    const std::int64_t left = (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y);
    const std::int64_t right = (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
    return left > right ? 1 : left < right ? -1 : 0;
}

/// Whether p lies on the closed segment ab.
[[nodiscard]] constexpr bool lies_on(grid_point p, grid_point a, grid_point b) noexcept
{
    return side(a, b, p) == 0 && (std::min)(a.x, b.x) <= p.x && p.x <= (std::max)(a.x, b.x) &&
           (std::min)(a.y, b.y) <= p.y && p.y <= (std::max)(a.y, b.y);
}

/// Whether the closed segments ab and cd have a point in common.
[[nodiscard]] constexpr bool meet(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    if (lies_on(c, a, b) || lies_on(d, a, b) || lies_on(a, c, d) || lies_on(b, c, d)) return true;
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// Twice the enclosed area, counter-clockwise positive. Exact if it fits into 63 bits, as for one loop on the grid.
[[nodiscard]] constexpr std::int64_t doubled_area(loop l) noexcept
{
    std::uint64_t sum = 0;  // partial sums may wrap
    for (std::size_t i = 0; i < l.size(); ++i) {
        const grid_point a = l[i], b = l[(i + 1) % l.size()];
        sum += static_cast<std::uint64_t>(std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x);
    }
    return static_cast<std::int64_t>(sum);
}
/// Twice the area, counter-clockwise positive; exact.
[[nodiscard]] inline std::int64_t doubled_area(const std::vector<loop>& loops) noexcept
{
    std::uint64_t sum = 0;
    for (const loop l : loops) sum += static_cast<std::uint64_t>(doubled_area(l));
    return static_cast<std::int64_t>(sum);
}
[[nodiscard]] inline std::int64_t doubled_area(const contours& c) { return doubled_area(loops_of(c)); }
[[nodiscard]] inline std::int64_t doubled_area(const region& r) { return doubled_area(loops_of(r)); }

/// The winding number of l around p, which must not lie on l: counted along the ray from p to the right.
[[nodiscard]] constexpr std::int32_t winding(loop l, grid_point p) noexcept
{
    std::int32_t w = 0;
    for (std::size_t i = 0; i < l.size(); ++i) {
        const grid_point a = l[i], b = l[(i + 1) % l.size()];
        if (a.y <= p.y && b.y > p.y && side(a, b, p) > 0) ++w;
        if (b.y <= p.y && a.y > p.y && side(a, b, p) < 0) --w;
    }
    return w;
}
/// The winding number of the loops around p, by brute force. p lies on no edge.
[[nodiscard]] inline std::int32_t winding(const std::vector<loop>& loops, grid_point p) noexcept
{
    std::int32_t w = 0;
    for (const loop l : loops) w += winding(l, p);
    return w;
}

/// The total length of all edges, in cells. Snapping edges by half a cell changes the area by at most half this length.
[[nodiscard]] inline double length(const std::vector<loop>& loops) noexcept
{
    double sum = 0.0;
    for (const loop l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            sum += std::hypot(double(b.x) - a.x, double(b.y) - a.y);
        }
    return sum;
}

/// The distance from p to the nearest edge, in cells; 1e300 if there are none.
[[nodiscard]] inline double distance(const std::vector<loop>& loops, grid_point p) noexcept
{
    double nearest = 1e300;
    for (const loop l : loops) {
        for (std::size_t i = 0; i < l.size(); ++i) {
            const grid_point a = l[i], b = l[(i + 1) % l.size()];
            const double x = double(b.x) - a.x, y = double(b.y) - a.y, px = double(p.x) - a.x, py = double(p.y) - a.y;
            const double square = x * x + y * y;
            const double t = square > 0.0 ? (std::max)(0.0, (std::min)(1.0, (px * x + py * y) / square)) : 0.0;
            nearest = (std::min)(nearest, std::hypot(px - t * x, py - t * y));
        }
    }
    return nearest;
}

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
