// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/offset/impl/moving_point.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The lines where two faces of a swept region meet, as a graph over its nodes. All memory comes from a scope.
///
///     +---------+       arcs      sides of triangles with another face on either side
///     | \     / |       ends      each arc that begins at the outline has an end of its own there
///     |   >--<  |       held      nodes at the last level, on the outline of the floor
///     | /     \ |
///     +---------+       Without the arcs at soft and reflex corners, what is left are the ridges.
class ridge_graph {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    struct arc {
        std::uint32_t a, b;         ///< nodes
        std::uint32_t left, right;  ///< triangles
        bool alive;
    };

    ridge_graph(const region& r, const swept_region& swept, workspace::scope& scratch) noexcept
        : region_{r}, swept_{swept}, scratch_{scratch}, own_{static_cast<std::uint32_t>(r.points().size())}
    {
    }

    /// Finds all arcs. False if out of memory.
    [[nodiscard]] bool build() noexcept
    {
        const std::size_t nodes = swept_.nodes.size(), halves = 3 * swept_.triangles.size();
        degree_ = scratch_.take<std::uint32_t>(nodes);
        first_ = scratch_.take<std::uint32_t>(nodes);
        held_ = scratch_.take<bool>(nodes);
        arcs_ = scratch_.take<arc>(halves / 2 + 1);
        next_ = scratch_.take<std::uint32_t>(halves + 2);
        todo_ = scratch_.take<std::uint32_t>(2 * halves);
        lone_ = scratch_.take<std::uint32_t>(nodes);
        if (degree_ == nullptr || first_ == nullptr || held_ == nullptr || arcs_ == nullptr || next_ == nullptr ||
            todo_ == nullptr || lone_ == nullptr)
            return false;
        for (std::size_t i = 0; i < nodes; ++i) {
            degree_[i] = 0;
            first_[i] = none;
            held_[i] = false;
        }
        const std::size_t last = swept_.levels.size() - 1;
        for (std::uint32_t i = swept_.at_level[last]; i < swept_.at_level[last + 1]; ++i)
            held_[swept_.edges_at[i].a] = held_[swept_.edges_at[i].b] = true;
        return find_arcs(nodes, halves);
    }

    /// Removes arcs from their open ends on, as long as they are no ridges: at the outline, where is_corner(point) says
    /// no; further in, where the two faces turn by less than the crease angle, or rise from the arc.
    ///
    ///     crease    the cosine of the angle, in 2^-30
    template <class IsCorner>
    void prune(std::int64_t crease, const IsCorner& is_corner) noexcept
    {
        // An arc waits at first, and again when either of its ends is open: at most three times.
        std::size_t waiting = 0;
        for (std::uint32_t i = count_; i-- != 0;) todo_[waiting++] = i;
        while (waiting != 0) {
            arc& one = arcs_[todo_[--waiting]];
            if (!one.alive) continue;
            const bool goes = is_spare(one, one.a, crease, is_corner) || is_spare(one, one.b, crease, is_corner);
            if (!goes) continue;
            remove(one);
            for (const std::uint32_t v : {one.a, one.b})
                if (is_free(v) && degree_[v] == 1) todo_[waiting++] = arc_at(v);
            note_lone(one);
        }
    }

    /// Calls put(node, begins) for the nodes of each chain of arcs: from one end or junction to the next, or once
    /// around and back to the first node. Then for single nodes: where no arc of a component is left, its deepest.
    template <class Put>
    [[nodiscard]] bool chains(Put put) noexcept
    {
        const auto nodes = static_cast<std::uint32_t>(swept_.nodes.size());
        for (const bool rings : {false, true})
            for (std::uint32_t v = 0; v < nodes; ++v) {
                if (!rings && !is_end(v)) continue;
                for (std::uint32_t h = first_[v]; h != none; h = next_[h])
                    if (arcs_[h / 2].alive && !walk(v, h, put)) return false;
            }
        for (std::size_t i = 0; i < lonely_; ++i)
            if (!put(lone_[i], true)) return false;
        return true;
    }

private:
    /// If nothing is left at either end of a removed arc, its deeper end stays as a single node.
    void note_lone(const arc& gone) noexcept
    {
        const auto is_bare = [this](std::uint32_t v) noexcept {
            return is_outline(v) || (!held_[v] && degree_[v] == 0);
        };
        if (!is_bare(gone.a) || !is_bare(gone.b)) return;
        lone_[lonely_++] = swept_.nodes[gone.a].distance >= swept_.nodes[gone.b].distance ? gone.a : gone.b;
    }
    /// Whether a node is neither on the outline nor on the floor's.
    [[nodiscard]] bool is_free(std::uint32_t v) const noexcept { return !is_outline(v) && !held_[v]; }
    [[nodiscard]] bool is_outline(std::uint32_t node) const noexcept { return node < own_; }
    [[nodiscard]] bool is_end(std::uint32_t v) const noexcept { return !is_free(v) || degree_[v] != 2; }

