// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/morph_writer.hpp>

#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a step has a key and a share, which stay within the keys", "[morph]")
{
    const std::vector<axis_coordinate> keys = {-100, 0, 50};
    const auto is = [&](double at, std::size_t key, double share) {
        const morph_step s = step_in(keys, at);
        return s.key == key && s.share == share;
    };
    CHECK(is(-200.0, 0, 0.0));
    CHECK(is(-100.0, 0, 0.0));
    CHECK(is(-25.0, 0, 0.75));
    CHECK(is(0.0, 1, 0.0));
    CHECK(is(12.5, 1, 0.25));
    CHECK(is(50.0, 1, 1.0));
    CHECK(is(99.0, 1, 1.0));
    const std::vector<axis_coordinate> one = {5};
    CHECK(step_in(one, 5.0).key == 0);
}
