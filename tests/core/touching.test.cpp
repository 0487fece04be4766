// SPDX-License-Identifier: MIT
#include <typemesh/core/contours.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/touching.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("corners are kept by default", "[touching]")
{
    CHECK(touching{} == touching::keep);
    CHECK(contours{}.corners == touching::keep);
    CHECK(region{}.corners() == touching::keep);
}

TEST_CASE("a region keeps the corner mode of its contours", "[touching]")
{
    contours loops;
    loops.corners = touching::join;
    CHECK(region::proven(loops, 0, 0).corners() == touching::join);
    loops.clear();
    CHECK(loops.corners == touching::join);
}
