// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/bent_edges.hpp>
#include <typemesh/fill/impl/crossing.hpp>
#include <typemesh/fill/impl/event_queue.hpp>
#include <typemesh/fill/impl/net_edges.hpp>
#include <typemesh/fill/impl/sector_links.hpp>
#include <typemesh/fill/impl/start_order.hpp>
#include <typemesh/fill/impl/sweep_line.hpp>
#include <typemesh/fill/impl/swept_edge.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// One sweep from left to right over an arrangement. It cuts segments where they cross, touch or overlap.
///
/// The sweep line crosses edges, ordered from bottom to top. Two edges that become neighbours are tested once: the one
/// that ends first must end on its own side of the other. If it does not, both are cut where they cross, at the nearest
/// grid point x, and bent through it:
///
///     a ---.__                     a ---.__      . d      The right halves wait in a queue until the sweep reaches x.
///     c ____  '--.__       ->      c ______'--x-'         An end that lies on the other edge cuts it without bending.
///           '---.___'-- b                      '--- b
///                    ' d
///
/// At a point, the edges that end there are adjacent in the status. The edges that start there are sorted by angle and
/// take their places. Edges that lie upon each other are joined: the longer one is cut at the end of the shorter one.
///
/// Afterwards no two segments share more than an end, the winding numbers below them are right, and `next` links the
/// segments that bound the filled area, as boundary_cycles needs. Otherwise `again` requests one more sweep over the
/// result, or snap rounding. In such a sweep any step may have been wrong: it may have made wrong cuts or missed some.
/// But nothing worse can happen, because the segments stay closed contours whatever is cut.
///
/// Why a sweep can be trusted. Bending moves an edge by less than a cell, and parts that the sweep has already passed
/// may then lie on its other side. So every point p is tested against the edges right below and right above it when the
/// sweep reaches it (pass_by), and the sweep is trusted if 1, 2 and 3 hold. Where one edge ends in p and one starts,
/// the test has been made before: p was tested against each neighbour, which ends later, when the edge that ends and
/// the neighbour became adjacent, and whenever either was cut (is_clear). The finding counts once the sweep is in p.
///
///     1  the points came in ascending order, each once, and every edge ended where the sweep removed it;
///     2  p lay strictly between those two edges, and still does after they have been bent;
///     3  no two edges that ended next to each other had begun together. All that end in a point are adjacent in the
///        status, so it is enough to remember the previous one.
///
/// Let X be the first place where final segments meet outside common ends; left of X the status is in order. If X is
/// not an end of a segment, two neighbours e below f cross there. (They do not begin together in one direction: until
/// one of them ends, nothing can come between them; ending in the same place violates 3, in different places 2.) After
/// X nothing can be inserted between them, because everything above e is above f. So the one that ends first does so on
/// the wrong side of the other, its neighbour, contrary to 2. If X is an end p, an edge that passes through it is next
/// to the edges that end there, or to the place where others start, contrary to 2. Where nothing meets, the winding
/// numbers add up.
///
/// To check 2 without another sweep: an edge ab is bent through x only once, and only if x is within one cell of its
/// line, that is |orientation(a, b, x)| <= |dx| + |dy|, so all of ax is. If anything is bent, every point must be
/// farther than that from the edges right below and right above it (otherwise it is `close_`). So no point changes
/// sides. A point after x cannot have been tested against ab yet, or x comes out of order (`late_`) or a second time.
///
/// Why the result is the snap rounding: each cut lies in a pixel that the contour's own edge passes through
/// (lead_home). Assume that this edge passes through the pixel of a point in which it is not cut. Then some piece of it
/// lies within a cell of that point, and the nearest of all such pairs are adjacent in the status (or in one column:
/// is_close_in_column). A crossing that was not found belongs to two edges that pass through one point beside it, where
/// more than these two meet (is_rough). Tests compare the result with the definition, pair by pair.
///
/// From  Bentley & Ottmann, Algorithms for reporting and counting geometric intersections (1979); Hobby, Practical
///       segment intersection with finite precision output (1999)
class resolving_sweep {
public:
    bool again = false;     ///< something may be inconsistent: another sweep is needed
    bool rough = false;     ///< a bend may deviate from snap rounding: only snap rounding helps
    bool partial = false;   ///< edges cancel in part: crossings with that part were not sought
    bool full = false;      ///< stopped early: no capacity for more segments
    bool touching = false;  ///< the boundary passes through some point more than once

    explicit resolving_sweep(arrangement& a, fill_rule rule) noexcept : a_{a}, rule_{rule}, mask_{winding_mask(rule)} {}

