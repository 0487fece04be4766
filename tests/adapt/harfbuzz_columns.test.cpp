// SPDX-License-Identifier: MIT
//
// Columns through HarfBuzz: what lies on its side is held against lines, what is upright against HarfBuzz's own columns.

#include "adapt/opened_font.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/laid_out.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/text/text_mesher.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

namespace column_fonts {

using test::dejavu;
using test::opened;
using test::sawarabi;

const char* const mplus = "opentype/mplus/Mplus1-Regular.otf";  // with a BASE table; not everywhere

glyph_run set(harfbuzz_font& font, text_view text, direction flow, const column_options& columns = {})
{
    shape_options how{.direction = flow};
    how.columns = columns;
    return test::shaped(font, text, how);
}

affine map_of(const glyph_run& run, const placed_glyph& g)
{
    return run.glyph_styles.empty() ? affine{} : run.glyph_styles[g.glyph_style].map;
}

}  // namespace column_fonts
using namespace column_fonts;

}  // namespace

TEST_CASE("letters on their side stand as in a line that is turned, kerning and ligatures kept",
          "[adapt][harfbuzz][columns]")
{
    struct sample {
        const char* font;
        std::u16string text;
    };
    const sample all[] = {
        {dejavu, u"AVATAR office, To Ve. 12"},
        {mplus, u"AVATAR, To (Ve)."},
        {dejavu, u"\u05E9\u05DC\u05D5\u05DD 12 abc"},
        {"opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
         u"\u0628\u0650\u0633\u0652\u0645\u0650 \u0627\u0644\u0644\u0651\u0647"},
        {"truetype/lohit-devanagari/Lohit-Devanagari.ttf", u"\u0915\u094D\u0937\u093F\u0924\u093F"},
    };
    for (const sample& s : all) {
        if (!has_font(s.font)) continue;
        harfbuzz_font font = opened(s.font);
        const glyph_run line = set(font, s.text, direction::automatic);
        const glyph_run column = set(font, s.text, direction::top_to_bottom);
        REQUIRE(line.glyphs.size() == column.glyphs.size());
        CHECK(column.lines[0].advance == Approx(line.lines[0].advance).epsilon(1e-12));
        for (std::size_t i = 0; i < line.glyphs.size(); ++i) {
            const placed_glyph &along = line.glyphs[i], &down = column.glyphs[i];
            CHECK(down.id == along.id);
            CHECK(down.cluster == along.cluster);
            CHECK(length(down.origin - quarter_turn(along.origin - point{0.0, font.column_middle()})) < 1e-9);
            CHECK(map_of(column, down) == quarter_turn);
        }
    }
}

TEST_CASE("upright glyphs are those of HarfBuzz's columns, with its vertical forms", "[adapt][harfbuzz][columns]")
{
    for (const char* const name : {sawarabi, mplus}) {
        if (!has_font(name)) continue;
        harfbuzz_font font = opened(name);
        const std::u16string text =
            u"\u3053\u3093\u306B\u3061\u306F\u3001\u300C\u4E16\u754C\u300D\u30B3\u30FC\u30C9\u3002";
        const glyph_run run = set(font, text, direction::top_to_bottom);
        hb_buffer_t* b = hb_buffer_create();
        const void* units = text.data();
        hb_buffer_add_utf16(b, static_cast<const std::uint16_t*>(units), static_cast<int>(text.size()), 0, -1);
        hb_buffer_set_direction(b, HB_DIRECTION_TTB);
        hb_buffer_set_script(b, HB_SCRIPT_HIRAGANA);
        hb_shape(font.handle(), b, nullptr, 0);
        unsigned count = 0;
        const hb_glyph_info_t* info = hb_buffer_get_glyph_infos(b, &count);
        const hb_glyph_position_t* position = hb_buffer_get_glyph_positions(b, nullptr);
        REQUIRE(count == run.glyphs.size());
        point pen;
        for (unsigned i = 0; i < count; ++i) {
            CHECK(run.glyphs[i].id == info[i].codepoint);
            CHECK(map_of(run, run.glyphs[i]) == affine{});
            const point offset{position[i].x_offset / 64.0, position[i].y_offset / 64.0};
            CHECK(length(run.glyphs[i].origin - pen - offset) < 1e-9);
            pen.y += position[i].y_advance / 64.0;
        }
        hb_buffer_destroy(b);
        const glyph_run line = set(font, text, direction::automatic);
        for (const std::size_t changed : {5u, 6u, 9u, 11u, 13u})
            CHECK(run.glyphs[changed].id != line.glyphs[changed].id);
    }
}

