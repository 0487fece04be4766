// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/sweep/impl/sectors.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/sweep/impl/sweep_status.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The sweep of the triangulators. It goes through the spans of interior from left to right, and `Cutter` cuts them
/// into triangles (see chain_cutter.hpp). If `Proving`, it also finds out whether the loops bound a region.
///
/// Between two neighbouring boundary edges that the sweep line crosses lies a *span* of interior. Its sides are
/// numbered: 0 lower, 1 upper.
///
/// Why the tests suffice: let X be the first point in sweep order where loops cross, touch or overlap. Left of X the
/// status is right. If X is not a vertex, two edges that are neighbours in the status cross there. Nothing can be
/// inserted between them afterwards, because everything above the upper one is above the lower one. So the first of
/// them that ends is tested against the other and found on the wrong side. If X is a vertex, either another vertex is
/// there (its neighbour in the sweep order), or an edge passes through X. Such an edge is next to an edge that ends
/// there (tested), or leaves no gap for a new span (tested), or lies between two edges that end there (then they are
/// not neighbours). Edges that double back are found where they start.
///
/// If `Touching`, a proven region may pass through a point more than once, each time along a separate sector of
/// interior. Imagine every such point moved a little into its sector. Then all points differ, and the sweep meets them
/// in this order:
///
///     .        ends            :::\ /:::   passes      ---.::::   a merge, or   ::::.---   starts
///     :::>.    (sector on the   ::: x :::   (above,        p :::   a split       ::: p      (sector on the    .<:::
///     '        left)           :::/ \:::   below)      ---'::::                 ::::'---   right)
///
/// Only starts must be placed among edges that begin in the point itself: by their angle.
///
/// If `Proving` and `Touching`: first the edges around every such point are sorted by angle. They must bound sectors,
/// no two may have one direction, and every visit must have a separate sector. Then one test is relaxed: an edge may
/// pass through p from outside its span if it begins or ends there. The argument above still holds, with X the first
/// place where loops meet outside common ends. If X is not a vertex, the two edges that cross there have no other point
/// in common. So the one that ends first does so strictly on the wrong side, and a vertex inserted between them is
/// tested against an edge that does not end in that vertex. If X is a vertex, an edge passes through it without ending
/// there. If others end in X, this edge or another such edge is right beside one of them, and every visit tests the
/// edges on both sides of those that it ends: passes and ends come first, and they only remove or replace edges that
/// end in X. If none ends in X, the first visit that opens there finds no edge from X yet. Left of X, the edges that
/// end in X are ordered by angle. After X, passes, splits and starts keep the edges that begin there in that order,
/// because at most two visits pass, one below and one above all that start, and at most one splits or merges; so the
/// status is right after X. Whether starts are outside and splits inside is tested against edges without an end in X,
/// or follows from the sectors.
template <bool Proving, bool Touching, class Cutter>
class monotone_sweep {
    struct vertex {
        std::uint32_t span[2];   // the span whose lower / upper side ends here; 0: that neighbour comes later
        std::uint32_t right[2];  // the end of a lower / upper side that starts here: the next / previous point
    };
    /// A boundary edge in the direction of its loop: the interior is on the left. Widened once and read about twice per
    /// point: 9 fewer instructions per point than with the two grid points.
    struct side {
        std::int64_t x, y;    // of its left end
        std::int64_t dx, dy;  // a lower side runs from there, an upper one to there

        /// As orientation(from, to, p).
        [[nodiscard]] std::int64_t at(grid_point p) const noexcept { return dx * (p.y - y) - dy * (p.x - x); }
        [[nodiscard]] bool begins_at(grid_point p) const noexcept { return p.x == x && p.y == y; }
        template <std::uint32_t on>
        [[nodiscard]] bool ends_at(grid_point p) const noexcept
        {
            return on == 0 ? p.x - x == dx && p.y - y == dy : x - p.x == dx && y - p.y == dy;
        }
    };
    struct span_of_interior {
        side sides[2];
        std::uint32_t end[2];  // the vertex where each side ends
        typename Cutter::chains seen;
    };

public:
    monotone_sweep(array_view<const grid_point> points, array_view<const std::uint32_t> starts, Cutter cutter) noexcept
        : points_{points}, starts_{starts}, cut_{cutter}
    {
    }

