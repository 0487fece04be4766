// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/bend_error.hpp>
#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/bevel_bisection.hpp>
#include <typemesh/extrude/placement.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

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
    double riser = 0.0;    ///< the height of upright faces on the region's own edges besides walls, in em
    bool apart = false;    ///< whether the walls stand elsewhere
    double margin = 1.0;   ///< how many times the error of an edge must fit into the tolerance, so that triangles on
                           ///< it can be small enough although it stays

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
        return upright(a.at, b.at, a.height < b.height ? b.height - a.height : a.height - b.height);
    }
    [[nodiscard]] double slope(const raised_point& a, const raised_point& b, const raised_point& c) const noexcept
    {
        const auto [least, greatest] = std::minmax({a.height, b.height, c.height});
        return size_of(around(a.at, b.at, c.at), (greatest - least) * em_per_depth);
    }

    /// Triangles that turn when they are bent are too large as well.
    [[nodiscard]] double triangle(grid_point p, grid_point q, grid_point r) const noexcept
    {
        const double size = size_of(around(p, q, r), 0.0);
        if (size > 1.0) return size;
        return turns(p, q, r, low) || turns(p, q, r, high) ? 2.0 : size;
    }

    /// Whether the image of a triangle at a height faces away from the direction in which the bent surface faces at one
    /// of its corners.
    [[nodiscard]] bool turns(grid_point p, grid_point q, grid_point r, double height) const noexcept
    {
        const deformed_point corners[] = {bends(at(p, height)), bends(at(q, height)), bends(at(r, height))};
        const double3 facing = cross(corners[1].at - corners[0].at, corners[2].at - corners[0].at);
        for (const deformed_point& c : corners)
            if (!(dot(facing, cross(c.x, c.y)) > 0.0)) return true;
        return false;
    }

    /// Whether any of these triangles turns, at the lowest or at the greatest height. Their corners are `points`,
    /// followed by `inner`.
    [[nodiscard]] bool any_turns(array_view<const grid_point> points, array_view<const grid_point> inner,
                                 array_view<const typemesh::triangle> triangles) const noexcept
    {
        const auto corner = [&](std::uint32_t i) noexcept {
            return i < points.size() ? points[i] : inner[i - points.size()];
        };
        for (const typemesh::triangle& t : triangles)
            for (const double height : {low, high})
                if (turns(corner(t.a), corner(t.b), corner(t.c), height)) return true;
        return false;
    }

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
};
template <deformation D>
boundary_measure(const bent_measure<D>&) -> boundary_measure<D>;

}  // namespace typemesh::inline TYPEMESH_ABI::detail
