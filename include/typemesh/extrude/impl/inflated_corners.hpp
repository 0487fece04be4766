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
/// the point, which has the normal of the wall before, and the others get a new one. A corner with a single triangle
/// stays one point, with a normal between the two.
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
        for (std::size_t i = 0; i < rim; ++i) of[i] = {};
        for (const triangle& t : triangles)
            for (const std::uint32_t i : {t.a, t.b, t.c})
                if (i < rim && of[i].triangles < 2) ++of[i].triangles;
        for (std::size_t loop = 0; loop + 1 < loops.starts.size(); ++loop) {
            const std::uint32_t first = loops.starts[loop], end = loops.starts[loop + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                second& s = of[i];
                s.before = i == first ? end - 1 : i - 1;
                s.after = i + 1 == end ? first : i + 1;
                if (!sides[i].doubled || sides[i].before == sides[i].after) continue;
                if (s.triangles < 2) {  // so the corner is convex, and not straight
                    membrane[i].slope = rounded(unit(direction(loops, i, s.before) + direction(loops, i, s.after)));
                    continue;
                }
                s.point = static_cast<std::uint32_t>(loops.points.size());
                if (!loops.points.push_back(loops.points[i]) ||
                    !membrane.push_back({0.0f, {-sides[i].after.x, -sides[i].after.y}}))
                    return false;
            }
        }
        for (triangle& t : triangles) {
            if (!is_doubled(t.a) && !is_doubled(t.b) && !is_doubled(t.c)) continue;
            const triangle old = t;
            t = {moved(loops, old.a, old.b, old.c), moved(loops, old.b, old.c, old.a),
                 moved(loops, old.c, old.a, old.b)};
        }
        return true;
    }

private:
    /// The second point of a corner, 0 for other points; the points before and after it; and the number of its
    /// triangles, up to 2.
    struct second {
        std::uint32_t point = 0, before = 0, after = 0, triangles = 0;
    };

    [[nodiscard]] bool is_doubled(std::uint32_t i) const noexcept
    {
        return i < seconds_.size() && seconds_[i].point != 0;
    }

    /// The point that a triangle uses at its corner i. The first and the last triangle at a corner have an edge of the
    /// outline, so both points are used.
    [[nodiscard]] std::uint32_t moved(const contours& loops, std::uint32_t i, std::uint32_t j,
                                      std::uint32_t k) const noexcept
    {
        if (!is_doubled(i)) return i;
        const second& s = seconds_[i];
        if (j == s.after) return s.point;
        if (k == s.before) return i;
        const point middle = direction(loops, i, j) + direction(loops, i, k);
        return dot(direction(loops, i, s.after) - direction(loops, i, s.before), middle) >= 0.0 ? s.point : i;
    }

    /// The unit vector from a point to another, or 0: points of pinched_edges lie over others.
    [[nodiscard]] static point direction(const contours& loops, std::uint32_t from, std::uint32_t to) noexcept
    {
        const grid_point a = loops.points[from], b = loops.points[to];
        return a == b ? point{} : unit(delta(a, b));
    }

    buffer<second> seconds_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
