// SPDX-License-Identifier: MIT
#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/laid_out.hpp"
#include "support/required.hpp"
#include "support/type1_mm_font.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

using test::dejavu;
using test::inter;
using test::microhei;
using test::shaped;

const char* const liberation = "truetype/liberation/LiberationSans-Regular.ttf";
const char* const comic = "opentype/comic-neue/ComicNeue-Regular.otf";
const char* const type1 = "X11/Type1/AharoniCLM-Book.pfa";  // with culmus of Debian 12 alone

freetype_font opened_face(const char* name, const font_options& options = {})
{
    return std::move(*test::required(freetype_font::open(font_file(name).c_str(), options)));
}

error refusal(freetype_font& font, text_view text, direction d = direction::automatic)
{
    glyph_run run;
    shape_options how;
    how.direction = d;
    return layout(font, text, how, {}, run).error();
}

outline drawn(freetype_font& font, glyph_id id)
{
    outline o;
    REQUIRE(record(font, id, o));
    return o;
}

std::vector<point> points_of(freetype_font& font, glyph_id id)
{
    std::vector<point> all;
    for (const curve& c : drawn(font, id).curves) all.insert(all.end(), c.p, c.p + c.degree + 1);
    return all;
}

/// A library and a face as a caller would hold them.
struct callers_face {
    FT_Library library = nullptr;
    FT_Face face = nullptr;

    explicit callers_face(const std::string& path)
    {
        REQUIRE(FT_Init_FreeType(&library) == 0);
        REQUIRE(FT_New_Face(library, path.c_str(), 0, &face) == 0);
    }
    callers_face(const callers_face&) = delete;
    callers_face& operator=(const callers_face&) = delete;
    ~callers_face()
    {
        FT_Done_Face(face);
        FT_Done_FreeType(library);
    }
};

}  // namespace

TEST_CASE("quadratics stay quadratics, cubics cubics", "[adapt][freetype]")
{
    freetype_font truetype = opened_face(dejavu), cff = opened_face(comic);
    const auto highest = [](freetype_font& font) {
        std::uint32_t degree = 0;
        for (const curve& c : drawn(font, shaped(font, "o").glyphs[0].id).curves)
            degree = degree > c.degree ? degree : c.degree;
        return degree;
    };
    CHECK(highest(truetype) == 2);
    CHECK(highest(cff) == 3);
    if (!has_font(type1)) return;
    freetype_font postscript = opened_face(type1);
    CHECK(postscript.units_per_em() == 1090.0);  // from its font matrix
    CHECK(highest(postscript) == 3);
}

TEST_CASE("plain text is set by character map, advances and kerning", "[adapt][freetype]")
{
    freetype_font font = opened_face(liberation);
    CHECK(font.units_per_em() == 2048.0);
    const glyph_run run = shaped(font, u8"Grüße, мир");
    REQUIRE(run.glyphs.size() == 10);
    CHECK(run.glyphs[2].cluster == 2);
    CHECK(run.glyphs[3].cluster == 4);
    CHECK(run.missing == 0);

    const double a = shaped(font, "A").lines[0].advance, v = shaped(font, "V").lines[0].advance;
    const glyph_run kerned = shaped(font, "AV");
    CHECK(kerned.lines[0].advance < a + v);
    CHECK(kerned.glyphs[1].origin.x < a);
    const feature off[] = {{"kern", 0}};
    shape_options how;
    how.features = off;
    CHECK(shaped(font, "AV", how).lines[0].advance == a + v);
    const feature off_and_on[] = {{"kern", 0}, {"kern", 1}};
    how.features = off_and_on;  // the last one counts
    CHECK(shaped(font, "AV", how).lines[0].advance == kerned.lines[0].advance);
}

TEST_CASE("a FreeType face kerns pairs in their order, across what is not drawn", "[adapt][freetype]")
{
    freetype_font font = opened_face(liberation);
    const auto length = [&font](text_view text) { return shaped(font, text).lines[0].advance; };
    CHECK(length("To") < length("T") + length("o"));
    CHECK(length("oT") == length("o") + length("T"));
    CHECK(length(u8"T\u00ADo") == length("To"));
}

TEST_CASE("each contour of a FreeType face is begun and closed once", "[adapt][freetype]")
{
    struct counter : ignore_outline {
        int moves = 0, closes = 0;
        void move(point) noexcept { CHECK(moves++ == closes); }
        void close() noexcept { ++closes; }
    };
    for (const char* name : {dejavu, comic, type1}) {
        if (!has_font(name)) continue;
        freetype_font font = opened_face(name);
        counter count;
        REQUIRE_FALSE(font.outline(shaped(font, "i").glyphs[0].id, count));
        CHECK(count.moves == 2);
        CHECK(count.closes == 2);
    }
}

