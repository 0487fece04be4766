// SPDX-License-Identifier: MIT
#include "policies.hpp"

namespace text_to_mesh {
namespace {

chosen_profile profile_of(const bevel_options& o)
{
    switch (o.profile) {
    case profile_name::round: return {typemesh::round_profile{o.steps}};
    case profile_name::concave: return {typemesh::concave_profile{o.steps}};
    case profile_name::stepped: return {typemesh::stepped_profile{}};
    case profile_name::engraved: return {typemesh::engraved_profile{}};
    case profile_name::points: return {typemesh::polyline_profile{o.points}};
    case profile_name::chamfer: break;
    }
    return {typemesh::chamfer_profile{}};
}

bevelled_extruder bevelled_of(const options& o)
{
    bevelled_extruder solid{.depth = o.depth, .width = o.bevel.width, .bevel_depth = o.bevel.depth};
    solid.sides = o.bevel.sides;
    solid.mode = o.bevel.mode;
    solid.outward = o.bevel.outward;
    solid.texture = o.uv;
    solid.profile = profile_of(o.bevel);
    if (o.crease) solid.crease_degrees = *o.crease;
    return solid;
}

unbevelled_extruder unbevelled_of(const options& o)
{
    using namespace typemesh;
    if (o.depth == 0.0f) return {flat{.texture = o.uv}};
    const auto with = [&](auto normals) {
        return unbevelled_extruder{extruded<decltype(normals)>{.depth = o.depth, .texture = o.uv, .normals = normals}};
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

template <class Solid>
chosen_extruder bold(const options& o, const Solid& solid)
{
    return bold_extruder<Solid>{.by = o.embolden, .solid = solid};
}

template <class Ring>
chosen_extruder hollow(const options& o, const Ring& ring)
{
    typemesh::outlined<Ring, unbevelled_extruder> letters{
        .width = o.outline.width, .place = o.outline.place, .ring = ring};
    letters.letter = unbevelled_of(o);
    if (!o.outline.letter) letters.letter = {typemesh::extruded<>{.front = false, .back = false, .side = false}};
    return hollow_extruder<Ring>{.by = o.embolden, .solid = letters};
}

}  // namespace

static_assert(typemesh::keeps_tolerance<typemesh::certified> && !typemesh::keeps_tolerance<unbounded_discretiser>);
static_assert(typemesh::has_final_diagonals<chosen_triangulator>, "else --triangulator delaunay is not Delaunay's");

chosen_discretiser discretiser_of(const options& o, double units_per_em)
{
    using typemesh::thesis_quality;
    if (o.discretiser == discretiser_name::two_lines) return unbounded_discretiser{typemesh::two_lines{}};
    if (o.discretiser == discretiser_name::adaptive)
        return unbounded_discretiser{thesis_quality{static_cast<thesis_quality::preset>(o.quality), units_per_em}};
    return typemesh::certified{};
}

chosen_triangulator triangulator_of(const options& o)
{
    if (o.triangulator == triangulator_name::delaunay) return {typemesh::constrained_delaunay{}};
    return {typemesh::monotone{}};
}

chosen_extruder extruder_of(const options& o)
{
    if (o.outline.width > 0.0f) return o.bevel.width > 0.0f ? hollow(o, bevelled_of(o)) : hollow(o, unbevelled_of(o));
    if (o.embolden != 0.0f) return o.bevel.width > 0.0f ? bold(o, bevelled_of(o)) : bold(o, unbevelled_of(o));
    if (o.bevel.width > 0.0f) return bevelled_of(o);
    return unbevelled_of(o);
}

}  // namespace text_to_mesh
