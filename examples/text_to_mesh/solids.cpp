// SPDX-License-Identifier: MIT
#include "solids.hpp"

namespace text_to_mesh {
namespace {

constexpr float plate_depth = 0.25f;  // of a background, times the depth of letters

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

}  // namespace

options options_of(const options& o, const typemesh::markup_solid& tags)
{
    using typemesh::markup_tag;
    options own = o;
    if (tags.has(markup_tag::mark)) {  // a plate from which the letters rise
        own.depth *= plate_depth;
        own.bevel.width = own.bevel.depth = 0.0f;
    }
    if (tags.has(markup_tag::depth)) own.depth = static_cast<float>(tags.depth);
    if (tags.has(markup_tag::bevel)) own.bevel.width = own.bevel.depth = static_cast<float>(tags.bevel);
    if (tags.has(markup_tag::bold)) own.embolden += static_cast<float>(bold_growth);
    const bool edges_move = tags.has(markup_tag::bevel) || tags.has(markup_tag::bold);
    if (edges_move && !o.keeps_apart) own.merge = true;  // as by --bevel
    return own;
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

typemesh::tubed tubed_of(const options& o)
{
    typemesh::tubed solid{.radius = o.tube.radius, .sides = o.tube.sides};
    solid.texture = o.uv;
    if (o.crease) solid.crease_degrees = *o.crease;
    return solid;
}

typemesh::inflated inflated_of(const options& o)
{
    typemesh::inflated solid{.height = o.inflate.height, .form = o.inflate.form, .texture = o.uv};
    if (o.inflate.form == typemesh::inflated_form::dome) solid.depth = o.depth;
    if (o.crease) solid.crease_degrees = *o.crease;
    return solid;
}

}  // namespace text_to_mesh