    /// Sweeps over all points. The cutter makes at most points + 2 * loops triangles, even if the sweep fails with
    /// error::crossing_contours.
    ///
    ///     known   the order of the points, from sweep_order(); empty: unknown
    [[nodiscard]] error run(workspace& space, array_view<const std::uint32_t> known = {}) noexcept
    {
        const std::size_t n = points_.size();
        if (n == 0) return error::none;
        TYPEMESH_ASSERT(loops() != 0 && starts_[loops()] == n, "the last of the starts must be the number of points");
        workspace::scope scratch{space};
        TYPEMESH_ASSERT(known.empty() || known.size() == n, "the given order belongs to other points");
        const bool sorted = !Touching && !known.empty();  // the visits of one point are sorted further
        auto* const own = sorted ? nullptr : scratch.take<std::uint32_t>(n);
        if (!sorted && (own == nullptr || (known.empty() && !sweep_order(points_, space, own))))
            return error::out_of_memory;
        vertices_ = scratch.take<vertex>(n);
        spans_ = scratch.take<span_of_interior>(n / 2 + 2);  // at most every other point opens one
        if (vertices_ == nullptr || spans_ == nullptr || !cut_.open(scratch, n) || !status_.open(scratch, n / 2 + 1))
            return error::out_of_memory;
        link_up();
        if constexpr (Touching) {
            for (std::size_t i = 0; i < known.size(); ++i) own[i] = known[i];
            if (const error e = order_visits(own, scratch)) return e;
        }
        if (sweep(sorted ? known.data() : own)) return error::none;
        return error{error::crossing_contours, equal_points_ ? 1u : 0u};
    }

    /// Whether equal points were found: up to the refusal or, if `Touching`, anywhere.
    [[nodiscard]] bool has_equal_points() const noexcept { return equal_points_; }

    [[nodiscard]] const Cutter& cutter() const noexcept { return cut_; }

    /// After a proof: every loop is a hole or an outer loop, and excess_ is 2h - 2c.
    [[nodiscard]] std::uint32_t holes() const noexcept
    {
        return static_cast<std::uint32_t>((loops_met_ + excess_ / 2) / 2);
    }
    [[nodiscard]] std::uint32_t outers() const noexcept { return loops_met_ - holes(); }

private:
    [[nodiscard]] std::size_t loops() const noexcept { return starts_.empty() ? 0 : starts_.size() - 1; }

    void link_up() noexcept
    {
        const auto n = static_cast<std::uint32_t>(points_.size());
        for (std::uint32_t v = 0; v < n; ++v) vertices_[v] = {{0, 0}, {v + 1, v - 1}};
        for (std::size_t loop = 0; loop < loops(); ++loop) {
            const std::uint32_t begin = starts_[loop], end = starts_[loop + 1];
            if (begin == end) continue;
            ++loops_met_;
            vertices_[end - 1].right[0] = begin;
            vertices_[begin].right[1] = end - 1;
        }
        // Span 0 surrounds everything: its lower side is above all points, its upper side below them.
        constexpr std::int64_t reach = 1 << 28;
        spans_[0] = {{{-reach, reach + 1, 2 * reach, 0}, {-reach, -reach - 1, -2 * reach, 0}}, {0, 0}, {}};
    }

    /// Sorts the visits of each point into the order given above.
    [[nodiscard]] error order_visits(std::uint32_t* order, workspace::scope& scratch) noexcept
    {
        const std::size_t n = points_.size();
        auto* const ordered = scratch.take<std::uint32_t>(n);
        outgoing_edge* const outgoing_edges = Proving ? scratch.take<outgoing_edge>(2 * n) : nullptr;
        if (ordered == nullptr || (Proving && outgoing_edges == nullptr)) return error::out_of_memory;
        for (std::size_t begin = 0, end = 1; begin < n; begin = end++) {
            while (end < n && points_[order[end]] == points_[order[begin]]) ++end;
            if (end - begin == 1) continue;
            equal_points_ = true;
            if constexpr (Proving)
                if (!are_sectors({order + begin, end - begin}, outgoing_edges)) return error::crossing_contours;
            std::size_t k = begin;
            for (std::uint32_t rank = 0; rank < 4; ++rank)
                for (std::size_t i = begin; i < end; ++i)
                    if (visit_rank(order[i]) == rank) ordered[k++] = order[i];
            for (k = begin; k < end; ++k) order[k] = ordered[k];
        }
        return error::none;
    }

