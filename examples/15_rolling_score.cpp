// SPDX-License-Identifier: MIT
//
// A score whose digits roll like a mileage counter. Each wheel is a word of ten digits. Their meshes are written
// once; a frame only gives each digit a map, which instanced drawing takes, and allocates nothing.
//
//     15_rolling_score FONT

#include "counted_allocations.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace typemesh;

/// Puts the ten digits of each word around a wheel, and turns the wheels. Digits on the far side are hidden.
struct wheels {
    double score;

    affine3 operator()(const letter_place& l) const noexcept
    {
        const double digit = l.index - l.word.first;
        double below = std::fmod(digit - turn(l.words - 1 - l.letter.word) + 20.0, 10.0);  // digits below the front one
        if (below > 5.0) below -= 10.0;
        constexpr float radius = 1.4f;
        if (std::fabs(below) > 2.0) return hidden_at({0.8f * static_cast<float>(l.letter.word), 0.0f, -radius});
        const affine3 on_wheel = shifted({0.8f * static_cast<float>(l.letter.word) - l.letter.pivot.x,
                                          -l.letter.pivot.y, radius - l.letter.pivot.z});
        return shifted({0.0f, 0.0f, -radius}) * turned(l.frame.right, 0.6283185307179586 * below) * on_wheel;
    }
    /// How many digits a wheel has gone. A wheel moves while the one to its right goes from 9 to 0.
    [[nodiscard]] double turn(std::uint32_t wheel) const noexcept
    {
        double gone = score;
        for (std::uint32_t i = 0; i < wheel; ++i) {
            const double tens = std::floor(gone / 10.0), over = gone - 10.0 * tens - 9.0;
            gone = tens + (over > 0.0 ? over : 0.0);
        }
        return std::fmod(gone, 10.0);
    }
};

int main(int argc, char** argv)
{
    if (argc < 2) return std::puts("usage: 15_rolling_score FONT"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    constexpr text_view text = "0123456789 0123456789 0123456789";
    text_mesher mesher{*font};
    auto plan = mesher.plan(text);
    if (!plan) return std::puts(plan.error().message()), 1;
    if (auto found = plan->find_letters(text, {.pivot = letter_pivot::centre}); !found)
        return std::puts(found.error().message()), 1;

    std::vector<vec3> vertices;  // the meshes of ten digits, for the graphics card
    std::vector<std::uint32_t> indices;
    if (!plan->write_meshes(into(vertices, indices))) return 1;
    std::printf("%zu digits share %zu meshes\n", plan->glyphs().size(), plan->meshes().size());
    std::vector<affine3> maps(plan->glyphs().size());  // of the instances
    const std::size_t before = allocations;
    for (int frame = 0; frame <= 250; ++frame) {
        char front[] = "---";  // the digits whose fronts can be read: those that are not turned away
        plan->write_instances(wheels{double(frame)}, [&](const glyph_instance& i, const affine3& map) noexcept {
            maps[i.glyph] = map;
            if (map.z.z > 0.999f) front[i.letter / 10] = static_cast<char>('0' + i.letter % 10);
        });
        if (frame % 50 == 49) std::printf("score %d: the wheels show %s\n", frame, front);
    }
    std::printf("%zu allocations in 251 frames\n", allocations - before);
}
