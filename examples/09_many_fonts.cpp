// SPDX-License-Identifier: MIT
//
// A text in several scripts: each font draws what the fonts before it lack. It prints which font draws what.
//
//     09_many_fonts TEXT FONT [FONT...]

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/font_list.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <deque>
#include <utility>

int main(int argc, char** argv)
{
    using namespace typemesh;
    if (argc < 3) return std::puts("usage: 09_many_fonts TEXT FONT [FONT...]"), 2;

    std::deque<harfbuzz_font> opened;  // where they stay; their number is known only now, else a font_cascade would do
    for (int i = 2; i < argc; ++i) {
        auto font = harfbuzz_font::open(argv[i]);
        if (!font) return std::printf("%s: %s\n", argv[i], font.error().message()), 1;
        opened.push_back(std::move(*font));
    }
    font_list fonts{opened.front()};
    for (std::size_t i = 1; i < opened.size(); ++i)
        if (const auto face = fonts.add(opened[i]); !face) return std::puts(face.error().message()), 1;

    text_mesher mesher{fonts};
    auto plan = mesher.plan(argv[1]);
    if (!plan) return std::puts(plan.error().message()), 1;
    for (const placed_glyph& g : plan->run().glyphs) {
        const std::uint32_t face = plan->run().glyph_styles.empty() ? 0 : plan->run().glyph_styles[g.glyph_style].face;
        std::printf("byte %3u  glyph %5u of %s%s\n", g.cluster, g.id, argv[2 + face], g.missing ? ", missing" : "");
    }
    std::printf("%llu triangles\n", static_cast<unsigned long long>(plan->size().triangles));
}
