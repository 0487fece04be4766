// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/refine/impl/boundary_cutter.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <bit>
#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Splits the boundary edges of a refinable_mesh, and lists those that must be split.
///
///     must be split    while a corner opposite lies in the circle around the edge (its *diametral* circle), or while
///                      the edge is too long
///     where            in the middle. At a corner below 60 degrees edges are cut at powers of two from it, so that
///                      neighbours are cut at the same distance. On the curve, if boundary_cutter allows that
///     never            within four cells of an edge's ends
///
/// An edge has the number of the point that it leaves. look(t), which the caller gives, is called for each triangle
/// that a split has made or changed, once; it returns false if it is out of memory.
class edge_splitter {
public:
    static constexpr std::uint32_t none = refinable_mesh::none;

    explicit edge_splitter(memory source = heap()) noexcept : cut_{source}, listed_{source} {}

    /// Corners beyond the next region's edges: see boundary_cutter.
    void attach(array_view<const grid_point> corners) noexcept { cut_.attach(corners); }

    /// Begins with a region, which must outlive the calls that follow, and an empty list. No edge may be longer than
    /// the root of max_square; 0: any length.
    void open(const region& r, std::int64_t max_square, std::uint32_t max_points) noexcept
    {
        region_ = &r;
        max_square_ = max_square;
        max_points_ = max_points;
        cut_.open(r);
        listed_.clear();
    }

    [[nodiscard]] const boundary_cutter& cutter() const noexcept { return cut_; }

    /// error::too_many_points if a mesh has more than max_points.
    [[nodiscard]] error too_many(const refinable_mesh& mesh) const noexcept
    {
        return mesh.vertex_count() > max_points_ ? error{error::too_many_points, max_points_} : error{};
    }

    [[nodiscard]] bool is_too_long(std::int64_t square) const noexcept
    {
        return max_square_ != 0 && square > max_square_;
    }

    /// The inner angle of a corner; both numbers are 0 for points that are not the region's own.
    struct corner {
        std::int64_t sine = 0, cosine = 0;  // times the lengths of both edges

        /// Below 60 degrees.
        [[nodiscard]] bool is_sharp() const noexcept
        {
            constexpr double tangent = 1.7320508075688772;
            return cosine > 0 && sine > 0 && static_cast<double>(sine) < tangent * static_cast<double>(cosine);
        }
    };
    [[nodiscard]] corner corner_at(const refinable_mesh& mesh, std::uint32_t v) const noexcept
    {
        if (v >= region_->points().size()) return {};
        const grid_point at = mesh.place(v), p = mesh.place(mesh.next_on_boundary(v)),
                         q = mesh.place(mesh.previous_on_boundary(v));
        return {orientation(at, p, q), refinable_mesh::dot(at, p, q)};
    }

    // ---- the list, a stack

    /// Lists an edge. False if out of memory.
    [[nodiscard]] bool list(std::uint32_t a) noexcept { return listed_.push_back(a); }

    /// Lists the edge whose half-edge is h if it must be split. False if out of memory.
    [[nodiscard]] bool examine(const refinable_mesh& mesh, std::uint32_t h) noexcept
    {
        return !must_split(mesh, h) || list(mesh.origin(h));
    }

    /// Takes an edge from the list; none if it is empty.
    [[nodiscard]] std::uint32_t take() noexcept
    {
        if (listed_.empty()) return none;
        const std::uint32_t a = listed_.back();
        listed_.truncate(listed_.size() - 1);
        return a;
    }

    /// Splits what is listed, and must be split still, until the list is empty.
    ///
    /// Fails  error::out_of_memory, error::too_many_points
    template <class Look>
    [[nodiscard]] error split_listed(refinable_mesh& mesh, Look&& look) noexcept
    {
        for (std::uint32_t a = take(); a != none; a = take()) {
            if (!must_split(mesh, mesh.at(a).boundary)) continue;
            if (error e = split(mesh, a, look)) return e;
            if (error e = too_many(mesh)) return e;
        }
        return {};
    }

    /// After a split or an insertion: looks at the triangles that it has changed, and lists their edges that must be
    /// split. False if out of memory.
    template <class Look>
    [[nodiscard]] bool check_changed(refinable_mesh& mesh, Look&& look) noexcept
    {
        const std::uint32_t seen = mesh.new_mark();
        for (const std::uint32_t t : mesh.changed()) {
            if (mesh.mark(t) == seen) continue;
            mesh.mark(t) = seen;
            if (!look(t)) return false;
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h)
                if (mesh.is_boundary(h) && !examine(mesh, h)) return false;
        }
        return true;
    }

    // ---- splits

    /// Splits the edge that leaves a, unless that is impossible. Fails with error::out_of_memory.
    template <class Look>
    [[nodiscard]] error split(refinable_mesh& mesh, std::uint32_t a, Look&& look) noexcept
    {
        const std::uint32_t b = mesh.next_on_boundary(a);
        const std::int64_t square = squared_distance(mesh.place(a), mesh.place(b));
        if (is_too_short(square)) return {};
        const bool from_a = corner_at(mesh, a).is_sharp(), from_b = corner_at(mesh, b).is_sharp();
        const double share = from_a == from_b ? 0.5 : from_a ? shell_in(square) : 1.0 - shell_in(square);
        const contour_edge edge = mesh.at(a).edge;
        double t = as_double(edge.t0) + share * (as_double(edge.t1) - as_double(edge.t0));
        if (from_a != from_b && cut_.ends_on_curve(mesh.at(a).source))
            t = cut_.parameter_at(edge, from_a,
                                  (from_a ? share : 1.0 - share) * std::sqrt(static_cast<double>(square)));
        return checked(mesh, cut_(mesh, a, share, t), look);
    }

    /// Splits it at a place of the caller's: see boundary_cutter::split_at().
    template <class Look>
    [[nodiscard]] error split_at(refinable_mesh& mesh, std::uint32_t a, const boundary_cutter::places& at,
                                 Look&& look) noexcept
    {
        return checked(mesh, cut_.split_at(mesh, a, at), look);
    }

    /// Whether an edge with this square of its length has no place for a point.
    [[nodiscard]] static bool is_too_short(std::int64_t square) noexcept
    {
        return square < 4 * refinable_mesh::spacing * refinable_mesh::spacing;
    }

private:
    [[nodiscard]] bool must_split(const refinable_mesh& mesh, std::uint32_t h) const noexcept
    {
        const grid_point p = mesh.start(h), q = mesh.place(mesh.target(h));
        return refinable_mesh::dot(mesh.place(mesh.apex(h)), p, q) < 0 || is_too_long(squared_distance(p, q));
    }

    template <class Look>
    [[nodiscard]] error checked(refinable_mesh& mesh, const result<std::uint32_t>& made, Look&& look) noexcept
    {
        if (!made) return made.error();
        return *made == none || check_changed(mesh, look) ? error{} : error{error::out_of_memory};
    }

    /// The share of an edge at a sharp corner that is cut off: a power of two cells, a third to two thirds of the edge.
    [[nodiscard]] static double shell_in(std::int64_t square) noexcept
    {
        const int power = (static_cast<int>(std::bit_width(static_cast<std::uint64_t>(square))) - 1) / 2;
        const double length = std::sqrt(static_cast<double>(square)), shell = std::ldexp(1.0, power);
        return (3.0 * shell > 2.0 * length ? 0.5 * shell : shell) / length;
    }

    boundary_cutter cut_;
    buffer<std::uint32_t> listed_;
    const region* region_ = nullptr;
    std::int64_t max_square_ = 0;
    std::uint32_t max_points_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
