// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inflate/impl/membrane_system.hpp>
#include <typemesh/inflate/impl/rim_rings.hpp>
#include <typemesh/inflate/impl/rim_slopes.hpp>
#include <typemesh/inflate/impl/slope_fit.hpp>
#include <typemesh/refine/impl/delaunay_refinement.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An inner point of an inflated membrane: its height, and the slope of half the height's square. The surface has the
/// normal (-slope, height) there, normalised; towards the boundary, where the height is 0, it turns into the plane.
struct membrane_point {
    float height = 0.0f;  ///< the root of 2u, in em
    vec2 slope;           ///< the slope of u, in em
};

/// The size of a membrane's mesh.
struct membrane_options {
    float edge = 0.03f;  ///< the length of the longest edge, in em; strokes narrower than that get shorter ones
    std::uint32_t max_points = default_max_points;  ///< the greatest number of points of one cap, 2^29 - 1 at most

    /// The error for options that are out of range on every glyph, or none.
    [[nodiscard]] error refused() const noexcept
    {
        if (!is_finite(as_double(edge)) || !(edge > 0.0f)) return error::bad("edge");
        return max_points > max_refined_points ? error::bad("max_points") : error{};
    }
};

/// A region's cap as an inflated membrane: the solution u of -Laplace(u) = 1 with u = 0 on the outline, whose height is
/// the root of 2u. A straight stroke becomes half a cylinder, a disc an ellipsoid, and joints are smooth.
///
///            _ - - - _                  u = x (w - x) / 2 on a straight stroke of the width w, so the height is the
///         /             \               root of x (w - x): half a circle
///        |               |
///     ---+---------------+---  outline
///
/// The cap is refined: no edge is longer than `edge`, except in slivers whose middle has no place for a point, and
/// edges of thin strokes are shorter. Rings of points along the outline, where the surface is steep, follow the section
/// at steps of 22.5 degrees, or 11.25 on thick strokes. The inner edges are Delaunay, so u is positive inside: see
/// impl/membrane_system.hpp.
///
/// The sums of the solution have one order, and heights and slopes are rounded to 2^-22 em, so that compilers that
/// contract products and sums agree but in rare cases.
///
///     membrane sheet;
///     sheet.inflate(region, cap, {.edge = 0.03f}, {loops, inner, triangles, kept})     as a refiner; then points()
///                                                                                      has one for each of `inner`
///
/// Fails  error::bad_option: edge is not positive and finite, or below 64 cells on a glyph ("edge"), or the grid has no
///        em ("units_per_em"), or max_points is above 2^29 - 1 ("max_points")
///        error::too_many_points: the glyph needs more than max_points
///        error::out_of_memory
/// Cost   O(n) for the points, and at most n^1.5 for the solution
class membrane {
public:
    explicit membrane(memory source = heap()) noexcept
        : mesh_{source}, system_{source}, fit_{source}, rise_{source}, slopes_{source}, points_{source}
    {
    }

    [[nodiscard]] error inflate(const region& r, array_view<const triangle> cap, const membrane_options& how,
                                const refined_cap& out) noexcept
    {
        points_.clear();
        if (error e = how.refused()) return e;
        const double em = r.grid().cells * r.grid().units_per_em, longest = as_double(how.edge) * em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        if (longest < min_edge) return error::bad("edge");
        auto limits = detail::refinement_limits::from(least_angle, longest, how.max_points);
        limits.boundary_only = true;  // the rings will divide most of the long edges inside
        if (error e = mesh_.run(r, cap, limits)) return e;
        out.kept = mesh_.kept();
        if (error e = mesh_.write(out)) return e;
        if (!system_.solve(view_of(out))) return error::out_of_memory;
        if (!rise_.measure(system_, mesh_.mesh(), r.starts(), out.loops.points.size())) return error::out_of_memory;
        if (error e = rise_.shorten(mesh_, r.starts(), longest / max_shortening)) return e;
        if (!detail::rim_rings::divide_crossings(mesh_.mesh()) ||
            !detail::rim_rings::add_rings(mesh_.mesh(), rise_.data(), longest) ||
            !detail::rim_rings::divide_long(mesh_.mesh(), longest, how.max_points) ||
            !detail::rim_rings::raise_specks(mesh_.mesh()))
            return error::out_of_memory;
        if (mesh_.mesh().vertex_count() > how.max_points) return {error::too_many_points, how.max_points};
        if (error e = mesh_.write(out)) return e;
        const detail::membrane_mesh m = view_of(out);
        if (!system_.solve(m) || !fit_(m, system_.u(), longest, slopes_)) return error::out_of_memory;
        return collect(em) ? error{} : error{error::out_of_memory};
    }

    /// The heights and slopes at the inner points of the last cap.
    [[nodiscard]] array_view<const membrane_point> points() const noexcept { return points_.view(); }

private:
    static constexpr double min_edge = 64.0;        // cells: rings need places between the outline and the middle
    static constexpr double least_angle = 25.0;     // degrees, as delaunay_refined's default
    static constexpr double max_shortening = 16.0;  // edges of thin strokes are halved up to four times
    static constexpr double finest = 0x1p-22;       // em: heights and slopes are multiples of it

    [[nodiscard]] static detail::membrane_mesh view_of(const refined_cap& cap) noexcept
    {
        return {cap.loops.points.view(), cap.inner.view(), cap.triangles.view()};
    }

    /// Rounds the heights and slopes. False if out of memory.
    [[nodiscard]] bool collect(double em) noexcept
    {
        const std::size_t n = system_.size();
        if (!points_.reserve(n)) return false;
        constexpr auto least = static_cast<float>(finest);
        const auto rounded = [](double v) noexcept {
            return static_cast<float>(std::floor(v / finest + 0.5) * finest);
        };
        for (std::size_t i = 0; i < n; ++i) {
            const float height = rounded(std::sqrt(2.0 * system_.u()[i]) / em);
            points_.push_back_unchecked(
                {height > least ? height : least, {rounded(slopes_[i].x / em), rounded(slopes_[i].y / em)}});
        }
        return true;
    }

    detail::delaunay_refinement mesh_;
    detail::membrane_system system_;
    detail::slope_fit fit_;
    detail::rim_slopes rise_;
    buffer<point> slopes_;
    buffer<membrane_point> points_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
