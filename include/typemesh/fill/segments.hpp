// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>

namespace typemesh {

/// Whether the closed segments ab and cd have a point in common; a segment may be one point. Exact, O(1).
[[nodiscard]] constexpr bool segments_meet(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
{
    const auto apart = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) noexcept {
        return (p < q ? q : p) < (r < s ? r : s) || (r < s ? s : r) < (p < q ? p : q);
    };
    if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
    const std::int64_t abc = orientation(a, b, c), abd = orientation(a, b, d);
    if ((abc > 0 && abd > 0) || (abc < 0 && abd < 0)) return false;
    const std::int64_t cda = orientation(c, d, a), cdb = orientation(c, d, b);
    if ((cda > 0 && cdb > 0) || (cda < 0 && cdb < 0)) return false;
    return true;  // on one line (all four zero) their boxes meet, so they do
}

}  // namespace typemesh
