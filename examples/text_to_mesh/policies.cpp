// SPDX-License-Identifier: MIT
#include "policies.hpp"

#include <type_traits>
#include <variant>

namespace text_to_mesh {
namespace {

typemesh::bevel_profile profile_of(const bevel_options& o)
{
    switch (o.profile) {
    case profile_name::round: return typemesh::round_profile(o.steps);
    case profile_name::concave: return typemesh::concave_profile(o.steps);
    case profile_name::stepped: return typemesh::stepped_profile();
    case profile_name::engraved: return typemesh::engraved_profile();
    case profile_name::points: return o.points;
    case profile_name::chamfer: break;
    }
    return typemesh::chamfer_profile();
}

typemesh::bevelled bevelled_of(const options& o)
{
    typemesh::bevelled solid{.depth = o.depth, .width = o.bevel.width, .bevel_depth = o.bevel.depth};
    solid.sides = o.bevel.sides;
    solid.mode = o.bevel.mode;
    solid.outward = o.bevel.outward;
    solid.texture = o.uv;
    solid.segments = o.segments;
    solid.profile = profile_of(o.bevel);
    if (o.crease) solid.crease_degrees = *o.crease;
    return solid;
}

typemesh::carved carved_of(const options& o)
{
    typemesh::carved solid{.tool_angle = o.carve.tool_angle, .max_depth = o.carve.depth, .as = o.carve.as};
    solid.texture = o.uv;
    if (o.crease) solid.crease_degrees = *o.crease;
    return solid;
}

plain_solid plain_of(const options& o)
{
    using namespace typemesh;
    if (o.depth == 0.0f) return flat{.texture = o.uv};
    const auto with = [&](auto normals) -> plain_solid {
        return extruded<decltype(normals)>{
            .depth = o.depth, .texture = o.uv, .normals = normals, .segments = o.segments};
    };
    switch (o.normals) {
    case normals_name::cap: return with(cap_normals{});
    case normals_name::shared: return with(shared_normals{});
    case normals_name::averaged: return with(averaged_normals{});
    case normals_name::creased:
        return with(creased_normals{.crease_degrees = o.crease.value_or(creased_normals{}.crease_degrees)});
    case normals_name::curve: break;
    }
    return with(curve_normals{.crease_degrees = o.crease.value_or(curve_normals{}.crease_degrees)});
}

chosen_solid solid_of(const options& o)
{
    if (o.inflate.height > 0.0f) {
        typemesh::inflated solid{.height = o.inflate.height, .form = o.inflate.form, .texture = o.uv};
        if (o.inflate.form == typemesh::inflated_form::dome) solid.depth = o.depth;
        if (o.crease) solid.crease_degrees = *o.crease;
        return solid;
    }
    if (o.bend.is_on && o.bevel.width > 0.0f)
        return bent_bevels{.solid = bevelled_of(o), .how = o.bend.how, .tolerance = o.tolerance};
    if (o.bend.is_on) return bent_solid{.solid = plain_of(o), .how = o.bend.how, .tolerance = o.tolerance};
    if (o.refine.refiner == refiner_name::delaunay)
        return refined_solid{.solid = plain_of(o),
                             .how = {.min_angle = o.refine.min_angle, .max_edge = o.refine.max_edge.value_or(0.0f)}};
    if (o.refine.refiner == refiner_name::quadtree) {
        squared_solid solid{.solid = plain_of(o)};
        if (o.refine.max_edge) solid.how.max_edge = *o.refine.max_edge;
        return solid;
    }
    if (o.refine.refiner == refiner_name::non_obtuse)
        return right_solid{.solid = plain_of(o), .how = {.max_edge = o.refine.max_edge.value_or(0.0f)}};
    if (o.carve.tool_angle > 0.0f) return letter_solid{carved_of(o)};
    const letter_solid letter = o.bevel.width > 0.0f ? letter_solid{bevelled_of(o)} : letter_solid{plain_of(o)};
    if (o.outline.width > 0.0f) {
        hollow_solid hollow{.width = o.outline.width, .place = o.outline.place, .ring = letter, .letter = plain_of(o)};
        if (!o.outline.letter) hollow.letter = typemesh::extruded<>{.front = false, .back = false, .side = false};
        return hollow;
    }
    return letter;
}

}  // namespace

void choose_policies(const options& o, double units_per_em, chosen_mesher& mesher)
{
    mesher.use(solid_of(o));
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
    with_discretiser(o, units_per_em, [&mesher](const auto& discretiser) { mesher.use(discretiser); });
    if (o.triangulator == triangulator_name::delaunay)
        mesher.use(typemesh::constrained_delaunay{});
    else
        mesher.use(typemesh::monotone{});
}

}  // namespace text_to_mesh
