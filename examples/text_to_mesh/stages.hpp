// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"

#include <typemesh/bend/warped.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/outline/stroked.hpp>
#include <typemesh/typemesh.hpp>

#include <type_traits>
#include <variant>

namespace text_to_mesh {

/// take(discretiser) with what the options choose.
template <class Take>
void with_discretiser(const options& o, double units_per_em, Take&& take)
{
    using typemesh::thesis_quality;
    switch (o.discretiser) {
    case discretiser_name::two_lines: return take(typemesh::two_lines{});
    case discretiser_name::adaptive:
        return take(thesis_quality{static_cast<thesis_quality::preset>(o.quality), units_per_em});
    case discretiser_name::certified: return take(typemesh::certified{});
    }
}

/// Gives a mesher all that the options choose but its solid: the steps before it, discretiser, triangulator.
template <class Mesher>
void use_stages(const options& o, double units_per_em, Mesher& mesher)
{
    if (o.embolden != 0.0f)
        mesher.use(typemesh::embolden{.by = o.embolden});
    else
        mesher.use(typemesh::no_step{});
    std::visit(
        [&mesher](const auto& warp) {
            if constexpr (typemesh::plane_warp<std::decay_t<decltype(warp)>>)
                mesher.use(typemesh::warped{warp});
            else
                mesher.use(typemesh::no_outline_step{});
        },
        o.bend.warp);
    if (o.stroke.width > 0.0) mesher.use(typemesh::stroked{o.stroke.style()});
    with_discretiser(o, units_per_em, [&mesher](const auto& discretiser) { mesher.use(discretiser); });
    if (o.triangulator == triangulator_name::delaunay)
        mesher.use(typemesh::constrained_delaunay{});
    else
        mesher.use(typemesh::monotone{});
}

}  // namespace text_to_mesh
