// SPDX-License-Identifier: MIT
//
// Every 40th glyph of the smoke fonts; tests/every_glyph/run.sh takes all of them, and more fonts.

#include "glyph_laws.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/smoke_glyphs.hpp"

#include <string>

TEST_CASE("every 40th glyph of the smoke fonts obeys all laws at every quality", "[every_glyph]")
{
    test::glyph_laws laws;
    std::size_t glyphs = 0, resolved = 0;
    test::each_smoke_glyph(40, [&](auto& font, typemesh::glyph_id g, const std::string& name) {
        for (const double tolerance : {typemesh::quality::low, typemesh::quality::normal, typemesh::quality::high}) {
            const test::glyph_findings f = laws.examine(font, g, tolerance);
            ++glyphs;
            resolved += f.resolved;
            if (f.wrong.empty()) continue;
            INFO(name << " at " << tolerance);
            CHECK(f.wrong == "");
        }
    });
    CHECK(glyphs > 10'000);
    CHECK(resolved > 1000);
}

TEST_CASE("glyphs with hairpins, soft joints and corners beside long walls obey all laws", "[every_glyph]")
{
    const struct {
        const char* file;
        typemesh::glyph_id glyph;
    } named[] = {{"truetype/dejavu/DejaVuSerif.ttf", 357},                 // a doubled corner, 74 degrees off a wall
                 {"truetype/ancient-scripts/Symbola_hint.ttf", 8256},      // hairpins inside curves
                 {"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", 527},    // a rounded corner, 46 degrees
                 {"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", 4659}};  // a soft joint
    test::glyph_laws laws;
    for (const auto& [file, glyph] : named) {
        auto font = typemesh::harfbuzz_font::open(font_file(file).c_str());
        REQUIRE(font);
        for (const double tolerance :
             {0.01, typemesh::quality::normal, typemesh::quality::high, typemesh::quality::best}) {
            INFO(file << " " << glyph << " at " << tolerance);
            CHECK(laws.examine(*font, glyph, tolerance).wrong == "");
        }
    }
}
