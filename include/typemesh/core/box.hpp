// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <limits>

namespace typemesh::inline TYPEMESH_ABI {

/// An axis-aligned bounding box. It is empty (`low` is greater than `high`) until the first point is added.
struct box {
    point low{(std::numeric_limits<double>::max)(), (std::numeric_limits<double>::max)()};
    point high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};

    [[nodiscard]] constexpr bool empty() const noexcept { return !(low.x <= high.x && low.y <= high.y); }
    [[nodiscard]] constexpr double width() const noexcept { return empty() ? 0.0 : high.x - low.x; }
    [[nodiscard]] constexpr double height() const noexcept { return empty() ? 0.0 : high.y - low.y; }

    /// Grows to hold p.
    constexpr void add(point p) noexcept
    {
        low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
        high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
    }
    /// Grows to hold all of `other`. An empty box changes nothing. It is not called add(): {x, y} would match both.
    constexpr void merge(const box& other) noexcept
    {
        if (other.empty()) return;
        add(other.low);
        add(other.high);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
