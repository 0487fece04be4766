// SPDX-License-Identifier: MIT

#include <typemesh/extrude/extruded.hpp>
#include <typemesh/inspect/normal_check.hpp>

#include <limits>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

static_assert(extruder<extruded<>>);
static_assert(extruder<extruded<shared_normals>>);
static_assert(extruder<extruded<averaged_normals>>);
static_assert(extruder<extruded<creased_normals>>);
static_assert(std::is_same_v<decltype(extruded{}), extruded<curve_normals>>);

namespace {

/// Vertices and seams of a wall as the style's own rule has them, counted without it.
template <class Style>
std::uint32_t expected_side_vertices(const shapes::shape& s, const built& b, texture_mapping texture)
{
    if (Style::shares_caps) return 0;
    std::uint32_t hard = 0, seams = 0;
    for (std::uint32_t k = 0; k < s.contour_count(); ++k) {
        std::uint32_t here = 0;
        for (std::uint32_t i = s.loops.starts[k]; i < s.loops.starts[k + 1]; ++i) {
            here += b.sides[i].doubled && !(b.sides[i].before == b.sides[i].after) ? 1u : 0u;
        }
        hard += here;
        seams += texture != texture_mapping::box && here == 0 ? 1u : 0u;
    }
    return 2 * s.points() + 2 * hard + 2 * seams;
}

}  // namespace

TEMPLATE_TEST_CASE("extruded has exactly the vertices and triangles of its style, for every choice of parts",
                   "[extrude]", shared_normals, averaged_normals, creased_normals, curve_normals)
{
    for (const auto& s : shapes::all())
        for (unsigned bits = 0; bits < 16; ++bits) {
            const auto texture = (bits & 8u) != 0 ? texture_mapping::em : texture_mapping::box;
            const extruded<TestType> how{
                .front = (bits & 1u) != 0, .back = (bits & 2u) != 0, .side = (bits & 4u) != 0, .texture = texture};
            INFO(s.name << ", switches " << bits);
            const built b = build(s, how);
            const std::uint32_t n = s.points(), cap = s.made().triangle_count();
            const bool lends = TestType::shares_caps && how.side;

            CHECK(b.sizes.vertices[part::front] == (how.front || lends ? n : 0));
            CHECK(b.sizes.vertices[part::back] == (how.back || lends ? n : 0));
            CHECK(b.sizes.vertices[part::side] == (how.side ? expected_side_vertices<TestType>(s, b, texture) : 0));
            CHECK(b.sizes.triangles[part::front] == (how.front ? cap : 0));
            CHECK(b.sizes.triangles[part::back] == (how.back ? cap : 0));
            CHECK(b.sizes.triangles[part::side] == (how.side ? 2 * n : 0));
            CHECK(s.cap.size() == cap);

            CHECK(b.begun == 1);
            CHECK(b.ended == 1);
            CHECK(b.in_order);
            CHECK(b.vertices.size() == b.announced.vertices);
            CHECK(b.triangles.size() == b.announced.triangles);
            for (const auto& t : b.triangles)
                for (const auto v : t) REQUIRE(v < b.vertices.size());
        }
}

TEST_CASE("the four styles have 2N, 4N, 4N + 2H and 4N + 2H vertices, and 2 more for each seam", "[extrude]")
{
    const auto total = [](const built& b) { return b.announced.vertices; };
    // 12 corners, all hard
    const auto e = shapes::letter_e();
    CHECK(total(build(e, extruded<shared_normals>{})) == 24);
    CHECK(total(build(e, extruded<averaged_normals>{})) == 48 + 2);  // and the seam
    CHECK(total(build(e, extruded<creased_normals>{})) == 48 + 24);
    CHECK(total(build(e, extruded<curve_normals>{})) == 48 + 24);
    // 22 points; four corners are hard, bowls join their lines softly
    const auto d = shapes::letter_d();
    CHECK(d.points() == 22);
    CHECK(total(build(d, extruded<shared_normals>{})) == 44);
    CHECK(total(build(d, extruded<averaged_normals>{})) == 88 + 4);
    CHECK(total(build(d, extruded<curve_normals>{})) == 88 + 8);
    // no hard point at all: em mapping needs one more pair a contour, box mapping none
    const auto o = shapes::ring();
    CHECK(o.points() == 48);
    CHECK(total(build(o, extruded<curve_normals>{})) == 192 + 4);
    CHECK(total(build(o, extruded<curve_normals>{.texture = texture_mapping::box})) == 192);
    CHECK(total(build(d, extruded<curve_normals>{.texture = texture_mapping::box})) == 96);
    CHECK(total(build(d, extruded<averaged_normals>{.texture = texture_mapping::box})) == 88);
    CHECK(total(build(d, extruded<shared_normals>{.texture = texture_mapping::box})) == 44);
}

