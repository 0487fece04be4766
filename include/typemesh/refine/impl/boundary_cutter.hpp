// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/refine/impl/boundary_buckets.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Splits boundary edges of a refinable_mesh. The new point lies on the edge's curve if the region's edge ends on the
/// curve and the new point keeps the mesh valid; otherwise it lies on the edge itself.
///
///           c                p must lie to the left of c a and to the right of c b. Beyond a b, the triangle a, p, b
///         /   \              must meet no other boundary edge. Both are decided exactly.
///       a-------b
///        '--p--'  curve
class boundary_cutter {
public:
    static constexpr std::uint32_t none = refinable_mesh::none;
    static constexpr int halvings = 40;  ///< of an interval of parameters; a contour_edge's have 24 bits

    explicit boundary_cutter(memory source = heap()) noexcept : near_{source} {}

    /// For the next region: its edge i is also an edge of a triangle of another surface, whose third corner is
    /// corners[i]. Only points are added that leave the triangles between this corner and the edge's parts as they lie.
    /// If the corner lies on the edge, none is added. The corners must outlive the calls that follow.
    void attach(array_view<const grid_point> corners) noexcept { next_attached_ = corners; }

    /// Begins with a region, which must outlive the calls that follow.
    void open(const region& r) noexcept
    {
        region_ = &r;
        near_.clear();
        attached_ = next_attached_;
        next_attached_ = {};
    }

    /// Whether the triangles of another surface allow the point p on the boundary edge that leaves a: see attach().
    [[nodiscard]] bool is_attachable(const refinable_mesh& mesh, std::uint32_t a, grid_point p) const noexcept
    {
        if (attached_.empty()) return true;
        const grid_point from = mesh.place(a), to = mesh.place(mesh.next_on_boundary(a)),
                         r = attached_[mesh.at(a).source];
        const bool is_left = orientation(from, to, r) > 0;
        const std::int64_t before = orientation(from, p, r), after = orientation(p, to, r);
        return is_left ? before > 0 && after > 0 : before < 0 && after < 0;
    }

