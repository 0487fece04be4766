// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/sweep_line.hpp>

#include "support/catch.hpp"

using namespace typemesh;
using detail::sweep_line;

TEST_CASE("A sweep line finds the last edge below a point, and reuses its slots", "[fill][sweep_line]")
{
    workspace space;
    workspace::scope scratch{space};
    sweep_line line;
    REQUIRE(line.open(scratch, 2));
    CHECK(line.empty());
    CHECK(line.find({0, 0}) == 0);

    const std::uint32_t low = line.insert_above(0), high = line.insert_above(low);
    line[low].begin({0, 0}, {10, 0}, 0, 1);
    line[high].begin({0, 5}, {10, 5}, 1, 0);
    CHECK(line.room() == 0);
    CHECK(line.above(low) == high);
    CHECK(line.below(high) == low);
    CHECK(line.find({4, -1}) == 0);
    CHECK(line.find({4, 0}) == 0);  // on the edge is not above it
    CHECK(line.find({4, 3}) == low);
    CHECK(line.find({4, 6}) == high);

    line.erase(low);
    CHECK(line[low].to == sweep_line::beyond);
    CHECK(line.find({4, 3}) == 0);
    CHECK(line.insert_above(high) == low);
    CHECK(line.above(high) == low);
    line.erase(low);
    line.erase(high);
    CHECK(line.empty());
    CHECK(line.room() == 2);
}
