// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/offset/impl/moving_point.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A triangulation of the area in front of a moving boundary. All its vertices are corners of that boundary. Half-edge
/// 3t + k runs from corner k of triangle t to the next one. On the other side of a half-edge lies its twin or, if the
/// half-edge is part of the boundary, a segment.
///
///     ---- segment --->          a segment is a piece of a moving line; the triangle
///     u-------------v            lies on its left, like all the area still to be swept
///      \     t     /
///        \       /   <- link: a twin
///           \ /
///            w
///
/// This is only the topology: it does not depend on the positions of the corners, so no rounding can break it.
class kinetic_triangles {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    struct vertex {
        moving_point moves;
        std::uint32_t before = none, after = none;  ///< segments
    };
    struct segment {
        std::uint32_t line = 0;
        std::uint32_t from = 0, to = 0;  ///< vertices
        std::uint32_t half = 0;          ///< the half-edge on its left
        std::uint32_t component = 0;     ///< the connected component of the region that it bounds
        bool alive = true;
    };
    struct triangle {
        std::uint32_t corner[3];
        std::uint32_t link[3] = {none, none, none};
        std::uint32_t stamp = 0;  ///< increases with each change
        bool alive = true;
    };

    buffer<moving_line> lines;
    buffer<vertex> vertices;
    buffer<segment> segments;
    buffer<triangle> triangles;

    explicit kinetic_triangles(memory source) noexcept
        : lines{source}, vertices{source}, segments{source}, triangles{source}
    {
    }

    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept { return triangles[h / 3].corner[h % 3]; }
    [[nodiscard]] std::uint32_t apex(std::uint32_t h) const noexcept { return origin(previous(h)); }

    // --- links: a half-edge, or a segment marked as such

    [[nodiscard]] std::uint32_t link(std::uint32_t h) const noexcept { return triangles[h / 3].link[h % 3]; }
    [[nodiscard]] static bool is_segment(std::uint32_t link) noexcept { return (link & boundary) != 0; }
    [[nodiscard]] static std::uint32_t segment_in(std::uint32_t link) noexcept { return link & ~boundary; }
    [[nodiscard]] static std::uint32_t to_segment(std::uint32_t s) noexcept { return s | boundary; }

    /// Links half-edge h with the half-edge or segment on its other side.
    void connect(std::uint32_t h, std::uint32_t other) noexcept
    {
        triangles[h / 3].link[h % 3] = other;
        if (is_segment(other))
            segments[segment_in(other)].half = h;
        else
            triangles[other / 3].link[other % 3] = h;
    }

    /// Removes a triangle that has become flat; its half-edge h has no length. Its two other sides meet. False if both
    /// are segments: then nothing is left between them.
    bool close(std::uint32_t h) noexcept
    {
        const std::uint32_t a = link(next(h)), b = link(previous(h));
        triangles[h / 3].alive = false;
        ++triangles[h / 3].stamp;
        if (is_segment(a) && is_segment(b)) return false;
        if (is_segment(a))
            connect(b, a);
        else
            connect(a, b);
        return true;
    }

    /// Replaces the diagonal under half-edge h with the other diagonal of its quadrilateral; their ends c and d differ.
    ///
    ///         c                 c
    ///       /   \             / | \        triangle t of h keeps a, the twin's triangle keeps b
    ///     a --h-- b    >    a   |   b
    ///       \   /             \ | /
    ///         d                 d
    void flip(std::uint32_t h) noexcept
    {
        const std::uint32_t g = link(h), t = h / 3, r = g / 3;
        const std::uint32_t a = origin(h), b = origin(g), c = apex(h), d = apex(g);
        const std::uint32_t bc = link(next(h)), ca = link(previous(h)), ad = link(next(g)), db = link(previous(g));
        triangles[t] = {{a, d, c}, {none, none, none}, triangles[t].stamp, true};
        triangles[r] = {{d, b, c}, {none, none, none}, triangles[r].stamp, true};
        connect(3 * t, ad);
        connect(3 * t + 2, ca);
        connect(3 * r, db);
        connect(3 * r + 1, bc);
        connect(3 * t + 1, 3 * r + 2);
    }

