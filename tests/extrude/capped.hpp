// SPDX-License-Identifier: MIT
#pragma once

// Solids of extruders that ask for caps, as the library makes them, and the laws of their meshes.

#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "mesh.hpp"
#include "support/catch.hpp"

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

/// What an extruder plans with caps of the test's own.
template <class E, class Caps>
planned<E> plan_solid_of(const shapes::shape& s, const E& how, Caps& caps)
{
    planned<E> made;
    const auto plan = plan_solid(how, s.made(), made.data, caps);
    REQUIRE(plan);
    made.plan = *plan;
    return made;
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
    const solid_of<E> form{{r.points(), r.starts(), s.cap}, to.data.read()};
    return write_solid<E>({form, *plan}, how, at, static_cast<mesh<everything>&>(to)).error();
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

/// In em, with the sign that `winding` gives it.
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
    for (const auto& v : m.vertices) {
        const vec3 t{v.tangent.x, v.tangent.y, v.tangent.z};
        REQUIRE(meshes::length(t) == Catch::Approx(1.0).margin(2e-6));
        REQUIRE(std::abs(meshes::dot(wide(t), wide(v.normal))) < 2e-6);
        REQUIRE(std::abs(v.tangent.w) == 1.0f);  // NOLINT
    }
}

}  // namespace meshes
