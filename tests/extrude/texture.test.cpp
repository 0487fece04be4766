// SPDX-License-Identifier: MIT

#include <typemesh/extrude/texture.hpp>

#include <typemesh/extrude/flat.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

placement em_texture(uv_origin origin)
{
    placement at = in_em(with_origin(right_handed_y_up, origin));
    at.em_pen = {1000.0, -300.0};
    return at;
}

/// The length of a contour in em.
double length_of(const shapes::shape& s, std::uint32_t contour)
{
    double length = 0.0;
    for (std::uint32_t i = s.loops.starts[contour]; i < s.loops.starts[contour + 1]; ++i)
        length += typemesh::length(delta(s.loops.points[i], s.loops.points[s.next(i)])) / 512000.0;
    return length;
}

}  // namespace

TEMPLATE_TEST_CASE("box mapping runs from exactly 0 to exactly 1, and walls take the coordinates of their edge",
                   "[extrude]", shared_normals, averaged_normals, curve_normals)
{
    for (const auto origin : {uv_origin::top_left, uv_origin::bottom_left})
        for (const auto& s : shapes::all()) {
            INFO(s.name);
            const placement at = over_box(s, with_origin(right_handed_y_up, origin));
            const built b = build(s, extruded<TestType>{.texture = texture_mapping::box}, at);
            vec2 low{2, 2}, high{-1, -1};
            for (const auto& v : b.vertices) {
                low = {(std::min)(low.x, v.uv.x), (std::min)(low.y, v.uv.y)};
                high = {(std::max)(high.x, v.uv.x), (std::max)(high.y, v.uv.y)};
                const double u = (v.position.x / at.unit_per_cell + at.texture_pen.x) * at.texture_per_cell.x;
                const double up = (v.position.y / at.unit_per_cell + at.texture_pen.y) * at.texture_per_cell.y;
                CHECK(v.uv.x == Approx(u).margin(1e-5));
                CHECK(v.uv.y == Approx(origin == uv_origin::top_left ? 1.0 - up : up).margin(1e-5));
            }
            CHECK(low == vec2{0.0f, 0.0f});
            CHECK(high == vec2{1.0f, 1.0f});
        }
}

TEST_CASE("a box without extent gives one coordinate, not NaN", "[extrude]")
{
    placement at = in_em();
    at.texture_per_cell = {0.0, 0.0};
    for (const auto& v : build(shapes::rectangle(), extruded<>{.texture = texture_mapping::box}, at).vertices)
        CHECK(v.uv == vec2{0.0f, 1.0f});
}

TEMPLATE_TEST_CASE("em mapping has one tile per em on caps and walls, within 1 %", "[extrude]", averaged_normals,
                   creased_normals, curve_normals)
{
    for (const auto origin : {uv_origin::top_left, uv_origin::bottom_left}) {
        const float flip = origin == uv_origin::top_left ? -1.0f : 1.0f;
        for (const auto& s : shapes::all()) {
            INFO(s.name);
            const built b =
                build(s, extruded<TestType>{.depth = 0.25f, .texture = texture_mapping::em}, em_texture(origin));
            for (std::uint32_t i = 0; i < 2 * s.points(); ++i) {
                const auto& v = b.vertices[i];
                const double up = v.position.y - 300.0 / 512000.0;
                CHECK(v.uv.x == Approx(v.position.x + 1000.0 / 512000.0).margin(1e-6));
                CHECK(v.uv.y == Approx(origin == uv_origin::top_left ? 1.0 - up : up).margin(1e-6));
            }
            for (std::uint32_t t = b.first_triangle(part::side); t < b.end_triangle(part::side); ++t) {
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto& p = b.vertices[b.triangles[t][k]];
                    const auto& q = b.vertices[b.triangles[t][(k + 1) % 3]];
                    const double du = q.uv.x - p.uv.x, dv = q.uv.y - p.uv.y;
                    const double along = std::hypot(q.position.x - p.position.x, q.position.y - p.position.y);
                    CHECK(std::abs(du) == Approx(along).epsilon(0.01));
                    CHECK(dv == Approx(flip * (q.position.z - p.position.z)).epsilon(0.01));
                }
                // Front of the first point, back of the first, ...: u grows in walking direction.
                const auto& upper = b.triangles[t];
                if ((t - b.first_triangle(part::side)) % 2 == 0)
                    CHECK(b.vertices[upper[2]].uv.x > b.vertices[upper[0]].uv.x);
            }
        }
    }
}

TEMPLATE_TEST_CASE("no triangle's texture is stretched into a line by default", "[extrude]", flat,
                   extruded<averaged_normals>, extruded<creased_normals>, extruded<curve_normals>)
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const built b = build(s, TestType{});
        for (const auto& t : b.triangles) {
            const vec2 p = b.vertices[t[0]].uv, q = b.vertices[t[1]].uv, r = b.vertices[t[2]].uv;
            CHECK((q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x) != 0.0f);
        }
    }
}

