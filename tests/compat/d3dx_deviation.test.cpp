// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/compat/d3dx_deviation.hpp>

using namespace typemesh;

TEST_CASE("a smaller deviation is never a larger tolerance", "[compat]")
{
    double before = 0.0;
    for (double deviation = 1e-6; deviation < 10.0; deviation *= 1.01) {
        const double tolerance = d3dx_tolerance(deviation);
        REQUIRE(tolerance > 0.0);
        REQUIRE(tolerance >= before);
        REQUIRE(tolerance <= deviation);
        before = tolerance;
    }
}
