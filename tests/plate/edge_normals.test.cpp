// SPDX-License-Identifier: MIT
#include <typemesh/core/workspace.hpp>
#include <typemesh/plate/impl/edge_normals.hpp>

#include "support/catch.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace typemesh;

namespace {

layer_arrangement lone_polygon(const std::vector<grid_point>& p)
{
    layer_arrangement cells;
    cells.begin({});
    const std::array<std::uint32_t, 2> starts{0, static_cast<std::uint32_t>(p.size())};
    REQUIRE(cells.add({p.data(), p.size()}, {starts.data(), 2}, 0));
    workspace space;
    REQUIRE(cells.cut(space));
    return cells;
}

}  // namespace

TEST_CASE("the walls of a fine circle have the circle's normals, those of a square its own", "[edge_normals]")
{
    std::vector<grid_point> circle;
    for (int i = 0; i < 64; ++i) {
        const double angle = 3.14159265358979 * i / 32;
        circle.push_back(
            {static_cast<std::int32_t>(1e6 * std::cos(angle)), static_cast<std::int32_t>(1e6 * std::sin(angle))});
    }
    const layer_arrangement round = lone_polygon(circle);
    detail::edge_normals normals;
    REQUIRE_FALSE(normals.find(round));
    for (std::size_t i = 0; i < round.piece_count(); ++i) {
        const auto s = round[i];
        const std::int32_t side = s.side(cells_of_layer(0));
        REQUIRE(side != 0);
        const vec2 n = normals.at(s, s.source.t0, side);
        CHECK(n.x == Catch::Approx(s.from.x / 1e6).margin(1e-4));
        CHECK(n.y == Catch::Approx(s.from.y / 1e6).margin(1e-4));
        const vec2 hole = normals.at(s, s.source.t1, -side);  // of the solid around a hole
        CHECK(hole.x == Catch::Approx(-s.to.x / 1e6).margin(1e-4));
        CHECK(hole.y == Catch::Approx(-s.to.y / 1e6).margin(1e-4));
    }
    const layer_arrangement square = lone_polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    REQUIRE_FALSE(normals.find(square));
    for (std::size_t i = 0; i < square.piece_count(); ++i) {
        const auto s = square[i];
        const vec2 n = normals.at(s, s.source.t0, s.side(cells_of_layer(0)));
        const double mx = 0.5 * (s.from.x + s.to.x) - 5, my = 0.5 * (s.from.y + s.to.y) - 5;
        CHECK(n.x == Catch::Approx(mx / 5));
        CHECK(n.y == Catch::Approx(my / 5));
    }
}
