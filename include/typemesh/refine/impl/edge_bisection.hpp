// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/boundary_cutter.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/impl/stretched_circle.hpp>
#include <typemesh/refine/impl/triangle_queue.hpp>
#include <typemesh/refine/impl/write_cap.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Halves the edges of a region's triangles until none is too large for a measure. The measure may know directions, so
/// this adds fewer points than a mesh of well-shaped triangles needs:
///
///     +--------------+       +---+---+---+---+      for a measure of widths, tall triangles stay tall
///     |            . |       |  /|  /|  /|  /|
///     |       .      |  -->  | / | / | / | / |
///     |  .           |       |/  |/  |/  |/  |
///     +--------------+       +---+---+---+---+
///
///     measure.edge(p, q)          the size of a boundary edge
///     measure.triangle(p, q, r)   the size of a triangle
///     measure.length(p, q)        for the choice: the edge of a triangle with the greatest length is halved
///     measure.extents()           the extents on which sizes depend: detail::extents
///
/// With `boundary::keep`, boundary edges stay as they are, however large.
///
/// Sizes above 1, and sizes that are not a number, are too large. New points on the boundary lie on the curves, see
/// boundary_cutter. All inner edges stay Delaunay for
/// the measure's extents. The middle of an edge is decided exactly; where it would come within
/// four cells of a corner of the triangle in which it lies, the edge stays.
class edge_bisection {
public:
    enum class boundary : bool { keep, cut };

    explicit edge_bisection(memory source = heap()) noexcept
        : mesh_{source}, cut_{source}, edges_{source}, waiting_{source}, numbers_{source}
    {
    }

    /// Fails  error::out_of_memory, error::too_many_points
    template <class Measure>
    [[nodiscard]] error run(const region& r, array_view<const triangle> triangles, const Measure& measure,
                            std::uint32_t max_points, boundary edges = boundary::cut) noexcept
    {
        region_ = &r;
        cuts_boundary_ = edges == boundary::cut;
        cut_.open(r);
        edges_.clear();
        waiting_.clear();
        if (!mesh_.open(r, triangles, measure.extents())) return error::out_of_memory;
        for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v)
            if (is_too_large(measure, v) && !edges_.push_back(v)) return error::out_of_memory;
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
            if (!list(measure, t)) return error::out_of_memory;
        while (mesh_.vertex_count() <= max_points) {
            if (edges_.empty() && waiting_.empty()) return {};
            if (error e = halve_next(measure)) return e;
        }
        return {error::too_many_points, max_points};
    }

    /// Writes the refined cap. Fails with error::out_of_memory.
    [[nodiscard]] error write(const refined_cap& out) noexcept { return write_cap(mesh_, *region_, numbers_, out); }

    [[nodiscard]] const refinable_mesh& mesh() const noexcept { return mesh_; }

private:
    static constexpr std::uint32_t none = refinable_mesh::none;

    /// Halves the last edge of the list, or an edge of the last triangle.
    template <class Measure>
    [[nodiscard]] error halve_next(const Measure& measure) noexcept
    {
        if (!edges_.empty()) {
            const std::uint32_t v = edges_.back();
            edges_.truncate(edges_.size() - 1);
            return is_too_large(measure, v) ? halve_boundary(measure, v) : error{};
        }
        const queued_triangle one = waiting_.back();
        waiting_.truncate(waiting_.size() - 1);
        return one.is_in(mesh_) ? halve_longest(measure, one.t) : error{};
    }

    template <class Measure>
    [[nodiscard]] bool is_too_large(const Measure& measure, std::uint32_t v) const noexcept
    {
        return cuts_boundary_ && !(measure.edge(mesh_.place(v), mesh_.place(mesh_.next_on_boundary(v))) <= 1.0);
    }

    /// Lists a triangle if it is too large. False if out of memory.
    template <class Measure>
    [[nodiscard]] bool list(const Measure& measure, std::uint32_t t) noexcept
    {
        const std::uint32_t h = 4 * t;
        if (measure.triangle(mesh_.start(h), mesh_.start(h + 1), mesh_.start(h + 2)) <= 1.0) return true;
        return waiting_.push_back(queued_triangle::of(mesh_, t));
    }

    template <class Measure>
    [[nodiscard]] bool list_changed(const Measure& measure) noexcept
    {
        for (const std::uint32_t t : mesh_.changed()) {
            if (!list(measure, t)) return false;
            for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h)
                if (mesh_.is_boundary(h) && is_too_large(measure, mesh_.origin(h)) &&
                    !edges_.push_back(mesh_.origin(h)))
                    return false;
        }
        return true;
    }

    template <class Measure>
    [[nodiscard]] error halve_boundary(const Measure& measure, std::uint32_t a) noexcept
    {
        const contour_edge edge = mesh_.at(a).edge;
        const auto made = cut_(mesh_, a, 0.5, 0.5 * (as_double(edge.t0) + as_double(edge.t1)));
        if (!made) return made.error();
        return *made == none || list_changed(measure) ? error{} : error{error::out_of_memory};
    }

    template <class Measure>
    [[nodiscard]] error halve_longest(const Measure& measure, std::uint32_t t) noexcept
    {
        std::uint32_t h = none;
        double greatest = -1.0;
        for (std::uint32_t k = 4 * t; k < 4 * t + 3; ++k) {
            if (!cuts_boundary_ && mesh_.is_boundary(k)) continue;
            const double length = measure.length(mesh_.start(k), mesh_.place(mesh_.target(k)));
            if (h == none || length > greatest) {  // if no length is a number: any edge
                greatest = length;
                h = k;
            }
        }
        if (h == none) return {};
        if (mesh_.is_boundary(h)) return halve_boundary(measure, mesh_.origin(h));
        const grid_point p = mesh_.start(h), q = mesh_.place(mesh_.target(h));
        const grid_point middle{halved(std::int64_t{p.x} + q.x), halved(std::int64_t{p.y} + q.y)};
        const auto [in, behind] = mesh_.locate(t, middle);
        if (behind != none) {
            if (!cuts_boundary_) return {};
            // The triangle itself may stay as it is, and is then looked at again.
            const std::uint32_t before = mesh_.vertex_count();
            if (error e = halve_boundary(measure, behind)) return e;
            return mesh_.vertex_count() == before || list(measure, t) ? error{} : error{error::out_of_memory};
        }
        if (in == none) return {};
        for (std::uint32_t k = 4 * in; k < 4 * in + 3; ++k)
            if (squared_distance(mesh_.start(k), middle) < refinable_mesh::spacing * refinable_mesh::spacing) return {};
        if (mesh_.insert(in, middle) == none || !list_changed(measure)) return error::out_of_memory;
        return {};
    }

    [[nodiscard]] static std::int32_t halved(std::int64_t sum) noexcept { return static_cast<std::int32_t>(sum >> 1); }

    refinable_mesh mesh_;
    boundary_cutter cut_;
    buffer<std::uint32_t> edges_;  // first points of boundary edges that are too large
    buffer<queued_triangle> waiting_;
    buffer<std::uint32_t> numbers_;
    const region* region_ = nullptr;
    bool cuts_boundary_ = true;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
