// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/triangulate/impl/monotone_sweep.hpp>
#include <typemesh/triangulate/impl/trapezoids.hpp>

#include <bit>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The constrained Delaunay triangulation of a region by divide and conquer: O(n log n) for any region.
///
/// Points are numbered from left to right. A *slab* of level k holds the 2^k points whose numbers differ only in their
/// last k bits, between two vertical *dividers* that block all sight. Two of its points have a *joint*, a Delaunay edge
/// of the slab, if they see each other and some circle through both contains no point of the slab that is visible from
/// the joint. So a slab of level 0 has no joints, and the joints of the last level are the triangulation. Two
/// neighbouring slabs become one of the next level: the divider between them is removed, span by span. A span crosses
/// the divider in one trapezoid (trapezoids.hpp), so each trapezoid is processed once, in the first slab that holds
/// both its points.
///
///     ------ top edge --------        The points visible from the divider on each side form a chain of joints that
///      .       |      .               bends towards it: where it bent away, the ends of the bend would be joined too.
///     : p2 - - | - - p3 :             The lowest joint across the divider is the span's lower edge if both its ends
///     : /  '   |  .   | :             are in the slab. Otherwise it is the lower tangent of the two chains, found by
///     :p1 - - -|- - - p4:             descending from the trapezoid's two points, which see each other. From there the
///      :   ' . | . '   :              merge climbs. Above a joint there is a triangle with a neighbour of one of its
///     ----- lower edge -------        ends, left or right, whose circle contains no other neighbour; its upper side is
///                                     the next joint. A joint on the left is deleted if the circle through it and the
///                                     right end contains the next neighbour on the left, and vice versa. At the top
///                                     edge or the upper tangent there is nothing above.
///
/// The trapezoids of one divider may be processed in any order. A joint l - r across one trapezoid is not undone by a
/// point v visible through another: a line of sight from l - r to v crosses the divider twice, with boundary between
/// the crossings. That boundary has points on both sides of the divider, inside the triangle of the two crossings and
/// the end of the line, so inside the circle that contains v. They are visible from l - r without the other trapezoid.
///
/// Each point lists its joints counter-clockwise, from the region's edge that leaves it to the edge that arrives at it.
/// These two are listed from the beginning, wherever their other ends are. So the outside is never examined, and a
/// point that the boundary visits twice is two points.
///
/// Cost   O(n) per level: a joint is made and deleted once; a link of a chain is passed once on descent, then covered
/// Space  72 bytes per point and 88 per hole, plus the temporary memory of monotone_sweep
/// Exact  orientation, and in-circle with its rule for ties (prefers_other_diagonal)
/// From   D. T. Lee & B. J. Schachter, Two algorithms for constructing a Delaunay triangulation (1980); L. Guibas &
///        J. Stolfi, Primitives for the manipulation of general subdivisions (1985); L. P. Chew, Constrained Delaunay
///        triangulations (1989), for slabs that edges run through
class delaunay_slabs {
    /// A joint as seen from one of its ends; the other half is number ^ 1. Halves 2v and 2v + 1 are the region's edge
    /// that leaves the point v.
    struct half {
        std::uint32_t to;
        std::uint32_t after;   // the next one counter-clockwise; none for the edge that arrives at the point
        std::uint32_t before;  // none for the edge that leaves the point
    };
    static constexpr std::uint32_t none = ~std::uint32_t{0};

public:
    /// Writes the r.triangle_count() triangles of r. Fails with error::out_of_memory.
    template <class = void>  // see constrained_delaunay
    [[nodiscard]] error run(const region& r, workspace& space, triangle* out) noexcept
    {
        points_ = r.points();
        starts_ = r.starts();
        const std::size_t n = points_.size(), joints = 2 * n + 3 * std::size_t{r.holes()};
        workspace::scope scratch{space};
        auto* const first = scratch.take<trapezoid>(n + r.holes());
        rank_ = scratch.take<std::uint32_t>(n);
        if (first == nullptr || rank_ == nullptr) return error::out_of_memory;
        const trapezoid_output output{first, rank_};
        const trapezoid* end = nullptr;
        if (const error e = r.is_touching() ? sweep<true>(output, space, end) : sweep<false>(output, space, end))
            return e;
        halves_ = scratch.take<half>(2 * joints);
        last_ = scratch.take<std::uint32_t>(n);
        if (halves_ == nullptr || last_ == nullptr) return error::out_of_memory;
        join_neighbours();

        std::uint32_t of_level[33];
        for (std::uint32_t& head : of_level) head = none;
        for (trapezoid* t = first; t != end; ++t) {
            std::uint32_t& head = of_level[std::bit_width(rank_[t->left] ^ rank_[t->right])];
            t->next = head;
            head = static_cast<std::uint32_t>(t - first);
        }
        for (std::uint32_t level = 1; level <= 32; ++level)
            for (std::uint32_t t = of_level[level]; t != none; t = first[t].next) remove_divider(first[t], level);
        write(out);
        return error::none;
    }

private:
    template <bool Touching>
    [[nodiscard]] error sweep(const trapezoid_output& output, workspace& space, const trapezoid*& end) const noexcept
    {
        monotone_sweep<false, Touching, trapezoid_output> s{points_, starts_, output};
        const error e = s.run(space);
        end = s.cutter().end();
        return e;
    }