    /// False if out of memory; the arrangement is then unusable.
    [[nodiscard]] bool run(workspace& space) noexcept
    {
        {
            workspace::scope scratch{space};
            if (!open(scratch)) return false;
            sweep();
        }
        partial = starts_.partial;
        rough_ |= starts_.rough;
        const bool out_of_order = full || late_ || unfinished_;
        a_.is_bent |= bent_;
        rough = a_.is_rounded ? bent_ : a_.is_bent && (rough_ || close_);
        again = unsure_ || out_of_order || rough;
        if (out_of_order) return a_.put_in_order(space);
        swap_values(a_.points, a_.spare);
        a_.point_count = passed_;
        a_.is_touching = touching;
        if (again) a_.list();
        return true;
    }

private:
    [[nodiscard]] bool open(workspace::scope& scratch) noexcept
    {
        const std::uint32_t most = a_.count < a_.max_active ? a_.count : a_.max_active;
        const std::uint32_t starts = a_.is_rounded ? most : most / 4 + 32;
        const std::size_t edges = std::size_t{most} + 1, cuts = a_.capacity - a_.count;
        ends_ = scratch.take<std::uint32_t>(edges);
        dirty_ = scratch.take<std::uint32_t>(cuts);
        hints_ = scratch.take<std::uint32_t>(std::size_t{a_.point_count} + 1);
        if (ends_ == nullptr || dirty_ == nullptr || hints_ == nullptr || !starts_.open(scratch, starts) ||
            !line_.open(scratch, most) || !queue_.open(scratch, 2 * cuts + edges / 8))
            return false;
        std::memset(hints_, 0, a_.point_count * sizeof *hints_);
        passed_ = 0;
        return true;
    }

    void sweep() noexcept
    {
        const std::uint32_t count = a_.point_count;
        const grid_point* const points = a_.points;
        std::uint32_t next = 0;
        constexpr std::int64_t column = std::int64_t{1} << 31;  // points of one x are closer, all others farther apart
        std::int64_t last = sweep_place({-sweep_line::beyond.x, -sweep_line::beyond.y});
        while (!full) {
            grid_point p = next < count ? points[next] : sweep_line::beyond;
            std::int64_t place = sweep_place(p);
            std::uint32_t starting = no_number, slot = 0;
            if (place <= queue_.first_place()) {
                if (next == count) {
                    unfinished_ = !line_.empty();
                    return;
                }
                starting = a_.first[next];
                slot = hints_[next++];
                if (!(line_[slot].to == p)) slot = 0;
            } else {
                place = queue_.first_place();
                p = point_at(place);
            }
            for (; queue_.first_place() == place; queue_.pop()) {
                const event e = queue_.top();
                if (e.segment != no_number) {
                    a_.segments[e.segment].next = starting;
                    starting = e.segment;
                }
                if (line_[e.slot].to == p) slot = e.slot;
            }
            const bool repeated = place == last;
            if (!repeated) {
                if (passed_ == a_.capacity) {
                    full = true;
                    return;
                }
                if (place < last) late_ = true;
                if (place - last < column && is_close_in_column(a_, last_ended_, starting, point_at(last), p))
                    close_ = true;
                a_.spare[passed_++] = p;
                last = place;
            }
            const bool passes = slot != 0 && starting != no_number;
            const bool alone = (line_[line_.below(slot)].to == p) + (line_[line_.above(slot)].to == p) == 0;
            if (passes && alone && a_.segments[starting].next == no_number && !repeated)
                pass(slot, starting, p);
            else
                meet(slot, starting, p, repeated);
            while (dirty_count_ != 0) {
                const std::uint32_t changed = dirty_[--dirty_count_], cut_slot = changed / 2;
                const std::uint32_t low = changed % 2 != 0 ? cut_slot : line_.below(cut_slot);
                const std::uint32_t high = line_.above(low);
                if (!is_clear(low, high)) separate(low, high);
            }
        }
    }

