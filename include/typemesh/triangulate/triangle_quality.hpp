// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The quality of triangles for lighting and bending, collected over one or more glyphs.
///
/// The angle of a triangle is its smallest angle in degrees: 60 at best, near 0 for a needle. The aspect is the longest
/// edge divided by the height on it: 2 / sqrt(3) at best. Triangles without area count with angle 0 and leave the
/// aspect unchanged.
struct triangle_quality {
    std::uint64_t triangles = 0;
    double smallest_angle = 60.0;  ///< the smallest angle of all triangles; 60 if there are none
    double largest_aspect = 0.0;   ///< the largest aspect of all triangles; 0 if there are none
    /// angles[i] counts triangles with an angle in [i, i + 1) tenths of a degree; the last entry includes 60.
    std::uint64_t angles[600] = {};

    /// The angle below which a share (0 to 1) of the triangles lie, to a tenth of a degree: angle_at(0.05) is the 5th
    /// percentile, angle_at(0.5) the median. 0 if there are no triangles.
    [[nodiscard]] double angle_at(double share) const noexcept
    {
        const double wanted = share * static_cast<double>(triangles);
        double passed = 0.0;
        for (std::size_t i = 0; i < 600; ++i) {
            const auto here = static_cast<double>(angles[i]);
            if (here > 0.0 && passed + here >= wanted) return 0.1 * (static_cast<double>(i) + 0.5);
            passed += here;
        }
        return 0.0;
    }
};

namespace detail {
[[nodiscard]] inline double doubled_area_of(grid_point a, grid_point b, grid_point c) noexcept
{
    return static_cast<double>(orientation(a, b, c));
}
template <class Point>
[[nodiscard]] double doubled_area_of(const Point& a, const Point& b, const Point& c) noexcept
{
    const double abx = static_cast<double>(b.x) - static_cast<double>(a.x),
                 aby = static_cast<double>(b.y) - static_cast<double>(a.y);
    const double acx = static_cast<double>(c.x) - static_cast<double>(a.x),
                 acy = static_cast<double>(c.y) - static_cast<double>(a.y);
    return abx * acy - aby * acx;
}
}  // namespace detail

/// Adds triangles over `points` (grid points, or any type with floating-point members x and y) to the statistics.
///
/// Cost   one arc tangent per triangle
template <class Point>
void add_triangles(triangle_quality& q, std::span<const Point> points, std::span<const triangle> triangles) noexcept
{
    for (const triangle t : triangles) {
        const Point corners[3] = {points[t.a], points[t.b], points[t.c]};
        double squared[3], shortest = 0.0, longest = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            const Point from = corners[i], to = corners[(i + 1) % 3];
            const double dx = static_cast<double>(to.x) - static_cast<double>(from.x);
            const double dy = static_cast<double>(to.y) - static_cast<double>(from.y);
            squared[i] = dx * dx + dy * dy;
            shortest = i == 0 || squared[i] < shortest ? squared[i] : shortest;
            longest = squared[i] > longest ? squared[i] : longest;
        }
        const double doubled_area = std::abs(detail::doubled_area_of(corners[0], corners[1], corners[2]));
        // The smallest angle is opposite the shortest edge: 2 * dot = sum of the other two squares minus its own.
        const double doubled_dot = squared[0] + squared[1] + squared[2] - 2.0 * shortest;
        const double angle = doubled_area > 0.0 ? std::atan2(2.0 * doubled_area, doubled_dot) * 57.29577951308232 : 0.0;
        ++q.triangles;
        q.smallest_angle = angle < q.smallest_angle ? angle : q.smallest_angle;
        if (doubled_area > 0.0 && longest / doubled_area > q.largest_aspect) q.largest_aspect = longest / doubled_area;
        const auto tenths = static_cast<std::size_t>(angle * 10.0);
        ++q.angles[tenths < 600 ? tenths : 599];
    }
}

/// The quality of these triangles.
[[nodiscard]] inline triangle_quality analyze_triangles(std::span<const grid_point> points,
                                                        std::span<const triangle> triangles) noexcept
{
    triangle_quality q;
    add_triangles(q, points, triangles);
    return q;
}

}  // namespace typemesh::inline TYPEMESH_ABI
