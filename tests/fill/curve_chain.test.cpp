// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/curve_chain.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("two curves meet where both are, or are not said to meet", "[fill][boundary]")
{
    const curve arch = curve::from(quadratic{{0, 0}, {50, 100}, {100, 0}}), line = curve::from({0, 30}, {100, 40});
    const double cells = 512.0;
    const point near = cells * point{20, 33};
    const auto m = detail::meeting_of({&arch, {}, 0.25}, {&line, {}, 0.15}, cells, near, 1e5);
    REQUIRE(m.found);
    CHECK(length(cells * arch.at(m.s) - cells * line.at(m.t)) < 1e-3);
    CHECK(length(m.at - cells * arch.at(m.s)) < 1e-9);
    CHECK_FALSE(detail::meeting_of({&arch, {}, 0.25}, {&line, {}, 0.15}, cells, near, 10.0).found);  // too far away
    const curve above = curve::from({0, 51}, {100, 51}), touching = curve::from({0, 50}, {100, 50});
    CHECK_FALSE(detail::meeting_of({&arch, {}, 0.45}, {&above, {}, 0.45}, cells, cells * point{45, 50}, 1e5).found);
    CHECK(detail::meeting_of({&arch, {}, 0.5}, {&touching, {}, 0.5}, cells, cells * point{50, 50}, 1.0)
              .found);  // is there
    // Moved curves meet at moved places.
    const point shift{1234, -77};
    const auto moved = detail::meeting_of({&arch, shift, 0.25}, {&line, shift, 0.15}, cells, near + shift, 1e5);
    REQUIRE(moved.found);
    CHECK(length(moved.at - m.at - shift) < 1e-3);
    // A curve does not meet itself where it only passes.
    CHECK_FALSE(detail::meeting_of({&arch, {}, 0.2}, {&arch, {}, 0.3}, cells, near, 1e6).found);
}
