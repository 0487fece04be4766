// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/discretise/impl/chord.hpp>
#include <typemesh/extrude/impl/box_tree.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Drops points of loops that bound a region. The loops that remain bound a region too, with the same nesting.
///
///          b             Consecutive edges of one curve are a run, and only the points inside runs are dropped. The
///       .-' '-.          points of a piece of a run are dropped one by one: first b, then c. A point is dropped only
///     a ------- c        if no other point of any loop lies in the closed triangle that it leaves (a b c, then
///      '-.       |       a c d). Then the new edge (a c) meets no other edge: an edge that crossed it would also have
///         '-.    |       to cross a b or b c, or end in the triangle. And no loop lies in the triangle, so no winding
///            '-. |       number changes except in the triangle itself. Every test is exact.
///               'd
///
/// A piece may become a chord if the chord keeps the tolerance from the true curve. The points that remain of a run
/// are evenly distributed over its points if that needs no further piece; the points of `certified` are then again
/// distributed as it would distribute them. Points where a curve stops and turns stay, because they are hard corners.
///
/// Cost   O(n log n) for n points whose loops are not entangled; see box_tree
class curve_coarsener {
public:
    explicit curve_coarsener(memory source = heap()) noexcept
        : tree_{source}, chunks_{source}, fates_{source}, measures_{source}
    {
    }

    /// Drops points in place. Every loop keeps at least 3 points.
    ///
    ///     tolerance    in cells. No place of a new edge is farther from its curve
    ///
    /// Fails  only with error::out_of_memory
    [[nodiscard]] error operator()(contours& loops, double tolerance) noexcept
    {
        const std::size_t n = loops.points.size();
        fates_.clear();
        measures_.clear();
        if (n == 0) return {};
        if (fates_.append(n) == nullptr || measures_.append(n + 1) == nullptr) return error::out_of_memory;
        for (std::uint8_t& fate : fates_) fate = stays;
        if (!divide(loops.points.view())) return error::out_of_memory;
        loops_ = &loops;
        tolerance_ = tolerance;
        for (std::uint32_t k = 0; k < loops.contour_count(); ++k) coarsen_loop(loops.starts[k], loops.starts[k + 1]);
        remove_dropped(loops);
        return {};
    }

private:
    static constexpr std::uint8_t stays = 0, dropped = 1;
    static constexpr std::size_t chunk = 8, few_chunks = 64;  // few are looked at faster one by one than in a tree
    static constexpr std::uint32_t max_others = 16;
    static constexpr double kept_share = 1.0 - 0x1p-20;  // of the tolerance; the rest is a margin for rounding

    /// A loop, whose points are counted from a point where a run begins.
    struct cyclic {
        std::uint32_t begin, size, seam;

        [[nodiscard]] std::uint32_t index(std::uint32_t place) const noexcept
        {
            const std::uint32_t i = seam - begin + place;
            return begin + (i < size ? i : i - size);
        }
        [[nodiscard]] std::uint32_t place(std::uint32_t index) const noexcept
        {
            return index >= seam ? index - seam : index + size - seam;
        }
    };

    [[nodiscard]] grid_point at(std::uint32_t place) const noexcept
    {
        return loops_->points[loop_.index(place < loop_.size ? place : 0)];
    }
    /// The edge that leaves a point.
    [[nodiscard]] const contour_edge& edge(std::uint32_t place) const noexcept
    {
        return loops_->edges[loop_.index(place)];
    }

    [[nodiscard]] bool goes_on(const contour_edge& before, const contour_edge& after) const noexcept
    {
        return before.curve == after.curve && after.curve < loops_->curves.size() && same(before.t1, after.t0) &&
               (before.t0 < before.t1) == (after.t0 < after.t1) &&
               !tangents_at(loops_->curves[after.curve], static_cast<double>(after.t0)).stops;
    }

    void coarsen_loop(std::uint32_t begin, std::uint32_t end) noexcept
    {
        loop_ = {begin, end - begin, begin};
        while (loop_.seam < end &&
               goes_on(loops_->edges[loop_.seam == begin ? end - 1 : loop_.seam - 1], loops_->edges[loop_.seam]))
            ++loop_.seam;
        if (loop_.seam == end) loop_.seam = begin;
        spare_ = loop_.size - 3;
        for (std::uint32_t first = 0; first < loop_.size && spare_ != 0;) {
            std::uint32_t last = first + 1;
            while (last < loop_.size && goes_on(edge(last - 1), edge(last))) ++last;
            if (last - first >= 2) coarsen_run(first, last);
            first = last;
        }
    }

    /// Finds the boxes of chunks of points, in the order along the loops. False if out of memory.
    [[nodiscard]] bool divide(array_view<const grid_point> points) noexcept
    {
        chunks_.clear();
        const std::size_t count = (points.size() + chunk - 1) / chunk;
        if (chunks_.append(count) == nullptr) return false;
        for (grid_box& b : chunks_) b = {};
        for (std::size_t i = 0; i < points.size(); ++i) chunks_[i / chunk].add(points[i]);
        if (count <= few_chunks) return true;
        if (!tree_.open(count)) return false;
        for (std::size_t k = 0; k < count; ++k) tree_.set(k, chunks_[k]);
        tree_.close();
        return true;
    }

