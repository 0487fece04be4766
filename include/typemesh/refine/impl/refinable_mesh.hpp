// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/stretched_circle.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A triangulated region to which points are added, inside and on its boundary. It is Delaunay between insertions: each
/// inner edge passes prefers_other_diagonal() for the extents with which it was opened.
///
///               r                  triangle t has the half-edges 4t, 4t + 1, 4t + 2; the fourth entry holds its mark.
///             /   ^                next() goes around a triangle counter-clockwise.
///           /   t   \              twin(h) is the same edge as seen from the other side; `none` on the boundary.
///         v           \            Each boundary point is the first point of one boundary edge. A point where a
///        p ---- h ----> q          boundary touches itself is two points at one place.
///
/// It keeps its memory for the next region.
class refinable_mesh {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// In cells: refiners add no point nearer than this to another one. Rounding could otherwise make them go on for
    /// ever.
    static constexpr std::int64_t spacing = 4;

    /// A point. The last three members matter for boundary points.
    struct vertex {
        grid_point place;
        std::uint32_t boundary = none;  ///< the half-edge of the boundary edge that leaves it; none: an inner point
        std::uint32_t source = none;    ///< the region's edge on which that edge lies
        contour_edge edge = {};         ///< the part of a curve that that edge stands for
    };

    explicit refinable_mesh(memory source = heap()) noexcept
        : vertices_{source}, edges_{source}, list_{source}, changed_{source}
    {
    }

