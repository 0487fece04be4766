// SPDX-License-Identifier: MIT
//
// Draws a word at five weights with its triangles, which are the same in all of them, as commands for ImageMagick's -draw:
// see make.sh.

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace typemesh;

int main(int, char** argv)
{
    constexpr double pixels = 200.0, line = 170.0;  // per em; from baseline to baseline
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    auto weight = harfbuzz_axis::open(*font, "wght");
    if (!weight) return std::puts(weight.error().message()), 1;
    axis_morph morph{*weight};
    auto plan = morph.plan("breathe", {.tolerance = 1.0 / 250.0, .depth = 0.1f});
    if (!plan) return std::puts(plan.error().message()), 1;

    std::printf("stroke-width 0.7 stroke '#0d1b2e' fill '#4682be'\n");
    for (int row = 0; row < 5; ++row) {
        std::vector<vec3> places;
        std::vector<std::uint32_t> corners;
        const double at = weight->coordinate(weight->low() + 0.25 * row * (weight->high() - weight->low()));
        const auto make = [](const surface_point<attribute::position>& v) noexcept { return v.position; };
        const auto written = plan->write_at(at, into(places, corners, make));
        if (!written) return std::puts(written.error().message()), 1;
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
            const vec3 a = places[corners[i]], b = places[corners[i + 1]], c = places[corners[i + 2]];
            const bool is_front = a.z == b.z && b.z == c.z && (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x);
            if (!is_front) continue;
            std::printf("polygon");
            for (const vec3& p : {a, b, c})
                std::printf(" %.1f,%.1f", 30.0 + pixels * static_cast<double>(p.x),
                            150.0 + line * row - pixels * static_cast<double>(p.y));
            std::printf("\n");
        }
    }
    return 0;
}
