// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <set>

using namespace typemesh;

TEMPLATE_TEST_CASE("a font's variation key tells its file, its face and its axes", "[adapt]", harfbuzz_font,
                   freetype_font)
{
    const std::string inter = font_file("truetype/inter-vf/Inter.var.ttf");
    const auto key = [&](float weight, std::uint32_t face = 0, const char* file = nullptr) {
        const variation axis[] = {{"wght", weight}};
        const auto font = TestType::open(file != nullptr ? file : inter.c_str(),
                                         {.face = face, .variations = std::span{axis, file == nullptr ? 1u : 0u}});
        REQUIRE(font);
        return font->variation_key();
    };
    std::set<std::uint64_t> keys;
    for (const float weight : {100.0f, 200.0f, 400.0f, 650.0f, 700.0f, 900.0f}) {
        CHECK(keys.insert(key(weight)).second);
        CHECK(key(weight) == key(weight));
    }
    const std::string collection = font_file("truetype/wqy/wqy-microhei.ttc");
    CHECK(key(0, 0, collection.c_str()) != key(0, 1, collection.c_str()));

    std::set<std::uint64_t> files;  // a number that the caller gives twice by mistake does no harm
    for (const char* file :
         {"truetype/dejavu/DejaVuSans.ttf", "truetype/dejavu/DejaVuSans-Bold.ttf",
          "truetype/liberation/LiberationSans-Regular.ttf", "truetype/liberation/LiberationSans-Bold.ttf",
          "opentype/comic-neue/ComicNeue-Regular.otf"})
        CHECK(files.insert(key(0, 0, font_file(file).c_str())).second);
}

TEST_CASE("weights and slants of one font share a cache without sharing a glyph", "[adapt]")
{
    glyph_cache cache;
    const auto built = [&](float weight, double slant, bool cached) {
        const variation axis[] = {{"wght", weight}};
        auto font = harfbuzz_font::open(font_file("truetype/inter-vf/Inter.var.ttf").c_str(), {.variations = axis});
        REQUIRE(font);
        transformed_outlines drawn{*font, affine{.xy = slant}};
        shaped_by both{*font, drawn};
        test::full_mesh m;
        if (cached)
            REQUIRE(text_mesher{both}.with(cached_in{cache, 1}).build("age", into(m.vertices, m.indices)));
        else
            REQUIRE(text_mesher{both}.build("age", into(m.vertices, m.indices)));
        return m;
    };
    for (int i = 0; i < 2; ++i) {
        for (const float weight : {400.0f, 800.0f}) {
            for (const double slant : {0.0, 0.2}) {
                const auto a = built(weight, slant, true), b = built(weight, slant, false);
                REQUIRE(a.indices == b.indices);
                for (std::size_t k = 0; k < a.vertices.size(); ++k)
                    REQUIRE(a.vertices[k].position == b.vertices[k].position);
            }
        }
    }
    CHECK(cache.statistics().misses == 12);
    CHECK(cache.statistics().hits == 12);
}
