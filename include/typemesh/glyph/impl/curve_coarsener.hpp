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
#include <typemesh/glyph/impl/point_chunks.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Drops points of loops that bound a region. The loops that remain bound a region too, with the same nesting.
///
///          b             Consecutive edges of one curve are a chain, and only points inside chains are dropped. The
///       .-' '-.          points of a piece of a chain are dropped one by one: first b, then c. A point is dropped only
///     a ------- c        if no other point of any loop lies in the closed triangle that it leaves (a b c, then
///      '-.       |       a c d). Then the new edge (a c) meets no other edge: an edge that crossed it would also have
///         '-.    |       to cross a b or b c, or end in the triangle. And no loop lies in the triangle, so no winding
///            '-. |       number changes except in the triangle itself. Every test is exact.
///               'd
///
/// A piece may become a chord if the chord keeps the tolerance from the true curve. The points that remain of a chain
/// are evenly distributed over its points where that suffices; the points of `certified` are then again distributed as
/// it would distribute them. The error of the whole chain's chord says with how many pieces to begin. Points where a
/// curve stops and turns stay, because they are hard corners.
///
/// The order of the points stays known, because points are only left out of it.
///
/// Cost   O(n log n) for n points whose loops are not entangled; see box_tree
class curve_coarsener {
public:
    explicit curve_coarsener(memory source = heap()) noexcept
        : chunks_{source}, fates_{source}, numbers_{source}, order_{source}, seams_{source}, measures_{source}
    {
    }

    /// Drops points in place. Every loop keeps at least 3 points.
    ///
    ///     tolerance    in cells. No place of a new edge is farther from its curve
    ///
    /// Fails  only with error::out_of_memory
    [[nodiscard]] error operator()(contours& loops, double tolerance) noexcept
    {
        is_proven_later_ = false;
        return run(loops, tolerance);
    }

    /// Likewise, but edges may cross: the caller lets a triangulator prove that they do not. If it does, the nesting is
    /// as before: each loop has a point that stays and lies in no sliver between another loop's old and new edges, so
    /// the winding numbers there have not changed. Fails also with error::crossing_contours, if a loop has turned.
    [[nodiscard]] error drop_unproven(contours& loops, double tolerance) noexcept
    {
        is_proven_later_ = true;
        return run(loops, tolerance);
    }

private:
    [[nodiscard]] error run(contours& loops, double tolerance) noexcept
    {
        const std::size_t n = loops.points.size();
        fates_.clear();
        numbers_.clear();
        measures_.clear();
        if (n == 0) return {};
        if (fates_.append(n) == nullptr || numbers_.append(n) == nullptr || measures_.append(n + 1) == nullptr)
            return error::out_of_memory;
        for (std::uint8_t& fate : fates_) fate = stays;
        loops_ = &loops;
        tolerance_ = tolerance;
        is_divided_ = has_failed_ = false;
        examined_ = none;
        seams_.clear();
        for (std::uint32_t k = 0; k < loops.contour_count(); ++k)
            if (!seams_.push_back(seam_of(loops.starts[k], loops.starts[k + 1]))) return error::out_of_memory;
        bool has_turned = false;
        for (std::uint32_t k = 0; k < loops.contour_count() && !has_failed_; ++k) {
            coarsen_loop({loops.starts[k], loops.starts[k + 1] - loops.starts[k], seams_[k]});
            has_turned = has_turned || (is_proven_later_ && turns());
        }
        if (has_turned && !has_failed_) return error::crossing_contours;
        return !has_failed_ && remove_dropped(loops) ? error{} : error{error::out_of_memory};
    }

    static constexpr std::uint8_t stays = 0, dropped = 1;
    static constexpr std::uint32_t max_others = 16, none = ~std::uint32_t{0};
    static constexpr double kept_share = 1.0 - 0x1p-20;  // of the tolerance; the rest is a margin for rounding
    static constexpr double estimate_share = 0.8;  // of the pieces that the whole's error predicts, for a first try
    static constexpr double nothing = 0x1p-38;     // beside the longest leg, squared: twice the 2^-20 of `tangents`
    using chords = cubic_chords<false>;

