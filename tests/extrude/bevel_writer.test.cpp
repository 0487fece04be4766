// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_writer.hpp>

#include <typemesh/extrude/bevelled.hpp>

#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

/// One strip that rises as far as it is wide, between the points (0, 0) and (0, 100), and a cap of one triangle.
bevel_data slope()
{
    bevel_data data;
    REQUIRE(data.of<bevel_strip>().push_back({100.0f, 0.0f, 1.0f}));
    REQUIRE(data.of<bevel_vertex>().push_back({{0, 0}, {0.0f, -1.0f}, 40.0f, 0.0f, 0}));
    REQUIRE(data.of<bevel_vertex>().push_back({{0, 100}, {0.0f, -1.0f}, 40.0f, 1.0f, 0}));
    REQUIRE(data.of<bevel_vertex>().push_back({{0, 50}, {0.0f, -1.0f}, 40.0f, 0.5f, 0}));
    REQUIRE(data.of<bevel_triangle>().push_back({{0, 1, 2}}));
    REQUIRE(data.of<bevel_rims>().push_back({.wall = 0.0f, .cap = 1.0f, .vertices = 3, .triangles = 1}));
    for (const grid_point p : {grid_point{0, 100}, grid_point{50, 100}, grid_point{0, 150}})
        REQUIRE(data.of<grid_point>().push_back(p));
    REQUIRE(data.of<triangle>().push_back({0, 1, 2}));
    return data;
}

constexpr attribute wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent;

std::vector<surface_point<wants>> bevel_of(const bevel_writer& writer, const placement& at, bool in_front)
{
    std::vector<surface_point<wants>> made;
    const auto put = [&made](const surface_point<wants>& v) noexcept { made.push_back(v); };
    writer.bevel<wants>(upright_axes{at}, at, in_front, put);
    return made;
}

}  // namespace

TEST_CASE("the back bevel mirrors the front one, and v continues downwards from the front", "[bevel_writer]")
{
    bevel_data data = slope();
    const solid_with<bevel_data> form{{}, data.read()};
    const placement at = in_em();
    const auto deep = static_cast<float>(100.0 / at.cells_per_depth());
    const bevel_writer writer{form, {.heights = {.depth = 0.5f, .bevel_depth = deep, .centred = true}}};
    const auto front = bevel_of(writer, at, true), back = bevel_of(writer, at, false);
    REQUIRE(front.size() == 3);
    REQUIRE(back.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(back[i].position == vec3{front[i].position.x, front[i].position.y, -front[i].position.z});
        CHECK(back[i].normal == vec3{front[i].normal.x, front[i].normal.y, -front[i].normal.z});
        CHECK(front[i].normal.y == Approx(-std::sqrt(0.5)));
        CHECK(front[i].normal.z == Approx(std::sqrt(0.5)));
        CHECK(front[i].uv.x == back[i].uv.x);
    }
    CHECK(front[0].position.z == Approx(0.25f - deep));
    CHECK(front[1].position.z == Approx(0.25f));
    CHECK(front[2].position.z == Approx(0.25f - 0.5f * deep));
    const auto v_step = [](const std::vector<surface_point<wants>>& of) {
        return static_cast<double>(of[1].uv.y) - static_cast<double>(of[0].uv.y);
    };
    CHECK(v_step(front) == Approx(-std::sqrt(2.0) * static_cast<double>(deep)).margin(0x1p-22));  // v is near 1 there
    CHECK(v_step(back) == Approx(-v_step(front)).margin(0x1p-22));
}

TEST_CASE("a cap within a bevel has the bevel's own points, at the bevel's height", "[bevel_writer]")
{
    bevel_data data = slope();
    const std::vector<grid_point> points{{0, 0}, {100, 0}, {0, 200}};
    const std::vector<triangle> own{{0, 1, 2}};
    const solid_with<bevel_data> form{{points, {}, own}, data.read()};
    const placement at = in_em();
    const bevel_writer writer{form, {.heights = {.depth = 0.5f, .bevel_depth = 0.1f, .sides = bevel_sides::front}}};
    for (const bool in_front : {true, false}) {
        std::vector<surface_point<wants>> made;
        const auto put = [&made](const surface_point<wants>& v) noexcept { made.push_back(v); };
        writer.cap<wants>(upright_axes{at}, at, in_front, put);
        REQUIRE(made.size() == 3);
        const grid_point expected = in_front ? grid_point{50, 100} : points[1];
        CHECK(made[1].position == at.position(expected, in_front ? 0.0f : -0.5f));
        CHECK(made[1].normal == vec3{0.0f, 0.0f, in_front ? 1.0f : -1.0f});
        CHECK(writer.cap_triangles(in_front).data() == (in_front ? data.of<triangle>().data() : own.data()));
    }
}

TEST_CASE("an empty solid has no bevel to write", "[bevel_writer]")
{
    const bevel_data data;
    const solid_with<bevel_data> form{{}, data.read()};
    std::uint32_t written = 0;
    for (const part p : parts_of<bevelled>) {
        bevelled{}.vertices<wants>(p, form, in_em(), [&](const surface_point<wants>&) noexcept { ++written; });
        bevelled{}.triangles(p, form, {}, [&](std::uint32_t, std::uint32_t, std::uint32_t) noexcept { ++written; });
    }
    CHECK(written == 0);
}
