// SPDX-License-Identifier: MIT
//
// A word with bevels of a profile of your own, in five parts, and which of its letters got narrower ones.
//
//     10_bevelled_word FONT

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <cstdio>
#include <vector>

struct vertex {
    float position[3], normal[3];
};
template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal;
    vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}};
    }
};

int main(int argc, char** argv)
{
    using namespace typemesh;
    if (argc < 2) return std::puts("usage: 10_bevelled_word FONT"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    // fit: where a letter would lose a cap, its bevels become narrower. clip, the default, closes them in a ridge.
    const bevelled bevels{.width = 0.06f,
                          .bevel_depth = 0.03f,
                          .mode = bevel_mode::fit,
                          .profile = sampled_profile([](float t) noexcept { return t * t * (3 - 2 * t); }, 8)};  // an S
    auto mesher = text_mesher{*font}.with(bevels);
    auto plan = mesher.plan("Bevelled", {.merge = true});
    if (!plan) return std::puts(plan.error().message()), 1;

    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    if (const auto written = plan->write(into(vertices, indices)); !written)
        return std::puts(written.error().message()), 1;
    const char* const names[] = {"front", "back", "side", "front bevel", "back bevel"};
    for (const part p : {part::front, part::back, part::side, part::front_bevel, part::back_bevel})
        std::printf("%11s: %u indices\n", names[static_cast<int>(p)], plan->range(p).index_count);

    for (const drawn_glyph& glyph : plan->glyphs()) {
        const float width = bevels.width_of(glyph.built->planned<bevelled>().form);
        std::printf("the letter at character %u has bevels %.4f em wide%s\n", glyph.cluster, static_cast<double>(width),
                    glyph.built->is_narrowed() ? ", because wider bevels were refused" : "");
    }
}
