// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_shapes.hpp"

#include "support/ridge_laws.hpp"

#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/inspect/manifoldness.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Region -> inflated and carved letters.
namespace fuzz {

namespace relief_laws {

using namespace typemesh;
using namespace solid_laws;

/// Closed, every vertex belongs to a triangle and is lit from its front, and everything inside has a height.
inline broken_law of_inflated(const inflated& how, drawn_shape& from)
{
    inflated_data data;
    mesh m;
    const auto plan = test::write_in_cells(how, from.made, from.caps, from.em, data, m);
    if (!plan) return unless_one_of(plan.error(), {error::bad_option, error::too_many_points});
    if (broken_law broken = of_mesh(m, how, from, plan->sizes); !broken.empty()) return broken;
    if (how.form == inflated_form::balloon && from.fits_floats() &&
        inspect::check_manifoldness(m.view()).crowded_edges != 0)
        return "front and back share an edge";
    const auto lit = inspect::check_normals(m.view(), [](const auto& v) { return v.normal; });
    if (from.fits_floats() && lit.inward_corners != 0) return "a normal points to the back of a triangle";
    std::vector<bool> is_used(m.vertices.size());
    for (const std::uint32_t i : m.indices) is_used[i] = true;
    for (const bool used : is_used)
        if (!used) return "a vertex belongs to no triangle";
    for (const membrane_point& p : data.working.points())
        if (!(p.height > 0.0f) || !is_finite(double(p.slope.x)) || !is_finite(double(p.slope.y)))
            return "a place inside has no height or no slope";
    const double volume = inspect::measure(m.view()).volume;
    return volume >= 0.0 ? "" : "the volume is negative";
}

/// Closed, unless it is a groove; and nowhere deeper than it is far from the outline.
inline broken_law of_carved(const carved& how, drawn_shape& from)
{
    carved_data data;
    mesh m;
    const auto plan = test::write_in_cells(how, from.made, from.caps, from.em, data, m);
    if (!plan) return unless_one_of(plan.error(), {error::bad_option, error::outline_beyond_grid});
    if (how.as != carving::groove)
        if (broken_law broken = of_mesh(m, how, from, plan->sizes); !broken.empty()) return broken;
    if (!from.is_small || from.made.points().size() > 200) return {};
    const test::plain_outline outline{from.made};
    const double slope = 1.0 / std::tan(double(how.tool_angle) * 3.14159265358979323846 / 360.0);
    for (std::size_t i = 0; i < m.vertices.size(); ++i) {
        const vec3 p = m.vertices[i].position;
        const double depth = std::fabs(double(p.z));
        if (!(depth > 0.0)) continue;
        const double wanted = outline.distance(double(p.x), double(p.y)), is = depth / slope,
                     slack = from.made.tolerance() + 4.0 + wanted / 800.0 + 1e-5 * (is + from.em);
        if (is > wanted + slack) return "it is deeper than the distance from the outline";
    }
    return {};
}

}  // namespace relief_laws

inline broken_law reliefs(values in)
{
    using namespace typemesh;
    using namespace relief_laws;
    static constexpr float edges[] = {0.03f, 0.1f, 0.3f, 0.01f, 2.0f, 0.003f}, heights[] = {1.0f, 0.2f, 5.0f},
                           limits[] = {0.0f, 0.02f, 0.3f}, tools[] = {90.0f, 1.0f, 30.0f, 60.0f, 150.0f, 179.0f},
                           depths[] = {0.0f, 0.03f, 0.1f, 0.001f, 2.0f}, creases[] = {15.0f, 0.0f, 44.0f, 180.0f};
    const std::uint32_t bits = in.byte();
    inflated balloon{.height = in.one_of(heights), .edge = in.one_of(edges) * float(in.between(0.75, 1.5))};
    balloon.limit = in.one_of(limits);
    balloon.form = (bits & 2) != 0 ? inflated_form::dome : inflated_form::balloon;
    balloon.max_points = 3000;
    carved bit{.tool_angle = in.one_of(tools), .max_depth = in.one_of(depths)};
    bit.as = static_cast<carving>((bits >> 2) % 3);
    bit.ridges = (bits & 16) != 0;
    balloon.crease_degrees = bit.crease_degrees = in.one_of(creases);
    balloon.texture = bit.texture = texture_mappings[(bits >> 5) % std::size(texture_mappings)];
    drawn_shape from;
    if (broken_law broken = from.read(in); !broken.empty()) return broken;
    if (from.made.points().empty()) return {};
    return (bits & 1) != 0 ? of_carved(bit, from) : of_inflated(balloon, from);
}

}  // namespace fuzz