    /// One edge ends, and one starts: the usual case.
    void pass(std::uint32_t slot, std::uint32_t starting, grid_point p) noexcept
    {
        const std::uint32_t ending = line_[slot].segment, under = line_.below(slot), over = line_.above(slot);
        segment& before = a_.segments[ending];
        segment& s = a_.segments[starting];
        if (s.bent != 0) rough_ |= goes_through(a_, s, p);
        last_ended_ = ending;
        finish(ending);
        if (s.winding_delta == before.winding_delta) {  // the winding numbers on its sides stay the same
            s.start = passed_ - 1;
            s.below = before.below;
            s.interior = before.interior;
            line_[slot].begin(p, s.to, starting, line_[slot].above);
            if (s.end != no_number) hints_[s.end] = slot;
        } else {
            unsure_ |= differ(s.winding_delta, before.winding_delta);
            begin(slot, starting, p, before.below);
        }
        if (s.interior >= 0) before.next = starting;
        s.next = ending;  // if the boundary runs from right to left; otherwise irrelevant
        if (under != 0 && !is_far(line_[under], line_[slot]) && !is_clear(under, slot)) separate(under, slot);
        if (over != 0 && !is_far(line_[slot], line_[over]) && !is_clear(slot, over)) separate(slot, over);
    }

    /// Tests p against the edges right below and right above it.
    void pass_by(std::uint32_t under, std::uint32_t over, grid_point p) noexcept
    {
        const auto hold = [&](const swept_edge& e, std::int64_t side) noexcept {
            unsure_ |= side <= 0;
            close_ |= side <= e.reach();
        };
        if (under != 0) hold(line_[under], orientation(line_[under].from, line_[under].to, p));
        if (over != 0) hold(line_[over], -orientation(line_[over].from, line_[over].to, p));
    }

    /// Whether an edge ends in p; if p occurs again, also whether it starts there.
    [[nodiscard]] bool is_here(std::uint32_t slot, grid_point p, bool repeated) const noexcept
    {
        return slot != 0 && (line_[slot].to == p || (repeated && line_[slot].from == p));
    }

    /// The edge right below all edges that end in p; one of them is in `slot`.
    [[nodiscard]] std::uint32_t below_ending(std::uint32_t slot, grid_point p, bool repeated) const noexcept
    {
        std::uint32_t under = line_.below(slot);
        while (is_here(under, p, repeated)) under = line_.below(under);
        return under;
    }

    /// Two edges start and none ends: a contour begins. Any other case is left untouched and returns false.
    [[nodiscard]] bool opens(std::uint32_t starting, grid_point p) noexcept
    {
        const segment& one = a_.segments[starting];
        const std::uint32_t second = one.next;
        if (second == no_number || line_.room() < 2) return false;
        const segment& other = a_.segments[second];
        const std::int64_t turn = orientation(p, one.to, other.to);
        if (turn == 0 || other.next != no_number || (one.bent | other.bent) != 0) return false;
        const std::uint32_t under = line_.find(p), over = line_.above(under);
        if (over != 0 && orientation(line_[over].from, line_[over].to, p) == 0) return false;
        pass_by(under, over, p);
        const std::uint32_t lower = turn > 0 ? starting : second, upper = turn > 0 ? second : starting;
        const std::uint32_t low = line_.insert_above(under), high = line_.insert_above(low);
        begin(low, lower, p, line_[under].above);
        begin(high, upper, p, line_[low].above);
        touching |= link_two(a_.segments, lower, upper, true);
        last_ended_ = no_number;
        check_winding(line_[high].above, over);
        if (!is_clear(low, high)) separate(low, high);
        if (!is_clear(under, low)) separate(under, low);
        if (!is_clear(high, over)) separate(high, over);
        return true;
    }

    /// Two edges end and none starts: a contour ends. Any other case is left untouched and returns false.
    [[nodiscard]] bool closes(std::uint32_t slot, grid_point p) noexcept
    {
        const std::uint32_t low = line_[line_.above(slot)].to == p ? slot : line_.below(slot);
        const std::uint32_t high = line_.above(low), under = line_.below(low), over = line_.above(high);
        if (!(line_[low].to == p) || !(line_[high].to == p) || line_[under].to == p || line_[over].to == p ||
            line_[low].from == line_[high].from)
            return false;
        pass_by(under, over, p);
        const std::uint32_t lower = line_[low].segment, upper = line_[high].segment;
        finish(lower);
        finish(upper);
        touching |= link_two(a_.segments, upper, lower, false);
        last_ended_ = upper;
        check_winding(line_[under].above, over);
        line_.erase(low);
        line_.erase(high);
        if (!is_clear(under, over)) separate(under, over);
        return true;
    }

    /// The sum over the edges below must be the winding number right below `over`.
    void check_winding(std::int32_t winding, std::uint32_t over) noexcept
    {
        const std::int32_t expected = over != 0 ? a_.segments[line_[over].segment].below : 0;
        if (winding != expected) unsure_ |= differ(winding, expected);
    }