TEMPLATE_TEST_CASE("extruded is closed, faces outward and has the frame's winding", "[extrude]", shared_normals,
                   averaged_normals, creased_normals, curve_normals)
{
    for (const frame& f : frames())
        for (const auto& s : shapes::all())
            for (const auto texture : texture_mappings) {
                INFO(s.name << " in a frame whose right is " << f.right.x << " " << f.right.y << ", winding "
                            << int(f.winding));
                const built b = build(s, extruded<TestType>{.texture = texture}, in_em(f));
                CHECK(open_edges(b) == 0);
                const auto indices = indices_of(b);
                const auto normals = check_normals(
                    inspect::mesh_view{b.vertices, indices}, [](const auto& v) { return v.normal; }, f.winding, 1e-6);
                CHECK(normals.is_right());
                CHECK(normals.triangles == b.triangles.size());
            }
}

TEMPLATE_TEST_CASE("caps are flat and at their heights, and walls stand straight between them", "[extrude]",
                   averaged_normals, creased_normals, curve_normals)
{
    for (const bool centred : {false, true}) {
        const extruded<TestType> how{.depth = 0.25f, .centred = centred};
        CHECK(how.heights().high == (centred ? 0.125 : 0.0));
        CHECK(how.heights().low == (centred ? -0.125 : -0.25));
        for (const auto& s : shapes::all()) {
            INFO(s.name);
            const built b = build(s, how);
            const float top = centred ? 0.125f : 0.0f, bottom = centred ? -0.125f : -0.25f;
            const std::uint32_t n = s.points(), side = b.first_vertex(part::side);
            for (std::uint32_t i = 0; i < n; ++i) {
                const grid_point g = s.loops.points[i];
                CHECK(b.vertices[i].position ==
                      vec3{static_cast<float>(g.x / 512000.0), static_cast<float>(g.y / 512000.0), top});
                CHECK(b.vertices[i].normal == vec3{0.0f, 0.0f, 1.0f});
                CHECK(b.vertices[n + i].position == vec3{b.vertices[i].position.x, b.vertices[i].position.y, bottom});
                CHECK(b.vertices[n + i].normal == vec3{0.0f, 0.0f, -1.0f});
            }
            std::uint32_t v = side;
            for (std::uint32_t i = 0; i < n; ++i)
                for (int k = 0; k <= int(b.sides[i].doubled); ++k, v += 2) {
                    CHECK(b.vertices[v].position == b.vertices[i].position);
                    CHECK(b.vertices[v + 1].position == b.vertices[n + i].position);
                    CHECK(b.vertices[v].normal == b.vertices[v + 1].normal);
                    CHECK(b.vertices[v].normal.z == 0.0f);
                    const vec2 kept = k == 0 ? b.sides[i].before : b.sides[i].after;
                    CHECK(b.vertices[v].normal == vec3{kept.x, kept.y, 0.0f});
                }
            CHECK(v == b.vertices.size());
        }
    }
}

TEST_CASE("each wall lies between its own pairs of vertices", "[extrude]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const built b = build(s, extruded<>{});
        const std::uint32_t first = b.first_triangle(part::side);
        for (std::uint32_t i = 0; i < s.points(); ++i) {
            const auto& upper = b.triangles[first + 2 * i];
            const auto& lower = b.triangles[first + 2 * i + 1];
            CHECK(upper[0] == lower[0]);  // one diagonal
            CHECK(upper[2] == lower[1]);
            const vec2 after = b.sides[i].after, before = b.sides[s.next(i)].before;
            CHECK(b.vertices[upper[0]].normal == vec3{after.x, after.y, 0.0f});
            CHECK(b.vertices[lower[2]].normal == vec3{before.x, before.y, 0.0f});
            CHECK(b.vertices[upper[0]].position == b.vertices[i].position);
            CHECK(b.vertices[lower[2]].position == b.vertices[s.next(i)].position);
        }
    }
}