TEST_CASE("a font says which characters it has a vertical form of", "[adapt][harfbuzz][columns]")
{
    harfbuzz_font japanese = opened(sawarabi), latin = opened(dejavu);
    for (const char32_t c : {U'\u30FC', U'\u300C', U'\u3001', U'\u301C'}) CHECK(japanese.has_vertical_form(c));
    for (const char32_t c : {U'\u4E00', U'A', U'\U0010FFFF'}) CHECK_FALSE(japanese.has_vertical_form(c));
    for (const char32_t c : {U'\u2329', U'A', U'\u30FC'}) CHECK_FALSE(latin.has_vertical_form(c));
    // U+2329, which is Tr and of which DejaVu Sans has no such form, lies on its side.
    const glyph_run run = set(latin, u"\u2329", direction::top_to_bottom);
    CHECK(map_of(run, run.glyphs[0]) == quarter_turn);
}

TEST_CASE("stretches of a column follow each other without a gap", "[adapt][harfbuzz][columns]")
{
    for (const char* const name : {sawarabi, mplus}) {
        if (!has_font(name)) continue;
        harfbuzz_font font = opened(name);
        const std::u16string parts[] = {u"\u65E5\u672C", u"AVATAR ", u"\u8A9E\u3001", u"To 2024", u"\u5E74"};
        std::u16string text;
        double length = 0.0;
        std::vector<glyph_run> runs;
        std::vector<double> lengths;  // with white space at the end, which hangs
        const double em = set(font, u"\u4E00", direction::top_to_bottom).lines[0].advance;
        for (const std::u16string& part : parts) {
            runs.push_back(set(font, part, direction::top_to_bottom));
            lengths.push_back(set(font, part + u"\u4E00", direction::top_to_bottom).lines[0].advance - em);
            text.append(part);
        }
        const glyph_run all = set(font, text, direction::top_to_bottom);
        std::size_t i = 0;
        for (const glyph_run& run : runs) {
            for (const placed_glyph& g : run.glyphs) {
                REQUIRE(i < all.glyphs.size());
                CHECK(all.glyphs[i].id == g.id);
                CHECK(typemesh::length(all.glyphs[i].origin - g.origin - point{0.0, 0.0 - length}) < 1e-9);
                CHECK(map_of(all, all.glyphs[i]) == map_of(run, g));
                ++i;
            }
            length += lengths[static_cast<std::size_t>(&run - runs.data())];
        }
        CHECK(i == all.glyphs.size());
        CHECK(all.lines[0].advance == Approx(length).epsilon(1e-12));
    }
}

TEST_CASE("a combined number is drawn within its em", "[adapt][harfbuzz][columns]")
{
    for (const char* const name : {sawarabi, mplus, dejavu})
        for (const char* const text : {"1", "12", "888", "2024"}) {
            if (!has_font(name)) continue;
            harfbuzz_font font = opened(name);
            const double em = font.units_per_em();
            const glyph_run run = set(font, text, direction::top_to_bottom, {.combined_digits = 4});
            CHECK(run.lines[0].advance == em);
            box ink;
            for (const placed_glyph& g : run.glyphs) {
                outline o;
                REQUIRE(record(font, g.id, o));
                REQUIRE_FALSE(map_outline(map_of(run, g), o));
                ink.add(g.origin + o.bounds.low);
                ink.add(g.origin + o.bounds.high);
            }
            CHECK(ink.low.x >= -0.5 * em);
            CHECK(ink.high.x <= 0.5 * em);
            CHECK(ink.low.y >= 0.0 - em);
            CHECK(ink.high.y <= 0.0);
            CHECK(std::fabs(ink.low.x + ink.high.x) < 0.2 * em);
        }
}

