// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/bend_error.hpp>
#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/bevel_bisection.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/refine/impl/stretched_circle.hpp>

#include <algorithm>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Triangles less high than this are roundings, and have no side; in cells.
inline constexpr double thinnest = 4.0;

/// Whether the image of a triangle faces away from the direction in which the bent surface faces at one of its corners.
/// False if it is lower than `thin`.
template <deformation D>
[[nodiscard]] bool is_turned(const D& bends, const double3 (&corners)[3], double thin) noexcept
{
    const double3 sides[] = {corners[1] - corners[0], corners[2] - corners[0], corners[2] - corners[1]};
    const double3 n = cross(sides[0], sides[1]);
    for (const double3& side : sides)
        if (dot(n, n) < thin * thin * dot(side, side)) return false;
    const deformed_point images[] = {bends(corners[0]), bends(corners[1]), bends(corners[2])};
    const double3 facing = cross(images[1].at - images[0].at, images[2].at - images[0].at);
    for (const deformed_point& c : images) {
        // By the cofactors of the Jacobian matrix, as normals are bent.
        const double3 own = n.x * cross(c.y, c.z) + n.y * cross(c.z, c.x) + n.z * cross(c.x, c.y);
        if (!(dot(facing, own) > 0.0)) return true;
    }
    return false;
}

/// Measures how much the edges and triangles of a glyph at its place in the text bend: see edge_bisection. The unit is
/// the tolerance.
template <deformation D>
struct bent_measure {
    const D& bends;
    point origin;  ///< the glyph's origin, in em
    double em_per_cell = 0.0;
    double low = 0.0;  ///< the solid's heights, in em
    double high = 0.0;
    double step = 0.0;       ///< the height of one segment of its walls, in em; 0 without walls
    double tolerance = 0.0;  ///< in em
    double em_per_depth = 1.0;
    double riser = 0.0;   ///< the height of upright faces on the region's own edges besides walls, in em
    bool apart = false;   ///< whether the walls stand elsewhere
    double margin = 1.0;  ///< how many times the error of an edge must fit into the tolerance, so that triangles on
                          ///< it can be small enough although it stays
    detail::extents compared = detail::extents::both;  ///< see extents_in()

    /// Includes the wall that stands on the edge.
    [[nodiscard]] double edge(grid_point p, grid_point q) const noexcept
    {
        const box3 b = around(p, q);
        const double upright = size_of(b, apart || riser > step ? riser : step);
        if (!(margin > 1.0)) return upright;
        const double alone = margin * size_of(b, 0.0);
        return upright > alone ? upright : alone;
    }
    [[nodiscard]] double length(grid_point p, grid_point q) const noexcept { return size_of({around(p, q)}, 0.0); }

    // --- of bevels: see bevel_bisection

    [[nodiscard]] double rim(grid_point p, grid_point q) const noexcept { return margin * length(p, q); }
    [[nodiscard]] double outer(grid_point p, grid_point q) const noexcept { return size_of(around(p, q), step); }
    /// The height is in the unit of depths.
    [[nodiscard]] double upright(grid_point p, grid_point q, double height) const noexcept
    {
        return size_of(around(p, q), height * em_per_depth);
    }
    [[nodiscard]] double span(const raised_point& a, const raised_point& b) const noexcept
    {
        return upright(a.at, b.at, a.behind < b.behind ? b.behind - a.behind : a.behind - b.behind);
    }
    [[nodiscard]] double slope(const raised_point& a, const raised_point& b, const raised_point& c) const noexcept
    {
        const auto [least, greatest] = std::minmax({a.behind, b.behind, c.behind});
        return size_of(around(a.at, b.at, c.at), (greatest - least) * em_per_depth);
    }
    /// Whether its image turns, in front or at the back.
    [[nodiscard]] bool turns(const raised_point& a, const raised_point& b, const raised_point& c) const noexcept
    {
        const auto in_front = [&](const raised_point& p) noexcept { return at(p.at, high - p.behind * em_per_depth); };
        const auto behind = [&](const raised_point& p) noexcept { return at(p.at, low + p.behind * em_per_depth); };
        const double thin = thinnest * em_per_cell;
        return is_turned(bends, {in_front(a), in_front(b), in_front(c)}, thin) ||
               is_turned(bends, {behind(a), behind(c), behind(b)}, thin);
    }

    // --- of caps: see edge_bisection

    /// Triangles that turn when they are bent are too large as well.
    [[nodiscard]] double triangle(grid_point p, grid_point q, grid_point r) const noexcept
    {
        const double size = size_of(around(p, q, r), 0.0);
        if (size > 1.0) return size;
        const double thin = thinnest * em_per_cell;
        for (const double height : {low, high})
            if (is_turned(bends, {at(p, height), at(q, height), at(r, height)}, thin)) return 2.0;
        return size;
    }

    /// The extents on which the sizes of triangles in a box depend, in em.
    [[nodiscard]] detail::extents extents_in(const box3& b) const noexcept
    {
        const bend_bounds by = bends.bend(b);
        if (by.xy > 0.0 || (by.xx > 0.0) == (by.yy > 0.0)) return detail::extents::both;
        return by.xx > 0.0 ? detail::extents::widths : detail::extents::heights;
    }
    [[nodiscard]] detail::extents extents() const noexcept { return compared; }

    /// A grid point at a height, in em.
    [[nodiscard]] double3 at(grid_point p, double height) const noexcept
    {
        const point place = em_per_cell * placement::exact(p) + origin;
        return {place.x, place.y, height};
    }

private:
    [[nodiscard]] box3 around(grid_point p, grid_point q) const noexcept
    {
        const double3 a = at(p, low), b = at(q, low);
        return {{a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y, low},
                {a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y, high}};
    }
    [[nodiscard]] box3 around(grid_point p, grid_point q, grid_point r) const noexcept
    {
        const box3 b = around(p, q);
        const double3 c = at(r, low);
        return {{c.x < b.low.x ? c.x : b.low.x, c.y < b.low.y ? c.y : b.low.y, low},
                {c.x > b.high.x ? c.x : b.high.x, c.y > b.high.y ? c.y : b.high.y, high}};
    }
    [[nodiscard]] double size_of(const box3& b, double height) const noexcept
    {
        return bend_error(bends.bend(b), {b.high.x - b.low.x, b.high.y - b.low.y, height}) / tolerance;
    }
};

/// A bent_measure of boundary edges only.
template <deformation D>
struct boundary_measure {
    const bent_measure<D>& all;

    [[nodiscard]] double edge(grid_point p, grid_point q) const noexcept { return all.edge(p, q); }
    [[nodiscard]] double length(grid_point p, grid_point q) const noexcept { return all.length(p, q); }
    [[nodiscard]] static double triangle(grid_point, grid_point, grid_point) noexcept { return 0.0; }
    [[nodiscard]] detail::extents extents() const noexcept { return all.extents(); }
};
template <deformation D>
boundary_measure(const bent_measure<D>&) -> boundary_measure<D>;

}  // namespace typemesh::inline TYPEMESH_ABI::detail
