// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/offset/impl/cell_outlines.hpp>
#include <typemesh/offset/impl/collapse.hpp>
#include <typemesh/offset/impl/collapse_queue.hpp>
#include <typemesh/offset/impl/collapse_times.hpp>
#include <typemesh/offset/impl/flip_history.hpp>
#include <typemesh/offset/impl/kinetic_triangles.hpp>
#include <typemesh/offset/impl/moving_point.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The boundary of a region on its way inwards, every edge with speed 1: the wavefront of its straight skeleton.
///
///     +------+      shrink    an edge has lost its length: its neighbours become adjacent
///     |\    /|      split     a reflex corner has run into an edge: the boundary falls apart there
///     | \__/ |      pinch     two corners have met: the same, between two corners
///     +------+      close up  two edges have met along a line: the area between them has become a ridge
///
/// A kinetic triangulation finds the times of events and the neighbours. Rounding can make an event late or early by a
/// fraction of a cell, but never inconsistent. Nodes within a few cells of each other on a corner's way are one node,
/// so that nodes on the grid keep the order that they have on the way.
///
/// Cost   O(log n) per event and triangle around it; most corners keep few triangles. The number of events is linear in
///        the number of edges, except for flips, which are few for outlines of glyphs
/// From   O. Aichholzer, F. Aurenhammer: Straight skeletons for general polygonal figures in the plane (1996); P.
///        Palfrader, M. Held, S. Huber: On computing straight skeletons by means of kinetic triangulations (2012)
class wavefront {
public:
    static constexpr std::uint32_t none = kinetic_triangles::none;

    kinetic_triangles mesh;
    cell_outlines outlines;
    buffer<swept_node> nodes;
    buffer<std::uint32_t> node_of;        ///< for each vertex: the last node on its way
    buffer<cell_outlines::ends> ends_of;  ///< for each segment
    buffer<std::uint32_t> live;           ///< for each component of the region: how many segments still bound it
    std::size_t flips_a_triangle = 64;    ///< if there are more, they are assumed never to end
    std::int64_t speck = 0;               ///< first_loss() ignores components that are swept completely sooner

    explicit wavefront(memory source) noexcept
        : mesh{source},
          outlines{source},
          nodes{source},
          node_of{source},
          ends_of{source},
          live{source},
          times_{mesh},
          queue_{source},
          history_{source},
          look_{buffer<std::uint32_t>{source}, buffer<std::uint32_t>{source}}
    {
    }

    /// Call once everything is set up. No event after `limit` will be needed.
    [[nodiscard]] bool start(std::int64_t limit) noexcept
    {
        times_.limit = limit;
        max_flips_ = flips_a_triangle * (mesh.triangles.size() + 16);
        if (!queue_.reserve(2 * mesh.triangles.size())) return false;
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) schedule(t);
        return !has_failed();
    }

    /// Moves on to a level. Events within `early` after the level happen now, so that a cap has no edges and gaps that
    /// are narrower than the grid. False if flips do not end, a hole shrinks to nothing, or memory runs out.
    [[nodiscard]] bool advance(std::int64_t level, std::int64_t early) noexcept
    {
        level_ = level;
        while (!queue_.empty() && queue_.first().time <= level + early) {
            const collapse next = queue_.pop();
            const auto& t = mesh.triangles[next.triangle];
            if (!t.alive || t.stamp != next.stamp) continue;
            times_.now = next.time;
            happen(next);
            if (has_failed() || flips_ > max_flips_ || hole_is_lost_) return false;
        }
        return true;
    }

    /// The node at the level for the current position of a vertex.
    [[nodiscard]] std::uint32_t node_at_level(std::uint32_t v, std::uint32_t a, std::uint32_t b) noexcept
    {
        const moving_point& moves = mesh.vertices[v].moves;
        const fixed_vector place = moves.place(moves.since > level_ ? moves.since : level_);
        return node_at(place, level_, {node_of[v], a, b});
    }

    [[nodiscard]] bool has_failed() const noexcept { return failed_ || outlines.failed; }
    /// The time at which the first component that is no speck was swept completely. If all components were swept and
    /// are specks, the time of the last one; otherwise negative.
    [[nodiscard]] std::int64_t first_loss() const noexcept
    {
        return first_loss_ < 0 && lost_ == live.size() ? last_loss_ : first_loss_;
    }
    /// The number of components that have been swept completely.
    [[nodiscard]] std::uint32_t lost() const noexcept { return lost_; }
    [[nodiscard]] std::size_t events() const noexcept { return events_; }
    [[nodiscard]] std::size_t schedules() const noexcept { return schedules_; }