TEST_CASE("a gap between combined digits reaches layout(), fallbacks and paragraphs alike",
          "[adapt][harfbuzz][columns]")
{
    if (!has_font(mplus)) return;
    harfbuzz_font font = opened(mplus);
    const double em = font.units_per_em();
    shape_options how{.direction = direction::top_to_bottom};
    how.columns = {.combined_digits = 2, .combined_gap = 0.06};
    const auto distance = [](const glyph_run& run) { return run.glyphs[1].origin.x - run.glyphs[0].origin.x; };
    const glyph_run run = set(font, "88", how.direction, how.columns);
    const double squeeze = map_of(run, run.glyphs[0]).xx;
    buffer<shaped_glyph> digit;
    REQUIRE_FALSE(font.shape("8", {.last = 1}, {}, digit));
    CHECK(squeeze * 2 * digit[0].advance + 0.06 * em == Approx(em));
    CHECK(distance(run) == Approx(squeeze * digit[0].advance + 0.06 * em));
    paragraph words{font};
    const glyph_run laid = test::laid_out(words, "88", how);
    CHECK(distance(laid) == Approx(distance(run)));
    harfbuzz_font other = opened(dejavu);
    font_cascade both{other, font};
    glyph_run filled;  // U+65E5 is the second font's, so that the first one's own shape() does not do
    REQUIRE(layout(both, u"88\u65E5", how, {}, filled));
    const glyph_run alone = set(other, "88", how.direction, how.columns);
    CHECK(distance(filled) == Approx(distance(alone)));
}

TEST_CASE("a turned letter's outline is the letter's, turned exactly", "[adapt][harfbuzz][columns]")
{
    harfbuzz_font font = opened(dejavu);
    const glyph_run run = set(font, "g", direction::top_to_bottom);
    const affine map = map_of(run, run.glyphs[0]);
    outline plain, turned;
    REQUIRE(record(font, run.glyphs[0].id, plain));
    mapped_face face{font, 0, &map, font.units_per_em()};
    REQUIRE(record(face, run.glyphs[0].id, turned));
    REQUIRE(plain.curves.size() == turned.curves.size());
    for (std::size_t i = 0; i < plain.curves.size(); ++i)
        for (std::uint32_t k = 0; k <= plain.curves[i].degree; ++k)
            CHECK(turned.curves[i].p[k] == quarter_turn(plain.curves[i].p[k]));
}

TEST_CASE("paragraphs without a width set columns as layout() does", "[adapt][harfbuzz][columns][paragraph]")
{
    const std::u16string text =
        u"\u65E5\u672C\u3067AVATAR office\u3002\u30B3\u30FC\u30C9 "
        u"12\u6708\u300C\u05E9\u05DC\u05D5\u05DD\u300D\n2024\u5E74";
    for (const char* const name : {sawarabi, mplus})
        for (const bool upright : {false, true})
            for (const std::uint8_t digits : {std::uint8_t{0}, std::uint8_t{2}}) {
                if (!has_font(name)) continue;
                harfbuzz_font font = opened(name);
                shape_options how{.direction = direction::top_to_bottom};
                how.columns = {upright ? column_latin::upright : column_latin::sideways, digits};
                glyph_run laid, run;
                REQUIRE(layout(font, text, how, {}, run));
                paragraph words{font};
                REQUIRE(words.set(text, how));
                REQUIRE(words.lay_out({}, laid));
                REQUIRE(run.glyphs.size() == laid.glyphs.size());
                for (std::size_t i = 0; i < run.glyphs.size(); ++i) {
                    CHECK(run.glyphs[i].id == laid.glyphs[i].id);
                    CHECK(run.glyphs[i].cluster == laid.glyphs[i].cluster);
                    CHECK(length(run.glyphs[i].origin - laid.glyphs[i].origin) < 1e-9);
                    CHECK(map_of(run, run.glyphs[i]) == map_of(laid, laid.glyphs[i]));
                }
            }
}