    /// Handles any number of edges that end and any number that start.
    void meet(std::uint32_t slot, std::uint32_t starting, grid_point p, bool repeated) noexcept
    {
        if (!repeated && (starting == no_number ? closes(slot, p) : slot == 0 && opens(starting, p))) return;
        point_event here{p, starting};
        if (!end_edges(here, slot, repeated)) return;
        last_ended_ = here.ending_count != 0 ? ends_[here.ending_count - 1] : no_number;
        const std::uint32_t starting_count = starts_.put_in_order(here.starting, p);
        full |= starts_.full;
        if (full || starting_count > here.place_count + line_.room()) {
            full = true;
            return;
        }
        start_edges(here, slot, starting_count);
    }

    /// The edges that end are adjacent. An edge that passes through the point is cut. If the point occurs again, the
    /// edges that started there the first time start again. False if there is no capacity left.
    [[nodiscard]] bool end_edges(point_event& here, std::uint32_t slot, bool repeated) noexcept
    {
        const grid_point p = here.at;
        unsure_ |= repeated;
        grid_point began = p;  // the start of the edge that ended last
        here.under = slot == 0 ? line_.find(p) : below_ending(slot, p, repeated);
        std::uint32_t over = line_.above(here.under);
        for (; over != 0; over = line_.above(over), ++here.place_count) {
            const swept_edge& e = line_[over];
            if (is_here(over, p, repeated)) {
                if (!(e.to == p)) {
                    a_.segments[e.segment].next = here.starting;
                    here.starting = e.segment;
                    continue;
                }
            } else if (slot == 0 && orientation(e.from, e.to, p) == 0 && is_between(e.from, p, e.to)) {
                const std::uint32_t rest = a_.count;
                if (!split(over, p)) return false;
                a_.segments[rest].next = here.starting;
                here.starting = rest;
            } else {
                break;
            }
            unsure_ |= e.from == began;
            began = e.from;
            finish(e.segment);
            ends_[here.ending_count++] = e.segment;
        }
        here.over = over;
        return true;
    }

    /// The edges that start take the places of those that end, if there are enough places and they appear to be right.
    void start_edges(point_event here, std::uint32_t slot, std::uint32_t starting_count) noexcept
    {
        const grid_point p = here.at;
        std::uint32_t under = here.under, over = here.over;
        pass_by(under, over, p);
        const bool enough = !unsure_ && starting_count <= here.place_count;
        for (std::uint32_t i = enough ? starting_count : 0; i < here.place_count; ++i) line_.erase(line_.above(under));
        if (!enough && slot != 0 && starting_count != 0) {
            under = line_.find(p);
            over = line_.above(under);
            pass_by(under, over, p);
        }
        sector_links links{a_.segments};
        std::int32_t winding = line_[under].above;
        std::uint32_t last = under, bends = 0;
        for (std::uint32_t i = 0; i < starting_count; ++i) {
            const std::uint32_t place = enough ? line_.above(last) : line_.insert_above(last), k = starts_.all()[i];
            begin(place, k, p, winding);
            bends |= a_.segments[k].bent;
            winding = line_[place].above;
            if (i != 0 && !is_clear(last, place)) separate(last, place);  // one may end near the other
            links.take(k, true);
            last = place;
        }
        if (bends) rough_ |= is_rough(a_, ends_, here.ending_count, starts_.all(), starting_count, p);
        check_winding(winding, over);
        for (std::uint32_t i = here.ending_count; i-- != 0;) links.take(ends_[i], false);
        touching |= links.close();
        if (const std::uint32_t low = line_.above(under); !is_clear(under, low)) separate(under, low);
        if (last != under && !is_clear(last, over)) separate(last, over);
    }

    /// Whether two winding numbers differ for the fill rule.
    [[nodiscard]] bool differ(std::int32_t a, std::int32_t b) const noexcept { return ((a - b) & mask_) != 0; }

    void begin(std::uint32_t slot, std::uint32_t starting, grid_point p, std::int32_t winding) noexcept
    {
        segment& s = a_.segments[starting];
        const std::int32_t above = winding + s.winding_delta;
        s.start = passed_ - 1;
        s.below = winding;
        s.interior = int{is_filled(rule_, above)} - int{is_filled(rule_, winding)};
        line_[slot].begin(p, s.to, starting, above);
        if (s.end != no_number) hints_[s.end] = slot;
    }

    void finish(std::uint32_t ending) noexcept
    {
        segment& s = a_.segments[ending];
        s.end = passed_ - 1;
        if (late_ && sweep_place(s.to) < sweep_place(s.from)) {
            s.flip();
            rough_ = true;
        }
    }

