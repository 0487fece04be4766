// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/ridge_graph.hpp>

#include "support/catch.hpp"
#include "support/filled_shape.hpp"
#include "support/regions.hpp"

#include <cstdint>
#include <vector>

using namespace typemesh;
using detail::ridge_graph;

namespace {

/// A square of 1000 cells, swept inwards by hand: to its middle, or to a floor of 600 cells.
struct hand_swept_square {
    test::filled_shape made{test::shape{"square", {test::square(0, 0, 1000)}}};
    swept_region swept;

    explicit hand_swept_square(bool has_floor)
    {
        bool fits = swept.levels.push_back(0.0) && swept.levels.push_back(has_floor ? 200.0 : 516.0);
        for (const grid_point p : made.filled.points()) fits = fits && swept.nodes.push_back({p, 0.0f});
        for (std::uint32_t i = 0; i < 4; ++i) fits = fits && swept.edges_at.push_back({i, i, (i + 1) % 4});
        for (std::uint32_t i = 0; i < 4; ++i) {
            const grid_point p = made.filled.points()[i];
            const auto inner = [](std::int32_t v) { return v == 0 ? 200 : 800; };
            if (has_floor) fits = fits && swept.nodes.push_back({{inner(p.x), inner(p.y)}, 200.0f});
            if (has_floor) fits = fits && swept.edges_at.push_back({i, i + 4, (i + 1) % 4 + 4});
        }
        if (!has_floor) fits = fits && swept.nodes.push_back({{500, 500}, 500.0f});
        for (std::uint32_t i = 0; i < 4; ++i) {
            const std::uint32_t next = (i + 1) % 4;
            fits = fits && swept.cells.push_back({i, 0, static_cast<std::uint32_t>(swept.triangles.size())});
            if (has_floor)
                fits = fits && swept.triangles.push_back({i, next, next + 4}) &&
                       swept.triangles.push_back({i, next + 4, i + 4});
            else
                fits = fits && swept.triangles.push_back({i, next, 4});
        }
        const auto end = static_cast<std::uint32_t>(swept.triangles.size());
        const std::uint32_t edges = has_floor ? 8 : 4;
        fits = fits && swept.cells.push_back({0, 1, end}) && swept.at_level.push_back(0) &&
               swept.at_level.push_back(4) && swept.at_level.push_back(edges);
        REQUIRE(fits);
    }
};

/// The lines that are left when the corners say what they are.
template <class IsCorner>
std::vector<std::vector<std::uint32_t>> ridge_chains(const hand_swept_square& s, const IsCorner& is_corner,
                                                     std::int64_t crease = detail::unit_one)
{
    workspace space;
    workspace::scope scratch{space};
    ridge_graph graph{s.made.filled, s.swept, scratch};
    REQUIRE(graph.build());
    graph.prune(crease, is_corner);
    std::vector<std::vector<std::uint32_t>> all;
    CHECK(graph.chains([&](std::uint32_t node, bool begins) {
        if (begins) all.emplace_back();
        all.back().push_back(node);
        return true;
    }));
    return all;
}

}  // namespace

TEST_CASE("a square has a ridge from each corner, in the order of its nodes", "[offset][ridges]")
{
    using chains = std::vector<std::vector<std::uint32_t>>;
    const auto all = [](std::uint32_t) noexcept { return true; };
    CHECK(ridge_chains(hand_swept_square{false}, all) == chains{{0, 4}, {1, 4}, {2, 4}, {3, 4}});
    CHECK(ridge_chains(hand_swept_square{true}, all) == chains{{0, 4}, {1, 5}, {2, 6}, {3, 7}});
    // Its faces turn by 90 degrees: less than a crease of 120. But ridges to the floor have no open end there.
    CHECK(ridge_chains(hand_swept_square{true}, all, -detail::unit_one / 2) == chains{{0, 4}, {1, 5}, {2, 6}, {3, 7}});
    const auto none = [](std::uint32_t) noexcept { return false; };
    CHECK(ridge_chains(hand_swept_square{false}, none) == chains{{4}});  // the deepest point
    CHECK(ridge_chains(hand_swept_square{true}, none).empty());          // the floor is there instead
    const auto two = [](std::uint32_t i) noexcept { return i < 2; };
    CHECK(ridge_chains(hand_swept_square{false}, two) == chains{{0, 4, 1}});  // one line through the middle
    const auto one = [](std::uint32_t i) noexcept { return i == 3; };
    CHECK(ridge_chains(hand_swept_square{false}, one) == chains{{3, 4}});
    CHECK(ridge_chains(hand_swept_square{true}, one) == chains{{3, 7}});
}
