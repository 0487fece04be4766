// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/text/cells_told_apart.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The grid on which a text and its plate are computed together, and its position in the output. A plate's mesh
/// stands where the text's own mesh would stand.
struct plate_plane {
    grid cells;                ///< units_per_em is 1, so grid::cells are the cells per em
    placement at;              ///< maps cells to output units
    double unit_per_em = 1.0;  ///< output units per em

    /// The finest grid of the plan's glyphs, made coarser until the text fits with `room` em around it, and until
    /// 32-bit floats tell neighbouring cells apart (cells_told_apart()).
    ///
    ///     plan    a text_plan of any solid
    ///
    /// Fails  error::bad_option ("text"): the plan has no glyphs. error::outline_beyond_grid
    template <class Plan>
    [[nodiscard]] static result<plate_plane> of(const Plan& plan, double room) noexcept
    {
        if (plan.glyphs().empty()) return error::bad("text");
        plate_plane made;
        made.at.frame = plan.text_frame();
        double finest = 0.0, farthest = 0.0;
        for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
            const placement p = plan.place(g);
            if (g == 0) made.unit_per_em = p.unit_per_cell / p.em_per_cell;
            if (finest <= 0.0 || p.unit_per_cell < finest) finest = p.unit_per_cell;
        }
        made.set(finest);
        for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
            const auto& built = *plan.glyphs()[g].built;
            const glyph_place at{plan, g, made};
            for (const grid_point p : {built.low(), built.high(), grid_point{built.low().x, built.high().y},
                                       grid_point{built.high().x, built.low().y}}) {
                const point q = at(p);
                farthest = std::fabs(q.x) > farthest ? std::fabs(q.x) : farthest;
                farthest = std::fabs(q.y) > farthest ? std::fabs(q.y) : farthest;
            }
        }
        farthest += room * made.cells.cells;
        if (!is_finite(farthest)) return error::outline_beyond_grid;
        const double apart = cells_told_apart(farthest / made.cells.cells, made.at.frame.is_along_axes());
        while (farthest > 0.5 * grid::reach || made.unit_per_em / finest > apart) {
            farthest *= 0.5;
            finest *= 2.0;
            if (made.unit_per_em / finest < 0x1p6) return error::outline_beyond_grid;
        }
        made.set(finest);
        made.cells.span_over({{-farthest / made.cells.cells, -farthest / made.cells.cells},
                              {farthest / made.cells.cells, farthest / made.cells.cells}});
        return made;
    }

    /// The map from a glyph's own cells to the plane's.
    class glyph_place {
    public:
        template <class Plan>
        glyph_place(const Plan& plan, std::size_t glyph, const plate_plane& onto) noexcept
        {
            const placement p = plan.place(glyph);
            // A turned glyph's frame has these floats, and its pen is written in the turned axes: see turned.hpp.
            const point right = plan.glyphs()[glyph].right;
            const double x = as_double(static_cast<float>(right.x)), y = as_double(static_cast<float>(right.y));
            const double scale = p.unit_per_cell / onto.at.unit_per_cell;
            x_ = scale * point{x, y};
            y_ = scale * point{-y, x};
            pen_ = p.pen.x * x_ + p.pen.y * y_;
        }
        /// The nearest point of the grid; its coordinates are integers, but not bounded.
        [[nodiscard]] point operator()(grid_point p) const noexcept
        {
            const double x = p.x, y = p.y;
            return {std::nearbyint(x * x_.x + y * y_.x + pen_.x), std::nearbyint(x * x_.y + y * y_.y + pen_.y)};
        }

    private:
        point x_, y_, pen_;
    };

private:
    void set(double unit_per_cell) noexcept
    {
        at.unit_per_cell = unit_per_cell;
        at.em_per_cell = unit_per_cell / unit_per_em;
        cells.cells = unit_per_em / unit_per_cell;
        cells.units_per_em = 1.0;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
