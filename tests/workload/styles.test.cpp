// SPDX-License-Identifier: MIT
//
// Styles given at random to texts of two directions, in real fonts.

#include "opened_font.hpp"
#include "support/executors.hpp"
#include "support/font_file.hpp"
#include "support/style_laws.hpp"

#include <typemesh/text/font_faces.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

std::string amiri() { return font_file("opentype/fonts-hosny-amiri/Amiri-Regular.ttf"); }

}  // namespace

TEST_CASE("styles only reorder glyphs of lines of both directions, whether merged, in chunks or by workers",
          "[workload]")
{
    auto font = test::opened(amiri());
    text_mesher mesher{font}, other{font};
    test::scrambled_workers several{3};
    auto pool = workers_of(several, [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); });
    REQUIRE(pool);
    glyph_run run;
    const char* text = "الخط العربي\nHello world, WAVE\nمرحبا بالعالم";
    REQUIRE(layout(font, text, {.letter_spacing = -0.03}, {.align = alignment::centre}, run));
    for (std::uint32_t seed = 1; seed <= 2; ++seed)
        test::check_styles(mesher, other, *pool, run, {.tolerance = quality::normal}, seed);
}

TEST_CASE("a line of two fonts has the same meshes as each font by itself", "[workload]")
{
    auto latin = test::opened(font_file("truetype/dejavu/DejaVuSans.ttf"));
    auto arabic = test::opened(amiri());
    REQUIRE(latin.units_per_em() != arabic.units_per_em());
    glyph_run first, second, both;
    REQUIRE(layout(latin, "Two fonts", {}, {}, first));
    REQUIRE(layout(arabic, "خطان", {}, {}, second));
    const double scale = latin.units_per_em() / arabic.units_per_em();
    const auto other_face = both.number_of({.face = 1});
    REQUIRE(other_face);
    for (const placed_glyph& g : first.glyphs) REQUIRE(both.glyphs.push_back(g));
    for (placed_glyph g : second.glyphs) {
        g.origin = scale * g.origin + point{0.0, -3000.0};
        g.glyph_style = *other_face;
        REQUIRE(both.glyphs.push_back(g));
    }
    font_faces faces{latin, arabic};
    text_mesher mesher{faces};
    text_mesher latin_mesher{latin}, arabic_mesher{arabic};
    const auto plan = mesher.plan(both);
    const auto of_latin = latin_mesher.plan(first), of_arabic = arabic_mesher.plan(second);
    REQUIRE(plan);
    REQUIRE(of_latin);
    REQUIRE(of_arabic);
    CHECK(plan->report().complete());
    const std::size_t letters = of_latin->glyphs().size();
    REQUIRE(plan->glyphs().size() == letters + of_arabic->glyphs().size());
    for (const part p : all_parts) {
        CHECK(plan->range(glyph_span{0, letters}, p).vertex_count == of_latin->range(p).vertex_count);
        // Another grid, to which curves are snapped otherwise: the same shapes, but for half a cell.
        for (std::size_t g = 0; g < of_arabic->glyphs().size(); ++g) {
            const box one = text_glyphs::ink_of(plan->glyphs()[letters + g]),
                      two = text_glyphs::ink_of(of_arabic->glyphs()[g]);
            CHECK(one.width() == Catch::Approx(scale * two.width()).margin(0.01));
            CHECK(one.height() == Catch::Approx(scale * two.height()).margin(0.01));
        }
    }
}
