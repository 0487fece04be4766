// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_shapes.hpp"

#include <typemesh/bend/along_curve.hpp>
#include <typemesh/bend/displaced.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/taper.hpp>
#include <typemesh/bend/text_path.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/wave.hpp>
#include <typemesh/extrude/bent.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

/// Region -> bent solids, extruded and bevelled, by each ready deformation.
namespace fuzz {

namespace bend_laws {

using namespace typemesh;
using namespace solid_laws;

/// One of the ready deformations.
struct any_deformation {
    std::variant<on_cylinder, on_sphere, twist, taper, displaced<wave>, along_curve> one;

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        return std::visit([&](const auto& d) { return d(p); }, one);
    }
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        return std::visit([&](const auto& d) { return d.bend(b); }, one);
    }
    [[nodiscard]] error refused_options() const noexcept
    {
        return std::visit([](const auto& d) { return d.refused_options(); }, one);
    }
    [[nodiscard]] error refused_text(const box3& text) const noexcept
    {
        return std::visit([&](const auto& d) { return typemesh::refused_text(d, text); }, one);
    }
};
static_assert(deformation<any_deformation>);

inline any_deformation read_deformation(values& in, text_path& path)
{
    static constexpr double radii[] = {2.0, -2.0, 0.3, -0.5, 60.0, 0.01, 0.0, 1e6};
    static constexpr double turns[] = {20.0, -75.0, 360.0, 0.0, 1e5}, growths[] = {-0.1, 0.3, 0.0, -2.0, 1e3},
                            lengths[] = {2.0, -0.7, 0.1, 0.0, 100.0};
    const std::uint32_t kind = in.below(6), bits = in.byte();
    const text_axis axis = (bits & 1) != 0 ? text_axis::up : text_axis::along;
    switch (kind) {
    case 0: return {on_cylinder{.radius = in.one_of(radii) * in.between(0.5, 2.0), .axis = axis}};
    case 1: return {on_sphere{.radius = in.one_of(radii) * in.between(0.5, 2.0)}};
    case 2: {
        const double turn = in.one_of(turns);
        return {twist{.degrees_per_em = turn, .axis = axis, .across = in.between(-2.0, 2.0), .depth = 0.0}};
    }
    case 3: return {taper{.growth = in.one_of(growths) * in.between(0.5, 2.0), .axis = axis}};
    case 4: {
        const double size = in.one_of(lengths), height = in.between(-1.0, 1.0);
        return {displaced<wave>{{.height = height, .length = size, .direction = 45.0 * (bits >> 5), .phase = 10.0}}};
    }
    default: {
        std::vector<double3> points(2 + bits % 5);
        for (double3& p : points) {
            p.x = in.between(-4.0, 4.0);
            p.y = in.between(-4.0, 4.0);
            p.z = in.between(-4.0, 4.0);
        }
        (void)path.through(points);  // an empty path is refused later
        return {along_curve{.path = &path, .start = in.between(-2.0, 4.0)}};
    }
    }
}

/// A planned solid and its meshes, bent and flat, in em.
template <class Solid>
struct bent_pair {
    bent_data<Solid> data;
    mesh bent_one, flat_one;

    result<solid_plan> make(const bent<any_deformation, Solid>& how, drawn_shape& from, point origin)
    {
        cap_builder further;
        static const monotone cut;
        region_caps maker{from.caps, further, cut, from.caps.triangles().view(), {origin, 1.0}};
        const auto plan = plan_solid(how, from.made, data, maker);
        if (!plan) return plan;
        placement at;
        at.unit_per_cell = at.em_per_cell = 1.0 / from.em;
        at.pen = at.em_pen = from.em * origin;
        const solid_of<bent<any_deformation, Solid>> form{
            {from.made.points(), from.made.starts(), from.caps.triangles().view()}, data.read()};
        using bent_type = bent<any_deformation, Solid>;
        if (const auto done = write_solid<bent_type>({form, *plan}, how, at, bent_one); !done) return done.error();
        Solid solid = how.solid;
        const auto own = data.form.template of<bent_form>().view();
        if (!own.empty()) set_segments(solid, own[0].segments);
        solid_plan flat_plan = *plan;
        flat_plan.around = plan->textured;
        if (const auto done = write_solid<Solid>({data.flat.read(), flat_plan}, solid, at, flat_one); !done)
            return done.error();
        return plan;
    }
};