TEST_CASE("letters of a FreeType face are spaced beside their kerning", "[adapt][freetype]")
{
    freetype_font font = opened_face(liberation);
    const glyph_run plain = shaped(font, "AVA");
    const glyph_run run = test::shaped(font, "AVA", {.letter_spacing = 0.125});
    for (std::size_t i = 0; i < 3; ++i)
        CHECK(run.glyphs[i].origin.x == plain.glyphs[i].origin.x + 256.0 * static_cast<double>(i));
    CHECK(run.lines[0].advance == plain.lines[0].advance + 512.0);
}

TEST_CASE("lines of a FreeType face stand as far apart as the font says", "[adapt][freetype]")
{
    freetype_font font = opened_face(dejavu);
    const line_metrics m = font.metrics(direction::automatic);
    CHECK(m.ascender == 1901.0);
    CHECK(m.descender == -483.0);
    CHECK(m.ascender - m.descender + m.gap == 2384.0);
    CHECK(shaped(font, "a\nb").lines[1].origin == point{0.0, -2384.0});
}

TEST_CASE("what the plain shaper would set wrongly it refuses, and names the place", "[adapt][freetype]")
{
    freetype_font font = opened_face(dejavu);
    const error e = refusal(font, u"ok\nab \u0633\u0644\u0627\u0645");
    CHECK(e == error::needs_shaping);
    CHECK(e.cluster == 6);
    for (const char16_t* text :
         {u"\u05D0", u"\u0915\u093F", u"\u0E01\u0E34", u"e\u0301", u"\u1112\u1161", u"\u200D", u"\u202E", u"\u1780"})
        CHECK(refusal(font, text) == error::needs_shaping);
    CHECK(refusal(font, "abc.", direction::right_to_left) == error::needs_shaping);
    CHECK(refusal(font, "abc", direction::top_to_bottom) == error::needs_shaping);
    CHECK(!refusal(font, "abc", direction::left_to_right));
}

TEST_CASE("missing and invalid characters are counted as by any shaper", "[adapt][freetype]")
{
    freetype_font font = opened_face(comic);
    const glyph_run run = shaped(font, u8"a世b\u00AD界");
    CHECK(run.missing == 2);
    CHECK(run.first_missing == 1);
    REQUIRE(run.glyphs.size() == 4);  // the soft hyphen is not drawn
    CHECK(run.glyphs[1].missing);
    CHECK(run.glyphs[1].id == 0);

    freetype_font wide = opened_face(dejavu);
    const glyph_run broken = shaped(wide, "a\xE2\x82z\xFF");
    CHECK(broken.invalid_units == 2);
    CHECK(broken.first_invalid_unit == 1);
    REQUIRE(broken.glyphs.size() == 4);
    CHECK(broken.glyphs[1].id == broken.glyphs[3].id);
    CHECK(broken.glyphs[3].cluster == 4);
}

TEST_CASE("varied outlines keep 1/64 unit", "[adapt][freetype]")
{
    const variation between[] = {{"wght", 603.0f}}, bold[] = {{"wght", 900.0f}}, beyond[] = {{"wght", 4000.0f}};
    freetype_font varied = opened_face(inter, {0, between}), plain = opened_face(inter),
                  heavy = opened_face(inter, {0, bold}), heaviest = opened_face(inter, {0, beyond});
    const glyph_id o = shaped(plain, "o").glyphs[0].id;
    bool fractions = false;
    for (const point p : points_of(varied, o)) fractions = fractions || p.x != std::floor(p.x);
    CHECK(fractions);
    CHECK(points_of(plain, o) != points_of(heavy, o));
    CHECK(points_of(heavy, o) == points_of(heaviest, o));
    CHECK(shaped(plain, "HAV").lines[0].advance < shaped(heavy, "HAV").lines[0].advance);

    const variation unknown[] = {{"abcd", 1.0f}}, infinite[] = {{"wght", std::numeric_limits<float>::infinity()}};
    CHECK(freetype_font::open(font_file(inter).c_str(), {0, unknown}).error() == error::unknown_variation);
    CHECK(freetype_font::open(font_file(inter).c_str(), {0, unknown}).error().count == error::no_axis("abcd").count);
    CHECK(freetype_font::open(font_file(dejavu).c_str(), {0, bold}).error() == error::unknown_variation);
    CHECK(freetype_font::open(font_file(inter).c_str(), {0, infinite}).error() == error::bad_option);
}

TEST_CASE("a font opens alike from its path, its bytes and the caller's library", "[adapt][freetype]")
{
    const auto bytes = bytes_of(font_file(comic));
    auto lent = test::required(freetype_font::open(bytes));
    freetype_font read = opened_face(comic);
    const callers_face other{font_file(dejavu)};
    auto shared = test::required(freetype_font::open(font_file(comic).c_str(), {}, other.library));
    for (glyph_id id = 0; id < read.glyph_count(); id += 7) {
        CHECK(points_of(*lent, id) == points_of(read, id));
        CHECK(points_of(*shared, id) == points_of(read, id));
    }
}

