// SPDX-License-Identifier: MIT

#include <typemesh/outline/stroke_style.hpp>

#include <limits>
#include <string>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a stroke's style refuses what is out of range by name", "[outline][stroke]")
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    CHECK_FALSE(stroke_style{}.refused());
    CHECK(std::string{stroke_style{.width = -1.0}.refused().option} == "width");
    CHECK(std::string{stroke_style{.width = infinite}.refused().option} == "width");
    CHECK(std::string{stroke_style{.mitre_limit = 0.99}.refused().option} == "mitre_limit");
    CHECK(std::string{stroke_style{.dash_offset = infinite}.refused().option} == "dash_offset");
    const double wrong[] = {1.0, infinite};
    CHECK(std::string{stroke_style{.dashes = wrong}.refused().option} == "dashes");
}
