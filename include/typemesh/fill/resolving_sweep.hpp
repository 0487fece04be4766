// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/sweep_status.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/crossing.hpp>
#include <typemesh/fill/event_queue.hpp>
#include <typemesh/fill/ray.hpp>
#include <typemesh/fill/swept_edge.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>

namespace typemesh::detail {

/// One walk from left to right over an arrangement that cuts stretches where they cross, touch or overlap.
///
/// The sweep line crosses edges, ordered from below to above. Two that become neighbours are tested once: the one that
/// ends first must end on its own side of the other. Where it does not, both are cut where they cross, at the nearest
/// grid point x, and bent through it:
///
///     a ---.__                     a ---.__      . d      The right parts wait in a queue until the sweep comes to x.
///     c ____  '--.__       ->      c ______'--x-'         An end that lies on the other edge cuts it without bending.
///           '---.___'-- b                      '--- b
///                    ' d
///
/// In a point the edges that end there lie next to each other. Those that start there are put in order by their angle;
/// those that lie upon each other are joined, the longer one cut at the end of the shorter one.
///
/// Afterwards no two stretches have more than an end in common, the winding numbers below them are right, and `next`
/// joins those that bound the filled area, as boundary_walk tells; or `again` asks for one more walk over what there is
/// now. In a walk that ends so any step may have been wrong: it cut in wrong places, missed some, and nothing worse,
/// for whatever is cut, the stretches stay closed contours.
///
/// Why what a walk believes is true. Bending moves an edge by less than a cell, and what the sweep has passed already
/// may then lie on its other side. So every point p is held against the edges right below and right above it when the
/// sweep is there (pass_by), and the walk is believed when
///
///     1  the points came in ascending order, each once, and every edge ended where the sweep took it out;
///     2  p lay strictly between those two edges, and does so still when they have been bent;
///     3  no two edges that ended next to each other had begun together: all that end in a point lie side by side in
///        the status, so to remember the one before is enough.
///
/// Let X be the first place where final stretches meet otherwise than in common ends; left of X the status is in order.
/// If X is no end of a stretch, two neighbours e below f cross there (they do not begin together in one direction: till
/// one of them ends nothing can come between them, and ending in the same place breaks 3, in different places 2).
/// Behind X nothing can be put between them, for what is above e is above f; so the one that ends first does so on the
/// wrong side of the other, its neighbour, against 2. If X is an end p, an edge that goes through it lies next to those
/// that end there, or where others start, against 2. Where nothing meets, the winding numbers add up.
///
/// To see 2 without walking again: an edge ab is bent through x only if x is within one cell of its line, that is
/// |orientation(a, b, x)| <= |dx| + |dy|, so all of ax is; and only if every point it was held against was farther
/// away than that (else it is `fixed`), and once. So none of them changes sides; and a point behind x cannot have been
/// held against ab yet, or x comes out of order (`late_`) or a second time.
///
/// Why walks would end even without snap rounding: cutting an edge in a grid point of its box leaves two whose widths
/// and heights add up to its own. So the sum of the widths and heights of all stretches never grows, every stretch has
/// at least 1 of it, and every walk but the last adds a stretch.
///
/// From  Bentley & Ottmann, Algorithms for reporting and counting geometric intersections (1979); Hobby, Practical
///       segment intersection with finite precision output (1999)
class resolving_sweep {
public:
    bool again = false;     ///< something may not add up: one more walk is needed
    bool astray = false;    ///< something was bent away from where it belongs: only snap rounding helps
    bool full = false;      ///< ended early, for there was no room for more stretches
    bool touching = false;  ///< the boundary comes through some point more than once

    explicit resolving_sweep(arrangement& a, fill_rule rule) noexcept : a_{a}, rule_{rule} {}

