// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/plan_scratch.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/glyph/region_caps.hpp>

#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// A region with its triangles.
struct capped_region {
    const region& filled;
    array_view<const triangle> triangles;
    corner_parting parted;  ///< the number of its corners that were separated or joined so far, and whether some
                            ///< corners still touch
};

/// A glyph's draft, and the region from which its solid is made.
struct planned_draft {
    glyph_draft draft;
    region filled;  ///< the step's region if there is a step
};

/// Lets an extruder plan the solid of a region, after the step if there is one. It owns the scratch memory, which is
/// kept for the next glyph.
///
///     region + its caps -- step --> region + caps -- raise --> draft
class solid_planner {
public:
    explicit solid_planner(memory source = heap()) noexcept : further_{source}, stepped_{source}, plan_{source} {}

    /// Returns its scratch memory to its source.
    void trim() noexcept
    {
        further_.trim();
        stepped_.release();
        plan_.release();
    }

    /// The draft of a region that has points. It refers to the region, to its caps, and to this planner until its next
    /// call.
    ///
    ///     caps      makes further triangles
    ///     place     its place in the text, for extruders whose solids differ from place to place
    ///
    /// Fails  as the step and the extruder do
    [[nodiscard]] result<planned_draft> plan(const capped_region& from, cap_builder& caps, const policies& with,
                                             const solid_place& place = {}) noexcept
    {
        const region& drawn = from.filled;
        const corner_parting& parted = from.parted;
        stepped_region made{drawn, from.triangles};
        if (!with.step.is_none()) {
            region_caps own{caps, further_, with.cut, from.triangles};
            const auto stepped = with.step(drawn, stepped_, own);
            if (!stepped) return stepped.error();
            made = *stepped;
        }
        solid_place at = place;
        if (place.pen) {
            const grid& cells = made.filled.grid();
            at.origin = (1.0 / cells.units_per_em) * rounded_pen(*place.pen, cells.cells);
        }
        const auto plan = with.raise.plan(made.filled, plan_, {caps, further_, with.cut, made.triangles, at});
        if (!plan) return plan.error();
        planned_draft out;
        out.filled = made.filled;
        out.draft.form = {made.filled.points(), made.filled.starts(), made.triangles};
        if (made.filled.points().data() != drawn.points().data()) {
            out.draft.drawn = {drawn.points(), drawn.starts()};
            out.draft.merged_as_drawn = !made.grown;
        }
        out.draft.plan = *plan;
        out.draft.plan.narrowed = plan->narrowed || made.narrowed;
        out.draft.plan.corners_moved += parted.corners + made.corners_moved;
        out.draft.plan.touching = plan->touching || parted.still_touching || made.touching;
        out.draft.data = &plan_;
        out.draft.cells = made.filled.grid().cells;
        return out;
    }

private:
    cap_builder further_;   // for regions that the step and the extruder need
    plan_scratch stepped_;  // the step's working memory
    plan_scratch plan_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