    struct curve_place {
        double t, offset;  // below 0: not known yet
    };

    /// A loop, whose points are counted from a point where a chain begins.
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

    [[nodiscard]] bool goes_on(const contour_edge& before, const contour_edge& after) noexcept
    {
        return before.curve == after.curve && after.curve < loops_->curves.size() && same(before.t1, after.t0) &&
               (before.t0 < before.t1) == (after.t0 < after.t1) &&
               !(may_stop(after.curve) &&
                 tangents_at(loops_->curves[after.curve], static_cast<double>(after.t0)).stops);
    }

    /// Whether the derivative of a curve could vanish anywhere, see tangents. It cannot if all legs of the control
    /// polygon go forward, by more than what counts as nothing: the derivative is a mean of them.
    [[nodiscard]] bool may_stop(std::uint32_t index) noexcept
    {
        if (examined_ == index) return may_stop_;
        examined_ = index;
        const curve& c = loops_->curves[index];
        const point way = c.p[c.degree] - c.p[0];
        double least = dot(c.p[1] - c.p[0], way), longest = 0.0;
        for (std::uint32_t k = 0; k < c.degree; ++k) {
            const point leg = c.p[k + 1] - c.p[k];
            const double along = dot(leg, way), square = dot(leg, leg);
            least = along < least ? along : least;
            longest = longest < square ? square : longest;
        }
        may_stop_ = !(least > 0.0 && least * least > nothing * longest * dot(way, way));
        return may_stop_;
    }

    /// The first point of a chain, which stays.
    [[nodiscard]] std::uint32_t seam_of(std::uint32_t begin, std::uint32_t end) noexcept
    {
        std::uint32_t seam = begin;
        while (seam < end && goes_on(loops_->edges[seam == begin ? end - 1 : seam - 1], loops_->edges[seam])) ++seam;
        return seam == end ? begin : seam;
    }

    void coarsen_loop(const cyclic& loop) noexcept
    {
        loop_ = loop;
        spare_ = loop_.size - 3;
        for (std::uint32_t first = 0; first < loop_.size && spare_ != 0;) {
            std::uint32_t last = first + 1;
            while (last < loop_.size && goes_on(edge(last - 1), edge(last))) ++last;
            if (last - first >= 2) coarsen_chain(first, last);
            first = last;
        }
    }

    /// Whether the loop without its dropped points has another orientation than before. The sums are exact modulo 2^64,
    /// and a doubled area is below 2^59.
    [[nodiscard]] bool turns() const noexcept
    {
        std::uint64_t before = 0, after = 0;
        const grid_point o = at(0);
        grid_point p = o, kept = o;
        for (std::uint32_t k = 1; k < loop_.size; ++k) {
            const std::uint32_t i = loop_.index(k);
            const grid_point q = loops_->points[i];
            before += static_cast<std::uint64_t>(orientation(o, p, q));
            p = q;
            if (fates_[i] == dropped) continue;
            after += static_cast<std::uint64_t>(orientation(o, kept, q));
            kept = q;
        }
        const auto was = static_cast<std::int64_t>(before), is = static_cast<std::int64_t>(after);
        return (was < 0) != (is < 0) || is == 0;
    }

