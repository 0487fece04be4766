// SPDX-License-Identifier: MIT
#include <typemesh/plate/stencil_wishes.hpp>

#include "support/catch.hpp"

#include <string>

using namespace typemesh;

TEST_CASE("wishes outside their ranges are named, and those within are not", "[stencil]")
{
    const auto named = [](const stencil_wishes& wanted) {
        const error e = wanted.refused();
        return e ? std::string{e.option} : std::string{};
    };
    CHECK(named({}).empty());
    CHECK(named({1, 8}).empty());
    CHECK(named({0, 1}) == "width");
    CHECK(named({-1, 1}) == "width");
    CHECK(named({1, 0}) == "per_island");
    CHECK(named({1, stencil_wishes::max_per_island + 1}) == "per_island");
}
