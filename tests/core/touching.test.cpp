// SPDX-License-Identifier: MIT
#include <typemesh/core/grid.hpp>
#include <typemesh/core/touching.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("corners are kept unless something else is asked for", "[touching]")
{
    CHECK(touching{} == touching::keep);
    CHECK(grid{}.corners == touching::keep);
    const auto fitting = grid::fitting(1000.0, {});
    REQUIRE(fitting);
    CHECK(fitting->corners == touching::keep);
}