    [[nodiscard]] std::uint32_t to(std::uint32_t h) const noexcept { return halves_[h].to; }
    [[nodiscard]] grid_point end_of(std::uint32_t h) const noexcept { return points_[halves_[h].to]; }
    /// Whether v is one of the points to the left / to the right of the divider.
    [[nodiscard]] bool is_left(std::uint32_t v) const noexcept { return rank_[v] - slab_ < half_; }
    [[nodiscard]] bool is_right(std::uint32_t v) const noexcept { return rank_[v] - slab_ - half_ < half_; }

    void join_neighbours() noexcept
    {
        for (std::size_t loop = 0; loop + 1 < starts_.size(); ++loop) {
            const std::uint32_t begin = starts_[loop], end = starts_[loop + 1];
            for (std::uint32_t v = begin; v < end; ++v) {
                const std::uint32_t previous = v == begin ? end - 1 : v - 1, next = v + 1 == end ? begin : v + 1;
                last_[v] = 2 * previous + 1;
                halves_[2 * v] = {next, last_[v], none};
                halves_[2 * v + 1] = {v, none, 2 * next};
            }
        }
        first_free_ = static_cast<std::uint32_t>(2 * points_.size());
    }

    void remove_divider(const trapezoid& t, std::uint32_t level) noexcept
    {
        half_ = std::uint32_t{1} << (level - 1);
        slab_ = rank_[t.left] & ~(2 * half_ - 1);
        const std::uint32_t edge = 2 * t.below;
        const std::uint32_t base = is_left(t.below) && is_right(to(edge)) ? edge : lowest_joint(t);
        if (base != none) climb(base);
    }

    /// The lowest joint across the divider, from left to right; `none` if there is only the top edge.
    [[nodiscard]] std::uint32_t lowest_joint(const trapezoid& t) noexcept
    {
        std::uint32_t left = t.left, right = t.right;
        std::uint32_t down_left = lower_on_left(t), down_right = lower_on_right(t);  // to the next point of each chain
        for (;;) {
            if (const std::uint32_t v = to(down_left);
                is_left(v) && orientation(points_[left], points_[right], points_[v]) < 0) {
                left = v;
                down_left = halves_[down_left ^ 1].before;
            } else if (const std::uint32_t w = to(down_right);
                       is_right(w) && orientation(points_[left], points_[right], points_[w]) < 0) {
                right = w;
                down_right = halves_[down_right ^ 1].after;
            } else {
                break;
            }
        }
        if (to(halves_[down_left].after) == right) return none;
        return join(left, right, down_left, halves_[down_right].before);
    }

    /// Where the trapezoid's left point sees the divider: between the returned half and the one after it.
    [[nodiscard]] std::uint32_t lower_on_left(const trapezoid& t) const noexcept
    {
        if (t.below == t.left) return 2 * t.left;
        const std::uint32_t last = last_[t.left];
        return rank_[to(last)] > rank_[t.left] ? halves_[last].before : widest_gap(t.left);
    }
    /// The same for its right point: between the returned half and the one before it.
    [[nodiscard]] std::uint32_t lower_on_right(const trapezoid& t) const noexcept
    {
        if (to(2 * t.below) == t.right) return last_[t.right];
        const std::uint32_t first = 2 * t.right;
        return halves_[rank_[to(first)] < rank_[t.right] ? first : widest_gap(t.right)].after;
    }
    /// For a point where spans merge or split: all its joints are still on one side of the sweep line.
    [[nodiscard]] std::uint32_t widest_gap(std::uint32_t v) const noexcept
    {
        std::uint32_t h = 2 * v;
        while (orientation(points_[v], end_of(h), end_of(halves_[h].after)) > 0) h = halves_[h].after;
        return h;
    }

