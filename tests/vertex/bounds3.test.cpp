// SPDX-License-Identifier: MIT

#include <typemesh/vertex/bounds3.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <limits>
#include <vector>

using namespace typemesh;

TEST_CASE("bounds contain all points that were added, and touch them on every side", "[vertex][bounds3]")
{
    test::dice d{4};
    const auto any = [&] {
        return vec3{static_cast<float>(d.fraction()) - 0.5f, 100.0f * static_cast<float>(d.fraction()),
                    -static_cast<float>(d.fraction())};
    };
    for (int round = 0; round < 300; ++round) {
        std::vector<vec3> points;
        for (int n = 1 + d.roll(8); n > 0; --n) points.push_back(any());
        bounds3 all{points[0], points[0]};
        for (const vec3 p : points) all.add(p);
        vec3 low = points[0], high = points[0];
        for (const vec3 p : points) {
            CHECK(all.holds(p));
            low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
            high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
        }
        CHECK(all.low == low);
        CHECK(all.high == high);
        for (const vec3 p : {vec3{high.x + 1, high.y, high.z}, vec3{low.x, low.y - 1, low.z},
                             vec3{high.x, high.y, high.z + 1}, vec3{low.x, low.y, low.z - 1}})
            CHECK_FALSE(all.holds(p));
    }
}
