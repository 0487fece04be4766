// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/vertex/growing_sink.hpp>

#include <cstdint>
#include <vector>

using namespace typemesh;

static_assert(mesh_vertex<vec3>);
static_assert(!mesh_vertex<vec2>);

TEST_CASE("a vector of positions needs no traits", "[vertex]")
{
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    auto sink = into(vertices, indices);
    STATIC_REQUIRE(decltype(sink)::wants == attribute::position);
    REQUIRE(!sink.begin({2, 1}));
    for (const float x : {1.0f, 4.0f}) {
        surface_point<attribute::position> s;
        s.position = {x, x + 1.0f, x + 2.0f};
        sink.vertex(s);
    }
    sink.triangle(0, 1, 1);
    sink.end();
    CHECK(vertices == std::vector<vec3>{{1.0f, 2.0f, 3.0f}, {4.0f, 5.0f, 6.0f}});
    CHECK(indices == std::vector<std::uint32_t>{0, 1, 1});
}
