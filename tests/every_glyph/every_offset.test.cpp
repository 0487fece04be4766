// SPDX-License-Identifier: MIT
//
// A slice of the smoke fonts swept inwards; the program every_offset takes all of their glyphs.

#include "glyph_laws.hpp"
#include "offset_laws.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

TEST_CASE("every 1600th glyph of the smoke fonts can be swept inwards at every width", "[every_glyph][offset]")
{
    test::offset_laws laws;
    std::size_t sweeps = 0, refused = 0;
    for (const font_package& package : smoke_fonts()) {
        if (!package.required) continue;
        std::size_t in_package = 0;  // goes on from face to face, so that faces do not repeat each other
        for (const std::string& file : font_files(package)) {
            for (const test::face_instance& face : test::instances_of(file)) {
                auto font = face.open();
                REQUIRE(font);
                for (std::uint32_t g = 0; g < face.glyph_count; ++g) {
                    if (in_package++ % 1600 != 0) continue;
                    const auto f = laws.examine(*font, g, typemesh::quality::high, false);
                    sweeps += f.sweeps;
                    refused += f.refused;
                    if (f.wrong.empty()) continue;
                    INFO(file << "@" << face.face << ":" << g << " " << face.name());
                    CHECK(f.wrong == "");
                }
            }
        }
    }
    CHECK(sweeps > 1'000);
    CHECK(refused == 0);
}

TEST_CASE("letters swept inwards are where the slow wavefront is", "[every_glyph][offset]")
{
    test::offset_laws laws;
    for (const char* file : {"truetype/liberation/LiberationSerif-Regular.ttf", "truetype/dejavu/DejaVuSans.ttf"}) {
        auto font = typemesh::harfbuzz_font::open(font_file(file).c_str());
        REQUIRE(font);
        for (std::uint32_t g = 36; g < 92; g += 7) {
            INFO(file << ", glyph " << g);
            const auto f = laws.examine(*font, g, typemesh::quality::high, true);
            CHECK(f.wrong == "");
            CHECK(f.refused == 0);
            CHECK(f.farthest_off_plane < 2.0);
        }
    }
}
