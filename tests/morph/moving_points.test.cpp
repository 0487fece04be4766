// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/moving_points.hpp>

#include <cstdlib>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("moving points go evenly from key to key, and fixed points stay", "[morph]")
{
    const std::vector<grid_point> places = {{0, 0}, {100, -7}, {320, -640}, {101, 9}};
    const grid_point fixed[] = {{5, 6}};
    const moving_points p{places, 2, fixed};
    CHECK(p.size() == 3);
    CHECK(p.at(1, 0) == grid_point{320, -640});
    CHECK(p.at(1, 2) == grid_point{5, 6});
    for (std::int32_t part = 0; part <= 32; ++part) {
        CHECK(p.between(0, part, 0) == grid_point{10 * part, -20 * part});
        CHECK(std::abs(32 * p.between(0, part, 1).y - (-7 * (32 - part) + 9 * part)) <= 16);
        CHECK(p.between(0, part, 2) == grid_point{5, 6});
    }
}