    /// Calls found(i) for the points in a box.
    template <class Found>
    void each_in(const grid_box& b, const Found& found) const noexcept
    {
        const array_view<const grid_point> points = loops_->points.view();
        const auto look_into = [&](std::size_t k) noexcept {
            const std::size_t end = (k + 1) * chunk < points.size() ? (k + 1) * chunk : points.size();
            for (std::size_t i = k * chunk; i < end; ++i)
                if (b.meets({points[i], points[i]})) found(i);
        };
        if (chunks_.size() > few_chunks) return tree_.each_meeting(b, look_into);
        for (std::size_t k = 0; k < chunks_.size(); ++k)
            if (b.meets(chunks_[k])) look_into(k);
    }

    /// Drops points strictly between two places of the loop, whose edges belong to one curve.
    void coarsen_run(std::uint32_t first, std::uint32_t last) noexcept
    {
        curve_ = loops_->curves[edge(first).curve];
        for (point& p : curve_.p) p = loops_->grid.cells * p;
        const cubic c = as_cubic(curve_);
        const point l0 = c.p1 - c.p0, l1 = c.p2 - c.p1, l2 = c.p3 - c.p2, s0 = l1 - l0, s1 = l2 - l1;
        const chords of_curve{c.p0, 3.0 * l0, 3.0 * s0, s1 - s0, 0.0};
        look_around(first, last);
        measure(first, last);
        const std::uint32_t edges = last - first;
        if (edges - 1 <= spare_ && is_even(of_curve, first, last, 1)) {
            spare_ -= edges - 1;
            return end_of_piece(first, last);
        }
        std::uint32_t pieces = 0;
        for (std::uint32_t from = first; from < last; ++pieces) {
            std::uint32_t to = from + 1;
            while (to < last && spare_ != 0 && fits(of_curve, from - first, to + 1 - first) && may_drop(from, to)) {
                --spare_;
                ++to;
            }
            end_of_piece(from, to);
            from = to;
        }
        if (pieces == edges || !is_even(of_curve, first, last, pieces)) return;
        for (std::uint32_t k = 0; k < pieces; ++k)
            end_of_piece(share(first, edges, k, pieces), share(first, edges, k + 1, pieces));
    }

    /// Marks the points between two that stay.
    void end_of_piece(std::uint32_t from, std::uint32_t to) noexcept
    {
        fates_[loop_.index(from)] = stays;
        for (std::uint32_t k = from + 1; k < to; ++k) fates_[loop_.index(k)] = dropped;
    }

    [[nodiscard]] static std::uint32_t share(std::uint32_t first, std::uint32_t edges, std::uint32_t k,
                                             std::uint32_t of) noexcept
    {
        return first + static_cast<std::uint32_t>((std::uint64_t{edges} * k + of / 2) / of);
    }

    using chords = cubic_chords<false>;

    [[nodiscard]] static cubic as_cubic(const curve& c) noexcept
    {
        if (c.degree == 3) return c.as_cubic();
        return raised(c.degree == 2 ? c.as_quadratic() : quadratic{c.p[0], lerp(c.p[0], c.p[1], 0.5), c.p[1]});
    }

    /// Whether a run can be divided into pieces of equally many edges.
    [[nodiscard]] bool is_even(const chords& of_curve, std::uint32_t first, std::uint32_t last,
                               std::uint32_t pieces) const noexcept
    {
        const std::uint32_t edges = last - first;
        for (std::uint32_t k = 0; k < pieces; ++k) {
            const std::uint32_t from = share(first, edges, k, pieces), to = share(first, edges, k + 1, pieces);
            if (to - from > 1 && !fits(of_curve, from - first, to - first)) return false;
            for (std::uint32_t i = from + 1; i < to; ++i)
                if (!may_drop(from, i)) return false;
        }
        return true;
    }

    /// Notes the parameter at each place of a run, and the distance of the point there from the curve.
    void measure(std::uint32_t first, std::uint32_t last) noexcept
    {
        for (std::uint32_t k = first; k <= last; ++k) {
            const double t = static_cast<double>(k == last ? edge(k - 1).t1 : edge(k).t0);
            const grid_point p = at(k);
            const point gap = curve_.at(t) - point{static_cast<double>(p.x), static_cast<double>(p.y)};
            measures_[k - first] = {t, length(gap)};
        }
    }

    /// Whether the chord between two places of a run, counted from its first one, keeps the tolerance: the curve's own
    /// chord, and the distances of its ends.
    [[nodiscard]] bool fits(chords of_curve, std::uint32_t from, std::uint32_t to) const noexcept
    {
        const curve_place a = measures_[from], b = measures_[to];
        const double room = kept_share * (tolerance_ - (a.offset > b.offset ? a.offset : b.offset));
        of_curve.tt = room * room;
        return room > 0.0 && of_curve.excess(a.t < b.t ? a.t : b.t, a.t < b.t ? b.t : a.t) <= 1.0;
    }