TEST_CASE("heights cover the parts that are switched on", "[extrude]")
{
    const struct {
        bool front, back, side;
        double low, high;
    } cases[] = {{true, false, false, 0.0, 0.0},
                 {false, true, false, -0.5, -0.5},
                 {false, false, true, -0.5, 0.0},
                 {true, true, false, -0.5, 0.0}};
    for (const auto& [front, back, side, low, high] : cases) {
        CAPTURE(front, back, side);
        const auto heights = extruded<>{.depth = 0.5f, .front = front, .back = back, .side = side}.heights();
        CHECK(heights.low == low);
        CHECK(heights.high == high);
    }
}

TEST_CASE("a depth that is not positive and finite is a bad option", "[extrude]")
{
    const auto s = shapes::rectangle();
    extruded<>::plan_data sides;
    for (const float depth : {0.0f, -0.1f, std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        CHECK(extruded<>{.depth = depth}.plan(s.made(), sides).error() == error::bad_option);
    }
    for (const float crease :
         {-1.0f, 180.5f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
        for (const bool side : {true, false}) {
            CHECK(extruded<curve_normals>{.side = side, .normals = {crease}}.plan(s.made(), sides).error() ==
                  error::bad_option);
            CHECK(extruded<creased_normals>{.side = side, .normals = {crease}}.plan(s.made(), sides).error() ==
                  error::bad_option);
        }
    }
    sides.clear();
    CHECK(extruded<>{}.plan(s.made(), sides));
    CHECK(sides.of<side_point>().size() == 4);
}

TEST_CASE("an empty region extrudes to nothing", "[extrude]")
{
    extruded<>::plan_data sides;
    mesh<> m;
    CHECK(extrude(region{}, {}, extruded<>{}, in_em(), sides, m));
    CHECK(m.vertices.empty());
    CHECK(m.triangles.empty());
    CHECK(m.begun == 1);
    CHECK(m.ended == 1);
    contours none;
    CHECK(extrude(region::proven(none, 0, 0), {}, extruded<>{.texture = texture_mapping::em}, in_em(), sides, m));
}

TEST_CASE("plan() reports that memory has run out", "[extrude]")
{
    test::counting_memory nothing{.fail_at = 1};
    extruded<>::plan_data sides{nothing.source()};
    CHECK(extruded<>{}.plan(shapes::rectangle().made(), sides).error() == error::out_of_memory);
    CHECK(sides.of<side_point>().empty());
    mesh<> m;
    CHECK(extrude(shapes::rectangle().made(), shapes::rectangle().cap, extruded<>{}, in_em(), sides, m) ==
          error::out_of_memory);
    CHECK(m.begun == 0);
}

TEST_CASE("fewer attributes give the same positions", "[extrude]")
{
    const auto s = shapes::letter_d();
    extruded<>::plan_data sides;
    mesh<attribute::position> bare;
    REQUIRE(extrude(s.made(), s.cap, extruded<>{}, in_em(), sides, bare));
    const built full = build(s, extruded<>{});
    REQUIRE(bare.vertices.size() == full.vertices.size());
    for (std::size_t i = 0; i < bare.vertices.size(); ++i)
        CHECK(bare.vertices[i].position == full.vertices[i].position);
    CHECK(bare.triangles == full.triangles);
}

TEST_CASE("the key of extruded changes with every option that is planned, and with no other", "[extrude]")
{
    const extruded<> plain;
    check_different_keys<extruded<>>(plain, {{.depth = 0.0f},
                                             {.front = false},
                                             {.back = false},
                                             {.side = false},
                                             {.texture = texture_mapping::box},
                                             {.normals = {.crease_degrees = 20.0f}}});
    CHECK(extruded<>{.depth = 0.7f}.cache_key() == plain.cache_key());
    CHECK(extruded<>{.centred = true}.cache_key() == plain.cache_key());
}
