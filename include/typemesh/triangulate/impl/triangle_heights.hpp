// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/orientation.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The height of triangles relative to the em: a *low* triangle is lower than 2^-20 em, which is one cell at 2048 units
/// per em.
///
///               c             The height h is the height on the longest edge, the smallest of the three. A position is
///        . -- ' | ' --- .     rounded to a 32-bit float once, by half a float step in each coordinate. So a triangle
///     a --------h-------- b   higher than sqrt(2) steps neither flips over nor becomes flat. Within 4 em of the origin
///                             a step is 2^-21 em or less, whatever the output's unit: h >= 2^-20 em suffices.
///
/// Levels grade the height: 0 for 2^-16 em and more, then one more for each halving, up to 12 below 2^-27 em. Higher
/// triangles are preferred even beyond the limit, because floats are coarser farther from the origin.
///
/// Exact, in integers: h * 2^k < em if (2A * 2^k)^2 < em^2 * longest^2, where A is the area. Budget: em <= 2^25 cells,
/// longest^2 <= 2^59, so a triangle that must be measured has 2A <= 2^39, and both sides are below 2^110.
class triangle_heights {
public:
    static constexpr std::uint32_t levels = 13;
    static constexpr std::uint32_t low = 5;  ///< the smallest level of a low triangle

    /// No triangle is low if the grid does not know its em.
    explicit triangle_heights(const grid& g) noexcept
    {
        const double cells = g.cells * g.units_per_em;
        em_ = static_cast<std::int64_t>(cells < 0x1p25 ? cells : 0x1p25);
        const double span = g.span > 0.0 && g.span < farthest ? g.span : farthest;
        most_ = static_cast<std::int64_t>(static_cast<double>(em_) * span * 0x1p-16) + (em_ != 0 ? 1 : 0);
        max_low_ = (most_ >> (low - 1)) + (em_ != 0 ? 1 : 0);
    }

    /// A triangle whose doubled area is this or more is not low.
    [[nodiscard]] std::int64_t doubled_area_of_low() const noexcept { return max_low_; }

    /// The level of a counter-clockwise triangle, given its doubled area.
    [[nodiscard]] std::uint32_t level(grid_point a, grid_point b, grid_point c,
                                      std::int64_t doubled_area) const noexcept
    {
        if (doubled_area >= most_) return 0;
        const std::int64_t ab = squared_distance(a, b), bc = squared_distance(b, c), ca = squared_distance(c, a);
        const std::int64_t longest = ab > bc ? (ab > ca ? ab : ca) : (bc > ca ? bc : ca);
        const detail::two_words right = detail::sum_of_products(em_ * em_, longest, 0, 0);
        const std::int64_t scaled = doubled_area << 16;
        detail::two_words left = detail::sum_of_products(scaled, scaled, 0, 0);
        std::uint32_t found = 0;
        while (found + 1 < levels && (left.high != right.high ? left.high < right.high : left.low < right.low)) {
            left = {left.high << 2 | left.low >> 62, left.low << 2};
            ++found;
        }
        return found;
    }
    [[nodiscard]] std::uint32_t level(grid_point a, grid_point b, grid_point c) const noexcept
    {
        return level(a, b, c, orientation(a, b, c));
    }
    [[nodiscard]] bool is_low(grid_point a, grid_point b, grid_point c) const noexcept
    {
        const std::int64_t doubled_area = orientation(a, b, c);
        return doubled_area < max_low_ && level(a, b, c, doubled_area) >= low;
    }

private:
    static constexpr double farthest = 0x1.8p29;  // between two points of any grid

    std::int64_t em_;  // in cells; 0: unknown
    std::int64_t most_;
    std::int64_t max_low_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
