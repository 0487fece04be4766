// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/flip_history.hpp>

#include "support/catch.hpp"

#include <cstdint>
#include <vector>

using namespace typemesh;
using detail::flip_history;
using detail::time_one;

TEST_CASE("a circle of flips is noticed, whatever its length and the flips before it", "[offset][flip_history]")
{
    for (const std::uint32_t length : {2u, 3u, 7u, 100u}) {
        flip_history history{heap()};
        for (std::uint32_t i = 0; i < 50; ++i) CHECK_FALSE(history.comes_back(1000 + i, 2000, 5));
        std::uint32_t flips = 0;
        while (!history.comes_back(flips % length, 500, 5) && flips < 10 * (50 + length)) ++flips;
        CHECK(flips >= length);
        CHECK(flips < 4 * (50 + length));
        CHECK(history.comes_back(500, flips % length, 5));        // from its other end
        CHECK_FALSE(history.comes_back(flips % length, 500, 6));  // at another time
    }
}

TEST_CASE("two triangles that undo each other's flips wait longer each time", "[offset][flip_history]")
{
    flip_history history{heap()};
    std::int64_t now = 77, calm = 0;
    std::vector<std::int64_t> waits;
    for (int i = 0; i < 60; ++i) {
        REQUIRE(history.note(3, 8, now, calm));
        waits.push_back(calm - now);
        now = calm;
    }
    for (int i = 0; i < 8; ++i) CHECK(waits[static_cast<std::size_t>(i)] == 0);
    CHECK(waits[8] == time_one / 16);
    for (std::size_t i = 9; i < 38; ++i) CHECK(waits[i] == 2 * waits[i - 1]);
    CHECK(waits[59] == waits[38]);
}

TEST_CASE("a new flip does not wait", "[offset][flip_history]")
{
    const auto wait_after = [](auto nineteenth) {
        flip_history history{heap()};
        std::int64_t calm = 100;
        for (int i = 0; i < 18; ++i) REQUIRE(history.note(3, 8, calm, calm));
        return nineteenth(history, calm);
    };
    const auto wait = [](flip_history& history, std::uint32_t t, std::uint32_t r, std::int64_t now) {
        std::int64_t calm = 0;
        REQUIRE(history.note(t, r, now, calm));
        return calm - now;
    };
    CHECK(wait_after([&](flip_history& h, std::int64_t now) { return wait(h, 3, 8, now); }) > 0);
    CHECK(wait_after([&](flip_history& h, std::int64_t now) { return wait(h, 8, 3, now); }) > 0);
    CHECK(wait_after([&](flip_history& h, std::int64_t now) { return wait(h, 3, 8, now + 1); }) == 0);
    CHECK(wait_after([&](flip_history& h, std::int64_t now) { return wait(h, 3, 9, now); }) == 0);
    CHECK(wait_after([&](flip_history& h, std::int64_t now) {
              CHECK(wait(h, 8, 9, now) == 0);
              return wait(h, 3, 8, now);
          }) == 0);
}
