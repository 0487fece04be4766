// SPDX-License-Identifier: MIT
//
// Every 40th glyph of the smoke fonts; tests/every_glyph/run.sh takes all of them, and more fonts.

#include "glyph_laws.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

TEST_CASE("every 40th glyph of the smoke fonts obeys all laws at every quality, also where its contours meet",
          "[every_glyph]")
{
    test::glyph_laws laws;
    std::size_t glyphs = 0, resolved = 0;
    for (const font_package& package : smoke_fonts()) {
        if (!package.required) continue;
        std::size_t in_package = 0;  // goes on from face to face, so that faces do not repeat each other
        for (const std::string& file : font_files(package)) {
            for (const test::face_instance& face : test::instances_of(file)) {
                auto font = face.open();
                REQUIRE(font);
                for (std::uint32_t g = 0; g < face.glyph_count; ++g) {
                    if (in_package++ % 40 != 0) continue;
                    for (const double tolerance :
                         {typemesh::quality::low, typemesh::quality::normal, typemesh::quality::high}) {
                        const test::glyph_findings f = laws.examine(*font, g, tolerance);
                        ++glyphs;
                        resolved += f.resolved;
                        if (f.wrong.empty()) continue;
                        INFO(file << "@" << face.face << ":" << g << " " << face.name() << " at " << tolerance);
                        CHECK(f.wrong == "");
                    }
                }
            }
        }
    }
    CHECK(glyphs > 10'000);
    CHECK(resolved > 1000);
}

TEST_CASE("glyphs with hairpins, soft joints and corners beside long walls obey all laws, from coarse to fine",
          "[every_glyph]")
{
    const struct {
        const char* file;
        typemesh::glyph_id glyph;
    } named[] = {{"truetype/dejavu/DejaVuSerif.ttf", 357},               // a corner, doubled, and 74 degrees off a wall
                 {"truetype/ancient-scripts/Symbola_hint.ttf", 8256},    // hairpins inside curves
                 {"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", 527},  // a rounded corner, 46 degrees
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
