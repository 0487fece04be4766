// SPDX-License-Identifier: MIT
#pragma once

// Solids of extruders that use caps, made as the library makes them, and laws that these extruders share.

#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

namespace meshes {

/// Caps as the library makes them.
template <class Triangulator = monotone>
class caps_by {
public:
    explicit caps_by(const region& r) { REQUIRE(of_region_.cap(r, Triangulator{})); }

    [[nodiscard]] auto maker() noexcept { return region_caps{of_region_, further_, cut_}; }

private:
    cap_builder of_region_, further_;
    Triangulator cut_;
};

/// Caps whose first fills are refused.
template <class Caps>
struct refusing_caps {
    Caps& caps;
    int refusals;

    [[nodiscard]] std::span<const triangle> triangles() const noexcept { return caps.triangles(); }
    error operator()(const region& r, triangle_list& out) noexcept { return caps(r, out); }
    [[nodiscard]] contours& loops() noexcept { return caps.loops(); }
    result<region> fill(triangle_list& out) noexcept
    {
        if (refusals-- > 0) return error::crossing_contours;
        return caps.fill(out);
    }
    [[nodiscard]] workspace& space() noexcept { return caps.space(); }
};

template <class E>
struct capped_mesh : mesh<everything> {
    solid_plan plan;
    plan_data_of<E> data;