inline double3 wide(vec3 v) { return {double{v.x}, double{v.y}, double{v.z}}; }
inline double largest(double3 v) { return (std::max)({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// No triangle's middle is farther than the tolerance from its place on the bent solid; more by what floats round.
template <class Solid>
broken_law of_places(const bent_pair<Solid>& made, const any_deformation& d, double tolerance)
{
    const auto &bent = made.bent_one.vertices, &flat = made.flat_one.vertices;
    for (std::size_t i = 0; i + 2 < made.bent_one.indices.size(); i += 3) {
        double3 is{}, from{};
        double slack = tolerance;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t v = made.bent_one.indices[i + k];
            const double3 p = wide(flat[v].position), q = wide(bent[v].position);
            const deformed_point at = d(p);
            slack += 1e-6 * (largest(q) + largest(p) * (length(at.x) + length(at.y) + length(at.z)));
            is = is + (1.0 / 3.0) * q;
            from = from + (1.0 / 3.0) * p;
        }
        if (!(length(d(from).at - is) <= slack)) return "a triangle is farther away than the tolerance";
    }
    return {};
}

/// Closed, as large as announced, within its bounds and the tolerance.
template <class Solid>
broken_law of_bent(const bent<any_deformation, Solid>& how, drawn_shape& from, point origin)
{
    bent_pair<Solid> made;
    const auto plan = made.make(how, from, origin);
    if (!plan)
        return unless_one_of(plan.error(),
                             {error::bad_option, error::folds_over, error::goes_around, error::too_many_points,
                              error::outline_beyond_grid, error::crossing_contours});
    const mesh& m = made.bent_one;
    if (m.announced.vertices != m.vertices.size() || 3 * m.announced.triangles != m.indices.size())
        return "another size than announced";
    const inspect::closedness closed = inspect::check_closedness(m.view());
    if (closed.bad_corners != 0) return "a corner is no vertex or not finite";
    if (closed.unmatched_edges != 0) return "the mesh is open";
    const solid_of<bent<any_deformation, Solid>> form{
        {from.made.points(), from.made.starts(), from.caps.triangles().view()}, made.data.read()};
    const height_range heights = how.heights(form);
    const box& around = plan->around;
    for (const auto& v : m.vertices) {
        const inspect::place n = inspect::to_place(v.normal), t = inspect::to_place(v.tangent);
        if (!(std::fabs(inspect::dot(n, n) - 1.0) < 2e-5)) return "a normal is not of unit length";
        if (!(std::fabs(inspect::dot(t, t) - 1.0) < 2e-5)) return "a tangent is not of unit length";
        const double3 p = wide(v.position);
        const double x = from.em * (p.x - origin.x), y = from.em * (p.y - origin.y),
                     slack = from.em * 1e-6 * (1.0 + largest(p));
        if (!(x >= around.low.x - slack && x <= around.high.x + slack && y >= around.low.y - slack &&
              y <= around.high.y + slack && p.z >= heights.low - slack && p.z <= heights.high + slack))
            return "a vertex lies beyond the bounds";
    }
    return of_places(made, how.how, how.tolerance);
}

}  // namespace bend_laws

inline broken_law bends(values in)
{
    using namespace typemesh;
    using namespace bend_laws;
    static constexpr double tolerances[] = {1.0 / 100, 1.0 / 800, 1.0 / 20, 1e-4, 0.3};
    const std::uint32_t bits = in.byte();
    text_path path;
    const any_deformation how = read_deformation(in, path);
    const double tolerance = in.one_of(tolerances), x = in.between(-1.0, 1.0);
    const point origin = (bits & 2) != 0 ? point{x, 0.1} : point{};
    const bevelled bevel = read_bevel(in, (bits & 4) != 0 ? 4 : 1);
    drawn_shape from;
    if (broken_law broken = from.read(in); !broken.empty()) return broken;
    if (from.made.points().empty()) return {};
    constexpr std::uint32_t limit = 1500;
    if ((bits & 1) != 0) return of_bent(bent<any_deformation, bevelled>{bevel, how, tolerance, limit}, from, origin);
    const extruded<> solid{.depth = bevel.depth, .centred = bevel.centred, .texture = bevel.texture};
    return of_bent(bent<any_deformation>{solid, how, tolerance, limit}, from, origin);
}

}  // namespace fuzz
