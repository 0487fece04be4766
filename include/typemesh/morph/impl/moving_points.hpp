// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/morph/impl/area_path.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Points at several places of an axis, the keys, between which they move evenly along straight lines.
///
///     places    [ all points at the first key | at the second key | ... ], `count` each
///     fixed     further points, which do not move; their numbers follow: count, count + 1, ...
struct moving_points {
    array_view<const grid_point> places;
    std::size_t count = 0;
    array_view<const grid_point> fixed;

    [[nodiscard]] grid_point at(std::size_t key, std::uint32_t point) const noexcept
    {
        return point < count ? places[key * count + point] : fixed[point - count];
    }
    [[nodiscard]] std::size_t size() const noexcept { return count + fixed.size(); }

    /// The grid point nearest to the place of a point, some 32nds of the way after a key.
    [[nodiscard]] grid_point between(std::size_t key, std::int32_t part, std::uint32_t point) const noexcept
    {
        const grid_point a = at(key, point);
        if (part == 0) return a;
        const grid_point b = at(key + 1, point);
        const auto mixed = [part](std::int64_t from, std::int64_t to) noexcept {
            const std::int64_t sum = from * (area_path::parts - part) + to * part + area_path::parts / 2;
            return static_cast<std::int32_t>(sum >> 5);
        };
        return {mixed(a.x, b.x), mixed(a.y, b.y)};
    }

    /// The area of a triangle from a key to the next.
    [[nodiscard]] area_path area(std::size_t key, const triangle& t) const noexcept
    {
        return {{at(key, t.a), at(key, t.b), at(key, t.c)}, {at(key + 1, t.a), at(key + 1, t.b), at(key + 1, t.c)}};
    }
};

/// A stretch of an axis in which triangles must stay positive: from `first` 32nds after a key to `last` 32nds before
/// the end of the last step, or some whole steps from key to key.
struct moving_stretch {
    std::size_t key = 0;    ///< the first key
    std::size_t steps = 1;  ///< the number of steps to the next key; 1 unless the stretch begins and ends at a key
    std::int32_t first = 0;
    std::int32_t last = area_path::parts;  ///< within the step, if there is only one

    /// Half the length of a single step, in 32nds rounded down.
    [[nodiscard]] std::int32_t middle() const noexcept { return (first + last) / 2; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
