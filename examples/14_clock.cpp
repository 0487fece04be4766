// SPDX-License-Identifier: MIT
//
// A clock: one text has its numerals, hands and a dot for the seconds. It is planned once, and each frame writes it with
// its words where they belong. A frame allocates nothing.
//
//     14_clock FONT

#include "counted_allocations.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

using namespace typemesh;

constexpr text_view dial = "12 1 2 3 4 5 6 7 8 9 10 11 I I o";

/// Words 0 to 11 stand on the face, 12 and 13 are the hands, and 14 runs around.
struct clock_motion {
    double seconds;  // since midnight

    affine3 operator()(const letter_place& l) const noexcept
    {
        const std::uint32_t word = l.letter.word;
        const affine3 to_centre = shifted({-l.word.pivot.x, -l.word.pivot.y, -l.word.pivot.z});
        if (word < 12) return shifted(at(word / 12.0, 3.0)) * to_centre;
        if (word == 14) return shifted(at(seconds / 60.0, 2.2)) * scaled(0.4f) * to_centre;
        const float length = word == 12 ? 1.6f : 2.4f;  // a hand is an I that reaches from the centre outwards
        const float height = l.letter.extent.y;
        const affine3 stretched{{0.7f, 0, 0}, {0, length / height, 0}, {0, 0, 0.5f}, {0, 0.45f * length, 0}};
        const double turns = seconds / (word == 12 ? 43200.0 : 3600.0);
        return turned(l.frame.toward, -6.283185307179586 * turns) * stretched * to_centre;
    }
    /// The place after a part of a turn, clockwise from the top.
    static vec3 at(double turns, double radius) noexcept
    {
        const double angle = 6.283185307179586 * turns;
        return {static_cast<float>(radius * std::sin(angle)), static_cast<float>(radius * std::cos(angle)), 0.0f};
    }
};

int main(int argc, char** argv)
{
    if (argc < 2) return std::puts("usage: 14_clock FONT"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    text_mesher mesher{*font};
    auto plan = mesher.plan(dial);
    if (!plan) return std::puts(plan.error().message()), 1;
    if (auto found = plan->find_letters(dial, {.pivot = letter_pivot::centre}); !found)
        return std::puts(found.error().message()), 1;

    std::vector<vec3> vertices(plan->size().vertices);  // or mapped GPU memory
    std::vector<std::uint32_t> indices(plan->size().indices());
    const mesh_range dot = plan->range(plan->glyphs().size() - 1, part::front);
    const std::size_t before = allocations;
    for (int frame = 0; frame <= 60; ++frame) {
        if (!plan->write(into(std::span{vertices}, std::span{indices}), clock_motion{36610.0 + frame})) return 1;
        const auto some = std::span{vertices}.subspan(dot.first_vertex, dot.vertex_count);
        double x = 0.0, y = 0.0;
        for (const vec3 v : some) x += v.x, y += v.y;
        const auto count = static_cast<double>(some.size());
        if (frame % 15 == 5) std::printf("10:10:%02d: %+.2f %+.2f\n", (10 + frame) % 60, x / count, y / count);
    }
    std::printf("%zu allocations in 61 frames\n", allocations - before);
}
