// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/triangulate/impl/half_edges.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Makes a mesh Delaunay again around a new point p: the edges around p are visited once, counter-clockwise.
///
///         c ------ d        Beyond an edge lies a triangle. If its third point is in the circle through p and the ends
///        / \      /         of the edge, like d beyond b c here, the edge is flipped to p d, and b d and d c are
///       /   \    /          visited instead.
///      a     \  /
///       '. p. b             The ends of an edge relative to p, and their cross product, are passed on from test to
///                           test: this takes two thirds of the instructions of in_circle().
class point_star {
public:
    /// An edge that is not yet visited; it begins where the previous one ends.
    struct open_edge {
        seen_point to;
        std::int64_t cross;  // of the edge's ends
        std::uint32_t edge;
    };

    point_star(half_edges& mesh, grid_point p) noexcept : mesh_{mesh}, p_{p} {}

    [[nodiscard]] seen_point origin(std::uint32_t h) const noexcept { return seen_point::of(mesh_.place(h), p_); }

    /// Visits the edges open[0] to open[size - 1]. The last one comes first; it begins at `from`. `open` has room for
    /// `room` edges. If the room is used up, returns how many edges are left in it; the usual result is 0.
    [[nodiscard]] std::size_t close(seen_point from, open_edge* open, std::size_t size, std::size_t room,
                                    std::int64_t& flips_left) const noexcept
    {
        half_edges mesh = mesh_;
        for (open_edge* top = open + size - 1;;) {
            const std::uint32_t h = top->edge, g = mesh.twin(h);
            if (!mesh.is_rim(g)) {
                const std::uint32_t g2 = half_edges::previous(g);
                const grid_point place = mesh.place(g2);
                const seen_point d = seen_point::of(place, p_);
                const std::int64_t ad = from.cross(d), db = d.cross(top->to);
                const int side = circle_side(from, top->to, d, top->cross, ad, db);
                if (side > 0 || (side == 0 && breaks_tie(mesh.place(h), mesh.place(g), p_, place))) {
                    if (top + 1 == open + room) return room;
                    mesh.flip(h, g, g2);
                    --flips_left;
                    top->cross = db;
                    top->edge = g2;
                    *++top = {d, ad, h};
                    continue;
                }
            }
            if (top == open) return 0;
            from = top->to;
            --top;
        }
    }

private:
    half_edges& mesh_;
    grid_point p_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