    /// Whether a point's index lies between two places of the loop, or at one of them.
    [[nodiscard]] bool is_between(std::uint32_t index, std::uint32_t from, std::uint32_t to) const noexcept
    {
        if (index - loop_.begin >= loop_.size) return false;
        const std::uint32_t own = loop_.place(index);
        return own - from <= to - from || (own == 0 && to == loop_.size);
    }

    /// Finds out which points may lie in the triangles of a run: its own ones if it is not convex, and the others that
    /// are in the box around it.
    void look_around(std::uint32_t first, std::uint32_t last) noexcept
    {
        is_convex_ = is_convex(first, last);
        grid_box around;
        for (std::uint32_t k = first; k <= last; ++k) around.add(at(k));
        others_ = 0;
        each_in(around, [&](std::size_t i) noexcept {
            if (is_between(static_cast<std::uint32_t>(i), first, last)) return;
            if (others_ < max_others) other_[others_] = loops_->points[i];
            ++others_;
        });
    }

    /// Whether a run and the chord between its ends bound a convex polygon: it turns to one side only, and lies on one
    /// side of the chord. Then the polygon is simple, because the run's edges do not meet, so it turns exactly once.
    [[nodiscard]] bool is_convex(std::uint32_t first, std::uint32_t last) const noexcept
    {
        const grid_point a = at(first), z = at(last);
        bool is_left = !(a == z), is_right = is_left;
        for (std::uint32_t k = first + 1; k < last; ++k) {
            const grid_point p = at(k);
            const std::int64_t turn = orientation(at(k - 1), p, at(k + 1)), side = orientation(a, p, z);
            is_left = is_left && turn >= 0 && side > 0;
            is_right = is_right && turn <= 0 && side < 0;
        }
        return is_left || is_right;
    }

    /// Whether a point may be dropped after all points between `from` and itself: no other point lies in the triangle.
    [[nodiscard]] bool may_drop(std::uint32_t from, std::uint32_t place) const noexcept
    {
        const grid_point a = at(from), b = at(place), c = at(place + 1);
        bool is_clear = !(a == c);
        const auto look_at = [&](grid_point p) noexcept {
            const std::int64_t x = orientation(a, b, p), y = orientation(b, c, p), z = orientation(c, a, p);
            if ((x >= 0 && y >= 0 && z >= 0) || (x <= 0 && y <= 0 && z <= 0)) is_clear = false;
        };
        if (is_convex_ && others_ <= max_others) {
            for (std::uint32_t k = 0; k < others_; ++k) look_at(other_[k]);
            return is_clear;
        }
        grid_box around;
        around.add(a);
        around.add(b);
        around.add(c);
        each_in(around, [&](std::size_t i) noexcept {
            if (!is_between(static_cast<std::uint32_t>(i), from, place + 1)) look_at(loops_->points[i]);
        });
        return is_clear;
    }

    /// Closes the gaps. An edge ends where the last edge of its piece ended.
    void remove_dropped(contours& loops) const noexcept
    {
        std::uint32_t to = 0, begin = 0;
        for (std::uint32_t k = 0; k < loops.contour_count(); ++k) {
            const std::uint32_t end = loops.starts[k + 1];
            std::uint32_t first = begin;
            while (fates_[first] == dropped) ++first;
            const float t1_of_last = loops.edges[first == begin ? end - 1 : first - 1].t1;
            loops.starts[k] = to;
            for (std::uint32_t i = first; i < end;) {
                std::uint32_t next = i + 1;
                while (next < end && fates_[next] == dropped) ++next;
                loops.points[to] = loops.points[i];
                const float t1 = next < end ? loops.edges[next - 1].t1 : t1_of_last;
                loops.edges[to++] = {loops.edges[i].curve, loops.edges[i].t0, t1};
                i = next;
            }
            begin = end;
        }
        if (!loops.starts.empty()) loops.starts[loops.contour_count()] = to;
        loops.points.truncate(to);
        loops.edges.truncate(to);
        loops.forget_order();
    }

    struct curve_place {
        double t, offset;
    };

    box_tree tree_;            // of the chunks, if they are many
    buffer<grid_box> chunks_;  // boxes of so many consecutive points
    buffer<std::uint8_t> fates_;
    buffer<curve_place> measures_;  // of a run
    const contours* loops_ = nullptr;
    double tolerance_ = 0.0;
    cyclic loop_{};
    curve curve_;  // of the run, in cells
    bool is_convex_ = false;
    std::uint32_t others_ = 0;  // the points of other runs in the box around the run; the first ones are in other_
    grid_point other_[max_others];
    std::uint32_t spare_ = 0;  // the number of points that the loop can still lose
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