    /// Splits the boundary edge that leaves a at the parameter t of its curve, or at a share of its length. Returns the
    /// new point; none if there is no valid one.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] result<std::uint32_t> operator()(refinable_mesh& mesh, std::uint32_t a, double share,
                                                   double t) noexcept
    {
        const grid_point p = mesh.place(a), q = mesh.place(mesh.next_on_boundary(a));
        const point on_chord = lerp(as_point(p), as_point(q), share);
        if (!ends_on_curve(mesh.at(a).source)) return split_at(mesh, a, {t, on_chord});
        const point on_curve = place_on(mesh.at(a).edge.curve, t);
        return split_at(mesh, a, {t, on_chord, on_curve, is_close(on_curve, on_chord, squared_distance(p, q))});
    }

    /// The places for a new point of an edge.
    struct places {
        double t;  ///< the curve's parameter
        point on_chord;
        point on_curve = {};
        bool allows_curve = false;  ///< whether on_curve comes first
    };

    /// Whether a place on the curve is so close to the edge's own that it comes first, for an edge of this squared
    /// length.
    [[nodiscard]] static bool is_close(point on_curve, point on_chord, std::int64_t square) noexcept
    {
        const point off = on_curve - on_chord;
        return typemesh::dot(off, off) < max_rise * max_rise * static_cast<double>(square);
    }

    /// Splits the boundary edge that leaves a in the first of these cells that keeps the mesh valid: the nearest one to
    /// the place on the curve, then the four around the place on the edge. Returns the new point; none if all are
    /// invalid.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] result<std::uint32_t> split_at(refinable_mesh& mesh, std::uint32_t a, const places& at) noexcept
    {
        const auto t = static_cast<float>(at.t);
        if (at.allows_curve) {
            const auto made = try_split(mesh, a, rounded(at.on_curve, 0), t);
            if (!made || *made != none) return made;
        }
        for (const int next_best : {0, 1, 2, 3}) {
            const auto made = try_split(mesh, a, rounded(at.on_chord, next_best), t);
            if (!made || *made != none) return made;
        }
        return none;
    }

    /// Whether both ends of a region's edge lie on its curve. If not, the edge ends at a crossing, or it has moved
    /// away from the curve, which then says nothing about the places of its points.
    [[nodiscard]] bool ends_on_curve(std::uint32_t source) const noexcept
    {
        const contour_edge edge = region_->edges()[source];
        if (edge.curve >= region_->curves().size() || region_->curves()[edge.curve].degree == 1) return false;
        const point first = place_on(edge.curve, as_double(edge.t0)) - as_point(region_->points()[source]),
                    last = place_on(edge.curve, as_double(edge.t1)) - as_point(region_->points()[next_point(source)]);
        constexpr double most = max_end_error * max_end_error;
        return typemesh::dot(first, first) < most && typemesh::dot(last, last) < most;
    }

    /// Where an edge's curve is so far from the edge's first or last point, by bisection.
    [[nodiscard]] double parameter_at(const contour_edge& edge, bool from_first, double distance) const noexcept
    {
        double nearer = as_double(from_first ? edge.t0 : edge.t1), farther = as_double(from_first ? edge.t1 : edge.t0);
        const point from = place_on(edge.curve, nearer);
        for (int i = 0; i < halvings; ++i) {
            const double middle = 0.5 * (nearer + farther);
            const point off = place_on(edge.curve, middle) - from;
            (typemesh::dot(off, off) < distance * distance ? nearer : farther) = middle;
        }
        return nearer;
    }

    /// The region's point after another.
    [[nodiscard]] std::uint32_t next_point(std::uint32_t v) const noexcept
    {
        const array_view<const std::uint32_t> starts = region_->starts();
        std::size_t low = 0, high = starts.size() - 1;
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (starts[middle] <= v ? low : high) = middle;
        }
        return v + 1 < starts[high] ? v + 1 : starts[low];
    }

    /// A grid point in double precision.
    [[nodiscard]] static point as_point(grid_point p) noexcept
    {
        return {static_cast<double>(p.x), static_cast<double>(p.y)};
    }

    /// The place of a curve at t, in cells.
    [[nodiscard]] point place_on(std::uint32_t curve, double t) const noexcept
    {
        return region_->grid().cells * region_->curves()[curve].at(t);
    }

    /// A corner of the grid's cell around a place, the nearest one first.
    [[nodiscard]] static grid_point rounded(point at, int corner) noexcept
    {
        const double x = std::floor(at.x), y = std::floor(at.y);
        const bool right = (at.x - x < 0.5) == ((corner & 1) != 0), up = (at.y - y < 0.5) == ((corner & 2) != 0);
        return {static_cast<std::int32_t>(x) + right, static_cast<std::int32_t>(y) + up};
    }

private:
    /// How far a point on the curve may lie from its place on the chord, as a share of the chord: as an arc of 124
    /// degrees rises. Farther away, it would make a corner out of the edge.
    static constexpr double max_rise = 0.3;
    /// How far an edge's end may lie from its place on the curve, in cells: more than rounding to the grid explains.
    static constexpr double max_end_error = 2.0;

    /// Splits the edge that leaves a at p if that keeps the mesh valid. Returns the new point, or none.
    [[nodiscard]] result<std::uint32_t> try_split(refinable_mesh& mesh, std::uint32_t a, grid_point p, float t) noexcept
    {
        const std::uint32_t h = mesh.at(a).boundary;
        const grid_point from = mesh.place(a), to = mesh.place(mesh.target(h)), c = mesh.place(mesh.apex(h));
        if (orientation(from, p, c) <= 0 || orientation(p, to, c) <= 0) return none;
        if (refinable_mesh::dot(p, from, to) >= 0) return none;  // beyond an end
        constexpr std::int64_t nearest = refinable_mesh::spacing * refinable_mesh::spacing;
        if (squared_distance(p, from) < nearest || squared_distance(p, to) < nearest) return none;
        if (!is_attachable(mesh, a, p)) return none;
        if (orientation(from, to, p) < 0) {
            if (near_.is_stale(mesh) && !near_.open(mesh)) return error::out_of_memory;
            if (!near_.is_free(mesh, a, p)) return none;
        }
        const std::uint32_t v = mesh.split(a, p, t);
        if (v == none) return error::out_of_memory;
        if (!near_.is_stale(mesh) && (!near_.add(mesh, a) || !near_.add(mesh, v))) return error::out_of_memory;
        return v;
    }

    const region* region_ = nullptr;
    boundary_buckets near_;
    array_view<const grid_point> attached_, next_attached_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
