// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Triangles that know their neighbours. Each directed edge of a triangle stores its origin and its twin, which is the
/// same edge as seen from the other side.
///
///               r                  triangle t has the half-edges 4t, 4t + 1, 4t + 2; 4t + 3 stays unused
///             /   ^                next() goes around a triangle counter-clockwise
///        h2 /   t   \ h1           the twin of a boundary edge p -> q is the *rim* half-edge of p, which belongs to no
///         v           \            triangle. So each boundary edge is found by its first point, and every half-edge
///        p ---- h ----> q          that moves has a twin to update
///
/// Points are indices into the caller's array. A triangle fills one cache line; 80 bytes per point in total.
class half_edges {
public:
    struct half_edge {
        std::uint32_t origin;
        std::uint32_t twin;
        grid_point place;  // of the origin
    };

    explicit half_edges(array_view<const grid_point> points) noexcept : points_{points} {}

    /// Takes memory for `triangles` triangles. False if out of memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::size_t triangles) noexcept
    {
        rim_ = static_cast<std::uint32_t>(4 * triangles);
        edges_ = scratch.take<half_edge>(4 * triangles + points_.size() + 1);
        return edges_ != nullptr;
    }

    /// For chain_cutter.hpp: takes its triangles, and links neighbours without any search.
    ///
    /// An edge is the half-edge that waits for its twin, or the half-edge that will be its twin. A sweep may draw a
    /// diagonal before either side has a triangle. Until finish(), the unused fourth entries of triangles represent its
    /// two sides.
    class output {
    public:
        using edge = std::uint32_t;
        struct edge_pair {
            edge first, second;
        };

        /// The sweep's point v is points[name[v]], perhaps at other coordinates in the same arrangement.
        explicit output(const half_edges& mesh, const std::uint32_t* name) noexcept
            : edges_{mesh.edges_},
              rim_{mesh.rim_},
              nobody_{mesh.rim_ + static_cast<std::uint32_t>(mesh.points_.size())},
              points_{mesh.points_.data()},
              name_{name}
        {
        }

        [[nodiscard]] std::uint32_t name(std::uint32_t v) const noexcept { return name_[v]; }

        template <std::uint32_t along, class Link>
        edge cut(const Link& a, const Link& b, std::uint32_t v, grid_point, std::int64_t, edge to_b) noexcept
        {
            const grid_point at_a = points_[a.point], at_b = points_[b.point], p = points_[v];
            const std::uint32_t t = count_, chain = along == 0 ? t : t + 2, open = along == 0 ? t + 2 : t;
            count_ += 4;
            edges_[t].origin = a.point;
            edges_[t].place = at_a;
            edges_[t + 1] = along == 0 ? half_edge{b.point, to_b, at_b} : half_edge{v, to_b, p};
            edges_[t + 2].origin = along == 0 ? v : b.point;
            edges_[t + 2].place = along == 0 ? p : at_b;
            edges_[to_b].twin = t + 1;
            edges_[chain].twin = b.edge;
            edges_[b.edge].twin = chain;
            return open;
        }
        template <std::uint32_t along>
        [[nodiscard]] edge next_outer() const noexcept
        {
            return count_ + 1;
        }
        template <std::uint32_t on>
        [[nodiscard]] edge boundary(std::uint32_t left, std::uint32_t v) const noexcept
        {
            return rim_ + (on == 0 ? left : v);
        }
        [[nodiscard]] edge_pair diagonal() noexcept
        {
            diagonals_ += 8;
            return {diagonals_ - 5, diagonals_ - 1};
        }
        [[nodiscard]] edge nobody() const noexcept { return nobody_; }
        void join(edge a, edge b) const noexcept
        {
            edges_[a].twin = b;
            edges_[b].twin = a;
        }
        void close(edge a) const noexcept { join(a, rim_ + edges_[a].origin); }

    private:
        friend class half_edges;
        half_edge* edges_;
        std::uint32_t rim_;
        std::uint32_t nobody_;
        std::uint32_t count_ = 0;
        std::uint32_t diagonals_ = 0;
        const grid_point* points_;
        const std::uint32_t* name_;
    };

    /// Call after a successful sweep: takes over the triangles of `made`.
    void finish(const output& made) noexcept
    {
        count_ = made.count_;
        for (std::uint32_t d = 0; d < made.diagonals_; d += 8) set_twins(edges_[d + 3].twin, edges_[d + 7].twin);
    }