    /// False when there is no memory; then the arrangement is of no use any more.
    [[nodiscard]] bool run(workspace& space) noexcept
    {
        workspace::scope scratch{space};
        const std::uint32_t room = a_.capacity;
        edges_ = scratch.take<swept_edge>(std::size_t{room} + 1);
        ends_ = scratch.take<std::uint32_t>(std::size_t{room} + 1);
        dirty_ = scratch.take<std::uint32_t>(std::size_t{room} + 1);
        rays_ = scratch.take<ray>(std::size_t{room} + 1);
        hints_ = scratch.take<std::uint32_t>(std::size_t{a_.point_count} + 1);
        if (edges_ == nullptr || ends_ == nullptr || dirty_ == nullptr || rays_ == nullptr || hints_ == nullptr ||
            !status_.open(scratch, room) || !queue_.open(scratch, room))
            return false;
        constexpr std::int32_t beyond = (std::numeric_limits<std::int32_t>::max)();
        edges_[0] = {};
        edges_[0].from = edges_[0].to = {beyond, beyond};
        for (std::uint32_t i = 0; i < a_.point_count; ++i) hints_[i] = 0;
        passed_ = 0;
        sweep();
        const bool out_of_order = full || late_ || status_.above(0) != 0;
        again = unsure_ || out_of_order || astray;
        if (out_of_order) return a_.put_in_order(space);
        take_points();
        if (again) a_.list();
        return true;
    }

private:
    void take_points() noexcept
    {
        grid_point* const swapped = a_.points;
        a_.points = a_.spare;
        a_.spare = swapped;
        a_.point_count = passed_;
    }

    void sweep() noexcept
    {
        std::uint32_t next = 0;
        std::uint64_t last = 0;  // below the place of every point of the grid
        while (!full) {
            std::uint64_t place = ~std::uint64_t{0};
            if (next < a_.point_count) place = sweep_place(a_.points[next]);
            std::uint32_t starting = no_number, slot = 0;
            if (queue_.empty() || place <= queue_.top().place) {
                if (next == a_.point_count) return;
                starting = a_.first[next];
                slot = hints_[next++];
            } else {
                place = queue_.top().place;
            }
            const grid_point p = point_at(place);
            if (!ends_in(slot, p)) slot = 0;
            for (; !queue_.empty() && queue_.top().place == place; queue_.pop()) {
                const event e = queue_.top();
                if (e.stretch != no_number) {
                    a_.stretches[e.stretch].next = starting;
                    starting = e.stretch;
                }
                if (ends_in(e.slot, p)) slot = e.slot;
            }
            const bool repeated = place == last;
            if (!repeated) {
                if (passed_ == a_.capacity) {
                    full = true;
                    return;
                }
                late_ |= place < last;
                a_.spare[passed_++] = p;
                last = place;
            }
            if (slot != 0 && starting != no_number && a_.stretches[starting].next == no_number && !repeated &&
                !(edges_[status_.below(slot)].to == p) && !(edges_[status_.above(slot)].to == p))
                pass(slot, starting, p);
            else
                meet(slot, starting, p, repeated);
            while (dirty_count_ != 0) {
                const std::uint32_t changed = dirty_[--dirty_count_];
                test(status_.below(changed), changed);
                test(changed, status_.above(changed));
            }
        }
    }

    [[nodiscard]] bool ends_in(std::uint32_t slot, grid_point p) const noexcept
    {
        return edges_[slot].to == p && edges_[slot].stretch != no_number;
    }

    /// One edge ends, one starts: the usual case.
    void pass(std::uint32_t slot, std::uint32_t starting, grid_point p) noexcept
    {
        swept_edge& e = edges_[slot];
        const std::uint32_t ending = e.stretch;
        stretch& s = a_.stretches[starting];
        const std::uint32_t under = status_.below(slot), over = status_.above(slot);
        pass_by(under, over, p);
        s.below = a_.stretches[ending].below;
        unsure_ |= s.turn != a_.stretches[ending].turn;
        finish(ending);
        begin(slot, starting, p);
        const bool up = is_filled(rule_, e.above), down = is_filled(rule_, s.below);
        if (up && !down) a_.stretches[ending].next = starting;
        if (down && !up) s.next = ending;
        test(under, slot);
        test(slot, over);
    }

    /// Holds p against the edges right below and right above it.
    void pass_by(std::uint32_t under, std::uint32_t over, grid_point p) noexcept
    {
        const auto hold = [&](swept_edge& e, std::int64_t side) noexcept {
            unsure_ |= side <= 0;
            e.fixed |= side <= e.reach();
        };
        if (under != 0) hold(edges_[under], orientation(edges_[under].from, edges_[under].to, p));
        if (over != 0) hold(edges_[over], -orientation(edges_[over].from, edges_[over].to, p));
    }

