// SPDX-License-Identifier: MIT
#include "policies.hpp"

#include <algorithm>

namespace text_to_mesh {
namespace {

typemesh::carved carved_of(const options& o)
{
    typemesh::carved solid{.tool_angle = o.carve.tool_angle, .max_depth = o.carve.depth, .as = o.carve.as};
    solid.texture = o.uv;
    if (o.crease) solid.crease_degrees = *o.crease;
    return solid;
}

chosen_solid solid_of(const options& o)
{
    if (o.inflate.height > 0.0f) return inflated_of(o);
    if (o.tube.radius > 0.0f) return tubed_of(o);
    if (o.bend.is_on && o.bevel.width > 0.0f) return bent_of(o, bevelled_of(o));
    if (o.bend.is_on) return bent_of(o, plain_of(o));
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
    if (o.outline.width > 0.0f) return hollow_of(o, letter);
    return letter;
}

}  // namespace

void choose_policies(const options& o, double units_per_em, chosen_mesher& mesher)
{
    mesher.use(solid_of(o));
    use_stages(o, units_per_em, mesher);
    if (o.path.curve) mesher.use(typemesh::on_path{o.path.curve.get(), o.path.how});
    if (!o.lod.empty()) use_level(o, 0, mesher);
}

void use_level(const options& o, std::size_t level, chosen_mesher& mesher)
{
    typemesh::coarsened levels{.level = static_cast<std::uint32_t>(level)};
    std::copy(o.lod.begin(), o.lod.end(), levels.tolerances);
    mesher.use(levels);
}

}  // namespace text_to_mesh
