// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/tube_surface.hpp>

#include "support/catch.hpp"

#include <typemesh/extrude/impl/axes.hpp>

#include <cmath>
#include <cstdint>
#include <set>
#include <utility>
#include <vector>

using namespace typemesh;

TEST_CASE("the section of a tube is a regular polygon with exact corners on its axes", "[extrude]")
{
    for (std::uint32_t sides = detail::tube_section::min_sides; sides <= detail::tube_section::max_sides; ++sides) {
        const detail::tube_section around{sides};
        CHECK(around.right(0) == 1.0);                              // NOLINT
        CHECK(around.up(0) == 0.0);                                 // NOLINT
        CHECK(around.right(sides) == 1.0);                          // NOLINT
        CHECK(around.up(sides) == 0.0);                             // NOLINT
        if (sides % 4 == 0) CHECK(around.up(sides / 4) == 1.0);     // NOLINT
        if (sides % 4 == 0) CHECK(around.right(sides / 4) == 0.0);  // NOLINT
        double area = 0.0;
        for (std::uint32_t k = 0; k < sides; ++k) {
            CHECK(std::hypot(around.right(k), around.up(k)) == Catch::Approx(1.0).margin(1e-6));
            area += 0.5 * (around.right(k) * around.up(k + 1) - around.right(k + 1) * around.up(k));
        }
        CHECK(area == Catch::Approx(0.5 * sides * std::sin(2.0 * 3.14159265358979323846 / sides)).epsilon(1e-5));
    }
}

TEST_CASE("a tube's surface has the vertices and triangles that it counts, and uses every vertex", "[extrude]")
{
    const grid_point line[] = {{0, 0}, {1000, 0}, {1000, 1000}, {4000, 4000}, {4000, 5000}};
    const std::uint32_t starts[] = {0, 3, 5};
    const float root = std::sqrt(0.5f);
    side_point sides[5]{};
    sides[0].before = sides[0].after = {0.0f, -1.0f};
    sides[1] = {{0.0f, -1.0f}, {1.0f, 0.0f}, 1000.0f, true, false};
    sides[2].before = sides[2].after = {root, root};
    sides[3].before = sides[3].after = sides[4].before = sides[4].after = {1.0f, 0.0f};
    const detail::tube_joint joints[] = {
        {line[0], {0, -50}}, {line[1], {50, -50}}, {line[2], {50, 0}}, {line[3], {50, 0}}, {line[4], {50, 0}}};
    for (const bool open : {false, true})
        for (const tube_end end : {tube_end::flat, tube_end::round})
            for (const std::uint32_t around : {3u, 4u, 5u, 6u, 16u}) {
                const detail::tube_path paths[] = {{0.05f, open ? 1u : 0u, 1}, {0.05f, 1u, 0}};
                detail::tube_surface all{starts, sides, joints, paths};
                all.sides_around = around;
                all.end = end;
                std::vector<vec3> places;
                std::set<std::uint32_t> used;
                std::size_t triangles = 0;
                const placement at;
                const auto vertex = [&](const surface_point<attribute::position>& v) { places.push_back(v.position); };
                all.vertices<attribute::position>(free_axes{at}, at, vertex);
                const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
                    ++triangles;
                    used.insert({a, b, c});
                };
                all.triangles(10, triangle);
                CHECK(places.size() == all.vertex_count(0) + all.vertex_count(1));
                CHECK(triangles == all.triangle_count(0) + all.triangle_count(1));
                REQUIRE_FALSE(used.empty());
                CHECK(*used.begin() == 10);
                CHECK(*used.rbegin() == 9 + places.size());
                CHECK(used.size() >=
                      places.size() - 2);  // a tip uses its rim without the vertex that repeats the first
            }
}

TEST_CASE("a path whose radius is 0 has no tube", "[extrude]")
{
    const std::uint32_t starts[] = {0, 2};
    const detail::tube_path none[] = {{0.0f, 1u, 0}};
    detail::tube_surface all;
    all.starts = starts;
    all.paths = none;
    CHECK(all.vertex_count(0) == 0);
    CHECK(all.triangle_count(0) == 0);
    bool any = false;
    const auto triangle = [&](std::uint32_t, std::uint32_t, std::uint32_t) { any = true; };
    all.triangles(0, triangle);
    CHECK_FALSE(any);
}