    /// Begins with a region's triangles, which need not be Delaunay. Points keep their numbers. `compared` says which
    /// extents of triangles shall be small: see stretched_circle.hpp.
    ///
    /// False if out of memory
    /// Cost   O(n), and O(1) for each flip. Delaunay triangles need no flips, others usually few, at worst n^2.
    [[nodiscard]] bool open(const region& r, array_view<const triangle> triangles,
                            extents compared = extents::both) noexcept
    {
        clear();
        compared_ = compared;
        const auto n = static_cast<std::uint32_t>(r.points().size());
        vertex* const all = vertices_.append(n);
        half_edge* const edges = edges_.append(4 * triangles.size());
        std::uint32_t* const leaving = list_.append(2 * std::size_t{n} + 4 * triangles.size());
        if (all == nullptr || edges == nullptr || leaving == nullptr) return false;
        for (std::uint32_t v = 0; v < n; ++v) {
            all[v] = {r.points()[v], none, v, r.edges()[v]};
            leaving[v] = none;
        }
        std::uint32_t *const noted = leaving + n, *const after = noted + n;
        for (std::uint32_t v = 0; v < n; ++v) noted[v] = none;
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            const std::uint32_t corners[] = {triangles[t].a, triangles[t].b, triangles[t].c};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const auto h = static_cast<std::uint32_t>(4 * t + k);
                edges[h] = {corners[k], none};
                after[h] = leaving[corners[k]];
                leaving[corners[k]] = h;
            }
            edges[4 * t + 3] = {0, 0};
        }
        // Twins, point by point, in O(n) even for points of many triangles: each half-edge that leaves the point is
        // noted at its other end, and each half-edge that arrives looks up the note at its own first point.
        for (std::uint32_t v = 0; v < n; ++v) {
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) noted[target(h)] = h;
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) {
                const std::uint32_t arriving = previous(h), from = origin(arriving), back = noted[from];
                if (back != none && origin(back) == v)
                    edges[arriving].twin = back;
                else
                    all[from].boundary = arriving;
            }
        }
        list_.clear();
        for (std::uint32_t h = 0; h < end(); h = h % 4 == 2 ? h + 2 : h + 1)
            if (edges_[h].twin != none && h < edges_[h].twin && !list_.push_back(h)) return false;
        return flip_listed();
    }

    void clear() noexcept
    {
        vertices_.clear();
        edges_.clear();
        list_.clear();
        changed_.clear();
        last_mark_ = 0;
    }

    [[nodiscard]] std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(vertices_.size()); }
    [[nodiscard]] std::uint32_t triangle_count() const noexcept { return end() / 4; }
    [[nodiscard]] const vertex& at(std::uint32_t v) const noexcept { return vertices_[v]; }
    [[nodiscard]] grid_point place(std::uint32_t v) const noexcept { return vertices_[v].place; }

    /// One past the last half-edge.
    [[nodiscard]] std::uint32_t end() const noexcept { return static_cast<std::uint32_t>(edges_.size()); }
    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return (h & 3) == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) noexcept { return (h & 3) == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept { return edges_[h].origin; }
    [[nodiscard]] std::uint32_t target(std::uint32_t h) const noexcept { return edges_[next(h)].origin; }
    [[nodiscard]] std::uint32_t apex(std::uint32_t h) const noexcept { return edges_[previous(h)].origin; }
    [[nodiscard]] std::uint32_t twin(std::uint32_t h) const noexcept { return edges_[h].twin; }
    [[nodiscard]] bool is_boundary(std::uint32_t h) const noexcept { return edges_[h].twin == none; }
    [[nodiscard]] grid_point start(std::uint32_t h) const noexcept { return vertices_[edges_[h].origin].place; }

    /// The product of the vectors from a place to p and q, exact: negative if the place lies in the circle over p q.
    [[nodiscard]] static std::int64_t dot(grid_point at, grid_point p, grid_point q) noexcept
    {
        return (std::int64_t{p.x} - at.x) * (std::int64_t{q.x} - at.x) +
               (std::int64_t{p.y} - at.y) * (std::int64_t{q.y} - at.y);
    }

    /// The boundary point after a boundary point.
    [[nodiscard]] std::uint32_t next_on_boundary(std::uint32_t v) const noexcept
    {
        return target(vertices_[v].boundary);
    }

    /// The boundary point before a boundary point, found by going around it.
    [[nodiscard]] std::uint32_t previous_on_boundary(std::uint32_t v) const noexcept
    {
        std::uint32_t h = previous(vertices_[v].boundary);
        while (!is_boundary(h)) h = previous(twin(h));
        return origin(h);
    }

    /// A number for each triangle that its user writes and reads; new triangles have 0.
    [[nodiscard]] std::uint32_t& mark(std::uint32_t t) noexcept { return edges_[4 * t + 3].origin; }
    /// A number that no triangle has yet.
    [[nodiscard]] std::uint32_t new_mark() noexcept { return ++last_mark_; }

    /// The triangles that the last call of split() or insert() has made or changed; some may occur twice.
    [[nodiscard]] array_view<const std::uint32_t> changed() const noexcept { return changed_.view(); }

    /// Where a place lies: in a triangle, or on or beyond the boundary edge that leaves `behind`. Both are none for a
    /// point of the mesh.
    struct location {
        std::uint32_t triangle = none;
        std::uint32_t behind = none;
    };

    /// Finds a place by a walk from triangle t.
    [[nodiscard]] location locate(std::uint32_t t, grid_point p) const noexcept
    {
        std::uint32_t came = none;
        for (std::uint32_t steps = triangle_count() + 3; steps != 0; --steps) {
            std::uint32_t across = none;
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h) {
                if (h == came) continue;
                const std::int64_t side = orientation(start(h), place(target(h)), p);
                if (side < 0 || (side == 0 && is_boundary(h))) {
                    across = h;
                    break;
                }
            }
            if (across == none) return {t, none};
            if (is_boundary(across)) return {none, origin(across)};
            came = twin(across);
            t = came / 4;
        }
        return {};
    }

    /// Adds the point p on the boundary edge that leaves a, which becomes two edges, a p and p b.
    /// The edge's triangle a, b, c becomes a, p, c and p, b, c, which must be counter-clockwise.
    ///
    ///          c                  c
    ///        /   \              / | \           p may lie on either side of the old edge. Beyond it, the caller has
    ///       /     \            /  |  \          made sure that nothing else lies in the triangle a, p, b.
    ///      a ----- b          a - p - b
    ///
    /// Returns p's number; none if out of memory.
    [[nodiscard]] std::uint32_t split(std::uint32_t a, grid_point p, float t) noexcept
    {
        const std::uint32_t h = vertices_[a].boundary, h1 = next(h), v = vertex_count(), g = end();
        if (!vertices_.push_back({}) || edges_.append(4) == nullptr) return none;
        const std::uint32_t b = origin(h1), c = apex(h), beyond = edges_[h1].twin;
        contour_edge after = vertices_[a].edge;
        after.t0 = t;
        vertices_[a].edge.t1 = t;
        vertices_[v] = {p, g, vertices_[a].source, after};
        edges_[g] = {v, none};
        edges_[g + 1] = {b, none};
        edges_[g + 2] = {c, none};
        edges_[g + 3] = {0, 0};
        edges_[h1].origin = v;
        edges_[(h & ~3u) + 3] = {0, 0};
        attach(g + 1, beyond);
        set_twins(h1, g + 2);
        list_.clear();
        changed_.clear();
        const bool fits = changed_.push_back(h / 4) && changed_.push_back(g / 4) && list_.push_back(g + 1) &&
                          list_.push_back(previous(h)) && list_.push_back(h1);
        return fits && flip_listed() ? v : none;
    }

    /// Adds the inner point p of a triangle, or of an inner edge of it. Returns its number; none if out of memory.
    [[nodiscard]] std::uint32_t insert(std::uint32_t t, grid_point p) noexcept
    {
        const std::uint32_t v = vertex_count(), h = 4 * t;
        if (!vertices_.push_back({p, none, none, {}}) || edges_.append(8) == nullptr) return none;
        const std::uint32_t g = end() - 8, k = end() - 4;
        const std::uint32_t a = origin(h), b = origin(h + 1), c = origin(h + 2), bc = twin(h + 1), ca = twin(h + 2);
        //  t becomes a b p; g is b c p; k is c a p
        edges_[h + 2].origin = v;
        edges_[h + 3] = {0, 0};
        edges_[g] = {b, none};
        edges_[g + 1] = {c, none};
        edges_[g + 2] = {v, none};
        edges_[g + 3] = {0, 0};
        edges_[k] = {c, none};
        edges_[k + 1] = {a, none};
        edges_[k + 2] = {v, none};
        edges_[k + 3] = {0, 0};
        attach(g, bc);
        attach(k, ca);
        set_twins(h + 1, g + 2);
        set_twins(g + 1, k + 2);
        set_twins(k + 1, h + 2);
        list_.clear();
        changed_.clear();
        bool fits = true;
        for (const std::uint32_t edge : {h, g, k}) fits = fits && changed_.push_back(edge / 4) && list_.push_back(edge);
        return fits && flip_opposite() ? v : none;
    }

    /// Replaces an inner edge by the other diagonal of its two triangles. They must form a strictly convex
    /// quadrilateral.
    ///
    ///         r                  h and g, its twin, are then the outer edges p s and q r
    ///        /  ^                next(h) and next(g) the new diagonal
    ///       p -h-> q
    ///        \  /
    ///         s
    void flip(std::uint32_t h) noexcept
    {
        const std::uint32_t g = twin(h), h1 = next(h), g1 = next(g);
        const std::uint32_t outer_of_g1 = twin(g1), outer_of_h1 = twin(h1), s = apex(g), r = apex(h);
        // h keeps its origin p and takes the edge p -> s (g1's); g keeps q and takes q -> r (h1's)
        attach(h, outer_of_g1);
        attach(g, outer_of_h1);
        edges_[h1].origin = s;
        edges_[g1].origin = r;
        set_twins(h1, g1);
        edges_[(h & ~3u) + 3] = {0, 0};
        edges_[(g & ~3u) + 3] = {0, 0};
    }