private:
    /// The node in `known` that is nearest to a place, if it is within 2 cells; otherwise a new node.
    std::uint32_t node_at(fixed_vector place, std::initializer_list<std::uint32_t> known) noexcept
    {
        return node_at(place, times_.now < level_ ? times_.now : level_, known);
    }
    std::uint32_t node_at(fixed_vector place, std::int64_t time, std::initializer_list<std::uint32_t> known) noexcept
    {
        constexpr std::int64_t beyond = 5;  // squared
        const grid_point at = nearest_cell(place);
        const auto distance = static_cast<float>(static_cast<double>(time) * 0x1p-32);
        std::uint32_t best = none;
        std::int64_t least = beyond;
        for (const std::uint32_t node : known) {
            if (node == none) continue;
            const std::int64_t d = squared_distance(nodes[node].at, at);
            const float later = distance - nodes[node].distance;
            if (d >= least || later > 1.0f || later < -1.0f) continue;
            least = d;
            best = node;
        }
        if (best != none) return best;
        failed_ |= !nodes.push_back({at, distance});
        return static_cast<std::uint32_t>(nodes.size() - 1);
    }

    /// The last nodes of the corners at the two ends of a segment.
    [[nodiscard]] std::uint32_t last_node(std::uint32_t s) const noexcept { return node_of[mesh.segments[s].from]; }
    [[nodiscard]] std::uint32_t next_node(std::uint32_t s) const noexcept { return node_of[mesh.segments[s].to]; }

    /// Schedules the next collapse. A collapse in which no length vanishes happens at `calm` at the earliest.
    void schedule(std::uint32_t t, std::int64_t calm = 0) noexcept
    {
        ++mesh.triangles[t].stamp;
        ++schedules_;
        collapse next;
        if (times_.find(t, next, calm)) failed_ |= !queue_.push(next);
    }

    void happen(const collapse& c) noexcept
    {
        ++events_;
        const std::uint32_t h = 3 * c.triangle + c.k;
        if (c.what == collapse::kind::shrink) return shrink(h);
        if (c.what == collapse::kind::close_up) return close_up(h);
        if (const std::uint32_t met = short_diagonal(c.triangle); met != none) return pinch(met);
        if (c.what == collapse::kind::meet) return meet(h);
        flip(longest_edge(c.triangle));
    }

    // --- events

    /// The segment on half-edge h has lost its length.
    void shrink(std::uint32_t h) noexcept
    {
        const std::uint32_t s = kinetic_triangles::segment_in(mesh.link(h));
        const std::uint32_t u = mesh.segments[s].from, v = mesh.segments[s].to;
        if (u == v) {
            hole_is_lost_ = true;
            return;
        }
        const fixed_vector at = meeting_place(u, v);
        const std::uint32_t before = mesh.vertices[u].before, after = mesh.vertices[v].after;
        const std::uint32_t node = node_at(at, {node_of[u], node_of[v], last_node(before), next_node(after)});
        if (failed_) return;
        outlines.close(ends_of[s], node);
        lose(s);
        outlines.at_tail(ends_of[before], node);
        outlines.at_head(ends_of[after], node);
        make_adjacent(h, before, after, at, node);
    }

    /// The place where the corners u and v have met. If this is found late, both are beyond it, the faster one farther.
    [[nodiscard]] fixed_vector meeting_place(std::uint32_t u, std::uint32_t v) const noexcept
    {
        const moving_point &a = mesh.vertices[u].moves, &b = mesh.vertices[v].moves;
        if (a.instant()) return times_.place(v);
        if (b.instant()) return times_.place(u);
        const int128 a_speed = dot(a.speed.of, a.speed.of), b_speed = dot(b.speed.of, b.speed.of);
        if (a_speed > b_speed) return times_.place(v);
        return a_speed < b_speed ? times_.place(u) : middle(times_.place(u), times_.place(v));
    }

    /// The area between the two segments of an instant corner has no width. The shorter segment ends, unless another
    /// corner lies in between: that corner splits it.
    ///
    ///     ------------w-------------.
    ///     u ----------------------- F
    void close_up(std::uint32_t h) noexcept
    {
        const auto& found = mesh.segments[kinetic_triangles::segment_in(mesh.link(h))];
        const std::uint32_t tip = mesh.vertices[found.to].moves.instant() ? found.to : found.from;
        const auto &in = mesh.segments[mesh.vertices[tip].before], &out = mesh.segments[mesh.vertices[tip].after];
        const std::uint32_t at = squared_length(in) <= squared_length(out) ? in.half : out.half;
        const std::uint32_t w = mesh.apex(at);
        const span_along along = measure(at);
        const bool between = along.from < along.apex && along.apex < along.to && !mesh.vertices[w].moves.instant();
        if (between && has_diagonals_only(at))
            split(at);
        else
            shrink(at);
    }
    [[nodiscard]] int128 squared_length(const kinetic_triangles::segment& s) const noexcept
    {
        const fixed_vector all = times_.place(s.to) - times_.place(s.from);
        return dot(all, all);
    }
    /// Whether the triangle's only segment is the one on half-edge h.
    [[nodiscard]] bool has_diagonals_only(std::uint32_t h) const noexcept
    {
        return !kinetic_triangles::is_segment(mesh.link(kinetic_triangles::next(h))) &&
               !kinetic_triangles::is_segment(mesh.link(kinetic_triangles::previous(h)));
    }

    /// The corners of a triangle along the line of the segment on half-edge h, in 2^-46 cells.
    struct span_along {
        int128 from, to, apex;
    };
    [[nodiscard]] span_along measure(std::uint32_t h) const noexcept
    {
        const fixed_vector along = line_beside(h).along;
        return {dot(along, times_.place(mesh.origin(h))),
                dot(along, times_.place(mesh.origin(kinetic_triangles::next(h)))),
                dot(along, times_.place(mesh.apex(h)))};
    }

    /// The apex of the triangle has reached the line of the segment on half-edge h. If it lies within the segment and
    /// can split it, it does. Otherwise another corner is in the way, and a flip brings it in.
    void meet(std::uint32_t h) noexcept
    {
        const span_along along = measure(h);
        const bool splits = can_split(mesh.apex(h), line_beside(h));
        if (along.apex < along.from - slip_along || (!splits && along.apex - along.from <= along.to - along.apex))
            flip(kinetic_triangles::next(h));
        else if (along.apex > along.to + slip_along || !splits)
            flip(kinetic_triangles::previous(h));
        else
            split(h);
    }

    /// Whether a corner can split a segment on `line`: it is reflex, or one of its edges lies on the line, nearly
    /// parallel.
    [[nodiscard]] bool can_split(std::uint32_t w, const moving_line& line) const noexcept
    {
        const moving_line &before = line_before(w), &after = line_after(w);
        return !turns_left(before, after) || is_opposite(before, line) || is_opposite(after, line);
    }
    [[nodiscard]] static bool is_opposite(const moving_line& a, const moving_line& b) noexcept
    {
        constexpr int128 one = static_cast<int128>(unit_one) * unit_one;
        return dot(a.along, b.along) < (one >> 20) - one;
    }
    /// The line of the segment on half-edge h.
    [[nodiscard]] const moving_line& line_beside(std::uint32_t h) const noexcept
    {
        return mesh.lines[mesh.segments[kinetic_triangles::segment_in(mesh.link(h))].line];
    }
    [[nodiscard]] const moving_line& line_before(std::uint32_t v) const noexcept
    {
        return mesh.lines[mesh.segments[mesh.vertices[v].before].line];
    }
    [[nodiscard]] const moving_line& line_after(std::uint32_t v) const noexcept
    {
        return mesh.lines[mesh.segments[mesh.vertices[v].after].line];
    }

    /// The apex w of the triangle lies on the segment s of half-edge h.
    ///
    ///       b \   / a             b \     / a        s keeps the left piece, `right` is new. The triangle goes. Now s
    ///           w          >         + +            and b are adjacent, and so are a and `right`.
    ///     ------s------>        --s--+ +-right->
    void split(std::uint32_t h) noexcept
    {
        const std::uint32_t s = kinetic_triangles::segment_in(mesh.link(h)), w = mesh.apex(h);
        const std::uint32_t a = mesh.vertices[w].before, b = mesh.vertices[w].after;
        const fixed_vector at = times_.place(w);
        const std::uint32_t v = mesh.segments[s].to;
        const std::uint32_t node = node_at(at, {node_of[w], last_node(s), next_node(s), last_node(a), next_node(b)});
        const auto right = static_cast<std::uint32_t>(mesh.segments.size());
        const kinetic_triangles::segment copy = mesh.segments[s];
        if (failed_ || !mesh.segments.push_back(copy) || !ends_of.push_back(outlines.split(ends_of[s], node))) {
            failed_ = true;
            return;
        }
        outlines.at_tail(ends_of[a], node);
        outlines.at_head(ends_of[b], node);
        ++live[copy.component];
        mesh.vertices[v].before = right;
        const std::uint32_t across_left = mesh.link(kinetic_triangles::previous(h)),
                            across_right = mesh.link(kinetic_triangles::next(h));
        mesh.triangles[h / 3].alive = false;
        ++mesh.triangles[h / 3].stamp;
        mesh.connect(across_left, kinetic_triangles::to_segment(s));
        mesh.connect(across_right, kinetic_triangles::to_segment(right));
        add_corner(s, b, at, node);
        add_corner(a, right, at, node);
    }

    /// The two ends of the diagonal under half-edge h have met: on each side of it the boundary continues separately.
    ///
    ///     ap \   / bq           ap \___/ bq
    ///         p-q         >
    ///     bp /   \ aq           bp /---\ aq
    void pinch(std::uint32_t h) noexcept
    {
        const std::uint32_t g = mesh.link(h), p = mesh.origin(h), q = mesh.origin(g);
        const auto first = mesh.vertices[p], second = mesh.vertices[q];
        const fixed_vector at = middle(times_.place(p), times_.place(q));
        const std::uint32_t node = node_at(at, {node_of[p], node_of[q], last_node(first.before), next_node(first.after),
                                                last_node(second.before), next_node(second.after)});
        if (failed_) return;
        for (const auto& one : {first, second}) {
            outlines.at_tail(ends_of[one.before], node);
            outlines.at_head(ends_of[one.after], node);
        }
        make_adjacent(h, first.before, second.after, at, node);
        make_adjacent(g, second.before, first.after, at, node);
    }
    [[nodiscard]] std::uint32_t short_diagonal(std::uint32_t t) const noexcept
    {
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            if (kinetic_triangles::is_segment(mesh.link(h))) continue;
            const fixed_vector all = along_edge(h);
            if (-slip < all.x && all.x < slip && -slip < all.y && all.y < slip) return h;
        }
        return none;
    }
    [[nodiscard]] fixed_vector along_edge(std::uint32_t h) const noexcept
    {
        return times_.place(mesh.origin(kinetic_triangles::next(h))) - times_.place(mesh.origin(h));
    }
    [[nodiscard]] int128 squared_length(std::uint32_t h) const noexcept
    {
        const fixed_vector all = along_edge(h);
        return dot(all, all);
    }
    [[nodiscard]] std::uint32_t longest_edge(std::uint32_t t) const noexcept
    {
        std::uint32_t best = 3 * t;
        int128 most = squared_length(best);
        for (std::uint32_t h = 3 * t + 1; h < 3 * t + 3; ++h) {
            const int128 here = squared_length(h);
            if (here <= most) continue;
            most = here;
            best = h;
        }
        return best;
    }

    /// Replaces the diagonal under half-edge h of a flat triangle.
    void flip(std::uint32_t h) noexcept
    {
        ++flips_;
        const std::uint32_t first = h / 3;
        if (history_.comes_back(mesh.apex(h), mesh.apex(mesh.link(h)), collapse::tick(times_.now))) {
            const std::uint32_t longest = longest_beyond(h);
            if (kinetic_triangles::is_segment(mesh.link(longest))) {
                split(longest);
                if (!failed_ && mesh.triangles[first].alive) schedule(first);
                return;
            }
            h = longest;
        }
        const std::uint32_t t = h / 3, r = mesh.link(h) / 3;
        mesh.flip(h);
        std::int64_t calm = 0;
        failed_ |= !history_.note(t, r, times_.now, calm);
        schedule(t, calm);
        schedule(r, calm);
        if (first != t && first != r) schedule(first);
    }
    /// Walks on through flat triangles beyond h, always across the longest edge. Returns the edge beyond which no flat
    /// triangle has a longer one, or a segment that can be split.
    [[nodiscard]] std::uint32_t longest_beyond(std::uint32_t h) const noexcept
    {
        for (;;) {
            const std::uint32_t beyond = mesh.link(h), longest = longest_edge(beyond / 3);
            if (squared_length(longest) <= squared_length(beyond) || !is_flat(longest)) return h;
            if (kinetic_triangles::is_segment(mesh.link(longest)))
                return has_diagonals_only(longest) && can_split(mesh.apex(longest), line_beside(longest)) ? longest : h;
            h = longest;
        }
    }
    /// Whether a triangle's height over its half-edge h is below the slip.
    [[nodiscard]] bool is_flat(std::uint32_t h) const noexcept
    {
        const fixed_vector along = along_edge(h), up = times_.place(mesh.apex(h)) - times_.place(mesh.origin(h));
        const int128 area = cross(along, up);
        return ((area < 0 ? -area : area) >> slip_bits) <=
               (along.x < 0 ? -along.x : along.x) + (along.y < 0 ? -along.y : along.y);
    }

    // --- consequences of events

    /// Removes the triangle of half-edge h, which has no length: `before` and `after` become adjacent at a node that
    /// both already have. If no other segments are left, both end on the line to the triangle's apex.
    void make_adjacent(std::uint32_t h, std::uint32_t before, std::uint32_t after, fixed_vector at,
                       std::uint32_t node) noexcept
    {
        const std::uint32_t w = mesh.apex(h);
        if (mesh.close(h)) return add_corner(before, after, at, node);
        const std::uint32_t end = node_at(times_.place(w), {node_of[w], node});
        if (failed_) return;
        for (const std::uint32_t s : {before, after}) {
            outlines.close(ends_of[s], end);
            lose(s);
        }
    }

    void add_corner(std::uint32_t before, std::uint32_t after, fixed_vector at, std::uint32_t node) noexcept
    {
        const auto v = static_cast<std::uint32_t>(mesh.vertices.size());
        const crossing_speed speed =
            speed_of(mesh.lines[mesh.segments[before].line], mesh.lines[mesh.segments[after].line], true);
        if (failed_ || !mesh.vertices.push_back({{at, times_.now, speed}, before, after}) || !node_of.push_back(node)) {
            failed_ = true;
            return;
        }
        const std::uint32_t around = mesh.set_corner(before, v, after);
        pass(mesh.segments[before].from, at, node);
        pass(mesh.segments[after].to, at, node);
        if (around > max_around) relieve(after);
        mesh.around(after, [&](std::uint32_t h) noexcept { schedule(h / 3); });
    }

    /// A corner with thousands of triangles that consumes a bow edge by edge would reschedule all of them each time. So
    /// it gives them away while it can; the edges of the bow then have O(log n) triangles each.
    void relieve(std::uint32_t after) noexcept
    {
        failed_ |= !mesh.thin_out(
            after, max_around / 2, [&](std::uint32_t h) noexcept { return is_convex(h); },
            [&](std::uint32_t t) noexcept { schedule(t); }, look_);
    }
    /// Whether the triangle of half-edge h and the next one around its origin make a convex quadrilateral.
    [[nodiscard]] bool is_convex(std::uint32_t h) const noexcept
    {
        const std::uint32_t next = mesh.link(kinetic_triangles::previous(h));
        const std::uint32_t a = mesh.origin(kinetic_triangles::next(h)), b = mesh.apex(h), c = mesh.apex(next);
        const std::uint32_t v = mesh.origin(h);
        for (const std::uint32_t corner : {a, b, c, v})
            if (mesh.vertices[corner].moves.instant()) return false;
        const fixed_vector at = times_.place(a), all = times_.place(c) - at;
        return cross(times_.place(b) - at, all) > 0 && cross(all, times_.place(v) - at) > 0;
    }

    /// If a corner lies where another one is born, it passes through the same node.
    void pass(std::uint32_t v, fixed_vector at, std::uint32_t node) noexcept
    {
        constexpr std::int64_t most = 2 * place_one;
        if (node_of[v] == node || mesh.vertices[v].moves.instant()) return;
        const fixed_vector gap = times_.place(v) - at;
        if (gap.x > most || gap.x < -most || gap.y > most || gap.y < -most) return;
        outlines.at_tail(ends_of[mesh.vertices[v].before], node);
        outlines.at_head(ends_of[mesh.vertices[v].after], node);
        node_of[v] = node;
    }

    void lose(std::uint32_t s) noexcept
    {
        mesh.segments[s].alive = false;
        if (--live[mesh.segments[s].component] != 0) return;
        ++lost_;
        last_loss_ = times_.now;
        if (first_loss_ < 0 && times_.now >= speck) first_loss_ = times_.now;
    }

    static constexpr std::uint32_t max_around = 64;

    collapse_times times_;
    collapse_queue queue_;
    flip_history history_;
    kinetic_triangles::rounds look_;
    std::int64_t level_ = 0;
    std::int64_t first_loss_ = -1, last_loss_ = -1;
    std::uint32_t lost_ = 0;
    std::size_t max_flips_ = 0, flips_ = 0, events_ = 0, schedules_ = 0;
    bool failed_ = false;
    bool hole_is_lost_ = false;  ///< only rounding can do that, since holes grow; a point has no place in the topology
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
