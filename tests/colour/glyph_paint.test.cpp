// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/colour/glyph_paint.hpp>

#include <cmath>

using namespace typemesh;

namespace {

bool is_at(const std::optional<double>& place, double expected) { return place && std::fabs(*place - expected) < 1e-9; }

}  // namespace

TEST_CASE("a linear gradient is constant along its third point's direction", "[colour]")
{
    glyph_paint p{.kind = paint_kind::linear, .from = {0, 0}, .to = {100, 0}, .across = {0, 50}};
    CHECK(is_at(gradient_place(p, {25, 700}), 0.25));
    CHECK(is_at(gradient_place(p, {-50, 0}), -0.5));
    p.across = {50, 50};  // slanted: the line through (100, 0) along (1, 1) is the end
    CHECK(is_at(gradient_place(p, {130, 30}), 1.0));
    CHECK(is_at(gradient_place(p, {30, 30}), 0.0));
    p.across = {10, 0};  // along the gradient itself: nothing is painted
    CHECK_FALSE(gradient_place(p, {1, 1}));
    CHECK(is_at(gradient_place(glyph_paint{}, {1, 1}), 0.0));
}

TEST_CASE("radial gradients take the outermost circle through a point", "[colour]")
{
    glyph_paint p{.kind = paint_kind::radial, .from = {10, 20}, .to = {10, 20}, .from_radius = 0, .to_radius = 100};
    CHECK(is_at(gradient_place(p, {10, 70}), 0.5));
    CHECK(is_at(gradient_place(p, {210, 20}), 2.0));
    p = {.kind = paint_kind::radial, .from = {0, 0}, .to = {100, 0}, .from_radius = 10, .to_radius = 10};  // a strip
    CHECK(is_at(gradient_place(p, {50, 0}), 0.6));
    CHECK_FALSE(gradient_place(p, {50, 11}));
    p.to_radius = 0;  // a cone that ends in (100, 0)
    CHECK_FALSE(gradient_place(p, {150, 60}));
    CHECK(is_at(gradient_place(p, {100, 0}), 1.0));
}

TEST_CASE("sweeps turn counter-clockwise, and maps are undone", "[colour]")
{
    glyph_paint p{.kind = paint_kind::sweep, .from = {5, 5}, .from_turn = 0.0, .to_turn = 2.0};
    CHECK(is_at(gradient_place(p, {5, 15}), 0.25));
    CHECK(is_at(gradient_place(p, {5, -15}), 0.75));
    p.placed = {.xx = 0.0, .xy = -1.0, .dx = 100.0, .yx = 1.0, .yy = 0.0, .dy = 0.0};  // a quarter turn, moved
    CHECK(is_at(gradient_place(p, p.placed(point{5, 15})), 0.25));
    p.placed = {.xx = 0.0, .yy = 0.0};
    CHECK_FALSE(gradient_place(p, {1, 2}));
}

TEST_CASE("colours between stops mix, and extend beyond them as asked", "[colour]")
{
    const gradient_stop stops[] = {
        {0.0, {0, 0, 0, 0.0f}, 0}, {0.5, {200, 100, 0, 1.0f}, 1}, {1.0, {0, 0, 250, 1.0f}, 2}};
    const auto at = [&](gradient_extend extend, double place) { return gradient_colour(stops, extend, place); };
    CHECK(at(gradient_extend::pad, 0.25) == palette_colour{100, 50, 0, 0.5f});
    CHECK(at(gradient_extend::pad, -3.0) == stops[0].colour);
    CHECK(at(gradient_extend::pad, 3.0) == stops[2].colour);
    CHECK(at(gradient_extend::repeat, 3.25) == palette_colour{100, 50, 0, 0.5f});
    CHECK(at(gradient_extend::repeat, -0.75) == palette_colour{100, 50, 0, 0.5f});
    CHECK(at(gradient_extend::reflect, 1.75) == palette_colour{100, 50, 0, 0.5f});
    CHECK(at(gradient_extend::reflect, 2.25) == palette_colour{100, 50, 0, 0.5f});
    CHECK(gradient_colour({}, gradient_extend::pad, 0.5) == palette_colour{});
}
