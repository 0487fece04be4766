// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/glyph/impl/curve_coarsener.hpp>
#include <typemesh/triangulate/cut_region.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Keeps the regions of glyphs, and makes them coarser, level by level: each glyph is filled once for all levels.
///
///     glyph_levels levels;
///     levels.keep(*builder.build_region(font, id, {.tolerance = quality::high}, with));      glyph 0, then 1, 2, ...
///     auto coarse = levels.coarser(0, 1.0 / 160, cut);                  a region; its triangles are levels.triangles()
///     auto coarser = levels.coarser(0, 1.0 / 60, cut);
///
/// A coarser level drops points between points of one curve, as described in coarsened.hpp, and moves none. The
/// triangulator proves each level while it makes the triangles, if it can (proving_triangulator). Otherwise, or if it
/// refuses the level, each dropped point is tested by itself, and fewer points are dropped.
///
/// The order of the points is known from the finest level, so they are never sorted again.
class glyph_levels {
public:
    explicit glyph_levels(memory source = heap()) noexcept
        : glyphs_{source},
          points_{source},
          edges_{source},
          order_{source},
          starts_{source},
          curves_{source},
          loops_{source},
          drop_{source},
          triangles_{source},
          space_{source}
    {
    }

    void clear() noexcept
    {
        glyphs_.clear();
        points_.clear();
        edges_.clear();
        order_.clear();
        starts_.clear();
        curves_.clear();
        triangles_.clear();
    }

    /// Keeps a copy of a region, with its curves, as the next glyph's finest level. A region without points is a blank
    /// glyph.
    ///
    /// Fails  only with error::out_of_memory. The glyphs that are kept already stay as they are
    [[nodiscard]] error keep(const region& filled) noexcept
    {
        kept made;
        made.point = points_.size();
        made.start = starts_.size();
        made.curve = curves_.size();
        made.points = filled.points().size();
        made.loops = filled.loop_count();
        made.curves = filled.curves().size();
        made.cells = filled.grid();
        made.tolerance = filled.tolerance();
        made.holes = filled.holes();
        made.outers = filled.outers();
        made.is_touching = filled.is_touching();
        made.corners = filled.corners();
        made.is_sorted = !filled.order().empty();
        if (append(filled) && glyphs_.push_back(made)) return {};
        points_.truncate(made.point);
        edges_.truncate(made.point);
        order_.truncate(made.point);
        starts_.truncate(made.start);
        curves_.truncate(made.curve);
        return error::out_of_memory;
    }

    /// The number of glyphs.
    [[nodiscard]] std::size_t size() const noexcept { return glyphs_.size(); }

    /// Replaces a glyph's level by a coarser one. Without tolerance, 0, the level stays as it is and gets triangles.
    /// The region is valid until the next call.
    ///
    ///     tolerance    in em, at least the one of the level before: no place of a new edge is farther from its curve
    ///
    /// Fails  error::bad_option: the tolerance is negative or not finite ("tolerance"), or the grid has no em
    ///        ("units_per_em"); error::out_of_memory; as the triangulator does. The glyph then keeps its level
    /// Cost   O(n log n) for the n points of the level before
    [[nodiscard]] result<region> coarser(std::size_t glyph, double tolerance, triangulator_ref cut) noexcept
    {
        kept& own = glyphs_[glyph];
        triangles_.clear();
        if (!is_finite(tolerance) || tolerance < 0.0) return error::bad("tolerance");
        if (own.points == 0) return region{};
        const double em = own.cells.cells * own.cells.units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        if (!read(own)) return error::out_of_memory;
        const bool drops = tolerance > 0.0;
        if (drops && cut.proves() && own.is_sorted && !own.is_touching) {
            const auto made = prove(own, tolerance * em, cut);
            if (made || made.error() != error::crossing_contours) return made;
            if (!read(own)) return error::out_of_memory;
        }
        if (drops)
            if (error e = drop_(loops_, tolerance * em)) return e;
        if (drops && loops_.tolerance > 0.0 && loops_.tolerance < tolerance * em) loops_.tolerance = tolerance * em;
        const region made = region::proven(loops_, own.holes, own.outers, own.is_touching);
        if (error e = cut.cut(made, space_, triangles_)) return e;
        write(own);
        return made;
    }

