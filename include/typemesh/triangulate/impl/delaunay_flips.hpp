// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/triangulate/impl/half_edges.hpp>
#include <typemesh/triangulate/impl/point_star.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Makes and keeps a triangulation Delaunay: flips edges, starting with the edges on a stack, until all pass the test.
///
/// The number of flips can be quadratic in the worst case, so there is a budget. It is checked once per flip, or once
/// per inserted point; a point may need as many flips as triangles meet in it.
///
/// From  C. Lawson, Software for C1 surface interpolation (1977); S. Sloan, A fast algorithm for generating
///       constrained Delaunay triangulations (1993)
class delaunay_flips {
public:
    delaunay_flips(half_edges& mesh, array_view<const grid_point> points, std::uint64_t budget) noexcept
        : mesh_{mesh}, points_{points}, left_{static_cast<std::int64_t>(budget)}
    {
    }

    /// Takes memory for a mesh of that many triangles. False if out of memory.
    [[nodiscard]] bool open(workspace::scope& scratch, std::size_t triangles) noexcept
    {
        room_ = 4 * triangles + room_of_star;
        stack_ = scratch.take<std::uint32_t>(room_);
        return stack_ != nullptr;
    }

    /// Makes the whole mesh Delaunay. False if the budget runs out.
    [[nodiscard]] bool everywhere() noexcept
    {
        do {
            overflow_ = false;
            size_ = 0;
            for (std::uint32_t t = 0; t < mesh_.end(); t += 4) {
                for (std::uint32_t h = t; h < t + 3; ++h) {  // each inner edge once
                    stack_[size_] = h;
                    size_ += mesh_.is_first_half(h);
                }
            }
            around();
        } while (overflow_ && left_ > 0);
        return left_ > 0;
    }

    /// Makes p the boundary point after `before`. The mesh is Delaunay and stays so.
    ///
    /// False if p is hidden from the boundary edge, if the budget is spent, and in rare cases for a visible p beyond
    /// the edge's triangle. The mesh is then unusable.
    [[nodiscard]] bool insert(std::uint32_t before, std::uint32_t p) noexcept
    {
        const std::uint32_t h = mesh_.boundary_from(before), h1 = half_edges::next(h), h2 = half_edges::previous(h);
        const grid_point at = points_[p];
        const point_star star{mesh_, at};
        const seen_point a = star.origin(h), b = star.origin(h1), c = star.origin(h2);
        const std::int64_t ab = a.cross(b), bc = b.cross(c), ca = c.cross(a);
        if (ab < 0) {  // beyond the boundary edge
            const int side = circle_side(b, a, c, -ab, bc, ca);
            if (side < 0 || (side == 0 && !breaks_tie(mesh_.place(h), mesh_.place(h1), mesh_.place(h2), at))) {
                mesh_.add_ear(h, p);
                return true;
            }  // otherwise an ear and a flip, which equals a dent
        }
        const std::uint32_t bc_edge = mesh_.dent(h, p);
        if (bc > 0 && ca > 0) {
            point_star::open_edge open[room_of_star];
            open[0] = {a, ca, h2};
            open[1] = {c, bc, bc_edge};
            const std::size_t left_open = star.close(b, open, 2, room_of_star, left_);
            return left_open == 0 ? left_ > 0 : around({open, left_open});
        }
        stack_[0] = bc_edge;
        stack_[1] = h2;
        return pull_to_apex(p);
    }

private:
    static constexpr std::size_t room_of_star = 32;

    void push(std::uint32_t h) noexcept
    {
        if (size_ < room_)
            stack_[size_++] = h;
        else
            overflow_ = true;
    }

    [[nodiscard]] static bool wants_flip(const half_edges& mesh, std::uint32_t h, std::uint32_t g) noexcept
    {
        return prefers_other_diagonal(mesh.place(h), mesh.place(g), mesh.place(half_edges::previous(h)),
                                      mesh.place(half_edges::previous(g)));
    }

    /// Continues from the edges of a star for which there was no room. False if the budget is spent.
    [[nodiscard]] bool around(array_view<const point_star::open_edge> star) noexcept
    {
        for (std::size_t i = 0; i < star.size(); ++i) stack_[i] = star[i].edge;
        size_ = star.size();
        overflow_ = false;
        around();
        return !overflow_ && left_ > 0;
    }

    /// Flips until the stack is empty or the budget is spent; a flip pushes the four edges around it.
    void around() noexcept
    {
        half_edges mesh = mesh_;  // local copies stay in registers
        std::uint32_t* const stack = stack_;
        std::size_t size = size_;
        std::int64_t left = left_;
        while (size != 0 && left > 0) {
            const std::uint32_t h = stack[--size], g = mesh.twin(h);
            if (mesh.is_rim(g)) continue;
            const std::uint32_t h2 = half_edges::previous(h), g2 = half_edges::previous(g);
            if (!prefers_other_diagonal(mesh.place(h), mesh.place(g), mesh.place(h2), mesh.place(g2))) continue;
            mesh.flip(h, g, g2);
            --left;
            if (room_ - size < 4) {
                overflow_ = true;
                continue;
            }
            stack[size] = g2;
            stack[size + 1] = g;
            stack[size + 2] = h2;
            stack[size + 3] = h;
            size += 4;
        }
        size_ = size;
        left_ = left;
    }

    /// The same if p lies beyond its triangle, so that some triangle at p is clockwise. The edge of that triangle
    /// opposite p must be flipped, whatever the circles say, until everything between p and its boundary edge is joined
    /// to p.
    [[nodiscard]] bool pull_to_apex(std::uint32_t p) noexcept
    {
        std::size_t size = 2;
        while (size != 0) {
            const std::uint32_t h = stack_[--size];
            const bool is_behind = orientation(mesh_.place(half_edges::previous(h)), mesh_.place(h),
                                               mesh_.place(half_edges::next(h))) <= 0;
            if (mesh_.is_boundary(h)) {
                if (is_behind) return false;
                continue;
            }
            const std::uint32_t g = mesh_.twin(h);
            if (!is_behind && !wants_flip(mesh_, h, g)) continue;
            mesh_.flip(h);
            --left_;
            stack_[size++] = half_edges::previous(g);
            stack_[size++] = h;
        }
        // Edges that were joined by force may not be Delaunay: the edges that leave p are tested too.
        size_ = 0;
        for (std::uint32_t h = mesh_.boundary_from(p);;) {
            h = half_edges::previous(h);
            if (mesh_.is_boundary(h)) break;
            push(h);
            h = mesh_.twin(h);
        }
        around();
        return !overflow_ && left_ > 0;
    }

    half_edges& mesh_;
    array_view<const grid_point> points_;
    std::uint32_t* stack_ = nullptr;
    std::size_t room_ = 0;
    std::size_t size_ = 0;
    std::int64_t left_;  // flips
    bool overflow_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