    /// Any number of edges ends, any number starts.
    void meet(std::uint32_t slot, std::uint32_t starting, grid_point p, bool repeated) noexcept
    {
        // Those that end lie next to each other. One that goes through p is cut; in a point that comes once more, those
        // that started there the first time start again.
        unsure_ |= repeated;
        grid_point began = p;  // the edge that ended last
        bool searched = false;
        std::uint32_t under = 0, low = 0;
        const auto is_here = [&](std::uint32_t s) noexcept {
            return s != 0 && (edges_[s].to == p || (repeated && edges_[s].from == p));
        };
        if (slot != 0) {
            low = slot;
            while (is_here(status_.below(low))) low = status_.below(low);
            under = status_.below(low);
        } else {
            under = find(p);
            low = status_.above(under);
            searched = true;
        }
        std::uint32_t ending_count = 0;
        for (std::uint32_t s = low, over; s != 0; s = over) {
            over = status_.above(s);
            swept_edge& e = edges_[s];
            if (is_here(s)) {
                if (!(e.to == p)) {
                    a_.stretches[e.stretch].next = starting;
                    starting = e.stretch;
                } else {
                    unsure_ |= e.from == began;
                    began = e.from;
                    ends_[ending_count++] = e.stretch;
                }
            } else if (slot == 0 && orientation(e.from, e.to, p) == 0 && is_between(e.from, p, e.to)) {
                const std::uint32_t rest = a_.count;
                if (!split(s, p)) return;
                unsure_ |= e.from == began;
                began = e.from;
                a_.stretches[rest].next = starting;
                starting = rest;
                ends_[ending_count++] = e.stretch;
            } else {
                break;
            }
            e.stretch = no_number;
            e.from = {0, static_cast<std::int32_t>(free_slot_)};
            free_slot_ = s;
            status_.erase(s);
        }
        for (std::uint32_t i = 0; i < ending_count; ++i) finish(ends_[i]);

        const std::uint32_t starting_count = order_rays(starting, p);
        if (full) return;
        if (starting_count != 0 && !searched) under = find(p);
        std::int32_t winding = edges_[under].above;
        std::uint32_t last = under;
        for (std::uint32_t i = 0; i < starting_count; ++i) {
            stretch& s = a_.stretches[rays_[i].stretch];
            s.below = winding;
            winding += s.turn;
            std::uint32_t fresh = free_slot_;
            if (fresh == 0)
                fresh = ++slot_count_;
            else
                free_slot_ = static_cast<std::uint32_t>(edges_[fresh].from.y);
            begin(fresh, rays_[i].stretch, p);
            status_.insert_above(last, fresh);
            if (i != 0) test(last, fresh);  // they do not cross, but may come near each other's ends
            last = fresh;
        }
        const std::uint32_t over = status_.above(last);
        pass_by(under, over, p);
        if (winding != (over != 0 ? a_.stretches[edges_[over].stretch].below : 0)) unsure_ = true;
        join(starting_count, ending_count);
        test(under, status_.above(under));
        if (last != under) test(last, over);
    }

    /// Bent edges cross a little beside where the contours do: takes the contours' crossing if both edges can be cut
    /// there. So bends do not add up along an edge with many crossings.
    void lead_home(std::uint32_t low, std::uint32_t high, grid_point& x) const noexcept
    {
        const auto l = a_.home(a_.stretches[edges_[low].stretch]), h = a_.home(a_.stretches[edges_[high].stretch]);
        grid_point better;
        if (crossing_of(l.from, l.to, h.from, h.to, better) && edges_[low].holds(better) && edges_[high].holds(better))
            x = better;
    }

    /// The last edge below p.
    [[nodiscard]] std::uint32_t find(grid_point p) noexcept
    {
        return status_.last_below(
            [&](std::uint32_t s) noexcept { return s != 0 && orientation(edges_[s].from, edges_[s].to, p) > 0; });
    }

    [[nodiscard]] static bool is_between(grid_point a, grid_point p, grid_point b) noexcept
    {
        return sweep_place(a) < sweep_place(p) && sweep_place(p) < sweep_place(b);
    }

