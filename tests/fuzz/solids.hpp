// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_loops.hpp"

#include "support/mesh_laws.hpp"
#include "support/solid_in_cells.hpp"

#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/shared_normals.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/inspect/euler_count.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

/// Closed polylines -> region -> solids: extruded, and bevelled. An em is as large as the drawing, or 2^20 cells.
namespace fuzz {

namespace solid_laws {

using namespace typemesh;

/// A mesh as a sink gets it, with positions in cells.
struct mesh {
    static constexpr attribute wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent;
    std::vector<surface_point<wants>> vertices;
    std::vector<std::uint32_t> indices;
    mesh_size announced;

    error begin(mesh_size exact) noexcept
    {
        announced = exact;
        return {};
    }
    void vertex(const surface_point<wants>& v) noexcept { vertices.push_back(v); }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        indices.insert(indices.end(), {a, b, c});
    }
    void end() noexcept {}
    [[nodiscard]] auto view() const { return inspect::mesh_view{vertices, indices}; }
};

/// The region of drawn loops, each edge with a line as its curve.
struct drawn_region {
    cap_builder caps, further;
    std::vector<curve> lines;
    region made;
    double em = 0x1p20;
    bool is_small = false;  ///< floats can tell all its points apart

    broken_law fill(values& in)
    {
        const fill_rule rule = in.flag() ? fill_rule::even_odd : fill_rule::non_zero;
        const bool fits = in.flag(), tolerant = in.flag();
        loop_reader reader{in};
        is_small = reader.is_small();
        const std::vector<polyline> drawn = reader.read(40);
        double reach = 16.0;
        for (const polyline& l : drawn)
            for (std::size_t i = 0; i < l.size(); ++i) {
                const grid_point a = l[i], b = l[(i + 1) % l.size()];
                lines.push_back(curve::from(point{double(a.x), double(a.y)}, point{double(b.x), double(b.y)}));
                reach = (std::max)({reach, std::fabs(double(a.x)), std::fabs(double(a.y))});
            }
        if (fits) em = reach;
        contours c = test::contours_of(drawn);
        for (contour_edge& e : c.edges) e.t0 = 0.0f, e.t1 = 1.0f;
        c.curves = lines;
        c.grid.cells = 1.0;
        c.grid.units_per_em = em;
        if (tolerant) c.tolerance = em / 1600.0;
        caps.loops() = std::move(c);
        const auto filled = in.flag() ? caps.fill({rule}, constrained_delaunay{}) : caps.fill({rule}, monotone{});
        if (!filled) return filled.error().message();
        made = *filled;
        return {};
    }
};

/// Closed, finite, of the announced size.
template <class Extruder>
broken_law of_mesh(const mesh& m, const Extruder& how, const drawn_region& from, const part_sizes& sizes)
{
    if (m.announced.vertices != m.vertices.size() || 3 * m.announced.triangles != m.indices.size())
        return "another size than announced";
    const inspect::closedness closed = inspect::check_closedness(m.view());
    if (closed.bad_corners != 0) return "a corner is no vertex or not finite";
    if (closed.unmatched_edges != 0) return "the mesh is open";
    for (const auto& v : m.vertices) {
        const inspect::place n = inspect::to_place(v.normal), t = inspect::to_place(v.tangent);
        if (!(std::fabs(inspect::dot(n, n) - 1.0) < 2e-5)) return "a normal is not of unit length";
        if (!(std::fabs(inspect::dot(t, t) - 1.0) < 2e-5)) return "a tangent is not of unit length";
        if (!(std::fabs(inspect::dot(n, t)) < 2e-5)) return "a tangent is askew";
        if (!is_finite(double(v.uv.x)) || !is_finite(double(v.uv.y))) return "a texture coordinate is not finite";
        const double z = double(v.position.z), slack = 1e-6 * from.em + 1e-3;
        if (!(z >= how.heights().low * from.em - slack && z <= how.heights().high * from.em + slack))
            return "a vertex lies above or below the solid";
    }
    const auto points = from.made.points();
    if (sizes.vertices[part::front] < 3 && !points.empty() && std::same_as<Extruder, extruded<>>) return "no front";
    return {};
}

/// The volume is the cap's area times the depth, and the region has as many solids and holes.
template <class Extruder>
broken_law of_extruded(const Extruder& how, drawn_region& from)
{
    mesh m;
    plan_data_of<Extruder> data;
    const auto plan = test::write_in_cells(how, from.made, from.caps, from.em, data, m);
    if (!plan) return plan.error().message();
    if (broken_law broken = of_mesh(m, how, from, plan->sizes); !broken.empty()) return broken;
    if (!from.is_small) return {};
    const double depth = double(static_cast<float>(double(how.depth) * from.em)),
                 area = 0.5 * static_cast<double>(inspect::doubled_area(inspect::loops_of(from.made)));
    const double volume = inspect::measure(m.view()).volume;
    if (!(std::fabs(volume - area * depth) <= 1e-5 * area * depth + 1e-3)) return "the volume is not area times depth";
    if (inspect::check_closedness(m.view()).zero_area != 0) return "a triangle without an area";
    const auto lit = inspect::check_normals(m.view(), [](const auto& v) { return v.normal; }, 1, 2e-5);
    if (lit.against_winding != 0) return "a triangle is lit from inside";
    const inspect::euler_count euler = inspect::count_euler(m.view());
    const bool apart = !from.made.is_touching();
    if (apart && euler.solids != from.made.outers()) return "the numbers of solids and outer loops differ";
    if (apart && euler.holes() != from.made.holes()) return "the numbers of holes differ";
    return {};
}

/// One of the ready profiles by its number, 1 to 6, with options from some bytes, or else a profile of random points.
inline bevel_profile read_profile(values& in, std::uint32_t ready)
{
    const std::uint32_t steps = ready >= 1 && ready <= 6 ? in.byte() % 67 : 0;
    switch (ready) {
    case 1: return chamfer_profile();
    case 2: return round_profile(steps);
    case 3: return concave_profile(steps);
    case 4: return stepped_profile();
    case 5: return engraved_profile();
    case 6: {
        const auto number_below = [&](float most) { return most * float(in.below(9)) / 8.0f; };
        bezier_section curve{{number_below(1.0f), number_below(1.5f)}, {number_below(1.0f), number_below(1.5f)}};
        curve.end = number_below(1.0f);
        return bezier_profile(curve, steps);
    }
    default: break;
    }
    profile_points points;
    float t = 0.0f;
    points.add({0.0f, 0.0f});
    for (std::uint32_t left = in.below(6); left > 0; --left) {
        t = (std::min)(1.0f, t + float(in.below(5)) / 8.0f);
        points.add({t, float(in.below(9)) / 8.0f});
    }
    points.add({1.0f, in.flag() ? 1.0f : float(in.below(5)) / 4.0f});
    return points;
}

inline bevelled read_bevel(values& in, std::uint32_t ready)
{
    static constexpr float widths[] = {0.0f, 2e-6f, 1e-5f, 0.001f, 0.005f, 0.02f, 0.05f, 0.1f, 0.3f, 1.0f, 4.0f},
                           mitres[] = {0.0f, 1.0f, 1.5f, 2.0f, 100.0f}, creases[] = {0.0f, 15.0f, 44.0f, 90.0f, 180.0f};
    const std::uint32_t bits = in.byte();
    bevelled how{.profile = read_profile(in, ready)};
    how.width = in.one_of(widths) * float(in.between(0.5, 1.5));
    how.bevel_depth = float(in.between(0.0, 0.099));
    how.sides = static_cast<bevel_sides>((bits & 3) % 3);
    how.mode = (bits & 4) != 0 ? bevel_mode::fit : bevel_mode::clip;
    how.outward = (bits & 8) != 0;
    how.joins = (bits & 16) != 0 ? bevel_joins{1} : bevel_joins{0};
    how.shading = (bits & 32) != 0 ? bevel_shading::rounded : bevel_shading::by_slope;
    how.centred = (bits & 64) != 0;
    how.texture = texture_mappings[bits % std::size(texture_mappings)];
    how.mitre_limit = in.one_of(mitres);
    how.crease_degrees = in.one_of(creases);
    how.profile_crease_degrees = in.one_of(creases);
    return how;
}

/// Closed, and never larger than the letter. An outward bevel only adds to the letter.
inline broken_law of_bevelled(const bevelled& how, drawn_region& from)
{
    bevel_data data;
    mesh m;
    const auto plan = test::write_in_cells(how, from.made, from.caps, from.em, data, m);
    if (!plan) {
        const error e = plan.error();
        const bool refused = e == error::bad_option || e == error::outline_beyond_grid;
        return refused || (how.outward && e == error::crossing_contours) ? "" : e.message();
    }
    if (broken_law broken = of_mesh(m, how, from, plan->sizes); !broken.empty()) return broken;
    if (!from.is_small || how.outward) return {};
    const double depth = double(how.depth) * from.em,
                 area = 0.5 * static_cast<double>(inspect::doubled_area(inspect::loops_of(from.made)));
    const double length = inspect::length(inspect::loops_of(from.made)), volume = inspect::measure(m.view()).volume;
    const double rounded = (2.0 * length + 16.0) * depth;  // nodes are rounded to cells
    if (!(volume <= area * depth + rounded && volume >= -rounded))
        return "a bevel takes away more than there is, or adds something";
    return {};
}

}  // namespace solid_laws

inline broken_law solids(values in)
{
    using namespace typemesh;
    using namespace solid_laws;
    const std::uint32_t what = in.byte(), kind = what >> 3;
    const bevelled bevel = read_bevel(in, kind);
    drawn_region from;
    if (broken_law broken = from.fill(in); !broken.empty()) return broken;
    if (from.made.points().empty()) return {};
    if (what % 8 >= 2) return of_bevelled(bevel, from);
    const auto with = [&]<class Normals>(Normals normals) {
        const extruded<Normals> how{
            .depth = bevel.depth, .centred = bevel.centred, .texture = bevel.texture, .normals = normals};
        return of_extruded(how, from);
    };
    if (what % 8 == 1) return with(shared_normals{});
    switch (kind % 4) {
    case 1: return with(creased_normals{});
    case 2: return with(averaged_normals{});
    default: return with(curve_normals{});
    }
}

}  // namespace fuzz