TEST_CASE("the caller's FT_Face keeps its size and transform, and has no part in the outlines", "[adapt][freetype]")
{
    const callers_face callers{font_file(dejavu)};
    REQUIRE(FT_Set_Pixel_Sizes(callers.face, 0, 13) == 0);
    FT_Matrix doubled{2 << 16, 0, 0, 2 << 16};
    FT_Set_Transform(callers.face, &doubled, nullptr);
    const FT_Size size = callers.face->size;
    freetype_font own = opened_face(dejavu);
    {
        auto wrapped = test::required(freetype_font::wrap(callers.face));
        CHECK(callers.face->size == size);
        CHECK(points_of(*wrapped, 36) == points_of(own, 36));
        CHECK(callers.face->size == size);
        CHECK(shaped(*wrapped, "AV").lines[0].advance == shaped(own, "AV").lines[0].advance);

        freetype_font moved = std::move(*wrapped);
        CHECK(points_of(moved, 37) == points_of(own, 37));
    }
    CHECK(callers.face->size == size);
    CHECK(callers.face->size->metrics.y_ppem == 13);
}

TEST_CASE("glyphs that do not exist are an error, blank ones are not", "[adapt][freetype]")
{
    freetype_font font = opened_face(dejavu);
    CHECK(points_of(font, shaped(font, " ").glyphs[0].id).empty());
    outline o;
    const error e = record(font, font.glyph_count(), o).error();
    CHECK(e == error::unknown_glyph);
    CHECK(e.glyph == font.glyph_count());
}

TEST_CASE("a FreeType face that does not open says why", "[adapt][freetype]")
{
    CHECK(freetype_font::open("/no/such/font.ttf").error() == error::unreadable_file);
    CHECK(freetype_font::open(TYPEMESH_TEST_DATA "/workload/README.md").error() == error::not_a_font);
    CHECK(freetype_font::open(std::span<const std::byte>{}).error() == error::not_a_font);
    const auto words = bytes_of(TYPEMESH_TEST_DATA "/workload/README.md");
    CHECK(freetype_font::open(words).error() == error::not_a_font);
    const error face = freetype_font::open(font_file(microhei).c_str(), {2, {}}).error();
    CHECK(face == error::no_such_face);
    CHECK(face.count == 2);
    CHECK(freetype_font::open(font_file(microhei).c_str(), {1, {}}));
    CHECK(freetype_font::open(font_file(dejavu).c_str(), {65536, {}}).error() == error::no_such_face);
    CHECK(freetype_font::open(font_file("../wine/fonts/courier.ttf").c_str()).error() == error::no_outlines);
    CHECK(freetype_font::open(font_file("../wine/fonts/coure.fon").c_str()).error() == error::no_outlines);
    if (has_font(type1)) CHECK(freetype_font::open(font_file(type1).c_str(), {3, {}}).error() == error::no_such_face);
}

TEST_CASE("FreeType: a Type 1 Multiple Master font is opened with the font's own shares of its masters",
          "[adapt][freetype]")
{
    const struct {
        const char* vector;
        double shares[4];
    } fonts[] = {{"0.12 0.18 0.28 0.42", {0.12, 0.18, 0.28, 0.42}},          // what weight 0.6 and width 0.7 give
                 {"0.1 0.2 0.3 0.4", {0.1, 0.2, 0.3, 0.4}},                  // what no weight and width give
                 {"0.375 0.125 0.125 0.375", {0.375, 0.125, 0.125, 0.375}},  // nor these, in the middle of both axes
                 {"0 0 0 1", {0, 0, 0, 1}}};
    const double widths[] = {100.0, 400.0, 600.0, 1100.0};
    const auto width_of = [](freetype_font& font) {
        outline o;
        REQUIRE(record(font, 1, o));
        CHECK(o.bounds.height() == Catch::Approx(700.0).margin(1.0));
        return o.bounds.width();
    };
    for (const auto& f : fonts) {
        INFO(f.vector);
        const auto bytes = test::type1_mm_font(f.vector);
        auto own = test::required(freetype_font::open(bytes));
        double expected = 0.0;
        for (int i = 0; i < 4; ++i) expected += f.shares[i] * widths[i];
        CHECK(width_of(*own) == Catch::Approx(expected).margin(1.0));

        // One axis set: the other stays at its design default, which is what the shares come closest to.
        const double wide = f.shares[2] + f.shares[3];
        const variation bold[] = {{"wght", 800.0f}};
        auto set = test::required(freetype_font::open(bytes, {0, bold}));
        CHECK(width_of(*set) == Catch::Approx((1.0 - wide) * widths[1] + wide * widths[3]).margin(1.0));

        // Fonts that draw differently are told apart by a cache, alike as their axes may stand.
        const variation same_axes[] = {{"wght", static_cast<float>(200.0 + 600.0 * (f.shares[1] + f.shares[3]))},
                                       {"wdth", static_cast<float>(50.0 + 100.0 * wide)}};
        auto alike = test::required(freetype_font::open(bytes, {0, same_axes}));
        if (std::abs(width_of(*alike) - width_of(*own)) > 1.5) CHECK(alike->variation_key() != own->variation_key());
        CHECK(test::required(freetype_font::open(bytes))->variation_key() == own->variation_key());
    }
}