    /// Goes from the lowest joint across the divider to the highest.
    void climb(std::uint32_t base) noexcept
    {
        for (;;) {
            const std::uint32_t l = to(base ^ 1), r = to(base);
            std::uint32_t up_left = halves_[base].after, up_right = halves_[base ^ 1].before;
            if (up_left == none) return;  // the top edge
            const grid_point pl = points_[l], pr = points_[r];
            const auto is_above = [&](std::uint32_t h) noexcept { return orientation(pl, pr, end_of(h)) > 0; };
            const bool left = is_left(to(up_left)) && is_above(up_left);
            if (left) {
                for (std::uint32_t next; (next = halves_[up_left].after) != none; up_left = next) {
                    if (!is_left(to(next)) || orientation(pl, end_of(up_left), end_of(next)) <= 0 ||
                        !prefers_other_diagonal(pl, end_of(up_left), end_of(next), pr))
                        break;
                    unlink(up_left);
                }
            }
            const bool right = is_right(to(up_right)) && is_above(up_right);
            if (right) {
                for (std::uint32_t next; (next = halves_[up_right].before) != none; up_right = next) {
                    if (!is_right(to(next)) || orientation(pr, end_of(next), end_of(up_right)) <= 0 ||
                        !prefers_other_diagonal(end_of(up_right), pr, end_of(next), pl))
                        break;
                    unlink(up_right);
                }
            }
            if (!left && !right) return;
            if (right && (!left || prefers_other_diagonal(pr, end_of(up_left), pl, end_of(up_right)))) {
                if (to(up_left) == to(up_right)) return;  // the top edge already exists
                base = join(l, to(up_right), base, halves_[up_right ^ 1].before);
            } else {
                if (to(up_left) == to(up_right)) return;
                base = join(to(up_left), r, up_left ^ 1, halves_[base ^ 1].before);
            }
        }
    }

    /// Joins l and r, right after `below_l` at l and right after `above_r` at r. Returns the joint's half at l.
    std::uint32_t join(std::uint32_t l, std::uint32_t r, std::uint32_t below_l, std::uint32_t above_r) noexcept
    {
        std::uint32_t h = free_;
        if (h != none)
            free_ = halves_[h].after;
        else
            first_free_ = (h = first_free_) + 2;
        insert_after(below_l, h, r);
        insert_after(above_r, h + 1, l);
        return h;
    }
    void insert_after(std::uint32_t before, std::uint32_t h, std::uint32_t end) noexcept
    {
        const std::uint32_t after = halves_[before].after;
        halves_[h] = {end, after, before};
        halves_[before].after = h;
        halves_[after].before = h;
    }
    void unlink(std::uint32_t h) noexcept
    {
        for (const std::uint32_t gone : {h, h ^ 1}) {
            halves_[halves_[gone].before].after = halves_[gone].after;
            halves_[halves_[gone].after].before = halves_[gone].before;
        }
        halves_[h & ~std::uint32_t{1}].after = free_;
        free_ = h & ~std::uint32_t{1};
    }

    void write(triangle* out) const noexcept
    {
        for (std::uint32_t v = 0; v < points_.size(); ++v) {
            std::uint32_t a = to(2 * v);
            for (std::uint32_t h = halves_[2 * v].after; h != none; h = halves_[h].after) {
                const std::uint32_t b = to(h);
                if (v < a && v < b) *out++ = {v, a, b};
                a = b;
            }
        }
    }

    array_view<const grid_point> points_;
    array_view<const std::uint32_t> starts_;
    std::uint32_t* rank_ = nullptr;  // for each point: its number in sweep order
    half* halves_ = nullptr;
    std::uint32_t* last_ = nullptr;  // for each point: the half of the region's edge that arrives at it
    std::uint32_t first_free_ = 0;
    std::uint32_t free_ = none;
    std::uint32_t slab_ = 0;  // its first number
    std::uint32_t half_ = 0;  // the number of points in each of its halves
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
