// SPDX-License-Identifier: MIT

#include <typemesh/extrude/texture_tangent.hpp>

#include <typemesh/extrude/flat.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

/// Where u and v grow on a triangle, from its positions and texture coordinates; `known` unless these lie on a line.
struct gradient {
    wide_vec u, v;
    bool known;
};

gradient gradient_of(const built& b, const std::array<std::uint32_t, 3>& t)
{
    const auto &p = b.vertices[t[0]], &q = b.vertices[t[1]], &r = b.vertices[t[2]];
    const wide_vec e = minus(wide(q.position), wide(p.position)), f = minus(wide(r.position), wide(p.position));
    const double eu = double(q.uv.x) - p.uv.x, ev = double(q.uv.y) - p.uv.y, fu = double(r.uv.x) - p.uv.x,
                 fv = double(r.uv.y) - p.uv.y;
    const double area = eu * fv - ev * fu;
    if (std::abs(area) < 1e-7) return {{}, {}, false};
    return {unit(scaled(1.0 / area, minus(scaled(fv, e), scaled(ev, f)))),
            unit(scaled(1.0 / area, minus(scaled(eu, f), scaled(fu, e)))), true};
}

/// Every frame, with v upwards and downwards, box mapping over the shape's box.
std::vector<placement> placements(const shapes::shape& s)
{
    std::vector<placement> all;
    for (const frame& f : frames())
        for (const auto origin : {uv_origin::top_left, uv_origin::bottom_left})
            all.push_back(over_box(s, with_origin(f, origin), {1.0, 0.5}));
    return all;
}

}  // namespace

TEMPLATE_TEST_CASE("tangents point where u grows and bitangents where v grows, on every triangle in every frame",
                   "[extrude]", shared_normals, averaged_normals, creased_normals, curve_normals)
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        for (const placement& at : placements(s))
            for (const auto mapping : texture_mappings) {
                const built b = build(s, extruded<TestType>{.depth = 0.25f, .texture = mapping}, at);
                for (const auto& v : b.vertices) check_tangent(v, 1e-6);
                std::size_t known = 0;
                const bool shared = TestType::shares_caps;
                for (std::uint32_t t = 0; t < b.triangles.size(); ++t) {
                    const bool wall = t >= b.first_triangle(part::side);
                    if (wall && shared) continue;  // planar coordinates on walls: their tangents are the caps'
                    const gradient grows = gradient_of(b, b.triangles[t]);
                    if (!grows.known) continue;
                    ++known;
                    const wide_vec flat = face_normal(b, b.triangles[t]);
                    for (const std::uint32_t i : b.triangles[t]) {
                        const auto& v = b.vertices[i];
                        CHECK(dot(wide(v.tangent), grows.u) > 0.0);
                        CHECK(dot(bitangent(v), grows.v) > 0.0);
                        if (shared) continue;
                        // As far from the triangle's own as the normal is from the triangle's.
                        const double lean = std::abs(dot(wide(v.normal), flat));
                        CHECK(dot(wide(v.tangent), grows.u) == Approx(lean).margin(2e-3));
                        CHECK(dot(bitangent(v), grows.v) == Approx(1.0).margin(2e-3));
                    }
                }
                CHECK(known > 0);
                if (mapping != texture_mapping::box && !shared) CHECK(known == b.triangles.size());
            }
    }
}

TEST_CASE("box mapping gives walls the tangents of em mapping, since u and v do not change along their height",
          "[extrude]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const built b = build(s, extruded<averaged_normals>{.texture = texture_mapping::box}),
                    e = build(s, extruded<averaged_normals>{.texture = texture_mapping::em});
        std::size_t k = 2 * s.points();  // em mapping may double one point more a contour: its seam
        for (std::size_t i = k; i < b.vertices.size(); ++i, ++k) {
            while (!(e.vertices[k].position == b.vertices[i].position)) ++k;
            CHECK(e.vertices[k].tangent == b.vertices[i].tangent);
        }
    }
}

TEST_CASE("flat text has one tangent, along the text", "[extrude]")
{
    for (const frame& f : frames()) {
        const built b = build(shapes::letter_d(), flat{}, in_em(f));
        const bool down = f.uv == uv_origin::top_left;
        for (const auto& v : b.vertices) {
            check_tangent(v, 1e-6);
            CHECK(vec3{v.tangent.x, v.tangent.y, v.tangent.z} == f.right);
            CHECK(dot(bitangent(v), wide(f.up)) == Approx(down ? -1.0 : 1.0));
        }
    }
}

TEST_CASE("a rim whose normal lies along the text still has a tangent", "[extrude]")
{
    const texture_tangent tangents{right_handed_y_up};
    const free_axes axes{in_em()};
    for (const float x : {1.0f, -1.0f, 0.99999994f}) {
        const vec4 t = tangents.on_rim(axes, {x, 0.0f, 0.0f}, 1.0f);
        CHECK(std::abs(t.x * x) < 1e-6f);
        CHECK(length(vec3{t.x, t.y, t.z}) == Approx(1.0));
    }
    CHECK(tangents.on_rim(axes, {0.0f, 0.0f, -1.0f}, -1.0f) == vec4{1.0f, 0.0f, 0.0f, 1.0f});
}

TEST_CASE("every vertex has its part, and the glyph and cluster of its placement", "[extrude]")
{
    placement at = in_em();
    CHECK(build(shapes::letter_d(), flat{}, at).vertices[0].glyph == no_glyph);
    at.glyph = 37;
    at.cluster = 4;
    const built b = build(shapes::letter_d(), extruded<>{}, at);
    for (std::uint32_t i = 0; i < b.vertices.size(); ++i) {
        const auto& v = b.vertices[i];
        CHECK(v.glyph == 37);
        CHECK(v.cluster == 4);
        const part p = i < b.first_vertex(part::back)   ? part::front
                       : i < b.first_vertex(part::side) ? part::back
                                                        : part::side;
        CHECK(v.part == p);
    }
}

TEST_CASE("the tangent of a general surface equals that of a cap or a wall with the same normal", "[extrude]")
{
    for (const frame& f : frames()) {
        placement at = in_em(f);
        const texture_tangent tangents{f};
        CHECK(tangents.along(at, {1.0f, 0.0f, 0.0f}, 1.0f) == tangents.on_cap(at, 1.0f));
        CHECK(tangents.along(at, {1.0f, 0.0f, 0.0f}, -1.0f) == tangents.on_cap(at, -1.0f));
        CHECK(tangents.along(at, {0.8f, 0.6f, 0.0f}, 1.0f) == tangents.on_wall(at, {0.6f, -0.8f}));
    }
}