private:
    struct half_edge {
        std::uint32_t origin;
        std::uint32_t twin;
    };

    void set_twins(std::uint32_t h, std::uint32_t g) noexcept
    {
        edges_[h].twin = g;
        edges_[g].twin = h;
    }
    /// Makes h the half-edge of a twin that had another, or of a boundary edge.
    void attach(std::uint32_t h, std::uint32_t g) noexcept
    {
        edges_[h].twin = g;
        if (g != none)
            edges_[g].twin = h;
        else
            vertices_[edges_[h].origin].boundary = h;
    }

    /// Flips until all listed edges, and those around edges that are flipped, are Delaunay. False if out of memory.
    [[nodiscard]] bool flip_listed() noexcept
    {
        while (!list_.empty()) {
            const std::uint32_t h = list_.back();
            list_.truncate(list_.size() - 1);
            const std::uint32_t g = twin(h);
            if (g == none) continue;
            const std::uint32_t h2 = previous(h), g2 = previous(g);
            if (!prefers_other_diagonal(compared_, start(h), start(g), start(h2), start(g2))) continue;
            flip(h);
            if (!list_.push_back(h) || !list_.push_back(g2) || !list_.push_back(g) || !list_.push_back(h2) ||
                !changed_.push_back(h / 4) || !changed_.push_back(g / 4))
                return false;
        }
        return true;
    }

    /// The same after an insertion into a mesh that was Delaunay: the edges of the new point, the apex of all listed
    /// half-edges, are Delaunay. False if out of memory.
    [[nodiscard]] bool flip_opposite() noexcept
    {
        while (!list_.empty()) {
            const std::uint32_t h = list_.back();
            list_.truncate(list_.size() - 1);
            const std::uint32_t g = twin(h);
            if (g == none) continue;
            const std::uint32_t g2 = previous(g);
            if (!prefers_other_diagonal(compared_, start(h), start(g), start(previous(h)), start(g2))) continue;
            flip(h);
            if (!list_.push_back(h) || !list_.push_back(g2) || !changed_.push_back(h / 4) || !changed_.push_back(g / 4))
                return false;
        }
        return true;
    }

    buffer<vertex> vertices_;
    buffer<half_edge> edges_;
    buffer<std::uint32_t> list_;
    buffer<std::uint32_t> changed_;
    std::uint32_t last_mark_ = 0;
    extents compared_ = extents::both;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
