// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/touching_walls.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <cstdint>
#include <initializer_list>

using namespace typemesh;

namespace {

/// A sweep whose last level consists of closed walls through these nodes, each list a loop.
struct walled {
    swept_region swept;

    walled()
    {
        for (const double level : {0.0, 100.0}) REQUIRE(swept.levels.push_back(level));
        for (int i = 0; i < 2; ++i) REQUIRE(swept.at_level.push_back(0u));
    }
    std::uint32_t node(std::int32_t x, std::int32_t y, float distance = 100.0f)
    {
        REQUIRE(swept.nodes.push_back({{x, y}, distance}));
        return static_cast<std::uint32_t>(swept.nodes.size() - 1);
    }
    void wall(std::initializer_list<std::uint32_t> loop)
    {
        std::uint32_t from = *(loop.end() - 1);
        for (const std::uint32_t to : loop) {
            REQUIRE(swept.edges_at.push_back({0, from, to}));
            from = to;
        }
        if (swept.at_level.size() == 2) REQUIRE(swept.at_level.push_back(0u));
        swept.at_level.back() = static_cast<std::uint32_t>(swept.edges_at.size());
    }
    [[nodiscard]] std::uint32_t touches()
    {
        workspace space;
        const auto found = count_touching_walls(swept, space);
        REQUIRE(found);
        return *found;
    }
};

}  // namespace

TEST_CASE("separate walls do not touch", "[touching_walls]")
{
    walled w;
    w.node(0, 0, 0.0f);
    w.wall({w.node(10, 0), w.node(20, 0), w.node(20, 10)});
    w.wall({w.node(30, 0), w.node(40, 0), w.node(40, 10)});
    CHECK(w.touches() == 0);
}

TEST_CASE("a wall without length does not count", "[touching_walls]")
{
    walled w;
    w.wall({w.node(10, 0), w.node(20, 0), w.node(20, 0), w.node(20, 10)});
    CHECK(w.touches() == 0);
}

TEST_CASE("two loops of walls touch in each point they share", "[touching_walls]")
{
    walled w;
    w.wall({w.node(10, 0), w.node(20, 0), w.node(20, 10)});
    w.wall({w.node(20, 0), w.node(40, 0), w.node(20, 10), w.node(30, 5)});
    CHECK(w.touches() == 2);
}

TEST_CASE("a node of the sweep may not end on a wall", "[touching_walls]")
{
    walled w;
    w.node(20, 0, 99.0f);
    w.node(15, 5, 99.0f);
    w.wall({w.node(10, 0), w.node(20, 0), w.node(20, 10)});
    CHECK(w.touches() == 1);
}

TEST_CASE("walls back to back are counted in addition to their points", "[touching_walls]")
{
    walled w;
    const std::uint32_t a = w.node(10, 0), b = w.node(20, 0);
    w.wall({a, b});
    CHECK(w.touches() == 1);
    w.wall({w.node(20, 0), w.node(10, 0), w.node(15, 20)});
    CHECK(w.touches() == 2 + 2);
}

TEST_CASE("count_touching_walls() reports that memory ran out", "[touching_walls]")
{
    walled w;
    w.wall({w.node(10, 0), w.node(20, 0), w.node(20, 10)});
    test::counting_memory memory{.fail_at = 1};
    workspace none{memory.source()};
    CHECK(count_touching_walls(w.swept, none).error() == error::out_of_memory);
}
