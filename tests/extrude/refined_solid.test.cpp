// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/refined_solid.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/flat.hpp>

#include <vector>

#include "mesh.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

static_assert(refinable_extruder<flat> && refinable_extruder<extruded<>> && !refinable_extruder<bevelled>);

namespace {

/// Writes a rectangle to a cap, with so many points on the middle line, and triangles around them.
///
///     3-----------2        one point: the four triangles around it; each further one lies in the triangle 0, 1, last
///     | \  ...  / |
///     |    .4     |
///     0-----------1
void write_fan(const refined_cap& out, const shapes::shape& s, std::uint32_t count)
{
    out.loops.clear();
    out.inner.clear();
    out.triangles.clear();
    REQUIRE(out.loops.points.append(s.loops.points.view()));
    REQUIRE(out.loops.edges.append(s.loops.edges.view()));
    REQUIRE(out.loops.starts.append(s.loops.starts.view()));
    out.loops.grid = s.loops.grid;
    out.loops.curves = s.curves;
    const auto p = s.loops.points.view();
    const grid_point middle{std::int32_t((std::int64_t{p[0].x} + p[2].x) / 2),
                            std::int32_t((std::int64_t{p[0].y} + p[2].y) / 2)};
    std::uint32_t last = 4;
    REQUIRE(out.inner.push_back(middle));
    for (const std::uint32_t k : {1u, 2u, 3u}) REQUIRE(out.triangles.push_back({k, (k + 1) % 4, last}));
    for (std::uint32_t i = 1; i < count; ++i) {  // between the last one and the first edge
        const grid_point q = out.inner.back();
        REQUIRE(out.inner.push_back({q.x, q.y - (q.y - p[0].y) / 2}));
        REQUIRE(out.triangles.push_back({1, last, last + 1}));
        REQUIRE(out.triangles.push_back({0, last + 1, last}));
        ++last;
    }
    REQUIRE(out.triangles.push_back({0, 1, last}));
}

template <class E>
void check_fan(const E& how, std::uint32_t caps_count)
{
    const auto s = shapes::rectangle();
    REQUIRE(s.points() == 4);
    no_caps maker;
    refined_solid<E> solid;
    for (const std::uint32_t count : {1u, 2u, 5u}) {
        CAPTURE(count);
        solid.clear();
        std::uint32_t kept = 7;
        write_fan(solid.out(kept), s, count);
        const auto plan = solid.plan_refined(how, s.made(), maker);
        REQUIRE(plan);
        CHECK(solid.loops.points.size() == 4 + count);
        CHECK(plan->sizes.vertices[part::front] == 4 + count);
        CHECK(plan->sizes.triangles[part::front] == 2 + 2 * count);
        CHECK(solid.triangles.size() == 2 + 2 * count);
        meshes::mesh<> m;
        REQUIRE(write_solid<E>({solid.read(), *plan}, how, meshes::in_em(), m));
        CHECK(m.vertices.size() == m.announced.vertices);
        CHECK(m.triangles.size() == m.announced.triangles);
        CHECK(meshes::open_edges(m) == (caps_count == 2 ? 0u : 4u));
        double area = 0.0;
        const auto p = solid.loops.points.view();
        for (const triangle t : solid.triangles) area += double(orientation(p[t.a], p[t.b], p[t.c]));
        CHECK(area == 2.0 * double(p[2].x - p[0].x) * double(p[2].y - p[0].y));
    }
    solid.clear();
    CHECK(solid.inner.empty());
    CHECK(solid.loops.points.empty());
}

}  // namespace

TEST_CASE("a refined solid's caps get the inner points, and it stays closed", "[extrude][refined_solid]")
{
    check_fan(flat{}, 1);
    check_fan(extruded<>{}, 2);
}

TEST_CASE("a refined solid without memory says so", "[extrude][refined_solid]")
{
    const auto s = shapes::rectangle();
    no_caps maker;
    bool failed_at_last = false, done = false;
    for (std::size_t nth = 1; !done; ++nth) {
        test::counting_memory memory{};
        refined_solid<extruded<>> solid{memory.source()};
        std::uint32_t kept = 0;
        write_fan(solid.out(kept), s, 40);
        memory.fail_at = memory.requests + nth;
        memory.fail_once = true;
        const auto plan = solid.plan_refined(extruded<>{}, s.made(), maker);
        done = memory.requests < memory.fail_at;
        CHECK(bool(plan) == done);
        if (!plan) {
            CHECK(plan.error() == error::out_of_memory);
            failed_at_last = true;
        }
    }
    CHECK(failed_at_last);
}
