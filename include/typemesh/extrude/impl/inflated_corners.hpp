// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/side_point.hpp>
#include <typemesh/inflate/membrane.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Doubles the hard corners of an inflated letter's outline: the triangles on one side of the corner's bisector keep
/// the point, which has the normal of the wall before, and the others get a new one.
///
///          wall before
///     ------------------o        The nearer edge, by the angle at the corner, decides for each triangle.
///              keeps  / |
///                   /   | wall after
///                 / new |
class inflated_corners {
public:
    explicit inflated_corners(memory source = heap()) noexcept : seconds_{source} {}

    /// `rim` is the number of the outline's points, which come first in loops.points; all points have a
    /// membrane_point. The new points follow. False if out of memory
    ///
    /// Cost   O(n)
    [[nodiscard]] bool operator()(contours& loops, std::size_t rim, array_view<const side_point> sides,
                                  triangle_list& triangles, buffer<membrane_point>& membrane) noexcept
    {
        seconds_.clear();
        second* const of = seconds_.append(rim);
        if (of == nullptr) return false;
        for (std::size_t loop = 0; loop + 1 < loops.starts.size(); ++loop) {
            const std::uint32_t first = loops.starts[loop], end = loops.starts[loop + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                of[i] = {};
                if (!sides[i].doubled || sides[i].before == sides[i].after) continue;
                const grid_point at = loops.points[i], before = loops.points[i == first ? end - 1 : i - 1],
                                 after = loops.points[i + 1 == end ? first : i + 1];
                of[i] = {static_cast<std::uint32_t>(loops.points.size()), unit(delta(at, before)),
                         unit(delta(at, after))};
                if (!loops.points.push_back(at) || !membrane.push_back({0.0f, {-sides[i].after.x, -sides[i].after.y}}))
                    return false;
            }
        }
        for (triangle& t : triangles) {
            const triangle old = t;
            t = {moved(loops, old.a, old.b, old.c), moved(loops, old.b, old.c, old.a),
                 moved(loops, old.c, old.a, old.b)};
        }
        return true;
    }

private:
    /// The second point of a corner, and the directions of its edges; 0 for other points.
    struct second {
        std::uint32_t point = 0;
        typemesh::point back = {}, ahead = {};
    };

    /// The point that a triangle uses at its corner i.
    [[nodiscard]] std::uint32_t moved(const contours& loops, std::uint32_t i, std::uint32_t j,
                                      std::uint32_t k) const noexcept
    {
        if (i >= seconds_.size() || seconds_[i].point == 0) return i;
        const grid_point at = loops.points[i];
        const point middle = delta(at, loops.points[j]) + delta(at, loops.points[k]);
        const second& s = seconds_[i];
        return dot(s.ahead, middle) >= dot(s.back, middle) ? s.point : i;
    }

    buffer<second> seconds_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