    /// The triangles of the last level that coarser() has made.
    [[nodiscard]] array_view<const triangle> triangles() const noexcept { return triangles_.view(); }

private:
    /// A glyph's part of the arrays below. Its points become fewer.
    struct kept {
        std::size_t point = 0, start = 0, curve = 0;  // the first
        std::size_t points = 0, loops = 0, curves = 0;
        grid cells;
        double tolerance = 0.0;
        std::uint32_t holes = 0, outers = 0;
        bool is_touching = false, is_sorted = false;
        touching corners = touching::keep;
    };

    /// Copies a region to the ends of all arrays. False if out of memory; some of them may then be longer.
    [[nodiscard]] bool append(const region& filled) noexcept
    {
        const std::size_t count = filled.points().size();
        std::uint32_t* const order = order_.append(count);
        if (order == nullptr && count != 0) return false;
        for (std::size_t i = 0; i < filled.order().size(); ++i) order[i] = filled.order()[i];
        return points_.append(filled.points()) && edges_.append(filled.edges()) && starts_.append(filled.starts()) &&
               curves_.append(filled.curves());
    }

    /// Drops points first, then lets the triangulator prove the level.
    ///
    /// Fails  error::crossing_contours: points have to be tested one by one; error::out_of_memory
    [[nodiscard]] result<region> prove(kept& own, double tolerance, triangulator_ref cut) noexcept
    {
        if (error e = drop_.drop_unproven(loops_, tolerance)) return e;
        if (loops_.tolerance > 0.0 && loops_.tolerance < tolerance) loops_.tolerance = tolerance;
        auto made = cut.prove(loops_, space_, triangles_);
        if (made && (made->holes() != own.holes || made->outers() != own.outers)) made = error::crossing_contours;
        if (!made) {
            triangles_.clear();
            return made;
        }
        if (error e = detail::settle_triangles(*made, triangles_, 0, space_, cut.has_final_diagonals())) return e;
        write(own);
        return made;
    }

    /// Copies a glyph's level into loops_. False if out of memory.
    [[nodiscard]] bool read(const kept& own) noexcept
    {
        loops_.clear();
        if (!loops_.points.append(points_.view().subspan(own.point, own.points)) ||
            !loops_.edges.append(edges_.view().subspan(own.point, own.points)) ||
            !loops_.starts.append(starts_.view().subspan(own.start, own.loops + 1)))
            return false;
        loops_.curves = curves_.view().subspan(own.curve, own.curves);
        loops_.grid = own.cells;
        loops_.tolerance = own.tolerance;
        loops_.corners = own.corners;
        if (!own.is_sorted) return true;
        std::uint32_t* const order = loops_.new_order(own.points);
        if (order == nullptr) return false;
        for (std::size_t i = 0; i < own.points; ++i) order[i] = order_[own.point + i];
        return true;
    }

    /// Copies loops_ back.
    void write(kept& own) noexcept
    {
        own.points = loops_.points.size();
        own.tolerance = loops_.tolerance;
        const array_view<const std::uint32_t> order = loops_.order();
        own.is_sorted = !order.empty();
        for (std::size_t i = 0; i < own.points; ++i) {
            points_[own.point + i] = loops_.points[i];
            edges_[own.point + i] = loops_.edges[i];
            if (own.is_sorted) order_[own.point + i] = order[i];
        }
        for (std::size_t k = 0; k <= own.loops; ++k) starts_[own.start + k] = loops_.starts[k];
    }

    buffer<kept> glyphs_;
    buffer<grid_point> points_;
    buffer<contour_edge> edges_;
    buffer<std::uint32_t> order_;
    buffer<std::uint32_t> starts_;
    buffer<curve> curves_;
    contours loops_;  // the glyph that was made last
    detail::curve_coarsener drop_;
    triangle_list triangles_;
    workspace space_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
