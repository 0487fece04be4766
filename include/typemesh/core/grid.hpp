// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/result.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// The integer grid on which all geometric decisions are made. `cells` is the number of grid steps per font unit, a
/// power of two (512 for ordinary fonts).
///
/// Every grid point is within snap_error() of the point that it replaces. The output consists of the grid points,
/// rounded to 32-bit floats.
struct grid {
    static constexpr double reach = 0x1p28;  ///< no coordinate is farther from 0 than this many cells

    double cells = 512.0;
    double units_per_em = 0.0;  ///< the font's units per em, which relate cells to the em; 0: unknown
    double span = 0.0;          ///< a limit for the distance between two points, in cells; 0: unknown

    /// Half a cell's diagonal, in font units: the greatest distance by which snap() moves a point.
    [[nodiscard]] constexpr double snap_error() const noexcept { return 0.70710678118654757 / cells; }

    /// The nearest grid point. Precondition: |p| * cells <= reach.
    [[nodiscard]] grid_point snap(point p) const noexcept { return {nearest(p.x * cells), nearest(p.y * cells)}; }

    /// The position of a grid point in font units; it is exact.
    [[nodiscard]] constexpr point place(grid_point g) const noexcept { return {g.x / cells, g.y / cells}; }

    /// The grid for an outline. An em of 64 to 65,536 units has 512 cells per unit. For any other em the cells per unit
    /// are the power of two that gives the em 2^20 to 2^21 cells. They are halved until `around` (a box that holds all
    /// control points) fits. The grid stores the em and the box's diagonal.
    ///
    /// Fails  error::bad_option: units_per_em is not positive and finite
    ///        error::outline_not_finite: a corner of the box is NaN or infinite
    ///        error::outline_beyond_grid: the box does not even fit with 2^-40 cells per unit
    [[nodiscard]] static result<grid> fitting(double units_per_em, const box& around) noexcept
    {
        const bool sensible = is_finite(units_per_em) && units_per_em > 0x1p-40 && units_per_em < 0x1p40;
        if (!sensible) return error::bad("units_per_em");
        grid g;
        if (units_per_em < 64.0 || units_per_em > 65536.0) {
            while (g.cells * units_per_em < 0x1p20) g.cells *= 2.0;
            while (g.cells * units_per_em >= 0x1p21) g.cells *= 0.5;
        }
        g.units_per_em = units_per_em;
        if (around.empty()) return g;
        double farthest = 0.0;
        for (const double v : {around.low.x, around.low.y, around.high.x, around.high.y}) {
            if (!is_finite(v)) return error::outline_not_finite;
            const double size = v < 0.0 ? -v : v;
            farthest = size > farthest ? size : farthest;
        }
        while (farthest * g.cells > reach - 1.0) {
            g.cells *= 0.5;
            if (g.cells < 0x1p-40) return error::outline_beyond_grid;
        }
        g.span_over(around);
        return g;
    }

    /// Halves `cells` until an em has at most `max_per_em` cells. If the em had more, it then has more than half of
    /// `max_per_em`.
    void coarsen(double max_per_em) noexcept
    {
        while (cells * units_per_em > max_per_em && cells > 0x1p-40) {
            cells *= 0.5;
            span = 0.5 * span + 8.0;
        }
    }

    /// Sets `span` for points in this box, with a margin for the points that snapping and crossings move out of the
    /// box.
    void span_over(const box& around) noexcept
    {
        const double width = (around.high.x - around.low.x) * cells, height = (around.high.y - around.low.y) * cells;
        span = std::sqrt(width * width + height * height) + 8.0;
    }

private:
    /// Rounds half to even: adding 2^52 + 2^51 to a double leaves the integer in its lowest bits. This is 1 ns faster
    /// than lrint. No compiler flag can fold it away, since the bits are read as an integer.
    [[nodiscard]] static std::int32_t nearest(double v) noexcept
    {
        const double shifted = v + 0x1.8p52;
        std::uint64_t bits = 0;
        std::memcpy(&bits, &shifted, sizeof bits);
        return static_cast<std::int32_t>(static_cast<std::uint32_t>(bits));
    }
};

/// A pen in font units, rounded to a grid with this many cells per font unit.
[[nodiscard]] inline point rounded_pen(point pen, double cells) noexcept
{
    return {std::nearbyint(pen.x * cells) / cells, std::nearbyint(pen.y * cells) / cells};
}

}  // namespace typemesh::inline TYPEMESH_ABI
