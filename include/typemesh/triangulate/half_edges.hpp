// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::detail {

/// Triangles that know their neighbours: for each directed edge of a triangle, where it begins and the same edge seen from the
/// other side.
///
///               r                  triangle t has the half-edges 4t, 4t + 1, 4t + 2; 4t + 3 stays empty
///             /   ^                next() goes round a triangle counter-clockwise
///        h2 /   t   \ h1           a boundary edge p -> q has for twin the *rim* half-edge of its first point p, which
///         v           \            is none of a triangle; so each boundary edge is found by its first point, and moving
///        p ---- h ----> q          a half-edge to another place needs no question what its twin is
///
/// Points are indices of the caller's. A triangle fills one cache line; 80 bytes a point in all, while linking 104.
class half_edges {
public:
    struct half_edge {
        std::uint32_t origin;
        std::uint32_t twin;
        grid_point place;  // of the origin
    };

    explicit half_edges(std::span<const grid_point> points) noexcept : points_{points} {}

    /// Room for `triangles` triangles; false when there is no memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::size_t triangles) noexcept
    {
        rim_ = static_cast<std::uint32_t>(4 * triangles);
        edges_ = scratch.take<half_edge>(4 * triangles + points_.size());
        return edges_ != nullptr;
    }

    /// Takes `triangles`, whose corners are called name[corner] here (corner itself where name is null). Edges that are met by no
    /// reverse are boundary. O(triangles), whatever the degrees; false when there is no memory.
    [[nodiscard]] bool link(std::span<const triangle> triangles, const std::uint32_t* name, workspace& space) noexcept
    {
        workspace::scope scratch{space};
        const std::size_t n = points_.size();
        auto* const first = scratch.take<std::uint32_t>(n);     // the last half-edge that leaves a point
        auto* const towards = scratch.take<std::uint32_t>(n);   // the half-edge from the point at hand to this one
        auto* const before = scratch.take<std::uint32_t>(4 * triangles.size());  // the half-edge listed before this one
        if (first == nullptr || towards == nullptr || before == nullptr) return false;
        count_ = static_cast<std::uint32_t>(4 * triangles.size());
        for (std::size_t v = 0; v < n; ++v) first[v] = none;
        std::uint32_t h = 0;
        for (const triangle t : triangles) {
            const std::uint32_t corners[3] = {name != nullptr ? name[t.a] : t.a, name != nullptr ? name[t.b] : t.b, name != nullptr ? name[t.c] : t.c};
            for (std::uint32_t k = 0; k < 3; ++k) {
                edges_[h + k].origin = corners[k];
                edges_[h + k].place = points_[corners[k]];
                before[h + k] = first[corners[k]];
                first[corners[k]] = h + k;
                towards[corners[k]] = 0;
            }
            h += 4;
        }
        for (std::uint32_t v = 0; v < n; ++v) {
            for (std::uint32_t out = first[v]; out != none; out = before[out]) towards[edges_[next(out)].origin] = out;
            for (std::uint32_t out = first[v]; out != none; out = before[out]) {
                const std::uint32_t in = previous(out), from = edges_[in].origin, back = towards[from];
                if (edges_[back].origin == v && edges_[next(back)].origin == from) edges_[in].twin = back;
                else set_twins(in, rim_ + from);
            }
        }
        return true;
    }

    /// One past the last half-edge in use.
    [[nodiscard]] std::uint32_t end() const noexcept { return count_; }
    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return (h & 3) == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) noexcept { return (h & 3) == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept { return edges_[h].origin; }
    [[nodiscard]] std::uint32_t twin(std::uint32_t h) const noexcept { return edges_[h].twin; }
    [[nodiscard]] grid_point place(std::uint32_t h) const noexcept { return edges_[h].place; }
    [[nodiscard]] bool is_boundary(std::uint32_t h) const noexcept { return edges_[h].twin >= rim_; }
    /// The half-edge of the boundary edge that leaves a point.
    [[nodiscard]] std::uint32_t boundary_from(std::uint32_t point) const noexcept { return edges_[rim_ + point].twin; }

    /// Exchanges the diagonals of the quadrilateral round h, which is no boundary edge.
    ///
    ///          r                      r            h, its twin g and the half-edges behind each keep their numbers and
    ///        / ^                    / | ^          their first points; the two that leave q before and p before are new:
    ///      h2   h1               h2   |   g
    ///      v     \               v   h1|   \         next(h) runs from s to r, next(g) from r to s.
    ///     p --h-> q             p     |g1   q
    ///      \ <-g- ^              \    |    ^       Outside are then: h, previous(h), g, previous(g).
    ///      g1    g2               h   |   g2
    ///        v  /                   v |  /
    ///          s                      s
    void flip(std::uint32_t h) noexcept
    {
        const std::uint32_t g = edges_[h].twin, h1 = next(h), g1 = next(g), h2 = previous(h), g2 = previous(g);
        set_twins(h, edges_[g1].twin);
        set_twins(g, edges_[h1].twin);
        edges_[h1] = {edges_[g2].origin, g1, edges_[g2].place};
        edges_[g1] = {edges_[h2].origin, h1, edges_[h2].place};
    }

    /// Hangs the triangle b, a, p on the boundary edge h from a to b: p comes between them on the boundary. Returns the
    /// half-edge from b to a in it.
    std::uint32_t add_ear(std::uint32_t h, std::uint32_t p) noexcept
    {
        const std::uint32_t a = edges_[h].origin, b = edges_[next(h)].origin, t = count_;
        count_ += 4;
        edges_[t] = {b, h, edges_[next(h)].place};
        edges_[t + 1] = {a, rim_ + a, edges_[h].place};
        edges_[t + 2] = {p, rim_ + p, points_[p]};
        edges_[h].twin = t;
        edges_[rim_ + a].twin = t + 1;
        edges_[rim_ + p].twin = t + 2;
        return t;
    }

    /// Dents the boundary edge h from a to b: p, which lies in the triangle a, b, c of h or on h, comes between them.
    /// Of the triangle remain  a, p, c  with h from a to p  and, new,  p, b, c.  Returns the half-edge from b to c.
    ///
    ///          c                c
    ///        /   \            / | \      |
    ///       /     \          /  p  \     |
    ///      /       \        / /   \ \    |
    ///     a---h-----b      a'       'b
    std::uint32_t dent(std::uint32_t h, std::uint32_t p) noexcept
    {
        const std::uint32_t h1 = next(h), b = edges_[h1].origin, c = edges_[previous(h)].origin, t = count_;
        count_ += 4;
        edges_[t] = {p, rim_ + p, points_[p]};
        edges_[t + 1] = {b, edges_[h1].twin, edges_[h1].place};
        edges_[t + 2] = {c, h1, edges_[previous(h)].place};
        edges_[rim_ + p].twin = t;
        edges_[edges_[h1].twin].twin = t + 1;
        edges_[h1] = {p, t + 2, points_[p]};
        return t + 1;
    }

    /// Writes the triangles: end() / 4 of them.
    void write(triangle* out) const noexcept
    {
        for (std::uint32_t h = 0; h < count_; h += 4) *out++ = {edges_[h].origin, edges_[h + 1].origin, edges_[h + 2].origin};
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    void set_twins(std::uint32_t h, std::uint32_t g) noexcept
    {
        edges_[h].twin = g;
        edges_[g].twin = h;
    }

    std::span<const grid_point> points_;
    half_edge* edges_ = nullptr;
    std::uint32_t rim_ = 0;
    std::uint32_t count_ = 0;
};

}  // namespace typemesh::detail
