// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inflate/membrane.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Raises the inner edges that join two points of an inflated letter's outline. The membrane leaves such an edge where
/// the letter is about as thin as a cell. It lies at height 0, so the front and the back would meet in it.
///
///           k                       k
///         /   \                   / | \        m lies over i, at a small height of its own. The triangles i m k and
///       i ----- j    -->    i -- m --- j       m i l are upright; m j k and j m l replace i j k and j i l.
///         \   /                   \ | /
///           l                       l
///
/// Pinched edges that leave i side by side share one m, which takes the place of i in the triangles between them: with
/// two, the triangle of i and both would have no area.
class pinched_edges {
public:
    explicit pinched_edges(memory source = heap()) noexcept : first_{source}, found_{source} {}

    /// `rim` is the number of the outline's points, which come first in loops.points; all points have a
    /// membrane_point. The new points follow. False if out of memory
    ///
    ///     step     the height of the first new point in a place, and the least difference to the next
    ///     apart    whether no two points of the outline have one place
    ///
    /// Cost   O(n), if few pinched edges leave each point
    [[nodiscard]] bool operator()(contours& loops, std::size_t rim, triangle_list& triangles,
                                  buffer<membrane_point>& membrane, float step, bool apart) noexcept
    {
        if (!find(loops.starts.view(), rim, triangles.view())) return false;
        if (found_.empty()) return true;
        for (triangle& t : triangles) join_two(t);
        std::uint32_t number = 0;
        for (std::uint32_t p = 0; p < found_.size(); ++p) {
            if (found_[p].shared != p) continue;
            found_[p].middle = static_cast<std::uint32_t>(loops.points.size());
            number = apart ? rank(p) : number + 1;
            const float height = static_cast<float>(number) * step;
            if (!loops.points.push_back(loops.points[found_[p].low]) || !membrane.push_back({height, {}})) return false;
        }
        for (std::uint32_t p = 0; p < found_.size(); ++p) found_[p].middle = found_[root(p)].middle;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const std::uint32_t two = join_two(triangles[t]);
            if (two != none) triangles[t].a = found_[two].middle;
            for (std::uint32_t p = pinch_of(triangles[t]); p != none; p = pinch_of(triangles[t]))
                if (!divide(triangles, t, found_[p].middle)) return false;
        }
        return true;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// The number of new points over the first end of a pinch, up to its own.
    [[nodiscard]] std::uint32_t rank(std::uint32_t p) const noexcept
    {
        std::uint32_t number = 0;
        for (std::uint32_t q = p; q != none; q = found_[q].next)  // found before it
            if (found_[q].shared == q) ++number;
        return number;
    }

    /// An inner edge between two points of the outline.
    struct pinch {
        std::uint32_t low, high;  ///< its points' numbers
        std::uint32_t next;       ///< the next pinch with the same first point
        std::uint32_t middle;     ///< the new point
        std::uint32_t shared;     ///< a pinch with the same new point; itself: it is the one that makes the point
    };

    /// Lists the pinched edges. False if out of memory.
    [[nodiscard]] bool find(array_view<const std::uint32_t> starts, std::size_t rim,
                            array_view<const triangle> triangles) noexcept
    {
        first_.clear();
        found_.clear();
        std::uint32_t* const after = first_.append(2 * rim);
        if (after == nullptr) return false;
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop)
            for (std::uint32_t i = starts[loop]; i < starts[loop + 1]; ++i) {
                after[i] = i + 1 == starts[loop + 1] ? starts[loop] : i + 1;
                after[rim + i] = none;
            }
        const auto list = [&](std::uint32_t i, std::uint32_t j) noexcept {
            // Each inner edge occurs in both directions.
            if (i >= j || j >= rim || after[i] == j || after[j] == i) return true;
            const auto number = static_cast<std::uint32_t>(found_.size());
            if (!found_.push_back({i, j, first_[rim + i], 0, number})) return false;
            first_[rim + i] = number;
            return true;
        };
        for (const triangle& t : triangles)
            if (!list(t.a, t.b) || !list(t.b, t.c) || !list(t.c, t.a)) return false;
        return true;
    }

    /// The pinch of an edge, or none.
    [[nodiscard]] std::uint32_t pinch_between(std::uint32_t i, std::uint32_t j) const noexcept
    {
        const std::size_t rim = first_.size() / 2;
        const std::uint32_t low = i < j ? i : j, high = i < j ? j : i;
        if (high >= rim) return none;
        std::uint32_t p = first_[rim + low];
        while (p != none && found_[p].high != high) p = found_[p].next;
        return p;
    }

    /// Turns a triangle until its first edge is pinched, and returns the pinch. None if no edge is.
    [[nodiscard]] std::uint32_t pinch_of(triangle& t) const noexcept
    {
        for (int turn = 0; turn < 3; ++turn, t = {t.b, t.c, t.a})
            if (const std::uint32_t p = pinch_between(t.a, t.b); p != none) return p;
        return none;
    }

    /// If two pinched edges leave the lowest point of a triangle, turns the triangle until that point is the first, has
    /// both share their new point, and returns one of them. Else none.
    std::uint32_t join_two(triangle& t) noexcept
    {
        triangle turned = t;
        while (turned.a > turned.b || turned.a > turned.c) turned = {turned.b, turned.c, turned.a};
        const std::uint32_t p = pinch_between(turned.a, turned.b), q = pinch_between(turned.a, turned.c);
        if (p == none || q == none) return none;
        t = turned;
        const std::uint32_t one = root(p), other = root(q);
        found_[one > other ? one : other].shared = one > other ? other : one;
        return p;
    }

    [[nodiscard]] std::uint32_t root(std::uint32_t p) noexcept
    {
        for (; found_[p].shared != p; p = found_[p].shared) found_[p].shared = found_[found_[p].shared].shared;
        return p;
    }

    /// Divides a triangle at the middle of its first edge. False if out of memory.
    [[nodiscard]] static bool divide(triangle_list& triangles, std::size_t at, std::uint32_t middle) noexcept
    {
        const triangle t = triangles[at];
        triangles[at] = {t.a, middle, t.c};
        return triangles.push_back({middle, t.b, t.c});
    }

    buffer<std::uint32_t> first_;  // the point after each point, then its first pinch
    buffer<pinch> found_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
