// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/boundary_cutter.hpp>
#include <typemesh/refine/impl/edge_splitter.hpp>
#include <typemesh/refine/impl/off_centre.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/impl/triangle_queue.hpp>
#include <typemesh/refine/impl/write_cap.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// What a refinement aims at, in cells.
struct refinement_limits {
    double tangent = 0.0;         ///< of the least angle
    double off_centre = 0.0;      ///< `farthest` of off_centre()
    std::int64_t max_square = 0;  ///< the square of the greatest length of an edge; 0: any length
    std::uint32_t max_points = default_max_points;
    bool boundary_only = false;  ///< edges inside may have any length

    /// For an angle in degrees, up to 33, and a length in cells; 0: any length.
    [[nodiscard]] static refinement_limits from(double min_angle, double longest, std::uint32_t max_points) noexcept
    {
        const double angle = min_angle * 0.017453292519943295, cosine = std::cos(angle);
        // To 24 bits after the point: the standard libraries' functions differ in the last bits of a double.
        const auto rounded = [](double v) noexcept { return std::floor(v * 0x1p24 + 0.5) * 0x1p-24; };
        refinement_limits limits;
        limits.tangent = rounded(std::tan(angle));
        limits.off_centre = cosine < 1.0 ? rounded(0.475 * std::sqrt((1.0 + cosine) / (1.0 - cosine))) : 1.0;
        limits.max_square = longest < grid::reach ? static_cast<std::int64_t>(longest * longest) : 0;
        limits.max_points = max_points;
        return limits;
    }
};

/// Adds points until no angle is too small and no edge too long: Ruppert's algorithm with off-centres.
///
///     boundary edges   An edge is split while a point of the mesh lies in its diametral circle, or while it is too
///                      long: see edge_splitter.
///     triangles        Of a bad triangle the off-centre becomes a point: on the perpendicular through the middle of
///                      the shortest edge, as far from it as the least angle allows, but no farther than the centre of
///                      the circle around the triangle. A point that would lie in the diametral circle of a boundary
///                      edge is not added; that edge is split instead.
///     sharp corners    A triangle between two cuts at the same distance from a corner below 60 degrees keeps its
///                      angle.
///     spacing          No inner point is added within four cells of another point: rounding could otherwise go on for
///                      ever.
///
/// Whether the mesh stays valid is decided exactly. Whether a triangle is bad enough for a point is decided in double
/// precision: it can cost a point, never the mesh.
///
/// From  J. Ruppert, A Delaunay refinement algorithm for quality 2-dimensional mesh generation (1995); G. Miller,
///       S. Pav & N. Walkington, When and why Ruppert's algorithm works (2003); see also off_centre.hpp
class delaunay_refinement {
public:
    explicit delaunay_refinement(memory source = heap()) noexcept
        : mesh_{source}, edges_{source}, waiting_{source}, cavity_{source}, numbers_{source}
    {
    }

    /// Corners beyond the next region's edges: see boundary_cutter.
    void attach(array_view<const grid_point> corners) noexcept { edges_.attach(corners); }

    /// Fails  error::out_of_memory, error::too_many_points
    [[nodiscard]] error run(const region& r, array_view<const triangle> triangles,
                            const refinement_limits& limits) noexcept
    {
        region_ = &r;
        limits_ = limits;
        edges_.open(r, limits.max_square, limits.max_points);
        waiting_.clear();
        kept_ = 0;
        if (!mesh_.open(r, triangles)) return error::out_of_memory;
        for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
            if (!edges_.examine(mesh_, mesh_.at(v).boundary)) return error::out_of_memory;
        if (error e = split_edges()) return e;
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
            if (!check_triangle(t)) return error::out_of_memory;
        if (error e = settle()) return e;
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) kept_ += rank_of(t) != good;
        return {};
    }

    /// After run(): halves the boundary edge that leaves the point a, unless that is impossible, and refines what has
    /// become bad by it. Fails as run() does.
    [[nodiscard]] error halve(std::uint32_t a) noexcept
    {
        if (error e = split(a)) return e;
        if (error e = split_edges()) return e;
        return settle();
    }

    /// After run(): adds the centre of the circle around each of these triangles that is still there, or splits the
    /// boundary edges in its way, and refines what has become bad by it. Fails as run() does.
    [[nodiscard]] error add_centres(array_view<const queued_triangle> of) noexcept
    {
        for (const queued_triangle& one : of) {
            if (error e = improve(one, up_to_centre)) return e;
            if (error e = split_edges()) return e;
        }
        return settle();
    }

    /// Writes the refined cap. Fails with error::out_of_memory.
    [[nodiscard]] error write(const refined_cap& out) noexcept { return write_cap(mesh_, *region_, numbers_, out); }

    [[nodiscard]] const refinable_mesh& mesh() const noexcept { return mesh_; }
    /// Inner points may be added to it before write(), but not before halve().
    [[nodiscard]] refinable_mesh& mesh() noexcept { return mesh_; }

    /// The number of bad triangles that were left, because a point would have come too near to others.
    [[nodiscard]] std::uint32_t kept() const noexcept { return kept_; }

    /// What has split the boundary's edges.
    [[nodiscard]] const boundary_cutter& cutter() const noexcept { return edges_.cutter(); }

