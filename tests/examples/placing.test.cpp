// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include "text_to_mesh/placing.hpp"

#include <array>
#include <initializer_list>

using namespace text_to_mesh;

TEST_CASE("an anchor comes to the origin: the shifted bounds have it there", "[placing]")
{
    const typemesh::bounds3 b{{1.0f, -2.0f, -5.0f}, {4.0f, 7.0f, 0.0f}};
    struct {
        const char* words;
        double x, y, z;  // of the bounds: what comes to the origin
    } const cases[] = {{"left,bottom,base", 1, -2, -5}, {"centre,middle,halfway", 2.5, 2.5, -2.5},
                       {"right,top,front", 4, 7, 0},    {"base", 0, 0, -5},
                       {"center", 2.5, 0, 0},           {"front,baseline,left", 1, 0, 0}};
    for (const auto& c : cases) {
        INFO(c.words);
        placing p;
        REQUIRE(read_anchor(c.words, p).empty());
        REQUIRE(read_origin("10,20,30", p).empty());
        const shift by = shift_of(p, b);
        CHECK(c.x + by.x == 10.0);
        CHECK(c.y + by.y == 20.0);
        CHECK(c.z + by.z == 30.0);
    }
}

TEST_CASE("anchors and origins that cannot be read are refused", "[placing]")
{
    placing p;
    for (const char* wrong :
         {"", "up", "left,", ",left", "left,centre", "top,bottom", "front,base", "Left", "left bottom"})
        CHECK_FALSE(read_anchor(wrong, p).empty());
    for (const char* wrong : {"", "1", "1,", "1,2,", "1,2,3,4", "x,y", "1e7,0", "nan,0", "1 ,2", "0,inf"})
        CHECK_FALSE(read_origin(wrong, p).empty());
    CHECK(read_origin("-1.5,2e3", p).empty());
    CHECK(p.at[1] == 2000.0);
}

TEST_CASE("a lifted mesh keeps its corners apart, or is refused", "[placing]")
{
    const auto mesh_of = [](std::initializer_list<std::array<float, 3>> corners) {
        model m;
        for (const auto& c : corners) m.vertices.push_back({{c[0], c[1], c[2]}, {}, {}});
        return m;
    };
    model far_apart = mesh_of({{0.0f, 0.0f, -2.0f}, {0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}});
    CHECK(lift(far_apart, 2.0));
    CHECK(far_apart.vertices[0].position[2] == 0.0f);
    CHECK(far_apart.vertices[1].position[2] == 2.0f);
    model near_elsewhere = mesh_of({{0.0f, 0.0f, -1e-9f}, {0.0f, 1.0f, -2e-9f}});  // of one height now, but two corners
    CHECK(lift(near_elsewhere, 2.0));
    model near_above = mesh_of({{0.0f, 1.0f, -1e-9f}, {5.0f, 1.0f, 0.0f}, {0.0f, 1.0f, -2e-9f}});
    CHECK_FALSE(lift(near_above, 2.0));
    near_above = mesh_of({{0.0f, 1.0f, -1e-9f}, {0.0f, 1.0f, -2e-9f}});
    CHECK(lift(near_above, 0.0));
    near_above.places.push_back({0, {1.0f, 2.0f, 3.0f}});
    CHECK(lift(near_above, 2.0));  // instances hold their own heights
    CHECK(near_above.places[0].at[2] == 5.0f);
    CHECK(near_above.vertices[0].position[2] == -1e-9f);
}
