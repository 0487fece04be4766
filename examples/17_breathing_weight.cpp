// SPDX-License-Identifier: MIT
//
// A word whose weight breathes: its mesh is planned once, then each frame writes it at another weight. The triangles stay
// the same, and a frame allocates nothing.
//
//     17_breathing_weight FONT [TEXT]      a variable font with a weight axis

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/vertex/array_sink.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <vector>

using namespace typemesh;

int main(int argc, char** argv)
{
    if (argc < 2) return std::puts("usage: 17_breathing_weight FONT [TEXT]"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;
    auto weight = harfbuzz_axis::open(*font, "wght");
    if (!weight) return std::puts(weight.error().message()), 1;

    axis_morph morph{*weight};
    auto plan = morph.plan(argc > 2 ? argv[2] : "breathe", {.depth = 0.1f});
    if (!plan) return std::puts(plan.error().message()), 1;
    const morph_report& report = plan->report();
    std::printf("%u letters, %u refused; %zu sections\n", report.letters, report.refused, plan->section_count());

    std::vector<vec3> vertices;  // or mapped GPU memory
    std::vector<std::uint32_t> indices;
    for (int frame = 0; frame <= 60; ++frame) {
        const double breath = 0.5 - 0.5 * std::cos(frame / 60.0 * 6.283185307179586);
        const double value = weight->low() + breath * (weight->high() - weight->low());
        const axis_coordinate at = weight->coordinate(value);
        const mesh_size size = plan->size(plan->section_at(at));
        vertices.resize(size.vertices);
        indices.resize(size.indices());
        if (!plan->write_at(at, into(std::span{vertices}, std::span{indices}))) return 1;
        if (frame % 15 != 0) continue;
        float right = 0.0f;
        for (const vec3& v : vertices) right = v.x > right ? v.x : right;
        std::printf("frame %d: weight %.0f, %zu triangles, %.3f em wide\n", frame, value, indices.size() / 3,
                    static_cast<double>(right));
    }
}
