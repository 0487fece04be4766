// SPDX-License-Identifier: MIT
//
// Some glyphs at some places; the program every_morph takes all.

#include "morph_laws.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <algorithm>

TEST_CASE("morphs of glyphs are the font's own instances, along its weight and its slant", "[every_glyph][morph]")
{
    for (const auto& [tag, step] : {std::pair{"wght", std::size_t{61}}, std::pair{"slnt", std::size_t{97}}}) {
        char axis[5] = {};
        std::copy_n(tag, 4, axis);
        test::morph_laws laws{font_file("truetype/inter-vf/Inter.var.ttf"), axis, 5};
        const auto glyphs = test::mapped_glyphs(laws.font());
        for (std::size_t i = 7; i < glyphs.size(); i += step) laws.examine(glyphs[i]);
        const test::morph_findings& f = laws.found();
        INFO(tag);
        CHECK(f.wrong == "");
        CHECK(f.glyphs > 20);
        CHECK(f.whole > f.glyphs / 3);
        CHECK(f.refused + f.partly_refused <= 1);
        CHECK(f.turned == 0);
        CHECK(f.places > 4 * f.glyphs);
    }
}
