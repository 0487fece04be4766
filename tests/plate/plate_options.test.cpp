// SPDX-License-Identifier: MIT
#include <typemesh/plate/plate_options.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <limits>
#include <string>

using namespace typemesh;

TEST_CASE("options outside their ranges are named, and those within are not", "[plate_options]")
{
    const auto named = [](const plate_options& how) {
        const error e = how.refused();
        return e ? std::string{e.option} : std::string{};
    };
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    CHECK(named({}).empty());
    CHECK(named({.margin = -0.5f, .radius = 0.0f, .bridges = 8}).empty());
    for (const float bad : {nan, infinite, -infinite, 1001.0f, -1001.0f}) CHECK(named({.margin = bad}) == "margin");
    for (const float bad : {nan, infinite, -1.0f, 1001.0f}) {
        CHECK(named({.radius = bad}) == "radius");
        CHECK(named({.thickness = bad}) == "thickness");
        CHECK(named({.depth = bad}) == "depth");
        CHECK(named({.bevel = bad}) == "bevel");
        CHECK(named({.fillet = bad}) == "fillet");
        CHECK(named({.ring_hole = bad}) == "ring_hole");
        CHECK(named({.ring_width = bad}) == "ring_width");
        CHECK(named({.bridge_width = bad}) == "bridge_width");
    }
    CHECK(named({.thickness = 0.0f}) == "thickness");
    CHECK(named({.depth = 0.0f}) == "depth");
    CHECK(named({.ring_width = 0.0f}) == "ring_width");
    CHECK(named({.bridges = 0}) == "bridges");
    CHECK(named({.bridges = 9}) == "bridges");
}

TEST_CASE("the room around a text holds its margin and its ring", "[plate_options]")
{
    CHECK(plate_options{.margin = 2.0f}.room() >= 2.0);
    CHECK(plate_options{.margin = -2.0f}.room() > 0.0);
    CHECK(plate_options{.margin = 2.0f, .ring_hole = 1.0f, .ring_width = 0.5f}.room() >= 2.0 + 2.0 + 0.5);
}