TEST_CASE("the seam of em mapping lies in a hard point if there is one, and u runs once along each contour",
          "[extrude]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const built b = build(s, extruded<>{.texture = texture_mapping::em}),
                    plain = build(s, extruded<>{.texture = texture_mapping::box});
        std::uint32_t v = b.first_vertex(part::side);
        for (std::uint32_t k = 0; k < s.contour_count(); ++k) {
            std::uint32_t seams = 0, hard = 0;
            float least = 1e9f, most = -1.0f;
            for (std::uint32_t i = s.loops.starts[k]; i < s.loops.starts[k + 1]; ++i) {
                seams += b.sides[i].seam;
                hard += plain.sides[i].doubled;
                if (b.sides[i].seam) CHECK(b.sides[i].doubled);
                if (b.sides[i].seam && !plain.sides[i].doubled) CHECK(i == s.loops.starts[k]);
                for (int twice = 0; twice <= int(b.sides[i].doubled); ++twice, v += 2) {
                    CHECK(b.vertices[v].uv.x == b.vertices[v + 1].uv.x);
                    least = (std::min)(least, b.vertices[v].uv.x);
                    most = (std::max)(most, b.vertices[v].uv.x);
                }
            }
            CHECK(seams == 1);
            CHECK(least == 0.0f);
            CHECK(most == Approx(length_of(s, k)));
            for (std::uint32_t i = s.loops.starts[k]; i < s.loops.starts[k + 1]; ++i) {
                if (b.sides[i].seam && hard != 0) CHECK(plain.sides[i].doubled);
                CHECK(b.sides[i].before == plain.sides[i].before);
                CHECK(b.sides[i].after == plain.sides[i].after);
            }
        }
    }
}

TEST_CASE("shared normals keep planar coordinates on their walls in em mapping", "[extrude]")
{
    const auto s = shapes::letter_d();
    const built b = build(s, extruded<shared_normals>{.texture = texture_mapping::em});
    const built f = build(s, flat{.texture = texture_mapping::em});
    REQUIRE(b.vertices.size() == 2 * f.vertices.size());
    for (std::size_t i = 0; i < f.vertices.size(); ++i) {
        CHECK(b.vertices[i].uv == f.vertices[i].uv);
        CHECK(b.vertices[f.vertices.size() + i].uv == f.vertices[i].uv);
    }
}

TEST_CASE("points get the texture coordinates of grid points, to the bit, and walls get theirs by length and depth",
          "[extrude]")
{
    for (const auto origin : {uv_origin::top_left, uv_origin::bottom_left}) {
        for (const auto mapping : texture_mappings) {
            const auto s = shapes::letter_d();
            const placement at = mapping == texture_mapping::box ? over_box(s, with_origin(right_handed_y_up, origin))
                                                                 : em_texture(origin);
            const planar_texture texture{mapping, at};
            for (const grid_point g : s.loops.points)
                CHECK(texture(point{static_cast<double>(g.x), static_cast<double>(g.y)}) == texture(g));
        }
        placement at = em_texture(origin);
        at.em_per_depth = 2.0;
        const wall_texture walls{at};
        const bool down = origin == uv_origin::top_left;
        CHECK(walls(512000.0f, 0.0) == vec2{1.0f, down ? 0.0f : 1.0f});
        CHECK(walls(0.0f, 0.25) == vec2{0.0f, 0.5f});
        CHECK(walls(-256000.0f, 0.5) == vec2{-0.5f, down ? 1.0f : 0.0f});
        wall_place place{};
        place.at = {512000.0, 0.0};
        place.along = -256000.0f;
        place.v = 0.25f;
        CHECK(em_mapping{at}.uv(place) == vec2{-0.5f, 0.25f});
        CHECK(box_mapping{at}.uv(place) == planar_texture{texture_mapping::box, at}(place.at));
        place.along = 0.75f;
        CHECK(cylindrical_mapping{at}.uv(place) == vec2{0.75f, 0.25f});
    }
}

TEST_CASE("cylindrical mapping runs once from 0 to 1 along each contour, and equals em mapping otherwise", "[extrude]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const placement at = em_texture(uv_origin::bottom_left);
        const built b = build(s, extruded<>{.texture = texture_mapping::cylindrical}, at),
                    em = build(s, extruded<>{.texture = texture_mapping::em}, at);
        REQUIRE(b.vertices.size() == em.vertices.size());
        CHECK(b.triangles == em.triangles);
        for (std::uint32_t v = 0; v < 2 * s.points(); ++v) CHECK(b.vertices[v].uv == em.vertices[v].uv);
        std::uint32_t v = b.first_vertex(part::side);
        for (std::uint32_t k = 0; k < s.contour_count(); ++k) {
            const double length = length_of(s, k);
            float least = 2.0f, most = -1.0f;
            for (std::uint32_t i = s.loops.starts[k]; i < s.loops.starts[k + 1]; ++i)
                for (int twice = 0; twice < 2 * (1 + int(b.sides[i].doubled)); ++twice, ++v) {
                    least = (std::min)(least, b.vertices[v].uv.x);
                    most = (std::max)(most, b.vertices[v].uv.x);
                    CHECK(b.vertices[v].uv.x * length == Approx(em.vertices[v].uv.x).margin(1e-6));
                    CHECK(b.vertices[v].uv.y == em.vertices[v].uv.y);
                }
            CHECK(least == 0.0f);
            CHECK(most == 1.0f);
        }
    }
}
