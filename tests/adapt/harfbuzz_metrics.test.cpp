// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/adapt/harfbuzz.hpp>

#include <cmath>

using namespace typemesh;

TEST_CASE("bars and small letters are as the font's tables say, in em", "[harfbuzz]")
{
    const auto font = harfbuzz_font::open(font_file("truetype/liberation/LiberationSans-Regular.ttf").c_str());
    REQUIRE(font);
    const face_metrics found = font->suggested_metrics();
    CHECK(std::fabs(found.underline.top - -67.0 / 2048) < 1e-12);
    CHECK(std::fabs(found.underline.thickness - 150.0 / 2048) < 1e-12);
    CHECK(std::fabs(found.strike_through.top - 530.0 / 2048) < 1e-12);
    CHECK(std::fabs(found.superscript.size - 1331.0 / 2048) < 1e-12);
    CHECK(std::fabs(found.superscript.rise - 977.0 / 2048) < 1e-12);
    CHECK(std::fabs(found.subscript.rise - -283.0 / 2048) < 1e-12);

    // A font of another scale says the same, one without tables what suits most.
    hb_font_t* coarse = hb_font_create(hb_font_get_face(font->handle()));
    hb_font_set_scale(coarse, 512, 1024);
    CHECK(std::fabs(harfbuzz_font::wrap(coarse)->suggested_metrics().strike_through.top - 0.25879) < 1e-3);
    hb_font_destroy(coarse);
    hb_face_t* none = hb_face_create(hb_blob_get_empty(), 0);
    hb_font_t* empty = hb_font_create(none);
    hb_font_set_scale(empty, 1000, 1000);
    CHECK(harfbuzz_font::wrap(empty)->suggested_metrics().underline.thickness > 0.0);
    hb_font_destroy(empty);
    hb_face_destroy(none);
}

TEST_CASE("a ligature's carets are those of GDEF", "[harfbuzz]")
{
    const auto font = harfbuzz_font::open(font_file("opentype/fonts-hosny-amiri/Amiri-Regular.ttf").c_str());
    REQUIRE(font);
    hb_codepoint_t ffi = 0, a = 0;
    REQUIRE(hb_font_get_glyph_from_name(font->handle(), "f_f_i", -1, &ffi) != 0);
    REQUIRE(hb_font_get_glyph_from_name(font->handle(), "a", -1, &a) != 0);
    buffer<double> carets;
    REQUIRE_FALSE(font->ligature_carets(0, ffi, false, carets));
    REQUIRE(carets.size() == 2);
    CHECK(std::fabs(carets[0] - 269.0) < 1.0);
    CHECK(std::fabs(carets[1] - 537.0) < 1.0);
    REQUIRE_FALSE(font->ligature_carets(0, a, false, carets));
    CHECK(carets.size() == 2);
}
