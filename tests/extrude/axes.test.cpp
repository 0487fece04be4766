// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/axes.hpp>

#include <random>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("the short way for upright frames gives the same numbers as the long one", "[extrude]")
{
    std::mt19937 random{3};
    std::uniform_int_distribution<std::int32_t> cell{-(1 << 28), 1 << 28};
    std::uniform_real_distribution<double> real{-1.0, 1.0};
    for (const frame& f : {right_handed_y_up, left_handed_y_up}) {
        REQUIRE(upright_axes::fit(f));
        for (int i = 0; i < 10000; ++i) {
            placement at;
            at.frame = f;
            at.pen = {1e6 * real(random), 1e6 * real(random)};
            at.unit_per_cell = real(random);
            const upright_axes quick{at};
            const free_axes slow{at};
            const grid_point g{cell(random), cell(random)};
            const auto z = static_cast<float>(real(random)), x = static_cast<float>(real(random));
            REQUIRE(quick.position(quick.foot(g), z) == slow.position(slow.foot(g), z));
            REQUIRE(at.position(g, z) == slow.position(slow.foot(g), z));
            REQUIRE(quick.direction(x, z, 0.0f) == slow.direction(x, z, 0.0f));
            REQUIRE(quick.direction(0.0f, 0.0f, -1.0f) == slow.direction(0.0f, 0.0f, -1.0f));
        }
    }
    CHECK_FALSE(upright_axes::fit(right_handed_z_up));
    CHECK_FALSE(upright_axes::fit(left_handed_z_up));
    CHECK_FALSE(upright_axes::fit(frame{.right = {-1.0f, 0.0f, 0.0f}}));
}

TEST_CASE("a place reached with different pens is the same float", "[extrude]")
{
    std::mt19937 random{5};
    std::uniform_int_distribution<std::int32_t> cell{-(1 << 27), 1 << 27};
    for (const frame& f : {right_handed_y_up, right_handed_z_up})
        for (int i = 0; i < 1000; ++i) {
            placement one, two;
            one.frame = two.frame = f;
            one.unit_per_cell = two.unit_per_cell = 1.0 / 1048576.0 / 0.7;
            const std::int32_t shift = cell(random);
            one.pen = {static_cast<double>(shift), 0.25};
            two.pen = {0.0, 0.25};
            const grid_point g{cell(random), cell(random)};
            with_axes(one, [&](const auto& a) {
                with_axes(two, [&](const auto& b) {
                    CHECK(a.position(a.foot(g), 0.5f) == b.position(b.foot(grid_point{g.x + shift, g.y}), 0.5f));
                });
            });
        }
}
