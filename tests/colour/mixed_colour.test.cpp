// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/colour/impl/mixed_colour.hpp>

#include <cmath>
#include <cstdint>

using namespace typemesh;

namespace {

int mixed_red(int backdrop, int source, std::uint32_t mode, float alpha = 1.0f)
{
    const palette_colour b{static_cast<std::uint8_t>(backdrop), 0, 0, 1.0f};
    return detail::mixed_colour(b, {static_cast<std::uint8_t>(source), 0, 0, alpha}, mode).red;
}

}  // namespace

TEST_CASE("a colour over another one is their mean by its alpha", "[colour]")
{
    const palette_colour half = detail::mixed_colour({255, 0, 0, 1.0f}, {0, 0, 255, 0.5f}, 0);
    CHECK((half == palette_colour{128, 0, 128, 1.0f}));
    CHECK((detail::mixed_colour({1, 2, 3, 1.0f}, {4, 5, 6, 1.0f}, 0) == palette_colour{4, 5, 6, 1.0f}));
    CHECK((detail::mixed_colour({1, 2, 3, 1.0f}, {4, 5, 6, 0.0f}, 0) == palette_colour{1, 2, 3, 1.0f}));
    const palette_colour thin = detail::mixed_colour({255, 0, 0, 0.5f}, {0, 0, 255, 0.5f}, 0);
    CHECK((thin == palette_colour{85, 0, 170, 0.75f}));
    CHECK(detail::mixed_colour({9, 9, 9, 0.0f}, {4, 5, 6, 0.0f}, 0).red == 4);
}

TEST_CASE("blend modes give the values of their formulas", "[colour]")
{
    CHECK(mixed_red(200, 100, 12) == 255);
    CHECK(mixed_red(51, 102, 13) == 133);  // 0.2 + 0.4 - 0.08
    CHECK(mixed_red(51, 102, 14) == 41);   // 2 * 0.2 * 0.4
    CHECK(mixed_red(51, 102, 15) == 51);
    CHECK(mixed_red(51, 102, 16) == 102);
    CHECK(mixed_red(51, 102, 17) == 85);    // 0.2 / 0.6
    CHECK(mixed_red(204, 102, 18) == 128);  // 1 - 0.2 / 0.4
    CHECK(mixed_red(51, 102, 19) == 41);
    CHECK(mixed_red(51, 204, 19) == 173);   // 0.2 + 0.6 * 0.8
    CHECK(mixed_red(51, 102, 20) == 43);    // 0.2 - 0.2 * 0.2 * 0.8
    CHECK(mixed_red(102, 204, 20) == 138);  // 0.4 + 0.6 * (sqrt(0.4) - 0.4)
    CHECK(mixed_red(51, 102, 21) == 51);
    CHECK(mixed_red(51, 102, 22) == 112);  // 0.6 - 0.16
    CHECK(mixed_red(51, 102, 23) == 20);
    CHECK(mixed_red(51, 102, 24) == 102);  // hue, which is not mixed
    CHECK(mixed_red(100, 255, 23, 0.5f) == 100);
    for (std::uint32_t mode = 0; mode < 28; ++mode)
        for (const int b : {0, 128, 255})
            for (const int s : {0, 128, 255}) {
                const double v = detail::blended_channel(mode, b / 255.0, s / 255.0);
                CHECK((v >= 0.0 && v <= 1.0));
                CHECK(mixed_red(b, s, mode, 0.0f) == b);
            }
    CHECK(std::fabs(detail::blended_channel(20, 0.5, 0.5) - 0.5) < 1e-12);  // grey leaves soft light as it is
}

TEST_CASE("only an opaque layer that does not blend hides what is below it", "[colour]")
{
    colour_layer layer;
    CHECK(detail::hides(layer));
    layer.blend = 23;
    CHECK_FALSE(detail::hides(layer));
    layer.blend = 0;
    layer.paint.colour.alpha = 0.99f;
    CHECK_FALSE(detail::hides(layer));
}