TEST_CASE("every column holds the glyphs of its text, at any height, as long as their advances",
          "[adapt][harfbuzz][columns][paragraph]")
{
    if (!has_font(mplus)) return;
    harfbuzz_font font = opened(mplus);
    const std::u16string text =
        u"\u65E5\u672C\u3067AVATAR To Ve, efficient office\u3002\u30B3\u30FC\u30C9 "
        u"12\u6708\u300C\u8A9E\u300D2024\u5E74";
    shape_options how{.direction = direction::top_to_bottom};
    how.columns.combined_digits = 2;
    paragraph words{font};
    glyph_run run;
    REQUIRE(words.set(text, how));
    for (double height = 0.5; height < 40.0; height *= 1.2) {
        REQUIRE(words.lay_out({.width = height}, run));
        for (std::size_t k = 0; k < run.lines.size(); ++k) {
            const laid_line& line = words.lines()[k];
            const auto glyphs = run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count);
            std::vector<glyph_id> drawn, fresh;
            for (const placed_glyph& g : glyphs) drawn.push_back(g.id);
            buffer<shaped_glyph> shaped;
            for (text_item item : words.shaped().items()) {
                item.first = std::max(item.first, line.first);
                item.last = std::min(item.last, line.last);
                if (item.first < item.last) REQUIRE_FALSE(font.shape(text, item, how, shaped));
            }
            for (const shaped_glyph& g : shaped) fresh.push_back(g.id);
            CHECK(drawn == fresh);
            for (const placed_glyph& g : glyphs) {
                const auto stands = words.shaped().items()[words.shaped().item_at(g.cluster)].orientation;
                CHECK((map_of(run, g) == quarter_turn) == (stands == glyph_orientation::sideways));
            }
            CHECK((line.last - line.first <= 2 || run.lines[k].advance <= height * font.units_per_em() + 1e-6));
        }
    }
}

TEST_CASE("a mesh of a column is the line's mesh, turned", "[adapt][harfbuzz][columns]")
{
    harfbuzz_font font = opened(dejavu);
    text_mesher mesher{font};
    text_options how{.unit = output_unit::font_units};
    const auto bounds_of = [&] { return test::required(mesher.plan("AVg", how))->bounds(); };
    const auto a = bounds_of();
    how.shape.direction = direction::top_to_bottom;
    const auto b = bounds_of();
    const double middle = font.column_middle();
    CHECK(b.low.x == Approx(a.low.y - middle));
    CHECK(b.high.x == Approx(a.high.y - middle));
    CHECK(b.low.y == Approx(0.0 - a.high.x));
    CHECK(b.high.y == Approx(0.0 - a.low.x));
}

TEST_CASE("letters on their side do not reach from one column to the next", "[adapt][harfbuzz][columns]")
{
    for (const char* name : {mplus, dejavu, sawarabi}) {
        if (!has_font(name)) continue;
        harfbuzz_font font = opened(name);
        text_mesher mesher{font};
        text_options how{.unit = output_unit::font_units};
        how.shape.direction = direction::top_to_bottom;
        const auto plan = test::required(mesher.plan("jgpyQ|\xC3\x85", how));
        const line_metrics reach = line_reach_of(font, direction::top_to_bottom);
        CHECK(plan->bounds().low.x >= reach.descender);
        CHECK(plan->bounds().high.x <= reach.ascender);
        const glyph_run run = set(font, "j\n\xC3\x85", direction::top_to_bottom);
        CHECK(run.lines[1].origin.x == Approx(reach.descender - reach.ascender - reach.gap));
    }
}