    /// Drops points strictly between two places of the loop, whose edges belong to one curve.
    void coarsen_chain(std::uint32_t first, std::uint32_t last) noexcept
    {
        curve_ = loops_->curves[edge(first).curve];
        for (point& p : curve_.p) p = loops_->grid.cells * p;
        const cubic c = as_cubic(curve_);
        const point l0 = c.p1 - c.p0, l1 = c.p2 - c.p1, l2 = c.p3 - c.p2, s0 = l1 - l0, s1 = l2 - l1;
        chords of_curve{c.p0, 3.0 * l0, 3.0 * s0, s1 - s0, 0.0};
        const std::uint32_t edges = last - first;
        for (std::uint32_t k = 0; k <= edges; ++k) measures_[k].offset = -1.0;
        const std::uint32_t pieces = even_pieces(of_curve, first, last);
        if (pieces == edges && edges == 2) return;
        bool has_looked = false;
        if (pieces < edges && edges - pieces <= spare_) {
            const bool is_clear = is_proven_later_ && is_apart(first, last);
            if (!is_clear) look_around(first, last);
            if (is_clear || may_divide(first, last, pieces)) {
                spare_ -= edges - pieces;
                return divide_chain(first, last, pieces);
            }
            has_looked = true;
        }
        for (std::uint32_t from = first; from < last;) {
            std::uint32_t to = from + 1;
            for (; to < last && spare_ != 0 && fits(of_curve, first, from, to + 1); ++to) {
                if (!has_looked) look_around(first, last);
                has_looked = true;
                if (!may_drop(from, to)) break;
                --spare_;
            }
            end_of_piece(from, to);
            from = to;
        }
    }

    /// The least number of pieces of equally many edges that keep the tolerance; the number of edges if no fewer do, or
    /// if other pieces are fewer. The error of a piece grows with the square of its length.
    [[nodiscard]] std::uint32_t even_pieces(chords& of_curve, std::uint32_t first, std::uint32_t last) noexcept
    {
        const std::uint32_t edges = last - first;
        const double whole = excess(of_curve, first, first, last);
        if (whole <= 1.0) return 1;
        const double estimate = estimate_share * std::sqrt(std::sqrt(whole));
        if (!(estimate < static_cast<double>(edges))) return edges;
        std::uint32_t pieces = estimate > 2.0 ? static_cast<std::uint32_t>(estimate) : 2;
        while (pieces < edges && !fits_evenly(of_curve, first, last, pieces)) ++pieces;
        const bool is_as_estimated = estimate_share * (static_cast<double>(pieces) - 1.0) <= estimate;
        return is_as_estimated || pieces_one_by_one(of_curve, first, last) >= pieces ? pieces : edges;
    }

    /// The number of pieces if each takes as many edges as it can.
    [[nodiscard]] std::uint32_t pieces_one_by_one(chords& of_curve, std::uint32_t first, std::uint32_t last) noexcept
    {
        std::uint32_t pieces = 0;
        for (std::uint32_t from = first, to = first; from < last; from = to, ++pieces)
            for (to = from + 1; to < last && fits(of_curve, first, from, to + 1);) ++to;
        return pieces;
    }

    [[nodiscard]] bool fits_evenly(chords& of_curve, std::uint32_t first, std::uint32_t last,
                                   std::uint32_t pieces) noexcept
    {
        const std::uint32_t edges = last - first;
        std::uint32_t from = first;
        for (std::uint32_t k = 1; k <= pieces; ++k) {
            const std::uint32_t to = share(first, edges, k, pieces);
            if (to - from > 1 && !fits(of_curve, first, from, to)) return false;
            from = to;
        }
        return true;
    }

    /// Whether all points may be dropped except those between pieces.
    [[nodiscard]] bool may_divide(std::uint32_t first, std::uint32_t last, std::uint32_t pieces) const noexcept
    {
        if (is_convex_ && others_ == 0) return true;
        std::uint32_t from = first;
        for (std::uint32_t k = 1; k <= pieces; ++k) {
            const std::uint32_t to = share(first, last - first, k, pieces);
            for (std::uint32_t i = from + 1; i < to; ++i)
                if (!may_drop(from, i)) return false;
            from = to;
        }
        return true;
    }

