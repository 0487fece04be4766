// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/impl/corner_rule.hpp>
#include <typemesh/extrude/impl/surroundings.hpp>
#include <typemesh/offset/impl/cap_edges.hpp>
#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cmath>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Moves the boundary of a region, outwards or inwards: letters grow or become thinner.
///
/// Each edge of the new loops names the curve that it comes from (name_cap_edges), so that its walls are lit like
/// the walls on the region's own edges. Keeps its storage for the next region.
class boundary_mover {
public:
    static constexpr double finest = finest_band;  ///< in cells: a smaller distance moves nothing

    explicit boundary_mover(memory source = heap()) noexcept : swept_{source}, around_{source}, triangles_{source} {}

    /// Replaces `out` by the loops of caps.triangles()' region, moved by `distance` cells: outwards, or inwards if it
    /// is negative. The loops are not proven (see fill_exactly). Parts thinner than twice the distance vanish.
    ///
    ///     curves      the region's curves; the curves of joins are appended. `out` must refer to them at the end
    ///
    /// Fails  as sweep_inwards() and caps.fill() do; error::crossing_contours: corners have met and grown a spike, and
    ///        again with a mitre limit of 1.5
    template <cap_maker Caps>
    [[nodiscard]] error operator()(const region& r, double distance, const corner_rule& how, Caps& caps,
                                   buffer<curve>& curves, contours& out) noexcept
    {
        out.clear();
        if (std::fabs(distance) < finest) {
            out.grid = r.grid();
            out.corners = r.corners();
            out.tolerance = r.tolerance();
            return append_loops(r, out) ? error{} : error{error::out_of_memory};
        }
        if (distance < 0.0) {
            if (error e = sweep({r, caps.triangles(), -distance}, how, caps.space(), curves)) return e;
        } else {
            const double reach = farthest_way(r, distance, as_double(how.mitre_limit));
            if (error e = surround(r, reach, caps.loops())) return e;
            triangles_.clear();
            const auto around = caps.fill(triangles_);
            if (!around) return around.error();
            around_ = std::move(caps.loops());  // move exchanges the storage: `around` still refers to it
            constexpr double slack = 4.0;       // for rounding
            const moving what{*around, triangles_.view(), distance};
            const std::size_t own = curves.size();
            if (error e = sweep(what, how, caps.space(), curves)) return e;
            if (!is_in_reach(swept_.cap, r, reach + slack)) {
                curves.truncate(own);
                constexpr float always = 1.5f;
                if (error e = sweep(what, {how.joins, always}, caps.space(), curves)) return e;
                if (!is_in_reach(swept_.cap, r, reach + slack)) return error::crossing_contours;
            }
            leave_frame(swept_.cap);
        }
        out = std::move(swept_.cap);
        return {};
    }

private:
    struct moving {
        const region& r;
        array_view<const triangle> triangles;
        double width;
    };

    [[nodiscard]] error sweep(const moving& what, const corner_rule& how, workspace& space,
                              buffer<curve>& curves) noexcept
    {
        const bool round = how.joins == bevel_joins::round;
        const double levels[] = {0.0, what.width};
        swept_.clear();
        workspace::scope scratch{space};
        sweep_options options{levels, as_double(how.mitre_limit), what.r.tolerance(), round};
        options.only_cap = true;
        if (error e = sweep_inwards(what.r, what.triangles, options, scratch, swept_)) return e;
        return name_cap_edges(what.r, round, swept_, curves, scratch);
    }

    swept_region swept_;
    contours around_;          // the surroundings of the region, for outward moves
    triangle_list triangles_;  // their triangles
};

}  // namespace typemesh::inline TYPEMESH_ABI
