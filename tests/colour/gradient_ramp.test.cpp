// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/colour/gradient_ramp.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

using namespace typemesh;

namespace {

constexpr gradient_stop ramp_stops[] = {
    {0.25, {0, 0, 0, 1.0f}, 0}, {0.5, {200, 100, 0, 1.0f}, 1}, {1.25, {0, 0, 250, 0.5f}, 2}};

/// What a sampler finds in a ramp of 256 texels at u, as its mode extends it.
palette_colour sampled(gradient_extend extend, double u)
{
    constexpr std::uint32_t width = 256;
    double place = u * width - 0.5;
    const auto texel = [&](double i) {
        auto k = static_cast<std::int64_t>(i);
        constexpr std::int64_t w = width;
        if (extend == gradient_extend::pad) k = std::clamp<std::int64_t>(k, 0, w - 1);
        const std::int64_t period = (k >= 0 ? k : k - w + 1) / w, in = k - period * w;
        const bool back = extend == gradient_extend::reflect && period % 2 != 0;
        return ramp_colour(ramp_stops, static_cast<std::uint32_t>(back ? w - 1 - in : in), width);
    };
    const double low = std::floor(place), share = place - low;
    const palette_colour a = texel(low), b = texel(low + 1.0);
    const auto mixed = [&](int from, int to) { return static_cast<std::uint8_t>(from + share * (to - from) + 0.5); };
    return {mixed(a.red, b.red), mixed(a.green, b.green), mixed(a.blue, b.blue), a.alpha};
}

int off(const palette_colour& a, const palette_colour& b)
{
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

}  // namespace

TEST_CASE("a sampler finds the gradient's colours in its ramp, beyond the stops as well", "[colour][gradient_ramp]")
{
    glyph_paint p{.kind = paint_kind::linear, .from = {10, 20}, .to = {90, 60}, .across = {-30, 100}};
    p.placed = {.xx = 2.0, .xy = 0.5, .dx = 7.0, .yx = -0.25, .yy = 1.5, .dy = -3.0};
    for (const auto extend : {gradient_extend::pad, gradient_extend::repeat, gradient_extend::reflect}) {
        p.extend = extend;
        int wrong = 0;
        for (int i = 0; i < 500; ++i) {
            const point at{double(i * 37 % 1000) - 300.0, double(i * 91 % 1000) - 300.0};
            const auto u = ramp_coordinate(p, ramp_stops, at);
            REQUIRE(u);
            const double period = *u - std::floor(*u);  // next to a seam of `repeat` a sampler mixes both ends
            if (extend == gradient_extend::repeat && (period < 0.01 || period > 0.99)) continue;
            wrong += off(sampled(extend, *u), gradient_colour(ramp_stops, extend, *gradient_place(p, at))) > 2;
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("the ramp of a linear gradient is linear over triangles, that of a radial one at vertices only",
          "[colour][gradient_ramp]")
{
    glyph_paint p{.kind = paint_kind::linear, .from = {0, 0}, .to = {100, 30}, .across = {-20, 50}};
    const point a{5, 900}, b{-700, 40}, c{333, -90};
    const auto at = [&p](point q) { return *ramp_coordinate(p, ramp_stops, q); };
    const auto off_linear = [&] {
        const point inside = 0.2 * a + 0.5 * b + 0.3 * c;
        return std::fabs(at(inside) - (0.2 * at(a) + 0.5 * at(b) + 0.3 * at(c)));
    };
    CHECK(off_linear() < 1e-12);
    CHECK(std::fabs(at({0, 0}) - (-0.25)) < 1e-12);
    p = {.kind = paint_kind::radial, .from = {0, 0}, .to = {0, 0}, .from_radius = 0, .to_radius = 100};
    CHECK(off_linear() > 1.0);
    CHECK(std::fabs(at({75, 0}) - 0.5) < 1e-12);
}

TEST_CASE("ramps without length or stops are no division by zero", "[colour][gradient_ramp]")
{
    const glyph_paint p{.kind = paint_kind::linear, .from = {0, 0}, .to = {100, 0}, .across = {0, 50}};
    const gradient_stop hard[] = {{0.5, {1, 2, 3, 1.0f}, 0}, {0.5, {4, 5, 6, 1.0f}, 1}};
    CHECK(*ramp_coordinate(p, hard, {49, 0}) < 0.25);
    CHECK(*ramp_coordinate(p, hard, {51, 0}) > 0.75);
    CHECK(ramp_colour(hard, 0, 4) == hard[0].colour);
    CHECK(ramp_colour(hard, 3, 4) == hard[1].colour);
    CHECK_FALSE(ramp_coordinate(p, {}, {1, 1}));
    CHECK(ramp_colour({}, 0, 4) == palette_colour{});
}