    /// Whether every visit of a point has its own sector, and no two sectors overlap.
    [[nodiscard]] bool are_sectors(array_view<const std::uint32_t> visits, outgoing_edge* outgoing_edges) const noexcept
    {
        std::size_t count = 0;
        for (const std::uint32_t v : visits) {
            outgoing_edges[count++] = outgoing_edge::to(points_[vertices_[v].right[0]], points_[v], v, true);
            outgoing_edges[count++] = outgoing_edge::to(points_[vertices_[v].right[1]], points_[v], v, false);
        }
        if (!sort_into_sectors(outgoing_edges, count)) return false;
        for (std::size_t i = 0; i < count; i += 2)
            if (outgoing_edges[i].visit != outgoing_edges[i + 1].visit) return false;
        return true;
    }

    /// Whether p lies outside a span beyond its side `on`; if `Touching`, also if p is an end of that side.
    template <std::uint32_t on>
    [[nodiscard]] bool is_outside(std::uint32_t span, grid_point p) const noexcept
    {
        const side& s = spans_[span].sides[on];
        if constexpr (Touching)
            if (s.begins_at(p) || s.template ends_at<on>(p)) return true;
        return s.at(p) < 0;
    }
    /// Whether p lies above the lower or below the upper side of a span.
    template <std::uint32_t on>
    [[nodiscard]] bool is_inside(std::uint32_t span, grid_point p) const noexcept
    {
        return spans_[span].sides[on].at(p) > 0;
    }

    /// 0: an end, 1: a pass, 2: a merge or a split, 3: a start.
    [[nodiscard]] std::uint32_t visit_rank(std::uint32_t v) const noexcept
    {
        const grid_point p = points_[v], next = points_[vertices_[v].right[0]],
                         previous = points_[vertices_[v].right[1]];
        const bool opens = lexicographic_less(p, next);
        if (opens != lexicographic_less(p, previous)) return 1;
        if (orientation(previous, p, next) < 0) return 2;
        return opens ? 3 : 0;
    }

    [[nodiscard]] bool sweep(const std::uint32_t* order) noexcept
    {
        const auto n = static_cast<std::int64_t>(points_.size());
        std::uint64_t last = grid_point{-(1 << 28) - 1, 0}.word();  // not on the grid
        Cutter cut = cut_;                                          // a local copy stays in registers
        stop_ = n;
        std::int64_t i = 0;
        for (; i < stop_; ++i) {
            const std::uint32_t v = order[i];
            const grid_point p = points_[v];
            if constexpr (Proving && !Touching) {
                if (p.word() == last) break;
                last = p.word();
            }
            const std::uint32_t lower = vertices_[v].span[0], upper = vertices_[v].span[1];
            if (lower != 0 && upper == 0) {
                if (!pass<0>(cut, lower, v, p)) break;
            } else if (lower == 0 && upper != 0) {
                if (!pass<1>(cut, upper, v, p)) break;
            } else {
                cut_ = cut;
                if (lower == 0 ? !open(v, p) : !close(lower, upper, v, p)) break;
                cut = cut_;
            }
        }
        cut_ = cut;
        if (i == n) return true;
        const grid_point p = points_[order[i]];
        equal_points_ = (i > 0 && points_[order[i - 1]] == p) || (i + 1 < n && points_[order[i + 1]] == p);
        return false;
    }

    /// One neighbour came before, the other comes later: a side of a span continues.
    ///
    ///   upper  -----------.                 :::::::::::
    ///          ::::::::::  '---       or    :::::::: .----
    ///   lower  --------p----                --------p
    template <std::uint32_t on>
    [[nodiscard]] bool pass(Cutter& cut, std::uint32_t s, std::uint32_t v, grid_point p) noexcept
    {
        if constexpr (Proving) {
            const std::uint32_t outside = status_.neighbour(s, on);
            if (!is_inside<1 - on>(s, p) || !is_outside<1 - on>(outside, p)) return false;
        }
        cut.template extend<on>(spans_[s].seen, v, p);
        set_side<on>(s, v, p);
        return true;
    }

