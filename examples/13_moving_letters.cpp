// SPDX-License-Identifier: MIT
//
// A score whose digits roll: the letters of a text are planned once, then each frame writes them with a motion. A frame
// allocates nothing.
//
//     13_moving_letters FONT [TEXT]

#include "counted_allocations.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

using namespace typemesh;

/// Digits roll in around the line's axis, one after another; nothing else moves.
struct roll {
    double time;  // from 0 to 1

    affine3 operator()(const letter_place& l) const noexcept
    {
        const double arrived = progress_of(turn_of(letter_order::forward, l.index, l.whole.count), time);
        if (arrived >= 1.0) return {};
        return turned(l.frame.right, (1.0 - arrived) * 6.283185307179586).about(l.letter.pivot);
    }
};

int main(int argc, char** argv)
{
    if (argc < 2) return std::puts("usage: 13_moving_letters FONT [TEXT]"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    const text_view text = argc > 2 ? argv[2] : "2 : 1";

    text_mesher mesher{*font};
    auto plan = mesher.plan(text);
    if (!plan) return std::puts(plan.error().message()), 1;
    if (auto found = plan->find_letters(text, {.pivot = letter_pivot::line}); !found)
        return std::puts(found.error().message()), 1;
    std::printf("%zu letters, %zu words\n", plan->letters().letters.size(), plan->letters().words.size());

    std::vector<vec3> vertices(plan->size().vertices);  // or mapped GPU memory
    std::vector<std::uint32_t> indices(plan->size().indices());
    const std::size_t before = allocations;
    for (int frame = 0; frame <= 60; ++frame) {
        const roll motion{frame / 60.0};
        if (!plan->write(into(std::span{vertices}, std::span{indices}), motion)) return 1;
        if (frame % 20 != 0) continue;
        const bounds3 box = plan->moved_bounds(motion);
        std::printf("frame %d: height %.3f\n", frame, static_cast<double>(box.high.y - box.low.y));
    }
    std::printf("%zu allocations in 61 frames\n", allocations - before);
}