    void begin(std::uint32_t slot, std::uint32_t starting, grid_point p) noexcept
    {
        stretch& s = a_.stretches[starting];
        s.start = passed_ - 1;
        edges_[slot] = swept_edge{p, s.to, starting, s.below + s.turn};
        if (s.end != no_number) hints_[s.end] = slot;
    }

    void finish(std::uint32_t ending) noexcept
    {
        stretch& s = a_.stretches[ending];
        s.end = passed_ - 1;
        if (late_ && sweep_place(s.to) < sweep_place(s.from)) s.flip();
    }

    /// The stretches that start in p as rays from below to above, each direction once; how many.
    [[nodiscard]] std::uint32_t order_rays(std::uint32_t starting, grid_point p) noexcept
    {
        std::uint32_t count = 0;
        for (std::uint32_t i = starting; i != no_number; i = a_.stretches[i].next) {
            const grid_point to = a_.stretches[i].to;
            rays_[count++] = {to.x - p.x, to.y - p.y, i};
        }
        if (count < 2) return count;
        sort_rays(rays_, count);
        std::uint32_t kept = 0;
        for (std::uint32_t i = 1; i < count && !full; ++i) {
            if (rays_[kept].cross(rays_[i]) != 0)
                rays_[++kept] = rays_[i];
            else
                rays_[kept].stretch = joined(rays_[kept].stretch, rays_[i].stretch);
        }
        count = kept + 1;
        kept = 0;
        for (std::uint32_t i = 0; i < count; ++i)
            if (a_.stretches[rays_[i].stretch].turn != 0) rays_[kept++] = rays_[i];
        return kept;
    }

    /// Two stretches that start in one point and in one direction: what they share becomes one of them, which is
    /// returned, the rest of the longer one the other.
    [[nodiscard]] std::uint32_t joined(std::uint32_t i, std::uint32_t k) noexcept
    {
        if (sweep_place(a_.stretches[k].to) < sweep_place(a_.stretches[i].to)) {
            const std::uint32_t swapped = i;
            i = k;
            k = swapped;
        }
        stretch& shorter = a_.stretches[i];
        stretch& longer = a_.stretches[k];
        const bool equal = shorter.to == longer.to;
        const float t = equal ? longer.source.t1 : longer.t_at(shorter.to);
        if (longer.source.curve < shorter.source.curve) {
            shorter.source = {longer.source.curve, longer.source.t0, t};
            shorter.origin = longer.origin;
            shorter.target = longer.target;
            shorter.bent |= longer.bent;
        }
        shorter.turn += longer.turn;
        if (equal) {
            longer.turn = 0;
        } else if (queue_.room() == 0) {
            shorter.turn -= longer.turn;
            full = true;
        } else {
            longer.from = shorter.to;
            longer.source.t0 = t;
            queue_.push({sweep_place(longer.from), k, 0});
        }
        return i;
    }

    /// Links the boundary through a point: next[] of a stretch that comes in is the one that goes out with the interior
    /// between them. Round the point, counter-clockwise, the interior follows every stretch that goes out.
    void join(std::uint32_t starting_count, std::uint32_t ending_count) noexcept
    {
        std::uint32_t first = no_number, last = no_number, out_count = 0;
        bool first_goes_out = false, last_goes_out = false;
        const auto take = [&](std::uint32_t i, bool starts) noexcept {
            const int interior = a_.stretches[i].interior(rule_);
            if (interior == 0) return;
            const bool goes_out = (interior > 0) == starts;
            if (last_goes_out) a_.stretches[i].next = last;
            if (first == no_number) {
                first = i;
                first_goes_out = goes_out;
            }
            last = i;
            last_goes_out = goes_out;
            out_count += goes_out;
        };
        for (std::uint32_t i = 0; i < starting_count; ++i) a_.stretches[rays_[i].stretch].next = no_number;
        for (std::uint32_t i = 0; i < starting_count; ++i) take(rays_[i].stretch, true);
        for (std::uint32_t i = ending_count; i-- != 0;) take(ends_[i], false);
        if (last_goes_out && !first_goes_out) a_.stretches[first].next = last;
        touching |= out_count > 1;
    }