    /// Both neighbours come later: a new span opens (start), or a span is split.
    ///
    ///          .--- upper             ::::::::::::: .---  lower side of a new span above
    ///   start p :::::::          split  t :::::::: p
    ///          '--- lower             ::::::::::::: '---  upper side of the part that stays below
    [[nodiscard]] bool open(std::uint32_t v, grid_point p) noexcept
    {
        const std::int64_t turn = orientation(points_[vertices_[v].right[1]], p, points_[vertices_[v].right[0]]);
        const std::uint32_t s = status_.last_below([&](std::uint32_t item) noexcept {
            const side& lower = spans_[item].sides[0];
            if constexpr (Touching) {
                if (lower.begins_at(p)) return lower.at(points_[vertices_[v].right[0]]) > 0;
            }
            return lower.at(p) > 0;
        });
        const bool splits = turn < 0;
        if constexpr (Proving) {
            if (turn == 0) return false;  // doubles back
            if (splits ? !is_inside<1>(s, p) : !is_outside<1>(s, p) || !is_outside<0>(status_.above(s), p))
                return false;
        }
        bound_triangles(splits ? 1 : -1);
        const std::uint32_t fresh = take_span();
        span_of_interior& above = spans_[fresh];
        if (splits) {
            span_of_interior& below = spans_[s];
            cut_.split(below.seen, above.seen, v, p);
            above.sides[1] = below.sides[1];
            above.end[1] = below.end[1];
            vertices_[above.end[1]].span[1] = fresh;
            set_side<1>(s, v, p);
        } else {
            cut_.start(above.seen, v, p);
            set_side<1>(fresh, v, p);
        }
        set_side<0>(fresh, v, p);
        status_.insert_above(s, fresh);
        return true;
    }

    /// Both neighbours came before: a span ends, or two become one.
    ///
    ///   upper ---.                  upper side of the span below ---.  :::::::
    ///     ::::::: p  end                                             p :::::::  merge
    ///   lower ---'                  lower side of the span above ---'  :::::::
    [[nodiscard]] bool close(std::uint32_t lower, std::uint32_t upper, std::uint32_t v, grid_point p) noexcept
    {
        const bool ends = lower == upper;
        if constexpr (Proving) {
            const bool clear = ends ? is_outside<1>(status_.below(lower), p) && is_outside<0>(status_.above(lower), p)
                                    : status_.above(upper) == lower && is_inside<0>(upper, p) && is_inside<1>(lower, p);
            if (!clear) return false;
        }
        bound_triangles(ends ? -1 : 1);
        span_of_interior& gone = spans_[lower];
        if (ends) {
            cut_.finish(gone.seen, v, p);
        } else {
            span_of_interior& stays = spans_[upper];
            cut_.merge(stays.seen, gone.seen, v, p);
            stays.sides[1] = gone.sides[1];
            stays.end[1] = gone.end[1];
            vertices_[stays.end[1]].span[1] = upper;
        }
        status_.erase(lower);
        gone.end[0] = free_span_;
        free_span_ = lower;
        return true;
    }

    template <std::uint32_t on>
    void set_side(std::uint32_t s, std::uint32_t v, grid_point p) noexcept
    {
        const std::uint32_t end = vertices_[v].right[on];
        const grid_point q = points_[end];
        const std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y;
        spans_[s].sides[on] = {p.x, p.y, on == 0 ? dx : -dx, on == 0 ? dy : -dy};
        spans_[s].end[on] = end;
        vertices_[end].span[on] = s;
    }

    [[nodiscard]] std::uint32_t take_span() noexcept
    {
        if (free_span_ == 0) return ++span_count_;
        const std::uint32_t s = free_span_;
        free_span_ = spans_[s].end[0];
        return s;
    }

    /// Splits and merges add triangles, starts and ends remove some. For a region, splits + merges - starts - ends is
    /// 2h - 2c at the end, so it never exceeds the amount that the remaining points can take back. A larger value means
    /// that loops cross, and the rest could make more triangles than there is memory for.
    void bound_triangles(std::int64_t change) noexcept
    {
        if constexpr (Proving) {
            excess_ += change;
            const auto n = static_cast<std::int64_t>(points_.size()),
                       room = n + 2 * static_cast<std::int64_t>(loops()) - excess_;
            stop_ = room < n ? room : n;
        }
    }

    array_view<const grid_point> points_;
    array_view<const std::uint32_t> starts_;
    vertex* vertices_ = nullptr;
    span_of_interior* spans_ = nullptr;
    sweep_status status_;
    Cutter cut_;
    std::int64_t stop_ = 0;
    std::int64_t excess_ = 0;
    std::uint32_t span_count_ = 0;
    std::uint32_t free_span_ = 0;
    std::uint32_t loops_met_ = 0;
    bool equal_points_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
