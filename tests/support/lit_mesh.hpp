// SPDX-License-Identifier: MIT
#pragma once

// Meshes with everything that light and texture need, and the laws of a plan's mesh.

#include "support/catch.hpp"

#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace test {

struct lit_vertex {
    typemesh::vec3 place, normal;
    typemesh::vec4 tangent;
    typemesh::vec2 uv;
    typemesh::part of;

    friend bool operator==(const lit_vertex&, const lit_vertex&) = default;
};

struct lit_mesh {
    std::vector<lit_vertex> vertices;
    std::vector<std::uint32_t> indices;

    friend bool operator==(const lit_mesh&, const lit_mesh&) = default;
    [[nodiscard]] auto view() const { return typemesh::inspect::mesh_view{vertices, indices, &lit_vertex::place}; }
};

}  // namespace test

template <>
struct typemesh::vertex_traits<test::lit_vertex> {
    static constexpr auto wants =
        attribute::position | attribute::normal | attribute::tangent | attribute::uv | attribute::part;
    test::lit_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal, s.tangent, s.uv, s.part};
    }
};

namespace test {

/// A plan's mesh, which has the stated size.
template <class Plan>
lit_mesh written(const Plan& plan)
{
    lit_mesh m;
    REQUIRE(plan.write(typemesh::into(m.vertices, m.indices)));
    CHECK(typemesh::mesh_size{m.vertices.size(), m.indices.size() / 3} == plan.size());
    return m;
}

/// The same mesh, which is also closed, right side out, lit from outside, and fills its bounds; each part is in its range.
template <class Plan>
lit_mesh lawful(const Plan& plan, const typemesh::frame& f = typemesh::right_handed_y_up)
{
    using namespace typemesh;
    const lit_mesh m = written(plan);
    const int depth_axis = f.toward.x != 0.0f ? 0 : f.toward.y != 0.0f ? 1 : 2;
    CHECK(inspect::check_closedness(m.view(), depth_axis).is_closed());
    CHECK(inspect::check_normals(m.view(), &lit_vertex::normal, f.winding).is_right());
    CHECK(inspect::measure(m.view()).volume * f.winding > 0.0);
    REQUIRE_FALSE(m.vertices.empty());
    bounds3 seen{m.vertices[0].place, m.vertices[0].place};
    for (const lit_vertex& v : m.vertices) seen.add(v.place);
    CHECK(plan.bounds().low == seen.low);
    CHECK(plan.bounds().high == seen.high);
    std::uint32_t next = 0, next_index = 0;
    for (const part p : plan.parts()) {
        const mesh_range r = plan.range(p);
        CHECK(r.first_vertex == next);
        CHECK(r.first_index == next_index);
        for (; next < r.first_vertex + r.vertex_count; ++next) REQUIRE(m.vertices[next].of == p);
        next_index += r.index_count;
    }
    CHECK(next == m.vertices.size());
    CHECK(next_index == m.indices.size());
    for (std::size_t p = plan.parts().size(); p < max_parts; ++p) CHECK(plan.range(all_parts[p]).vertex_count == 0);
    return m;
}

}  // namespace test
