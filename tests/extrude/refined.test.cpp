// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/cap_normals.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;
using namespace meshes;

static_assert(extruder<refined<flat>> && extruder<refined<extruded<shared_normals>>>);
static_assert(cacheable_policy<refined<>> && has_front_triangles<refined<>> && part_count_of<refined<flat>> == 3);
static_assert(!refinable_extruder<int>);

namespace {

/// A mesh of a refined shape, and its plan.
struct refined_mesh : built {
    solid_plan plan;
    std::vector<grid_point> inner;
};

template <class E>
result<refined_mesh> refine(const shapes::shape& s, const E& how, plan_data_of<E>& data)
{
    static const monotone cut;
    cap_builder caps, further;
    region_caps maker{caps, further, cut, array_view<const triangle>{s.cap}};
    data.clear();
    const region r = s.made();
    const auto plan = plan_solid(how, r, data, maker);
    if (!plan) return plan.error();
    refined_mesh out;
    out.plan = *plan;
    out.sizes = plan->sizes;
    out.inner.assign(data.inner.begin(), data.inner.end());
    const solid_of<E> form{{r.points(), r.starts(), s.cap}, data.read()};
    if (const auto done = write_solid<E>({form, *plan}, how, in_em(), static_cast<mesh<everything>&>(out)); !done)
        return done.error();
    return out;
}

/// Says of each cap that seven triangles miss its aim.
struct resigned : delaunay_refined {
    [[nodiscard]] error operator()(const region& r, array_view<const triangle> cap, scratch& space,
                                   const refined_cap& out) const noexcept
    {
        const error e = delaunay_refined::operator()(r, cap, space, out);
        out.kept = 7;
        return e;
    }
};

template <class E>
std::uint32_t kept_triangles_of(const E& how)
{
    plan_data_of<E> data;
    cap_builder caps, further;
    const monotone cut;
    const auto all = shapes::all();
    const shapes::shape& s = all[0];
    region_caps maker{caps, further, cut, array_view<const triangle>{s.cap}};
    const auto plan = plan_solid(how, s.made(), data, maker);
    REQUIRE(plan);
    return plan->kept_triangles;
}

/// The volume inside a mesh's triangles.
template <class Mesh>
double volume_of(const Mesh& m)
{
    return measure(inspect::mesh_view{m.vertices, indices_of(m)}).volume;
}

/// The area of the front, by its triangles.
double front_area(const refined_mesh& m)
{
    double area = 0.0;
    for (std::uint32_t t = m.first_triangle(part::front); t < m.end_triangle(part::front); ++t) {
        const auto& [a, b, c] = m.triangles[t];
        area += 0.5 * cross(minus(wide(m.vertices[b].position), wide(m.vertices[a].position)),
                            minus(wide(m.vertices[c].position), wide(m.vertices[a].position)))[2];
    }
    return area;
}

}  // namespace

TEMPLATE_TEST_CASE("a refined solid is closed, and its caps and walls share every point", "[extrude][refined]",
                   curve_normals, creased_normals, averaged_normals, shared_normals, cap_normals)
{
    for (const auto& s : shapes::all()) {
        for (const float longest : {0.0f, 0.1f, 0.02f}) {
            INFO(s.name << ", no edge longer than " << longest);
            const refined<extruded<TestType>> how{.how = {.min_angle = 22.0f, .max_edge = longest}};
            plan_data_of<refined<extruded<TestType>>> data;
            const auto m = refine(s, how, data);
            REQUIRE(m);
            CHECK(m->vertices.size() == m->announced.vertices);
            CHECK(m->triangles.size() == m->announced.triangles);
            CHECK(open_edges(*m) == 0);
            // The depth is 0.2 em: the walls are upright on the edge of the caps.
            CHECK(volume_of(*m) == Catch::Approx(0.2 * front_area(*m)).epsilon(1e-5));
            CHECK(m->sizes.triangles[part::front] == m->sizes.triangles[part::back]);
            const std::size_t on_boundary = data.loops.points.size() - m->inner.size();
            CHECK(m->sizes.triangles[part::side] == 2 * on_boundary);
            CHECK(m->sizes.vertices[part::front] == data.loops.points.size());
            if (longest == 0.02f) CHECK(m->inner.size() > 10);
            std::size_t outside = 0, odd_normals = 0;
            for (const auto& v : m->vertices) {
                odd_normals +=
                    std::abs(length(v.normal) - 1.0) > 1e-6 || std::abs(dot(wide(v.tangent), wide(v.normal))) > 1e-5;
                const double x = 512000.0 * double{v.position.x}, y = 512000.0 * double{v.position.y};
                const box& around = m->plan.around;
                outside += x < around.low.x - 0.5 || x > around.high.x + 0.5 || y < around.low.y - 0.5 ||
                           y > around.high.y + 0.5;
            }
            CHECK(outside == 0);
            CHECK(odd_normals == 0);
        }
    }
}

TEST_CASE("a solid refined by squares is closed as well, and upright on the edge of its caps", "[extrude][refined]")
{
    using squared = refined<extruded<>, quadtree_refined>;
    static_assert(extruder<squared> && cacheable_policy<squared>);
    CHECK_FALSE(squared{}.cache_key() == squared{.how = {.max_edge = 0.1f}}.cache_key());
    CHECK(refused_options(squared{.how = {.max_edge = 0.0f}}) == error::bad_option);
    plan_data_of<squared> data;
    for (const auto& s : shapes::all()) {
        for (const float longest : {0.3f, 0.1f, 0.02f}) {
            INFO(s.name << ", no edge longer than " << longest);
            const auto m = refine(s, squared{.how = {.max_edge = longest}}, data);
            REQUIRE(m);
            CHECK(m->vertices.size() == m->announced.vertices);
            CHECK(m->triangles.size() == m->announced.triangles);
            CHECK(open_edges(*m) == 0);
            CHECK(volume_of(*m) == Catch::Approx(0.2 * front_area(*m)).epsilon(1e-5));
            CHECK(m->sizes.vertices[part::front] == data.loops.points.size());
            if (longest == 0.02f) CHECK(m->inner.size() > 10);
        }
    }
}

