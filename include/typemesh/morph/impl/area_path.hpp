// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The doubled area of a triangle whose three corners move evenly along straight lines, from their places at the start
/// to their places at the end. It is a quadratic of the share s of the way, with exact Bernstein coefficients:
///
///     area(s) = (1-s)^2 start + 2 s (1-s) middle + s^2 end        start, end: the doubled areas there
///                                                                 middle: half the sum of two mixed cross products
///
/// If all three are positive, the area is positive everywhere. If only `middle` is not, the way is halved, at most five
/// times: the proof then holds for each half.
///
/// Exact. Budget: |coordinate| <= 2^24, differences <= 2^25, cross products <= 2^51, twice `middle` <= 2^52; divided at
/// 32nds of the way, every coefficient times 2048 is a weighted mean of these times 2048: <= 2^62.
class area_path {
public:
    static constexpr std::int32_t reach = 1 << 24;  ///< the greatest coordinate
    static constexpr std::int32_t parts = 32;       ///< shares of the way are counted in 32nds

    struct corners {
        grid_point a, b, c;
    };

    area_path(const corners& start, const corners& end) noexcept
        : start_{crossed(start.a, start.b, start.a, start.c)},
          twice_middle_{crossed(start.a, start.b, end.a, end.c) + crossed(end.a, end.b, start.a, start.c)},
          end_{crossed(end.a, end.b, end.a, end.c)}
    {
    }

    /// Whether the area is proven positive at every place between two 32nds of the way, and at these two. Only at the
    /// very start and the very end (0 and 32) it may also be zero, where points of an outline meet.
    [[nodiscard]] bool is_positive(std::int32_t first = 0, std::int32_t last = parts) const noexcept
    {
        TYPEMESH_ASSERT(0 <= first && first < last && last <= parts, "a way has 32 parts");
        const std::int64_t low = mixed(first, first), between = mixed(first, last), high = mixed(last, last);
        if (low < 0 || high < 0 || (low == 0 && first != 0) || (high == 0 && last != parts)) return false;
        if (between > 0 || (between == 0 && (low > 0 || high > 0))) return true;
        if (last - first == 1 || low == 0 || high == 0) return false;
        const std::int32_t half = (first + last) / 2;
        return is_positive(first, half) && is_positive(half, last);
    }

private:
    /// The cross product of q - p and s - r.
    static std::int64_t crossed(grid_point p, grid_point q, grid_point r, grid_point s) noexcept
    {
        const std::int64_t ux = std::int64_t{q.x} - p.x, uy = std::int64_t{q.y} - p.y;
        const std::int64_t vx = std::int64_t{s.x} - r.x, vy = std::int64_t{s.y} - r.y;
        return ux * vy - uy * vx;
    }

    /// 2048 times the polar form at two 32nds: a coefficient of the part between them.
    [[nodiscard]] std::int64_t mixed(std::int64_t s, std::int64_t t) const noexcept
    {
        return 2 * start_ * ((parts - s) * (parts - t)) + twice_middle_ * (s * (parts - t) + t * (parts - s)) +
               2 * end_ * (s * t);
    }

    std::int64_t start_;
    std::int64_t twice_middle_;
    std::int64_t end_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