    /// One past the last half-edge in use.
    [[nodiscard]] std::uint32_t end() const noexcept { return count_; }
    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return (h & 3) == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) noexcept { return (h & 3) == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept { return edges_[h].origin; }
    [[nodiscard]] std::uint32_t twin(std::uint32_t h) const noexcept { return edges_[h].twin; }
    [[nodiscard]] grid_point place(std::uint32_t h) const noexcept { return edges_[h].place; }
    [[nodiscard]] bool is_boundary(std::uint32_t h) const noexcept { return edges_[h].twin >= rim_; }
    [[nodiscard]] bool is_rim(std::uint32_t h) const noexcept { return h >= rim_; }
    /// Whether h has the smaller number of the two half-edges of an inner edge.
    [[nodiscard]] bool is_first_half(std::uint32_t h) const noexcept { return edges_[h].twin - h - 1 < rim_ - h - 1; }
    /// The half-edge of the boundary edge that leaves a point.
    [[nodiscard]] std::uint32_t boundary_from(std::uint32_t point) const noexcept { return edges_[rim_ + point].twin; }

    /// Flips h, which is not a boundary edge: exchanges the diagonals of the quadrilateral around it.
    ///
    ///          r                      r            h, its twin g and the half-edges before each keep their numbers and
    ///        / ^                    / | ^          first points. The two half-edges that left q and p are new:
    ///      h2   h1               h2   |   g
    ///      v     \               v   h1|   \         next(h) runs from s to r, next(g) from r to s.
    ///     p --h-> q             p     |g1   q
    ///      \ <-g- ^              \    |    ^       Then h, previous(h), g, previous(g) are outside.
    ///      g1    g2               h   |   g2
    ///        v  /                   v |  /
    ///          s                      s
    void flip(std::uint32_t h) noexcept
    {
        const std::uint32_t g = edges_[h].twin;
        flip(h, g, previous(g));
    }
    /// The same for callers that know g and previous(g).
    void flip(std::uint32_t h, std::uint32_t g, std::uint32_t g2) noexcept
    {
        const std::uint32_t h1 = next(h), g1 = next(g), h2 = previous(h);
        set_twins(h, edges_[g1].twin);
        set_twins(g, edges_[h1].twin);
        edges_[h1] = {edges_[g2].origin, g1, edges_[g2].place};
        edges_[g1] = {edges_[h2].origin, h1, edges_[h2].place};
    }

    /// Adds the triangle b, a, p on the boundary edge h from a to b. On the boundary p then lies between them.
    void add_ear(std::uint32_t h, std::uint32_t p) noexcept
    {
        const std::uint32_t a = edges_[h].origin, b = edges_[next(h)].origin, t = count_;
        count_ += 4;
        edges_[t] = {b, h, edges_[next(h)].place};
        edges_[t + 1] = {a, rim_ + a, edges_[h].place};
        edges_[t + 2] = {p, rim_ + p, points_[p]};
        edges_[h].twin = t;
        edges_[rim_ + a].twin = t + 1;
        edges_[rim_ + p].twin = t + 2;
    }

    /// Dents the boundary edge h from a to b. p, which lies in the triangle a, b, c of h or on h, is inserted between
    /// them. The triangle becomes a, p, c with h from a to p; p, b, c is new. Returns the half-edge from b to c. If p
    /// lies outside, but inside the circle through a, b, c, the result equals an ear and then the flip of h.
    ///
    ///          c                c
    ///        /   \            / | \      |
    ///       /     \          /  p  \     |
    ///      /       \        / /   \ \    |
    ///     a---h-----b      a'       'b
    std::uint32_t dent(std::uint32_t h, std::uint32_t p) noexcept
    {
        const std::uint32_t t = count_;
        const half_edge b = edges_[next(h)], c = edges_[previous(h)];
        const grid_point place = points_[p];
        count_ += 4;
        edges_[t] = {p, rim_ + p, place};
        edges_[t + 1] = b;
        edges_[t + 2] = {c.origin, next(h), c.place};
        edges_[rim_ + p].twin = t;
        edges_[b.twin].twin = t + 1;
        edges_[next(h)] = {p, t + 2, place};
        return t + 1;
    }

    /// Writes the triangles; there are end() / 4 of them.
    void write(triangle* out) const noexcept
    {
        for (std::uint32_t h = 0; h < count_; h += 4)
            *out++ = {edges_[h].origin, edges_[h + 1].origin, edges_[h + 2].origin};
    }

private:
    void set_twins(std::uint32_t h, std::uint32_t g) noexcept
    {
        edges_[h].twin = g;
        edges_[g].twin = h;
    }

    array_view<const grid_point> points_;
    half_edge* edges_ = nullptr;
    std::uint32_t rim_ = 0;
    std::uint32_t count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