private:
    static constexpr std::uint32_t none = refinable_mesh::none;
    static constexpr std::uint32_t good = triangle_queue::ranks;
    static constexpr std::int64_t spacing = refinable_mesh::spacing;

    // ---- boundary edges

    /// What edge_splitter calls for the triangles that have changed.
    [[nodiscard]] auto check_triangles() noexcept
    {
        return [this](std::uint32_t t) noexcept { return check_triangle(t); };
    }
    [[nodiscard]] error split(std::uint32_t a) noexcept { return edges_.split(mesh_, a, check_triangles()); }
    [[nodiscard]] error split_edges() noexcept { return edges_.split_listed(mesh_, check_triangles()); }

    // ---- triangles

    /// Adds points until nothing that is listed is bad.
    [[nodiscard]] error settle() noexcept
    {
        while (waiting_.has_more()) {
            if (error e = improve(waiting_.pop(), limits_.off_centre)) return e;
            if (error e = split_edges()) return e;
            if (error e = edges_.too_many(mesh_)) return e;
        }
        return edges_.too_many(mesh_);
    }

    /// The rank of a bad triangle: small angles come first, at the shortest edges first; then long edges, the longest
    /// first. `good` if it is not bad.
    [[nodiscard]] std::uint32_t rank_of(std::uint32_t t) const noexcept
    {
        const std::uint32_t h = 4 * t, corners[] = {mesh_.origin(h), mesh_.origin(h + 1), mesh_.origin(h + 2)};
        const grid_point p[] = {mesh_.place(corners[0]), mesh_.place(corners[1]), mesh_.place(corners[2])};
        const std::int64_t squares[] = {squared_distance(p[0], p[1]), squared_distance(p[1], p[2]),
                                        squared_distance(p[2], p[0])};
        const std::size_t first = squares[1] < squares[0] ? 1 : 0, least = squares[2] < squares[first] ? 2 : first,
                          next = least == 2 ? 0 : least + 1, apex = 3 - least - next;
        // Twice the product of two edges with an angle between them, by the law of cosines.
        const std::int64_t cosine = (squares[next] + squares[apex] - squares[least]) / 2,
                           sine = orientation(p[0], p[1], p[2]);
        if (cosine > 0 && static_cast<double>(sine) < limits_.tangent * static_cast<double>(cosine) &&
            !is_between_shells(corners[least], corners[next], static_cast<double>(sine) / static_cast<double>(cosine)))
            return triangle_queue::rank_of(squares[least]);
        const std::int64_t longer = squares[next] < squares[apex] ? squares[apex] : squares[next];
        return !limits_.boundary_only && edges_.is_too_long(longer)
                   ? triangle_queue::ranks - 1 - triangle_queue::rank_of(longer)
                   : good;
    }

    /// Whether two points lie on two boundary edges that meet in a sharp corner, equally far from it, and the angle
    /// opposite, whose tangent is given, is as large as the corner allows: arctan(sin c / (2 - cos c)), less a fiftieth
    /// for rounding.
    [[nodiscard]] bool is_between_shells(std::uint32_t u, std::uint32_t v, double tangent) const noexcept
    {
        const std::size_t n = region_->points().size();
        if (u < n || v < n) return false;
        const std::uint32_t edge_u = mesh_.at(u).source, edge_v = mesh_.at(v).source;
        if (edge_u == none || edge_v == none || edge_u == edge_v) return false;
        const std::uint32_t after_u = cutter().next_point(edge_u), after_v = cutter().next_point(edge_v);
        const std::uint32_t between = after_u == edge_v ? edge_v : after_v == edge_u ? edge_u : none;
        if (between == none) return false;
        const edge_splitter::corner c = edges_.corner_at(mesh_, between);
        if (!c.is_sharp()) return false;
        const auto sine = static_cast<double>(c.sine), cosine = static_cast<double>(c.cosine);
        if (tangent * (2.0 * std::sqrt(sine * sine + cosine * cosine) - cosine) < 0.98 * sine) return false;
        const auto far_u = static_cast<double>(squared_distance(mesh_.place(between), mesh_.place(u))),
                   far_v = static_cast<double>(squared_distance(mesh_.place(between), mesh_.place(v)));
        const double difference = std::sqrt(far_u) - std::sqrt(far_v);
        return difference < 4.0 && difference > -4.0;
    }

    /// Lists a triangle if it is bad. False if out of memory.
    [[nodiscard]] bool check_triangle(std::uint32_t t) noexcept
    {
        const std::uint32_t rank = rank_of(t);
        return rank == good || waiting_.push(rank, queued_triangle::of(mesh_, t));
    }

    /// Adds the off-centre of a bad triangle that is still there, or splits a boundary edge that is in its way.
    [[nodiscard]] error improve(const queued_triangle& bad, double farthest) noexcept
    {
        if (!bad.is_in(mesh_)) return {};
        const std::uint32_t short_edge = shortest_edge(bad.t);
        const grid_point p = detail::off_centre(mesh_.start(short_edge), mesh_.place(mesh_.target(short_edge)),
                                                mesh_.place(mesh_.apex(short_edge)), farthest);
        const auto [t, blocked] = mesh_.locate(bad.t, p);
        if (blocked != none) return force(blocked, bad);
        bool is_far = false;
        if (t != none) {
            const auto entered = enter(t, p);
            if (!entered) return entered.error();
            is_far = *entered;
        }
        if (!is_far) return {};
        if (encroached_ != none) return force(encroached_, bad);
        const std::uint32_t v = mesh_.insert(t, p);
        if (v == none || !edges_.check_changed(mesh_, check_triangles())) return error::out_of_memory;
        return {};
    }

    /// Splits a boundary edge for a bad triangle, which is listed again if it is still there.
    [[nodiscard]] error force(std::uint32_t a, const queued_triangle& bad) noexcept
    {
        const std::uint32_t before = mesh_.vertex_count();
        if (error e = split(a)) return e;
        if (mesh_.vertex_count() == before) return {};
        return !bad.is_in(mesh_) || check_triangle(bad.t) ? error{} : error{error::out_of_memory};
    }

    [[nodiscard]] std::int64_t squared_length(std::uint32_t h) const noexcept
    {
        return squared_distance(mesh_.start(h), mesh_.place(mesh_.target(h)));
    }
    [[nodiscard]] std::uint32_t shortest_edge(std::uint32_t t) const noexcept
    {
        std::uint32_t least = 4 * t;
        for (std::uint32_t h = least + 1; h < 4 * t + 3; ++h)
            if (squared_length(h) < squared_length(least)) least = h;
        return least;
    }

    /// Visits the triangles whose circles hold p. Returns whether p is far enough from all their corners. encroached_
    /// is the first point of a boundary edge around them whose diametral circle holds p, or none.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] result<bool> enter(std::uint32_t t, grid_point p) noexcept
    {
        encroached_ = none;
        cavity_.clear();
        if (!cavity_.push_back(t)) return error::out_of_memory;
        bool is_far = true;
        const std::uint32_t seen = mesh_.new_mark();
        mesh_.mark(t) = seen;
        while (!cavity_.empty()) {
            const std::uint32_t in = cavity_.back();
            cavity_.truncate(cavity_.size() - 1);
            for (std::uint32_t h = 4 * in; h < 4 * in + 3; ++h) {
                const grid_point a = mesh_.start(h);
                is_far = is_far && squared_distance(a, p) >= spacing * spacing;
                const std::uint32_t g = mesh_.twin(h);
                if (g == none) {
                    if (refinable_mesh::dot(p, a, mesh_.place(mesh_.target(h))) < 0) encroached_ = mesh_.origin(h);
                    continue;
                }
                const std::uint32_t beyond = g / 4;
                if (mesh_.mark(beyond) == seen) continue;
                if (in_circle(mesh_.start(4 * beyond), mesh_.start(4 * beyond + 1), mesh_.start(4 * beyond + 2), p) <=
                    0)
                    continue;
                mesh_.mark(beyond) = seen;
                if (!cavity_.push_back(beyond)) return error::out_of_memory;
            }
        }
        return is_far;
    }

    refinable_mesh mesh_;
    edge_splitter edges_;
    triangle_queue waiting_;
    buffer<std::uint32_t> cavity_;
    buffer<std::uint32_t> numbers_;
    const region* region_ = nullptr;
    refinement_limits limits_;
    std::uint32_t kept_ = 0;
    std::uint32_t encroached_ = none;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