    /// Whether the one of two neighbours that ends first does so on its own side of the other. Notes how close it
    /// comes.
    [[nodiscard]] bool is_clear(std::uint32_t low, std::uint32_t high) noexcept
    {
        if (low == 0 || high == 0) return true;
        const auto [side, reach] = clearance_of(line_[low], line_[high]);
        if (side > reach) return true;
        if (side <= 0) return false;
        return close_ = true;
    }

    /// Two neighbours that are not clear of each other: cuts them where they meet, unless both end there.
    void separate(std::uint32_t low, std::uint32_t high) noexcept
    {
        const swept_edge &l = line_[low], &h = line_[high];
        if (l.to == h.to) return;
        if (grid_point x; crossing_of(l.from, l.to, h.from, h.to, x)) {
            if (a_.segments[l.segment].bent || a_.segments[h.segment].bent) rough_ |= !lead_home(a_, l, h, x);
            if (cut(low, x, 0)) (void)cut(high, x, 1);
            return;
        }
        const bool low_first = sweep_place(l.to) < sweep_place(h.to);
        const swept_edge& longer = low_first ? h : l;
        const grid_point end = low_first ? l.to : h.to;
        if (orientation(longer.from, longer.to, end) == 0 && is_between(longer.from, end, longer.to))
            (void)cut(low_first ? high : low, end, low_first);
        else
            unsure_ = true;
    }

    /// Cuts an edge in a grid point of its box and queues the right half. False if there is no capacity left. Also
    /// queues a test against the neighbour on `side` (0: below, 1: above); the other neighbour ends there, too.
    ///
    /// A half of a nearly vertical edge may be vertical and run downwards. The right half is then reversed and queued
    /// where the edge ended. The left half is reversed when the sweep finishes it, which happens at once.
    [[nodiscard]] bool cut(std::uint32_t slot, grid_point x, std::uint32_t side) noexcept
    {
        if (line_[slot].to == x || line_[slot].from == x) {
            unsure_ |= line_[slot].from == x;
            if (queue_.room() == 0)
                full = true;
            else
                queue_.push({sweep_place(x), no_number, slot});
            return !full;
        }
        if (!split(slot, x)) return false;
        const std::uint32_t rest = a_.count - 1;
        segment& r = a_.segments[rest];
        if (sweep_place(r.to) < sweep_place(x)) {
            r.flip();
            unsure_ = rough_ = true;
            queue_.push({sweep_place(r.from), rest, 0});
            queue_.push({sweep_place(x), no_number, slot});
        } else {
            queue_.push({sweep_place(x), rest, slot});
        }
        dirty_[dirty_count_++] = 2 * slot + side;
        return true;
    }

    /// Ends the edge in a slot in x; its rest becomes the last segment of all. False if there is no capacity left.
    [[nodiscard]] bool split(std::uint32_t slot, grid_point x) noexcept
    {
        if (a_.count == a_.capacity || queue_.room() < 2) {
            full = true;
            return false;
        }
        swept_edge& e = line_[slot];
        segment& s = a_.segments[e.segment];
        if (const std::int64_t side = orientation(e.from, e.to, x); side != 0) {
            unsure_ |= e.is_bent || (side < 0 ? -side : side) > e.reach();
            e.is_bent = bent_ = true;
            s.bent = 1;
        }
        const float t = s.t_at(x);
        ::new (a_.segments + a_.count++) segment{
            x,        s.to,      no_number, s.end, s.winding_delta, 0, {s.source.curve, t, s.source.t1}, s.origin,
            s.target, no_number, s.bent,    0};
        s.to = x;
        s.end = no_number;
        s.source.t1 = t;
        e.to = x;
        return true;
    }

    arrangement& a_;
    fill_rule rule_;
    std::int32_t mask_;  // of winding numbers
    sweep_line line_;
    std::uint32_t* ends_ = nullptr;
    std::uint32_t* dirty_ = nullptr;  // edges that were cut: slots times 2, plus 1 for a test against the edge above
    std::uint32_t* hints_ = nullptr;  // for every point: a slot whose edge may end there
    event_queue queue_;
    start_order starts_{a_, queue_, mask_};
    std::uint32_t passed_ = 0, dirty_count_ = 0;
    std::uint32_t last_ended_ = no_number;  // the uppermost edge in the last point where edges ended
    bool unsure_ = false, late_ = false;
    bool unfinished_ = false;  // edges that were never removed
    bool close_ = false;       // a point lies within a cell of an edge that does not end in it
    bool rough_ = false;       // see `rough`, if anything is bent
    bool bent_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