    /// Two neighbours: cuts them where they meet before either ends.
    void test(std::uint32_t low, std::uint32_t high) noexcept
    {
        if (low == 0 || high == 0) return;
        const swept_edge& l = edges_[low];
        const swept_edge& h = edges_[high];
        const bool low_first = lexicographic_less(l.to, h.to);
        const swept_edge& longer = low_first ? h : l;
        const std::int64_t turn = orientation(longer.from, longer.to, low_first ? l.to : h.to);
        const std::int64_t side = low_first ? -turn : turn;
        if (side <= 0) part(low, high, low_first, side == 0);
    }

    /// Two neighbours, one of which ends on the wrong side of the other, or on it.
    void part(std::uint32_t low, std::uint32_t high, bool low_first, bool on_it) noexcept
    {
        const swept_edge& l = edges_[low];
        const swept_edge& h = edges_[high];
        if (l.to == h.to) return;
        if (on_it) {
            const swept_edge& longer = low_first ? h : l;
            const grid_point end = low_first ? l.to : h.to;
            if (is_between(longer.from, end, longer.to))
                (void)cut(low_first ? high : low, end);
            else
                unsure_ = true;
            return;
        }
        grid_point x;
        if (!crossing_of(l.from, l.to, h.from, h.to, x)) {
            unsure_ = true;
            return;
        }
        if (a_.stretches[l.stretch].bent || a_.stretches[h.stretch].bent) lead_home(low, high, x);
        if (cut(low, x)) (void)cut(high, x);
    }

    /// Cuts an edge in a grid point of its box and lets the right part wait; false when there is no room.
    ///
    /// A part of a nearly vertical edge may be vertical and run from above to below. The right part is turned round
    /// then and waits where the edge ended; the left part is turned round when the sweep finishes it, which it does at
    /// once.
    [[nodiscard]] bool cut(std::uint32_t slot, grid_point x) noexcept
    {
        if (edges_[slot].to == x || edges_[slot].from == x) {
            unsure_ |= edges_[slot].from == x;
            if (queue_.room() == 0)
                full = true;
            else
                queue_.push({sweep_place(x), no_number, slot});
            return !full;
        }
        if (!split(slot, x)) return false;
        const std::uint32_t rest = a_.count - 1;
        stretch& r = a_.stretches[rest];
        if (sweep_place(r.to) < sweep_place(x)) {
            r.flip();
            unsure_ = true;
            queue_.push({sweep_place(r.from), rest, 0});
            queue_.push({sweep_place(x), no_number, slot});
        } else {
            queue_.push({sweep_place(x), rest, slot});
        }
        dirty_[dirty_count_++] = slot;
        return true;
    }

    /// The edge in a slot ends in x from now on; its rest is the last stretch of all. False when there is no room.
    [[nodiscard]] bool split(std::uint32_t slot, grid_point x) noexcept
    {
        if (a_.count == a_.capacity || queue_.room() < 2) {
            full = true;
            return false;
        }
        swept_edge& e = edges_[slot];
        stretch& s = a_.stretches[e.stretch];
        if (const std::int64_t side = orientation(e.from, e.to, x); side != 0) {
            const bool within = (side < 0 ? -side : side) <= e.reach();
            unsure_ |= e.fixed || !within;
            astray |= s.bent ? !a_.is_at_home(s, x) : !within;
            e.fixed = true;
            s.bent = 1;
        }
        const float t = s.t_at(x);
        a_.stretches[a_.count++] = {x,        s.to,      no_number, s.end, s.turn, 0, {s.source.curve, t, s.source.t1},
                                    s.origin, s.target, no_number, s.bent};
        s.to = x;
        s.end = no_number;
        s.source.t1 = t;
        e.to = x;
        return true;
    }

    arrangement& a_;
    fill_rule rule_;
    swept_edge* edges_ = nullptr;
    std::uint32_t* ends_ = nullptr;
    std::uint32_t* dirty_ = nullptr;
    ray* rays_ = nullptr;
    std::uint32_t* hints_ = nullptr;  // for every point: a slot whose edge ends there, perhaps
    sweep_status status_;
    event_queue queue_;
    std::uint32_t passed_ = 0;
    std::uint32_t dirty_count_ = 0;
    std::uint32_t slot_count_ = 0;
    std::uint32_t free_slot_ = 0;
    bool unsure_ = false;
    bool late_ = false;
};

}  // namespace typemesh::detail
