// SPDX-License-Identifier: MIT
#include "policies.hpp"

namespace text_to_mesh {

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
    using namespace typemesh;
    if (o.depth == 0.0f) return {flat{.texture = o.uv}};
    const auto with = [&](auto normals) -> chosen_extruder {
        return {extruded<decltype(normals)>{.depth = o.depth, .texture = o.uv, .normals = normals}};
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

}  // namespace text_to_mesh
