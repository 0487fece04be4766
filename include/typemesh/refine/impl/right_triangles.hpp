// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/boundary_cutter.hpp>
#include <typemesh/refine/impl/radical_weights.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Whether the corner between two edges, given as vectors from it, is a right angle or less, or
/// larger only by rounding: each coordinate of a vector may have moved by one and a half cells.
[[nodiscard]] constexpr bool is_right_or_less(std::int64_t px, std::int64_t py, std::int64_t qx,
                                              std::int64_t qy) noexcept
{
    const auto size = [](std::int64_t v) noexcept { return v < 0 ? -v : v; };
    return 2 * (px * qx + py * qy) + 3 * (size(px) + size(py) + size(qx) + size(qy)) + 9 >= 0;
}

/// Divides each triangle of a mesh into six at its radical centre and the feet on its edges, rounded to the grid.
///
///             c                 Feet inside and radical centres move by half a cell at most, in x and in y. A foot on
///           / | \               the boundary moves by less than a cell, to the inner side of its edge, so the boundary
///         /   |   \             remains simple. Where the nearest cell would turn a triangle, a centre moves by less
///       f2-___o___-f1           than a cell.
///       /     |     \           Triangles that are too small for that remain whole. An edge between such a triangle
///      a------f3-----b          and one that is divided has no foot, so that fewer than six triangles remain there.
///                               Whether the triangles are valid is decided exactly.
class right_triangles {
public:
    explicit right_triangles(memory source = heap()) noexcept
        : feet_{source}, centres_{source}, waiting_{source}, numbers_{source}
    {
    }

    /// `cut` knows which feet the boundary allows. False if out of memory.
    [[nodiscard]] bool divide(const refinable_mesh& mesh, const radical_weights& weights,
                              const boundary_cutter& cut) noexcept
    {
        feet_.clear();
        centres_.clear();
        waiting_.clear();
        foot* const feet = feet_.append(mesh.end());
        centre* const centres = centres_.append(mesh.triangle_count());
        if (feet == nullptr || centres == nullptr) return false;
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h)
                if (is_first(mesh, h)) feet[h] = foot_of(mesh, weights, cut, h);
            centres[t] = {centre_at(mesh, weights, t, 0), true};
        }
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            if (!waiting_.push_back(t)) return false;
            while (!waiting_.empty()) {
                const std::uint32_t one = waiting_.back();
                waiting_.truncate(waiting_.size() - 1);
                if (centres[one].is_used && !find_centre(mesh, weights, one) && !leave_whole(mesh, one)) return false;
            }
        }
        return true;
    }

    /// The number of points, and of triangles that have a larger angle than rounding explains.
    struct counts {
        std::uint32_t points = 0, obtuse = 0;
    };
    [[nodiscard]] counts count(const refinable_mesh& mesh) const noexcept
    {
        counts all;
        all.points = mesh.vertex_count();
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            all.points += centres_[t].is_used;
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h) all.points += is_first(mesh, h) && feet_[h].is_used;
            each_part(mesh, t, [&](corner a, corner b, corner c) noexcept { all.obtuse += is_obtuse(a, b, c); });
        }
        return all;
    }

    /// Writes the cap of a region whose mesh is divided. Fails with error::out_of_memory.
    [[nodiscard]] error write(const refinable_mesh& mesh, const region& of, const refined_cap& out) noexcept
    {
        numbers_.clear();
        std::uint32_t* const number = numbers_.append(mesh.vertex_count());
        if (number == nullptr) return error::out_of_memory;
        out.loops.clear();
        out.inner.clear();
        out.triangles.clear();
        const auto all = of.starts();
        for (std::size_t loop = 0; loop + 1 < all.size(); ++loop) {
            if (!out.loops.starts.push_back(static_cast<std::uint32_t>(out.loops.points.size())))
                return error::out_of_memory;
            std::uint32_t v = all[loop];
            do {
                number[v] = static_cast<std::uint32_t>(out.loops.points.size());
                if (!write_edge(mesh.at(v), feet_[mesh.at(v).boundary], out.loops)) return error::out_of_memory;
                v = mesh.next_on_boundary(v);
            } while (v != all[loop]);
        }
        if (!out.loops.starts.push_back(static_cast<std::uint32_t>(out.loops.points.size())))
            return error::out_of_memory;
        return write_inside(mesh, out) ? write_source(of, out.loops) : error{error::out_of_memory};
    }