    void divide_chain(std::uint32_t first, std::uint32_t last, std::uint32_t pieces) noexcept
    {
        std::uint32_t from = first;
        for (std::uint32_t k = 1; k <= pieces; ++k) {
            const std::uint32_t to = share(first, last - first, k, pieces);
            end_of_piece(from, to);
            from = to;
        }
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

    [[nodiscard]] static cubic as_cubic(const curve& c) noexcept
    {
        if (c.degree == 3) return c.as_cubic();
        return raised(c.degree == 2 ? c.as_quadratic() : quadratic{c.p[0], lerp(c.p[0], c.p[1], 0.5), c.p[1]});
    }

    /// The parameter at a place of a chain, and the distance of the point there from the curve.
    [[nodiscard]] const curve_place& measure(std::uint32_t first, std::uint32_t place) noexcept
    {
        curve_place& m = measures_[place - first];
        if (m.offset >= 0.0) return m;
        m.t = static_cast<double>(place == first ? edge(place).t0 : edge(place - 1).t1);
        const grid_point p = at(place);
        m.offset = length(curve_.at(m.t) - point{static_cast<double>(p.x), static_cast<double>(p.y)});
        return m;
    }

    /// How much the chord between two places of the chain exceeds the tolerance: see cubic_chords. The chord's own
    /// distance, and the distances of its ends.
    [[nodiscard]] double excess(chords& of_curve, std::uint32_t first, std::uint32_t from, std::uint32_t to) noexcept
    {
        const curve_place a = measure(first, from), b = measure(first, to);
        const double room = kept_share * (tolerance_ - (a.offset > b.offset ? a.offset : b.offset));
        if (!(room > 0.0)) return (std::numeric_limits<double>::max)();
        of_curve.tt = room * room;
        return of_curve.excess(a.t < b.t ? a.t : b.t, a.t < b.t ? b.t : a.t);
    }
    [[nodiscard]] bool fits(chords& of_curve, std::uint32_t first, std::uint32_t from, std::uint32_t to) noexcept
    {
        return excess(of_curve, first, from, to) <= 1.0;
    }

    /// Whether a point's index lies between two places of the loop, or at one of them.
    [[nodiscard]] bool is_between(std::uint32_t index, std::uint32_t from, std::uint32_t to) const noexcept
    {
        if (index - loop_.begin >= loop_.size) return false;
        const std::uint32_t own = loop_.place(index);
        return own - from <= to - from || (own == 0 && to == loop_.size);
    }

    /// Whether the point that stays of each other loop lies beside all triangles of a chain: outside the box around it,
    /// on the other side of the chord between its ends, or beyond its farthest point.
    [[nodiscard]] bool is_apart(std::uint32_t first, std::uint32_t last) noexcept
    {
        if (seams_.size() == 1) return true;
        const grid_point a = at(first), z = at(last);
        std::int64_t least = 0, greatest = 0;
        grid_box around;
        for (std::uint32_t k = first; k <= last; ++k) {
            const grid_point p = at(k);
            const std::int64_t side = orientation(a, z, p);
            least = side < least ? side : least;
            greatest = side > greatest ? side : greatest;
            around.add(p);
        }
        for (const std::uint32_t i : seams_) {
            const grid_point p = loops_->points[i];
            if (i == loop_.seam || !around.meets({p, p})) continue;
            const std::int64_t side = orientation(a, z, p);
            if (side >= least && side <= greatest) return false;
        }
        return true;
    }

    /// Finds out which points may lie in the triangles of a chain: its own ones if it is not convex, and others that
    /// are in the box around it; if it is convex, only those between the chord of its ends and its farthest point.
    void look_around(std::uint32_t first, std::uint32_t last) noexcept
    {
        is_convex_ = is_convex(first, last);
        if (!is_divided_ && !chunks_.open(loops_->points.view())) has_failed_ = true;
        is_divided_ = true;
        grid_box around;
        for (std::uint32_t k = first; k <= last; ++k) around.add(at(k));
        const std::uint32_t from = loop_.index(first), own = last - first + 1, to_end = loop_.begin + loop_.size - from,
                            before = own > to_end ? own - to_end : 0;
        const grid_point a = at(first), z = at(last);
        others_ = 0;
        chunks_.each_in(around, [&](std::size_t i) noexcept {
            const auto index = static_cast<std::uint32_t>(i);
            if ((index - from < own && index - from < to_end) || index - loop_.begin < before) return;
            if (is_convex_) {
                const std::int64_t side =
                    farthest_ < 0 ? -orientation(a, z, loops_->points[i]) : orientation(a, z, loops_->points[i]);
                if (side < 0 || side > (farthest_ < 0 ? -farthest_ : farthest_)) return;
            }
            if (others_ < max_others) other_[others_] = loops_->points[i];
            ++others_;
        });
    }

    /// Whether a chain and the chord between its ends bound a convex polygon: it turns to one side only, and is on one
    /// side of the chord. Then the polygon is simple, because the chain's edges do not meet, so it turns exactly once.
    /// Notes the side of its farthest point.
    [[nodiscard]] bool is_convex(std::uint32_t first, std::uint32_t last) noexcept
    {
        const grid_point a = at(first), z = at(last);
        bool is_left = !(a == z), is_right = is_left;
        std::int64_t least = 0, greatest = 0;
        grid_point before = a, p = at(first + 1);
        for (std::uint32_t k = first + 1; k < last; ++k) {
            const grid_point after = at(k + 1);
            const std::int64_t turn = orientation(before, p, after), side = orientation(a, p, z);
            is_left = is_left && turn >= 0 && side > 0;
            is_right = is_right && turn <= 0 && side < 0;
            least = side < least ? side : least;
            greatest = side > greatest ? side : greatest;
            before = p;
            p = after;
        }
        farthest_ = is_left ? -greatest : -least;  // orientation(a, z, p)
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
        chunks_.each_in(around, [&](std::size_t i) noexcept {
            if (!is_between(static_cast<std::uint32_t>(i), from, place + 1)) look_at(loops_->points[i]);
        });
        return is_clear;
    }

    /// Closes the gaps. An edge ends where the last edge of its piece ended. False if out of memory.
    [[nodiscard]] bool remove_dropped(contours& loops) noexcept
    {
        order_.clear();
        const array_view<const std::uint32_t> order = loops.order();
        if (!order_.reserve(order.size())) return false;
        for (const std::uint32_t i : order)
            if (fates_[i] == stays) order_.push_back_unchecked(i);
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
                numbers_[i] = to;
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
        if (order_.empty()) return true;
        std::uint32_t* next = loops.new_order(order_.size());
        if (next == nullptr) return false;
        for (const std::uint32_t i : order_) *next++ = numbers_[i];
        return true;
    }

    point_chunks chunks_;  // of the points, if is_divided_
    buffer<std::uint8_t> fates_;
    buffer<std::uint32_t> numbers_, order_;                                   // of the points that stay, afterwards
    buffer<std::uint32_t> seams_;                                             // a point of each loop that stays
    bool is_proven_later_ = false, is_divided_ = false, has_failed_ = false;  // the last: out of memory
    buffer<curve_place> measures_;                                            // of a chain
    const contours* loops_ = nullptr;
    double tolerance_ = 0.0;
    cyclic loop_{};
    curve curve_;                    // of the chain, in cells
    std::uint32_t examined_ = none;  // the curve that may_stop_ is about
    bool may_stop_ = false, is_convex_ = false;
    std::int64_t farthest_ = 0;  // the side of a convex chain's farthest point, of the chord between its ends
    std::uint32_t others_ = 0;   // the points that look_around() has found; the first ones are in other_
    grid_point other_[max_others];
    std::uint32_t spare_ = 0;  // the number of points that the loop can still lose
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