    /// Calls visit(h) for each half-edge h that leaves the corner at which segment `after` begins, counter-clockwise.
    template <class Visit>
    void around(std::uint32_t after, Visit visit) noexcept
    {
        std::uint32_t h = segments[after].half;
        for (;;) {
            const std::uint32_t across = link(previous(h));
            visit(h);
            if (is_segment(across)) return;
            h = across;
        }
    }

    /// Makes `v` the corner between two segments, and the corner of all triangles there. Returns the number of
    /// triangles.
    std::uint32_t set_corner(std::uint32_t before, std::uint32_t v, std::uint32_t after) noexcept
    {
        segments[before].to = v;
        segments[after].from = v;
        std::uint32_t count = 0;
        around(after, [&](std::uint32_t h) noexcept {
            triangles[h / 3].corner[h % 3] = v;
            ++count;
        });
        return count;
    }

    /// The half-edges to examine in this round and in the next one.
    struct rounds {
        buffer<std::uint32_t> now, then;
    };

    /// Removes triangles from the corner at which segment `after` begins, until no more than `enough` are left. Each
    /// round removes at most every other one. is_convex(h) says whether the triangle of half-edge h and the next one
    /// around the corner may be flipped; changed(t) is called for each triangle removed. False if out of memory.
    ///
    ///          c               c
    ///        / |             /   \          the triangle of h is removed, the triangle of c stays
    ///      v---b     >     v     b
    ///     h  \ |             \   /
    ///          a               a
    ///
    /// Cost   two examinations per triangle there: after the first round, only on both sides of a change
    template <class IsConvex, class Changed>
    [[nodiscard]] bool thin_out(std::uint32_t after, std::uint32_t enough, IsConvex is_convex, Changed changed,
                                rounds& look) noexcept
    {
        look.now.clear();
        bool fits = true;
        around(after, [&](std::uint32_t h) noexcept { fits = fits && look.now.push_back(h); });
        for (std::size_t left = look.now.size(); fits && left > enough && !look.now.empty(); look.now.swap(look.then)) {
            std::uint32_t stays = none;
            look.then.clear();
            for (const std::uint32_t h : look.now) {
                const std::uint32_t across = link(previous(h));
                if (h / 3 == stays || is_segment(across) || !is_convex(h)) continue;
                stays = across / 3;
                flip(previous(h));
                changed(h / 3);
                --left;
                const std::uint32_t own = 3 * stays + 1, last = link(own);
                if (!is_segment(last) && (look.then.empty() || look.then.back() != next(last)))
                    fits = fits && look.then.push_back(next(last));
                fits = fits && look.then.push_back(own);
            }
        }
        return fits;
    }

    /// Finds the twins of triangles that have none yet. In the region, edge i begins at corner i and is segment i.
    /// Half-edges from a to b and from b to a are twins. `scratch` has room for 2 values per corner and 3 per triangle.
    void link_all(std::uint32_t corners, std::uint32_t* scratch) noexcept
    {
        std::uint32_t *const leaving = scratch, *const noted = scratch + corners, *const after = noted + corners;
        for (std::uint32_t v = 0; v < corners; ++v) leaving[v] = noted[v] = none;
        for (auto t = static_cast<std::uint32_t>(triangles.size()); t-- != 0;) {
            for (std::uint32_t k = 3; k-- != 0;) {
                std::uint32_t& first = leaving[triangles[t].corner[k]];
                after[3 * t + k] = first;
                first = 3 * t + k;
            }
        }
        for (std::uint32_t v = 0; v < corners; ++v) {
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) {
                const std::uint32_t t = h / 3, k = h - 3 * t;
                noted[triangles[t].corner[k == 2 ? 0 : k + 1]] = h;
            }
            for (std::uint32_t h = leaving[v]; h != none; h = after[h]) {
                const std::uint32_t t = h / 3, k = h - 3 * t, coming = k == 0 ? 2 : k - 1;
                const std::uint32_t from = triangles[t].corner[coming], back = noted[from];
                if (back != none && origin(back) == v)
                    triangles[t].link[coming] = back;
                else
                    connect(3 * t + coming, to_segment(from));
            }
        }
    }

private:
    static constexpr std::uint32_t boundary = std::uint32_t{1} << 31;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
