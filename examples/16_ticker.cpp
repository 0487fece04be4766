// SPDX-License-Identifier: MIT
//
// A ticker: messages run through a window from right to left, and their letters rise at its right end and sink at its left
// end. Each message is planned once. After the first round of messages neither a frame nor a plan allocates.
//
//     16_ticker FONT MESSAGE...

#include "counted_allocations.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <vector>

using namespace typemesh;

/// Letters go to the left. Outside the window they are hidden; near its ends they are small.
struct running {
    float gone;    // since the message began at the window's right end
    float window;  // its width

    affine3 operator()(const letter_place& l) const noexcept
    {
        const float x = l.letter.pivot.x + window - gone;
        const float inside = std::min(x, window - x);
        if (!(inside > 0.0f)) return hidden_at(l.letter.pivot);
        affine3 map;
        if (inside < 1.0f) map = scaled(inside);
        map.origin.x = window - gone;
        return map.about(l.letter.pivot);
    }
};

int main(int argc, char** argv)
{
    if (argc < 3) return std::puts("usage: 16_ticker FONT MESSAGE..."), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    text_mesher mesher{*font};
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (int round = 1; round <= 2; ++round) {
        const std::size_t before = allocations;
        int frames = 0;
        for (int message = 2; message < argc; ++message) {
            auto plan = mesher.plan(argv[message]);
            if (!plan) return std::puts(plan.error().message()), 1;
            if (auto found = plan->find_letters(argv[message]); !found) return std::puts(found.error().message()), 1;
            constexpr float window = 8.0f, step = 0.1f;
            const float all = plan->bounds().high.x + window;
            float widest = 0.0f;
            for (float gone = 0.0f; gone < all; gone += step, ++frames) {
                if (!plan->write(into(vertices, indices), running{gone, window})) return 1;
                float left = window, right = 0.0f;
                for (const vec3 v : vertices)
                    if (v.x > 0.0f && v.x < window) left = std::min(left, v.x), right = std::max(right, v.x);
                widest = std::max(widest, right - left);
            }
            if (round == 1) std::printf("%s: up to %.1f wide\n", argv[message], static_cast<double>(widest));
        }
        std::printf("round %d: %zu allocations in %d frames\n", round, allocations - before, frames);
    }
}
