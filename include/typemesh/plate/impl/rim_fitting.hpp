// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/exact_fill.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/impl/rim_offset.hpp>
#include <typemesh/plate/layer_arrangement.hpp>
#include <typemesh/plate/layered_slab.hpp>
#include <typemesh/triangulate/impl/triangulator_ref.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Fits the bevel of a slab's upper rim and the fillet of the next slab's foot into the floor between the two.
///
///      --.                  .--      The bevel moves the lower slab's outline inwards, the fillet moves the upper
///         '-.            .-'         slab's outline outwards. The floor lies between the two offsets. Both fit if
///            '----------'            the floor is proven to be bounded by exactly these loops: then nothing
///      fillet    floor    bevel      crosses. What does not fit becomes narrower by quarters, first the bevel.
class rim_fitting {
public:
    explicit rim_fitting(memory source = heap()) noexcept
        : inner_{source},
          outer_{source},
          loops_{source},
          floor_{source},
          triangles_{source},
          builder_{source},
          further_{source}
    {
    }

    struct shape {
        rim_section section = rim_section::chamfer;  ///< of bevels
        double tolerance = 0.0;                      ///< see rim_offset
        float least_width = 0.0f;                    ///< in em; what would have to be narrower is left out
    };

    /// Fits the widths of one level: they become what was reached, both 0 if nothing fits. points() and triangles() are
    /// then the floor's, unless both are 0.
    ///
    ///     under, over    the cells of the slabs below and above the level; `over` may be empty
    ///
    /// Fails  as the triangulator, resolve() and layer_arrangement::trace() do
    [[nodiscard]] error fit(layer_arrangement& cells, cell_set under, cell_set over, rim_widths& widths,
                            const shape& how, triangulator_ref cut) noexcept
    {
        cells_ = &cells;
        how_ = how;
        const bool stands = cells.doubled_area(over) != 0;
        if (!stands) {
            widths.fillet = 0.0f;
            return move(inner_, under, how.section, widths.bevel, cut);
        }
        rim_widths made;
        const error e = try_to_fit(under, over, widths, made, cut);
        widths = made;
        return e;
    }

    /// Moves the rim of a slab's cells inwards. points() and triangles() are then the ones of inner(). `width` becomes
    /// what was reached.
    [[nodiscard]] error fit_lower(layer_arrangement& cells, cell_set filled, float& width, const shape& how,
                                  triangulator_ref cut) noexcept
    {
        cells_ = &cells;
        how_ = how;
        return move(inner_, filled, how.section, width, cut);
    }

    [[nodiscard]] rim_offset& inner() noexcept { return inner_; }  ///< of the bevel
    [[nodiscard]] rim_offset& outer() noexcept { return outer_; }  ///< of the fillet
    /// The floor that fit() has left.
    [[nodiscard]] array_view<const grid_point> points() noexcept
    {
        return has_floor_ ? floor_.points.view() : inner_.points();
    }
    [[nodiscard]] array_view<const triangle> triangles() noexcept
    {
        return has_floor_ ? triangles_.view() : inner_.triangles();
    }

private:
    /// What does not fit is made narrower so often, and then left out.
    static constexpr int max_attempts = 32;
    /// By quarters, and after half of the attempts by halves: from the widest offset down to a few cells.
    static float narrower(float width, int attempt) noexcept
    {
        return width * (attempt < max_attempts / 2 ? 0.75f : 0.5f);
    }

    [[nodiscard]] error try_to_fit(cell_set under, cell_set over, const rim_widths& wanted, rim_widths& made,
                                   triangulator_ref cut) noexcept
    {
        bool fits = false;
        if (!(wanted.bevel > 0.0f) && !(wanted.fillet > 0.0f)) return {};
        if (error e = make_floor(under, over, {}, fits, cut)) return e;
        if (!fits) return {};  // it stands on the rim
        fits = false;
        float width = wanted.bevel;
        for (int i = 0; width > 0.0f && !fits && i < max_attempts; width = narrower(width, ++i)) {
            if (error e = move(inner_, under, how_.section, width, cut)) return e;
            if (error e = make_floor(under, over, {width, 0.0f}, fits, cut)) return e;
            if (fits) made.bevel = width;
        }
        width = wanted.fillet;
        fits = false;
        for (int i = 0; width > 0.0f && !fits && i < max_attempts; width = narrower(width, ++i)) {
            if (error e = move(outer_, over, rim_section::fillet, width, cut)) return e;
            if (error e = make_floor(under, over, {made.bevel, width}, fits, cut)) return e;
            if (fits) made.fillet = width;
        }
        // The floor of the bevel alone is there already if no fillet was tried.
        if (made.fillet > 0.0f || !(made.bevel > 0.0f) || !(wanted.fillet > 0.0f)) return {};
        return make_floor(under, over, made, fits, cut);
    }

    [[nodiscard]] error move(rim_offset& to, cell_set cells, rim_section section, float& width,
                             triangulator_ref cut) noexcept
    {
        has_floor_ = false;
        if (!(width > 0.0f)) return {};
        const auto r = cells_->trace(cells, builder_.space(), loops_);
        if (!r) return r.error();
        const auto reached = to.plan(*r, section, width, how_.tolerance, cut);
        width = reached && *reached >= how_.least_width ? *reached : 0.0f;
        return reached.error();
    }

    /// Makes the floor between the offsets, or the outlines where a width is 0. `fits`: whether they bound it.
    [[nodiscard]] error make_floor(cell_set under, cell_set over, const rim_widths& widths, bool& fits,
                                   triangulator_ref cut) noexcept
    {
        floor_.clear();
        floor_.grid = cells_->grid();
        triangles_.clear();
        if (error e = add(under, widths.bevel, inner_, false)) return e;
        if (error e = add(over, widths.fillet, outer_, true)) return e;
        region_caps caps{builder_, further_, cut, {}};
        const auto made = fill_exactly(floor_, caps, triangles_);
        fits = static_cast<bool>(made);
        has_floor_ = fits;
        return made || rim_offset::is_refusal(made.error()) ? error{} : made.error();
    }

    /// Adds the loops of an offset, or of the cells if the offset has no width.
    [[nodiscard]] error add(cell_set cells, float width, rim_offset& from, bool turned) noexcept
    {
        const std::uint32_t first = floor_.contour_count();
        array_view<const grid_point> points = from.points();
        array_view<const std::uint32_t> starts = from.starts();
        if (!(width > 0.0f)) {
            const auto r = cells_->trace(cells, builder_.space(), loops_);
            if (!r) return r.error();
            points = r->points();
            starts = r->starts();
        }
        if (!append_loops(points, starts, floor_)) return error::out_of_memory;
        for (std::uint32_t k = first; turned && k < floor_.contour_count(); ++k) turn_loop(floor_, k);
        return {};
    }

    rim_offset inner_, outer_;
    contours loops_, floor_;
    triangle_list triangles_;
    cap_builder builder_, further_;
    layer_arrangement* cells_ = nullptr;
    shape how_;
    bool has_floor_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