TEST_CASE("a solid of right triangles is closed as well, and upright on the edge of its caps", "[extrude][refined]")
{
    using right = refined<extruded<>, non_obtuse>;
    static_assert(extruder<right> && cacheable_policy<right>);
    CHECK_FALSE(right{}.cache_key() == right{.how = {.max_edge = 0.1f}}.cache_key());
    plan_data_of<right> data;
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const auto m = refine(s, right{}, data);
        REQUIRE(m);
        CHECK(m->vertices.size() == m->announced.vertices);
        CHECK(m->triangles.size() == m->announced.triangles);
        CHECK(open_edges(*m) == 0);
        CHECK(volume_of(*m) == Catch::Approx(0.2 * front_area(*m)).epsilon(1e-5));
        CHECK(m->sizes.vertices[part::front] == data.loops.points.size());
    }
}

TEST_CASE("walls of a refined solid have the curve's normals at the points that are added to it", "[extrude][refined]")
{
    // A disc: every wall's normal points away from its middle.
    shapes::shape ring{"ring", {shapes::quadratic_circle({0, 0}, 400)}, {}, 3};
    const refined<> how{.how = {.max_edge = 0.03f}};
    plan_data_of<refined<>> data;
    const auto m = refine(ring, how, data);
    REQUIRE(m);
    const std::uint32_t first = m->first_vertex(part::side);
    REQUIRE(m->sizes.vertices[part::side] > 100);
    double worst = 0.0;
    for (std::uint32_t i = first; i < m->vertices.size(); ++i) {
        const auto& v = m->vertices[i];
        const wide_vec out = unit(wide_vec{v.position.x, v.position.y, 0.0});
        worst = (std::max)(worst, std::acos((std::min)(1.0, dot(out, wide(v.normal)))));
    }
    CHECK(worst < 0.04);  // quadratics are no circle
}

TEST_CASE("flat letters are refined as well, and a part that is switched off stays empty", "[extrude][refined]")
{
    const auto letter = shapes::letter_e();
    plan_data_of<refined<flat>> of_flat;
    const auto m = refine(letter, refined<flat>{.how = {.max_edge = 0.05f}}, of_flat);
    REQUIRE(m);
    CHECK(m->vertices.size() == of_flat.loops.points.size());
    CHECK(m->triangles.size() == of_flat.triangles.size());
    for (unsigned bits = 0; bits < 8; ++bits) {
        CAPTURE(bits);
        const refined<> how{.solid = {.front = (bits & 1u) != 0, .back = (bits & 2u) != 0, .side = (bits & 4u) != 0},
                            .how = {.max_edge = 0.1f}};
        plan_data_of<refined<>> data;
        const auto part_of = refine(letter, how, data);
        REQUIRE(part_of);
        CHECK((part_of->sizes.triangles[part::front] != 0) == how.solid.front);
        CHECK((part_of->sizes.triangles[part::back] != 0) == how.solid.back);
        CHECK((part_of->sizes.triangles[part::side] != 0) == how.solid.side);
        CHECK(part_of->vertices.size() == part_of->announced.vertices);
        CHECK(part_of->triangles.size() == part_of->announced.triangles);
    }
}

TEST_CASE("refined options of the refiner and of the solid have keys and are refused", "[extrude][refined]")
{
    CHECK_FALSE(refined<>{}.cache_key() == refined<>{.how = {.max_edge = 0.1f}}.cache_key());
    CHECK_FALSE(refined<>{}.cache_key() == refined<>{.solid = {.front = false}}.cache_key());
    CHECK(refused_options(refined<>{}) == error::none);
    CHECK(refused_options(refined<>{.how = {.min_angle = 50.0f}}) == error::bad_option);
    CHECK(refused_options(refined<>{.solid = {.depth = -1.0f}}) == error::bad_option);
}

TEST_CASE("a refined solid without memory says so, and asks for none once it is warm", "[extrude][refined]")
{
    const auto letter = shapes::letter_d();
    const refined<> how{.how = {.max_edge = 0.05f}};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        plan_data_of<refined<>> data{memory.source()};
        const auto m = refine(letter, how, data);
        was_asked = memory.requests >= nth;
        CHECK(bool(m) != was_asked);
        if (!m) CHECK(m.error() == error::out_of_memory);
        memory.fail_at = 0;
        REQUIRE(refine(letter, how, data));
        const std::size_t warm = memory.requests;
        REQUIRE(refine(letter, how, data));
        CHECK(memory.requests == warm);
    }
}

TEST_CASE("a refined solid's plan counts the triangles that miss the aim, of each cap that it has",
          "[extrude][refined]")
{
    CHECK(kept_triangles_of(refined<>{}) == 0);
    CHECK(kept_triangles_of(refined<extruded<>, resigned>{}) == 7);
    CHECK(kept_triangles_of(refined<flat, resigned>{}) == 7);
    bevelled bevel{.depth = 0.2f, .width = 0.01f, .bevel_depth = 0.01f};
    CHECK(kept_triangles_of(refined<bevelled, resigned>{bevel, {}}) == 7);  // both caps lie within bevels
    bevel.sides = bevel_sides::front;
    CHECK(kept_triangles_of(refined<bevelled, resigned>{bevel, {}}) == 14);  // the back is the letter's own
    CHECK(kept_triangles_of(outlined<refined<extruded<>, resigned>>{.width = 0.01f}) == 7);
}
