// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/corner_rule.hpp>

#include "support/catch.hpp"

#include <limits>

using namespace typemesh;

TEST_CASE("a mitre limit is at least 1, or 0 for none", "[corner_rule]")
{
    for (const float limit : {0.0f, 1.0f, 2.0f, 1e30f}) CHECK(corner_rule{.mitre_limit = limit}.is_valid());
    for (const float limit : {0.5f, -1.0f, std::numeric_limits<float>::infinity(),
                              -std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()})
        CHECK_FALSE(corner_rule{.mitre_limit = limit}.is_valid());
    CHECK(corner_rule{}.is_valid());
}
