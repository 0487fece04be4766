// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/cell_repair.hpp>

#include <typemesh/core/orientation.hpp>

#include "support/catch.hpp"

#include <cstdint>
#include <vector>

using namespace typemesh;

namespace {

buffer<swept_node> nodes_at(const std::vector<grid_point>& places)
{
    buffer<swept_node> nodes;
    for (const grid_point p : places) REQUIRE(nodes.push_back({p, 0.0f}));
    return nodes;
}

/// A ring of so many nodes, one after the other.
buffer<std::uint32_t> ring_of(std::uint32_t size, std::uint32_t first = 0)
{
    buffer<std::uint32_t> ring;
    for (std::uint32_t i = 0; i < size; ++i) REQUIRE(ring.push_back(first + i));
    return ring;
}

std::vector<std::uint32_t> way(const detail::cell_repair& repair, std::uint32_t from, std::uint32_t to)
{
    buffer<std::uint32_t> path;
    REQUIRE(path.push_back(from));
    REQUIRE(repair.follow(path, to));
    return {path.begin(), path.end()};
}

constexpr auto nowhere = [](std::uint32_t, std::uint32_t) { return false; };

}  // namespace

TEST_CASE("cell_repair leads a side over its nearest node, in both directions", "[offset]")
{
    auto nodes = nodes_at({{0, 0}, {1000, 0}, {600, -2}, {300, -1}});
    const auto ring = ring_of(4);
    detail::cell_repair repair{heap()};
    repair.begin(0);
    REQUIRE(repair.mend(ring, nodes, nowhere));
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0, 3});  // the nodes before the end of the side
    CHECK(way(repair, 1, 0) == std::vector<std::uint32_t>{1, 3});
    CHECK(way(repair, 1, 2) == std::vector<std::uint32_t>{1});
    CHECK(nodes[3].at == grid_point{300, -1});

    repair.begin(0);
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0});
}

TEST_CASE("cell_repair makes no detour that returns over the side it replaces", "[offset]")
{
    // Within rounding, each of three nodes lies beside the side between the two others.
    auto nodes = nodes_at({{0, 0}, {100, 0}, {50, -1}});
    detail::cell_repair repair{heap()};
    repair.begin(0);
    REQUIRE(repair.mend(ring_of(3), nodes, nowhere));
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0, 2});
    nodes[1].at = {50, 0};  // now node 1 is beside the side from 0 to 2
    nodes[2].at = {100, -1};
    CHECK_FALSE(repair.mend(ring_of(3), nodes, nowhere));
    CHECK(way(repair, 0, 2) == std::vector<std::uint32_t>{0});
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0, 2});
}

TEST_CASE("cell_repair moves a node off a side at a level, unless an earlier band owns the node", "[offset]")
{
    const auto at_level = [](std::uint32_t a, std::uint32_t b) { return a + b == 1; };
    for (const std::int32_t below : {0, 1}) {
        auto nodes = nodes_at({{0, 0}, {1000, 3}, {500, 1 - below}, {500, 400}});
        const auto ring = ring_of(4);
        detail::cell_repair repair{heap()};
        repair.begin(2);
        REQUIRE(repair.mend(ring, nodes, at_level));
        CHECK(nodes[2].at == grid_point{500, 2});
        CHECK(orientation(nodes[0].at, nodes[1].at, nodes[2].at) > 0);
        CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0});
    }
    auto nodes = nodes_at({{0, 0}, {1000, 3}, {500, 1}, {500, 400}});
    detail::cell_repair repair{heap()};
    repair.begin(3);
    CHECK_FALSE(repair.mend(ring_of(4), nodes, at_level));
    CHECK(nodes[2].at == grid_point{500, 1});
}

TEST_CASE("cell_repair joins two close neighbours, but not at levels", "[offset]")
{
    auto nodes = nodes_at({{0, 2}, {2, 0}, {0, -2}, {-2, 0}});
    const auto ring = ring_of(4);
    detail::cell_repair repair{heap()};
    repair.begin(0);
    REQUIRE(repair.mend(ring, nodes, nowhere));
    CHECK(repair.node(0) == 1);
    CHECK(repair.node(2) == 2);
    CHECK(way(repair, 3, 0) == std::vector<std::uint32_t>{3});
    repair.begin(4);  // an earlier band owns all of them
    CHECK(repair.node(0) == 0);
    CHECK_FALSE(repair.mend(ring, nodes, nowhere));
    repair.begin(0);
    CHECK_FALSE(repair.mend(ring, nodes, [](std::uint32_t a, std::uint32_t b) { return a == b; }));
    nodes[2].distance = 100.0f;
    nodes[3].distance = 50.0f;
    REQUIRE(repair.mend(ring, nodes, [](std::uint32_t a, std::uint32_t b) { return a == b && a == 0; }));
    CHECK(repair.node(1) == 0);
}

TEST_CASE("cell_repair changes nothing that is two cells apart", "[offset]")
{
    auto nodes = nodes_at({{0, 0}, {1000, 0}, {500, -2}, {-10, 0}});
    detail::cell_repair repair{heap()};
    repair.begin(0);
    CHECK_FALSE(repair.mend(ring_of(3), nodes, nowhere));
    CHECK_FALSE(repair.mend(ring_of(3), nodes, [](std::uint32_t, std::uint32_t) { return true; }));
}

TEST_CASE("cell_repair joins at most 64 pairs of nodes in a band", "[offset]")
{
    // Pairs 2 cells apart, far from each other: nothing else can be done about them.
    std::vector<grid_point> places;
    for (std::int32_t i = 0; i < 66; ++i) {
        const std::int32_t x = 1000 * i, y = i * i;
        places.insert(places.end(), {{x, y}, {x + 2, y}});
    }
    auto nodes = nodes_at(places);
    const auto nothing_near = [](std::uint32_t a, std::uint32_t b) { return a != b; };  // sides stay straight
    detail::cell_repair repair{heap()};
    repair.begin(0);
    for (std::uint32_t pair = 0; pair < 66; ++pair) {
        CHECK(repair.mend(ring_of(2, 2 * pair), nodes, nothing_near) == (pair < 64));
        CHECK((repair.node(2 * pair) == 2 * pair + 1) == (pair < 64));
    }
    repair.begin(0);  // the next band starts anew
    CHECK(repair.mend(ring_of(2, 130), nodes, nothing_near));
}

TEST_CASE("cell_repair makes at most 1024 detours in a band, joins nodes after that, and forgets both", "[offset]")
{
    // Triangles with a node one cell beside the longest side. Those after the first 1024 are close enough to be joined.
    constexpr std::uint32_t most = 1024;
    std::vector<grid_point> places;
    for (std::uint32_t i = 0; i <= most; ++i) {
        const auto y = static_cast<std::int32_t>(1000 * i);
        places.insert(places.end(), {{0, y}, {1000, y}, {2, y - 1}});
    }
    auto nodes = nodes_at(places);
    const auto ring_at = [](std::uint32_t i) { return ring_of(3, 3 * i); };
    detail::cell_repair repair{heap()};
    repair.begin(0);
    for (std::uint32_t i = 0; i < most; ++i) REQUIRE(repair.mend(ring_at(i), nodes, nowhere));
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0, 2});
    CHECK(repair.node(2) == 2);
    REQUIRE(repair.mend(ring_at(most), nodes, nowhere));
    CHECK(repair.node(3 * most + 2) == 3 * most);
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0});
    CHECK(repair.mend(ring_at(0), nodes, nowhere));
    CHECK(way(repair, 0, 1) == std::vector<std::uint32_t>{0, 2});
}
