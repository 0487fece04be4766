// SPDX-License-Identifier: MIT

#include <typemesh/inspect/mesh_view.hpp>

#include "support/catch.hpp"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

using namespace typemesh::inspect;

namespace {

struct with_methods {  // as matrix libraries have it
    double values[3];
    double x() const { return values[0]; }
    double operator[](std::size_t i) const { return values[i]; }
};
struct placed {
    float colour[4];
    std::array<float, 3> where;
};
struct named {
    struct {
        float x, y, z;
    } position;
};

}  // namespace

TEST_CASE("a mesh view reads arrays of any kind and indices of any type", "[inspect]")
{
    const auto is_seen = [](const auto& mesh) {
        CHECK(mesh.vertex_count() == 4);
        CHECK(mesh.triangle_count() == 2);
        CHECK(mesh.corners(1) == std::array<std::size_t, 3>{2, 1, 3});
        const place p = mesh.position(3);
        CHECK((p.x == 1.0 && p.y == 2.0 && p.z == 3.0));
    };
    const std::uint16_t small[] = {0, 1, 2, 2, 1, 3};
    const std::vector<int> wide{0, 1, 2, 2, 1, 3, 0};  // one too many: no triangle
    const std::vector<named> names{{}, {}, {}, {{1, 2, 3}}};
    const std::array<placed, 4> places{{{}, {}, {}, {{}, {1, 2, 3}}}};
    const double plain[4][3] = {{}, {}, {}, {1, 2, 3}};
    const std::vector<with_methods> methods{{}, {}, {}, {{1, 2, 3}}};
    is_seen(mesh_view{names, small});
    is_seen(mesh_view{std::span{names}, wide});
    is_seen(mesh_view{places, small, &placed::where});
    is_seen(mesh_view{places, wide, [](const placed& p) { return p.where; }});
    is_seen(mesh_view{plain, small});
    is_seen(mesh_view{methods, wide});
}

TEST_CASE("triangles are not drawable if their corners are no vertices, or not finite", "[inspect]")
{
    const double nowhere = std::numeric_limits<double>::quiet_NaN(), far_away = std::numeric_limits<double>::infinity();
    const double positions[][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {nowhere, 0, 0}, {0, far_away, 0}};
    const std::array<std::int32_t, 15> indices{0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 0, 1, -1};
    const mesh_view mesh{positions, indices};
    CHECK(mesh.is_drawable(mesh.corners(0)));
    for (std::size_t t = 1; t < 5; ++t) CHECK_FALSE(mesh.is_drawable(mesh.corners(t)));
}

TEST_CASE("only equal positions are welded, and the two zeros are equal", "[inspect]")
{
    const float next = std::nextafter(1.0f, 2.0f);
    const float positions[][3] = {{0, 0, 1}, {-0.0f, 0, 1}, {0, 0, next}, {1, 0, 0}, {1, 0, 0}, {9, 9, 9}};
    const unsigned indices[] = {0, 2, 3, 1, 2, 4};
    const welded_places w = weld(mesh_view{positions, indices});
    CHECK(w.at.size() == 3);
    CHECK(w.of[0] == w.of[1]);
    CHECK(w.of[3] == w.of[4]);
    CHECK(w.of[0] != w.of[2]);
    CHECK(w.of[5] == welded_places::none);
}