    [[nodiscard]] const part_sizes& sizes() const { return plan.sizes; }
};

template <class E>
struct planned {
    solid_plan plan;
    plan_data_of<E> data;
};

/// What an extruder plans with these caps.
template <class E, class Caps>
planned<E> plan_solid_of(const shapes::shape& s, const E& how, Caps& caps)
{
    planned<E> made;
    const auto plan = plan_solid(how, s.made(), made.data, caps);
    REQUIRE(plan);
    made.plan = *plan;
    return made;
}

template <class E>
planned<E> plan_solid_of(const shapes::shape& s, const E& how)
{
    caps_by<> caps{s.made()};
    auto maker = caps.maker();
    return plan_solid_of(s, how, maker);
}

/// A planned solid over its shape.
template <class E>
solid_of<E> form_of(const shapes::shape& s, const plan_data_of<E>& data)
{
    return {{s.loops.points.view(), s.loops.starts.view(), s.cap}, data.read()};
}

template <class Triangulator = monotone, class E>
error build_capped(const shapes::shape& s, const E& how, capped_mesh<E>& to, const placement& at = in_em())
{
    const region r = s.made();
    caps_by<Triangulator> caps{r};
    auto maker = caps.maker();
    const auto plan = plan_solid(how, r, to.data, maker);
    if (!plan) return plan.error();
    to.plan = *plan;
    return write_solid<E>({form_of<E>(s, to.data), *plan}, how, at, static_cast<mesh<everything>&>(to)).error();
}

template <class Triangulator = monotone, class E>
capped_mesh<E> capped(const shapes::shape& s, const E& how, const placement& at = in_em())
{
    capped_mesh<E> m;
    REQUIRE_FALSE(build_capped<Triangulator>(s, how, m, at));
    CHECK(m.announced == m.sizes().total());
    CHECK(m.vertices.size() == m.announced.vertices);
    CHECK(m.triangles.size() == m.announced.triangles);
    CHECK(m.in_order);
    return m;
}

template <class E>
std::span<const surface_point<everything>> vertices_of(const capped_mesh<E>& m, part p)
{
    return std::span{m.vertices}.subspan(m.sizes().starts().vertices[p], m.sizes().vertices[p]);
}

template <class E>
auto triangles_of(const capped_mesh<E>& m, part p)
{
    return std::span{m.triangles}.subspan(m.sizes().starts().triangles[p], m.sizes().triangles[p]);
}

/// In em, with the sign of the winding.
template <class Mesh>
double volume_of(const Mesh& m)
{
    const auto indices = indices_of(m);
    return inspect::measure(inspect::mesh_view{m.vertices, indices}).volume;
}

/// The laws that every mesh of a solid obeys.
template <class Mesh>
void check_laws(const Mesh& m, const frame& f = right_handed_y_up)
{
    CHECK(open_edges(m) == 0);
    const auto indices = indices_of(m);
    const auto normals =
        check_normals(inspect::mesh_view{m.vertices, indices}, [](const auto& v) { return v.normal; }, f.winding, 2e-6);
    CHECK(normals.is_right());
    CHECK(normals.triangles == m.triangles.size());
    for (const auto& v : m.vertices) check_tangent(v, 2e-6);
}

/// These options are refused by the name of one of them, with and without a region.
template <class E>
void check_refused(const char* name, const E& how)
{
    INFO(name);
    capped_mesh<E> m;
    const error refusals[] = {refused_options(how), build_capped(shapes::rectangle(), how, m)};
    for (const error& e : refusals) {
        CHECK(e == error::bad_option);
        REQUIRE(e.option != nullptr);
        CHECK(std::string{e.option} == name);
    }
}

/// This solid is too large, or too small, for a rectangle: it is refused by the name of an option.
template <class E>
void check_refused_size(const char* name, const E& how)
{
    capped_mesh<E> m;
    CHECK(std::string{build_capped(shapes::rectangle(), how, m).option} == name);
}

/// An extruder needs to know how many units an em has.
template <class E>
void check_unknown_em()
{
    shapes::shape unknown = shapes::rectangle();
    unknown.loops.grid.units_per_em = 0.0;
    capped_mesh<E> m;
    CHECK(std::string{build_capped(unknown, E{}, m).option} == "units_per_em");
}

template <class E>
void check_empty_region(const E& how)
{
    plan_data_of<E> data;
    no_caps nothing;
    const auto empty = plan_solid(how, region{}, data, nothing);
    REQUIRE(empty);
    CHECK(empty->sizes.total() == mesh_size{});
}

/// A plan that gets fewer blocks of memory than it needs reports it. It needs at most `most` blocks.
template <class E>
void check_scarce_memory(const E& how, std::size_t most)
{
    const auto s = shapes::letter_d(8);
    bool done = false;
    for (std::size_t allowed = 0; !done && allowed <= most; ++allowed) {
        test::counting_memory memory;
        memory.fail_at = allowed + 1;
        plan_data_of<E> scarce{memory.source()};
        caps_by<> caps{s.made()};
        auto maker = caps.maker();
        const auto plan = plan_solid(how, s.made(), scarce, maker);
        done = static_cast<bool>(plan);
        if (!done) CHECK(plan.error() == error::out_of_memory);
    }
    CHECK(done);
}

/// A plan is the same in memory that another one has used.
template <class E>
void check_planned_anew(const E& how)
{
    plan_data_of<E> data;
    const auto large = shapes::ring(8), small = shapes::rectangle();
    caps_by<> of_large{large.made()}, of_small{small.made()};
    auto large_caps = of_large.maker();
    auto small_caps = of_small.maker();
    const auto first = plan_solid(how, small.made(), data, small_caps);
    REQUIRE(first);
    data.clear();
    REQUIRE(plan_solid(how, large.made(), data, large_caps));
    data.clear();
    const auto again = plan_solid(how, small.made(), data, small_caps);
    REQUIRE(again);
    CHECK(again->sizes == first->sizes);
}

/// Where the first new edges are refused, the plan for `wide` is that for `narrow`. Where all are, there is none.
template <class E>
void check_refused_edges(const E& narrow, const E& wide)
{
    const auto s = shapes::letter_d(8);
    caps_by<> caps{s.made()};
    auto maker = caps.maker();
    const auto expected = plan_solid_of(s, narrow, maker);
    CHECK_FALSE(expected.plan.narrowed);
    refusing_caps<decltype(maker)> refusing{maker, 1};
    const auto narrowed = plan_solid_of(s, wide, refusing);
    CHECK(narrowed.plan.narrowed);
    CHECK(narrowed.plan.sizes == expected.plan.sizes);
    CHECK(narrowed.plan.around.low == expected.plan.around.low);
    refusing.refusals = 1000;
    plan_data_of<E> data;
    CHECK(plan_solid(E{}, s.made(), data, refusing).error() == error::edges_not_moved);
}

}  // namespace meshes