private:
    static constexpr std::uint32_t none = refinable_mesh::none;

    struct foot {
        grid_point place;
        bool is_used = false;
        float share = 0.5f;
        std::uint32_t number = none;  // in the cap that is written
    };
    struct centre {
        grid_point place;
        bool is_used = false;
        std::uint32_t number = none;
    };
    /// A point of a divided triangle.
    struct corner {
        grid_point place;
        std::uint32_t number;  // in the cap that is written; for a point of the mesh, its number there
        bool is_added;
    };

    /// Whether h stands for its edge: of two twins, only one does.
    [[nodiscard]] static bool is_first(const refinable_mesh& mesh, std::uint32_t h) noexcept
    {
        return mesh.is_boundary(h) || h < mesh.twin(h);
    }
    [[nodiscard]] static std::uint32_t first_of(const refinable_mesh& mesh, std::uint32_t h) noexcept
    {
        return is_first(mesh, h) ? h : mesh.twin(h);
    }

    [[nodiscard]] static foot foot_of(const refinable_mesh& mesh, const radical_weights& weights,
                                      const boundary_cutter& cut, std::uint32_t h) noexcept
    {
        const grid_point p = mesh.start(h), q = mesh.place(mesh.target(h));
        const double share =
            weights.foot_share(mesh.origin(h), mesh.target(h), static_cast<double>(squared_distance(p, q)));
        foot made;
        if (!(share > 0.0 && share < 1.0)) return made;
        made.share = static_cast<float>(share);
        const point on = lerp(boundary_cutter::as_point(p), boundary_cutter::as_point(q), share);
        for (const int next_best : {0, 1, 2, 3}) {
            made.place = boundary_cutter::rounded(on, next_best);
            made.is_used = made.place != p && made.place != q;
            if (!mesh.is_boundary(h)) break;
            if (orientation(p, q, made.place) >= 0 && cut.is_attachable(mesh, mesh.origin(h), made.place)) break;
            made.is_used = false;
        }
        return made;
    }

    /// Visits the triangles into which a triangle is divided.
    template <class Visit>
    void each_part(const refinable_mesh& mesh, std::uint32_t t, Visit&& visit) const noexcept
    {
        corner around[3];
        for (std::uint32_t k = 0; k < 3; ++k) around[k] = {mesh.start(4 * t + k), mesh.origin(4 * t + k), false};
        if (!centres_[t].is_used) {
            visit(around[0], around[1], around[2]);
            return;
        }
        const corner middle{centres_[t].place, centres_[t].number, true};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const corner from = around[k], to = around[(k + 1) % 3];
            const foot& f = feet_[first_of(mesh, 4 * t + k)];
            if (!f.is_used) {
                visit(from, to, middle);
                continue;
            }
            const corner between{f.place, f.number, true};
            visit(from, between, middle);
            visit(between, to, middle);
        }
    }

    /// The radical centre of a triangle, rounded to a corner of the grid's cell around it, the nearest one first. A
    /// centre that is far away, or no number, is no centre: it becomes a corner, and the triangle stays whole.
    [[nodiscard]] static grid_point centre_at(const refinable_mesh& mesh, const radical_weights& weights,
                                              std::uint32_t t, int next_best) noexcept
    {
        const grid_point from = mesh.start(4 * t);
        const point off = weights.centre_of(mesh, t), at{from.x + off.x, from.y + off.y};
        const bool is_near = at.x > -0x1p28 && at.x < 0x1p28 && at.y > -0x1p28 && at.y < 0x1p28;
        return is_near ? boundary_cutter::rounded(at, next_best) : from;
    }

    /// Finds a place for a triangle's centre with which its parts are valid. False if there is none.
    [[nodiscard]] bool find_centre(const refinable_mesh& mesh, const radical_weights& weights, std::uint32_t t) noexcept
    {
        for (const int next_best : {0, 1, 2, 3}) {
            centres_[t].place = centre_at(mesh, weights, t, next_best);
            if (is_valid(mesh, t)) return true;
        }
        return false;
    }

    [[nodiscard]] bool is_valid(const refinable_mesh& mesh, std::uint32_t t) const noexcept
    {
        bool valid = true;
        each_part(mesh, t, [&](corner a, corner b, corner c) noexcept {
            valid = valid && orientation(a.place, b.place, c.place) > 0;
        });
        return valid;
    }

    /// Takes the centre and the feet of a triangle away. False if out of memory.
    [[nodiscard]] bool leave_whole(const refinable_mesh& mesh, std::uint32_t t) noexcept
    {
        centres_[t].is_used = false;
        for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h) {
            feet_[first_of(mesh, h)].is_used = false;
            if (!mesh.is_boundary(h) && !waiting_.push_back(mesh.twin(h) / 4)) return false;
        }
        return true;
    }

    [[nodiscard]] static bool is_obtuse(corner a, corner b, corner c) noexcept
    {
        const auto is_wide = [](grid_point at, grid_point p, grid_point q) noexcept {
            return !is_right_or_less(std::int64_t{p.x} - at.x, std::int64_t{p.y} - at.y, std::int64_t{q.x} - at.x,
                                     std::int64_t{q.y} - at.y);
        };
        return is_wide(a.place, b.place, c.place) || is_wide(b.place, c.place, a.place) ||
               is_wide(c.place, a.place, b.place);
    }

    /// Writes a boundary point and the foot on the edge that leaves it. False if out of memory.
    [[nodiscard]] static bool write_edge(const refinable_mesh::vertex& v, foot& f, contours& loops) noexcept
    {
        contour_edge before = v.edge, after = v.edge;
        if (f.is_used) before.t1 = after.t0 = v.edge.t0 + f.share * (v.edge.t1 - v.edge.t0);
        if (!loops.points.push_back(v.place) || !loops.edges.push_back(before)) return false;
        if (!f.is_used) return true;
        f.number = static_cast<std::uint32_t>(loops.points.size());
        return loops.points.push_back(f.place) && loops.edges.push_back(after);
    }

    /// Writes the points inside, and all triangles. False if out of memory.
    [[nodiscard]] bool write_inside(const refinable_mesh& mesh, const refined_cap& out) noexcept
    {
        auto count = static_cast<std::uint32_t>(out.loops.points.size());
        const auto add = [&](grid_point p, std::uint32_t& number) noexcept {
            number = count++;
            return out.inner.push_back(p);
        };
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            if (mesh.at(v).boundary == none && !add(mesh.place(v), numbers_[v])) return false;
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h) {
                foot& f = feet_[h];
                if (!mesh.is_boundary(h) && is_first(mesh, h) && f.is_used && !add(f.place, f.number)) return false;
            }
            if (centres_[t].is_used && !add(centres_[t].place, centres_[t].number)) return false;
        }
        bool fits = true;
        const auto number = [&](const corner& c) noexcept { return c.is_added ? c.number : numbers_[c.number]; };
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t)
            each_part(mesh, t, [&](corner a, corner b, corner c) noexcept {
                fits = fits && out.triangles.push_back({number(a), number(b), number(c)});
            });
        return fits;
    }

    [[nodiscard]] static error write_source(const region& of, contours& loops) noexcept
    {
        loops.curves = of.curves();
        loops.grid = of.grid();
        loops.tolerance = of.tolerance();
        loops.corners = of.corners();
        return {};
    }

    buffer<foot> feet_;       // for each half-edge that stands for its edge
    buffer<centre> centres_;  // for each triangle
    buffer<std::uint32_t> waiting_;
    buffer<std::uint32_t> numbers_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
