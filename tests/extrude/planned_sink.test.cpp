// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/extrude/impl/planned_sink.hpp>

#include <array>
#include <cstdint>
#include <vector>

using namespace typemesh;

namespace {

struct listing {
    static constexpr auto wants = attribute::position;
    std::vector<vec3> places;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>& s) noexcept { places.push_back(s.position); }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { triangles.push_back({a, b, c}); }
    void end() noexcept {}
};

}  // namespace

TEST_CASE("planned vertices and triangles reach the sink unchanged", "[extrude]")
{
    // What was not planned is asserted: tests/asserts/policies.test.cpp.
    listing sink;
    detail::planned_vertices<listing> vertices{sink, 2};
    vertices.bounds = {{}, {1.0f, 2.0f, 3.0f}};
    surface_point<attribute::position> s;
    s.position = {1.0f, 2.0f, 3.0f};
    vertices.vertex({});
    vertices.vertex(s);
    CHECK(sink.places == std::vector<vec3>{{}, {1.0f, 2.0f, 3.0f}});

    const part_sizes sizes{{{3, 0, 4}}, {{1, 0, 1}}};
    const first_vertices first{{10, 20, 30}};
    detail::planned_triangles<listing> triangles{sink, sizes, first, 2};
    triangles.triangle(10, 11, 12);
    triangles.triangle(12, 30, 33);
    CHECK(sink.triangles == std::vector<std::array<std::uint32_t, 3>>{{10, 11, 12}, {12, 30, 33}});
    for (const std::uint32_t v : {10u, 12u, 30u, 33u}) CHECK(triangles.numbers(v));
    for (const std::uint32_t v : {0u, 9u, 13u, 20u, 29u, 34u, 0xFFFF'FFFFu}) CHECK_FALSE(triangles.numbers(v));
}