    bool find_arcs(std::size_t nodes, std::size_t halves) noexcept
    {
        // Half-edge 3t + k leaves corner k of triangle t, whose face is faces_[t].
        auto* const leaving = scratch_.take<std::uint32_t>(nodes);
        auto* const noted = scratch_.take<std::uint32_t>(nodes);
        auto* const after = scratch_.take<std::uint32_t>(halves);
        faces_ = scratch_.take<std::uint32_t>(swept_.triangles.size());
        pieces_ = scratch_.take<std::uint32_t>(swept_.triangles.size());
        open_ = scratch_.take<bool>(swept_.triangles.size());
        if (leaving == nullptr || noted == nullptr || after == nullptr || faces_ == nullptr || pieces_ == nullptr ||
            open_ == nullptr)
            return false;
        for (std::size_t i = 0; i < nodes; ++i) leaving[i] = noted[i] = none;
        for (std::size_t c = 0; c + 1 < swept_.cells.size(); ++c)
            for (std::uint32_t t = swept_.cells[c].first_triangle; t < swept_.cells[c + 1].first_triangle; ++t) {
                const triangle& one = swept_.triangles[t];
                faces_[t] = swept_.cells[c].edge;
                pieces_[t] = t;
                open_[t] = is_outline(one.a) || is_outline(one.b) || is_outline(one.c);
            }
        for (auto h = static_cast<std::uint32_t>(halves); h-- != 0;) {
            std::uint32_t& first = leaving[origin(h)];
            after[h] = first;
            first = h;
        }
        for (std::uint32_t v = 0; v < nodes; ++v) {
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) noted[target(h)] = h;
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) {
                // The half-edge that arrives at v in the same triangle: its twin leaves v.
                const std::uint32_t g = h % 3 == 0 ? h + 2 : h - 1, from = origin(g), twin = noted[from];
                if (from > v || twin == none || origin(twin) != v) continue;
                add(from, v, g / 3, twin / 3);
            }
        }
        open_islands();
        return true;
    }
    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept
    {
        const triangle& t = swept_.triangles[h / 3];
        return h % 3 == 0 ? t.a : h % 3 == 1 ? t.b : t.c;
    }
    [[nodiscard]] std::uint32_t target(std::uint32_t h) const noexcept { return origin(h % 3 == 2 ? h - 2 : h + 1); }

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t left, std::uint32_t right) noexcept
    {
        if (faces_[left] == faces_[right]) return unite(left, right);
        if (is_outline(a) && is_outline(b)) return;  // a component too small to sweep lies at distance 0
        arcs_[count_] = {a, b, left, right, true};
        link(a, 2 * count_);
        link(b, 2 * count_ + 1);
        ++count_;
    }
    /// Rounding can cut a piece off a face, where a dozen faces meet within a few cells. The arcs around it would be a
    /// ring without a hole, so one of them goes.
    void open_islands() noexcept
    {
        for (std::uint32_t i = 0; i < count_; ++i) {
            arc& one = arcs_[i];
            const std::uint32_t left = piece(one.left), right = piece(one.right);
            if (left == right || (open_[left] && open_[right])) continue;
            unite(left, right);
            remove(one);
        }
    }
    [[nodiscard]] std::uint32_t piece(std::uint32_t t) noexcept
    {
        while (pieces_[t] != t) t = pieces_[t] = pieces_[pieces_[t]];
        return t;
    }
    void unite(std::uint32_t s, std::uint32_t t) noexcept
    {
        s = piece(s);
        t = piece(t);
        pieces_[t] = s;
        open_[s] = open_[s] || open_[t];
    }

    void remove(arc& one) noexcept
    {
        one.alive = false;
        --degree_[one.a];
        --degree_[one.b];
    }
    void link(std::uint32_t v, std::uint32_t half) noexcept
    {
        next_[half] = first_[v];
        first_[v] = half;
        ++degree_[v];
    }
    [[nodiscard]] std::uint32_t arc_at(std::uint32_t v) const noexcept
    {
        std::uint32_t h = first_[v];
        while (!arcs_[h / 2].alive) h = next_[h];
        return h / 2;
    }

    template <class IsCorner>
    [[nodiscard]] bool is_spare(const arc& one, std::uint32_t end, std::int64_t crease,
                                const IsCorner& is_corner) const noexcept
    {
        if (is_outline(end)) return !is_convex(end) || !is_corner(end);
        if (held_[end] || degree_[end] != 1) return false;
        const fixed_vector left = inward(faces_[one.left]), right = inward(faces_[one.right]);
        const auto cosine = static_cast<std::int64_t>(dot(left, right));
        return cosine > crease * unit_one || !falls(one, left - right);
    }
    /// Whether the surface falls on both sides of an arc.
    [[nodiscard]] bool falls(const arc& one, fixed_vector apart) const noexcept
    {
        const grid_point a = swept_.nodes[one.a].at, b = swept_.nodes[one.b].at;
        const std::int64_t x = std::int64_t{b.x} - a.x, y = std::int64_t{b.y} - a.y;
        return apart.y * x - apart.x * y < 0;
    }
    [[nodiscard]] bool is_convex(std::uint32_t i) const noexcept
    {
        const std::uint32_t next = swept_.edges_at[i].b, last = before(i);
        return orientation(region_.points()[last], region_.points()[i], region_.points()[next]) > 0;
    }
    /// The point before point i in its loop. At level 0, edge i goes from point i to the next.
    [[nodiscard]] std::uint32_t before(std::uint32_t i) const noexcept
    {
        if (i != 0 && swept_.edges_at[i - 1].b == i) return i - 1;
        std::uint32_t last = i;
        while (swept_.edges_at[last].b != i) ++last;
        return last;
    }

    /// The direction in which a face rises, in 2^-30.
    [[nodiscard]] fixed_vector inward(std::uint32_t face) const noexcept
    {
        if (face >= own_) {
            const vec2 to = swept_.joins[face - own_].inward;
            return {whole(to.x), whole(to.y)};
        }
        const grid_point p = region_.points()[face], q = region_.points()[swept_.edges_at[face].b];
        return moving_line{unit_along({std::int64_t{q.x} - p.x, std::int64_t{q.y} - p.y})}.inward();
    }
    [[nodiscard]] static std::int64_t whole(float share) noexcept
    {
        return static_cast<std::int64_t>(static_cast<double>(share) * static_cast<double>(unit_one));
    }

    /// Goes from v along half-arc h, and uses up the arcs.
    template <class Put>
    [[nodiscard]] bool walk(std::uint32_t v, std::uint32_t h, Put& put) noexcept
    {
        const std::uint32_t start = v;
        if (!put(v, true)) return false;
        for (;;) {
            arc& one = arcs_[h / 2];
            one.alive = false;
            v = h % 2 == 0 ? one.b : one.a;
            if (!put(v, false)) return false;
            if (v == start || is_end(v)) return true;
            h = first_[v];
            while (!arcs_[h / 2].alive) h = next_[h];
        }
    }

    const region& region_;
    const swept_region& swept_;
    workspace::scope& scratch_;
    std::uint32_t own_;
    std::uint32_t* degree_ = nullptr;  // of each node
    std::uint32_t* first_ = nullptr;   // the first half-arc at each node: 2 * arc, or 2 * arc + 1 at its end b
    bool* held_ = nullptr;
    arc* arcs_ = nullptr;
    std::uint32_t* faces_ = nullptr;   // of each triangle: an edge of the region, or a join
    std::uint32_t* pieces_ = nullptr;  // of each triangle: another one of the same piece of a face, or itself
    bool* open_ = nullptr;             // whether a piece reaches the outline
    std::uint32_t* next_ = nullptr;    // for each half-arc, the next one at its node
    std::uint32_t* todo_ = nullptr;
    std::uint32_t* lone_ = nullptr;
    std::uint32_t count_ = 0;
    std::size_t lonely_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
