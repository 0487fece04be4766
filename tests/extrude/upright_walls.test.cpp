// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/upright_walls.hpp>

#include <typemesh/extrude/curve_normals.hpp>

#include <array>
#include <vector>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;

TEST_CASE("walls between other heights equal those of extruded, and v begins at the given front", "[upright_walls]")
{
    constexpr attribute wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent;
    const placement at = in_em();
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const auto whole = build(s, extruded<>{.depth = 0.5f});
        const upright_walls walls{-0.125, -0.25, 0.0};
        std::vector<surface_point<wants>> made;
        const auto put = [&made](const surface_point<wants>& v) noexcept { made.push_back(v); };
        walls.vertices<wants>(s.loops.points.view(), whole.sides, upright_axes{at}, at, put);
        REQUIRE(made.size() == upright_walls::vertex_count(s.points(), whole.doubled()));
        REQUIRE(made.size() == whole.sizes.vertices[part::side]);
        const auto* expected = whole.vertices.data() + whole.first_vertex(part::side);
        for (std::size_t i = 0; i < made.size(); ++i) {
            CHECK(made[i].position ==
                  vec3{expected[i].position.x, expected[i].position.y, i % 2 == 0 ? -0.125f : -0.25f});
            CHECK(made[i].normal == expected[i].normal);
            CHECK(made[i].tangent == expected[i].tangent);
            CHECK(made[i].uv == vec2{expected[i].uv.x, i % 2 == 0 ? 0.125f : 0.25f});  // downwards: 1 - (1 - down)
        }

        std::vector<std::array<std::uint32_t, 3>> joined;
        const auto join = [&joined](std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept {
            joined.push_back({a, b, c});
        };
        upright_walls::triangles(s.loops.starts.view(), whole.sides, whole.first_vertex(part::side), join);
        CHECK(joined == std::vector(whole.triangles.begin() + whole.first_triangle(part::side), whole.triangles.end()));
    }
}

TEST_CASE("sides are measured along each contour from a doubled point, and doubled points are counted",
          "[upright_walls]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        buffer<side_point> sides, plain;
        const auto doubled = plan_sides(s.made(), curve_normals{}, texture_mapping::em, sides);
        const auto hard = plan_sides(s.made(), curve_normals{}, texture_mapping::box, plain);
        REQUIRE(doubled);
        REQUIRE(hard);
        CHECK(*hard == count_hard(sides.view()));
        CHECK(*hard == count_hard(plain.view()));
        std::uint32_t seams = 0, bare = 0;
        for (std::uint32_t k = 0; k < s.contour_count(); ++k) {
            double length = 0.0, at_seam = 0.0;
            std::uint32_t here = 0;
            for (std::uint32_t i = s.loops.starts[k]; i < s.loops.starts[k + 1]; ++i) {
                const grid_point a = s.loops.points[i], b = s.loops.points[s.next(i)];
                const double edge = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
                length += edge;
                const side_point &from = sides[i], &to = sides[s.next(i)];
                CHECK(to.along - (from.seam ? 0.0 : double(from.along)) == Catch::Approx(edge).epsilon(1e-5));
                here += plain[i].doubled;
                seams += from.seam;
                if (from.seam) at_seam = from.along;
            }
            CHECK(at_seam == Catch::Approx(length));
            bare += here == 0;
        }
        CHECK(seams == s.contour_count());
        CHECK(*doubled == *hard + bare);
    }
}
