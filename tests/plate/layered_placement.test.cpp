// SPDX-License-Identifier: MIT
#include <typemesh/plate/layered_placement.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a mirrored placement mirrors points and directions, and turns triangles unless the frame does", "[plate]")
{
    layered_placement to;
    CHECK(to.place({3, 5}) == grid_point{3, 5});
    CHECK(to.turn({0.5f, 0.25f}) == vec2{0.5f, 0.25f});
    CHECK_FALSE(to.turns_triangles());
    to.mirrored = true;
    CHECK(to.place({3, 5}) == grid_point{-3, 5});
    CHECK(to.turn({0.5f, 0.25f}) == vec2{-0.5f, 0.25f});
    CHECK(to.turns_triangles());
    to.at.frame = left_handed_y_up;
    CHECK_FALSE(to.turns_triangles());
}
