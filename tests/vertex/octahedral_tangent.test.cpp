// SPDX-License-Identifier: MIT

#include <typemesh/vertex/octahedral_tangent.hpp>

#include <algorithm>
#include <type_traits>

#include "directions.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using test::degrees_between;
using test::directions;

static_assert(std::is_trivially_copyable_v<octahedral_tangent32> && std::is_standard_layout_v<octahedral_tangent32>);

TEMPLATE_TEST_CASE("an octahedral tangent keeps its sign, and its error bound", "[vertex]", snorm8, snorm16)
{
    const double bound = std::is_same_v<TestType, snorm8> ? 1.1 : 0.0043;
    double most = 0.0;
    for (const vec3 v : directions(200'000))
        for (const float sign : {1.0f, -1.0f}) {
            const vec4 t = octahedral_tangent<TestType>{v.x, v.y, v.z, sign}.decoded();
            if (t.w != sign) FAIL("the sign is lost");
            most = (std::max)(most, degrees_between({t.x, t.y, t.z}, v));
        }
    INFO(most << " degrees");
    CHECK(most < bound);
}
