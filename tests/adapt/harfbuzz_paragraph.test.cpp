// SPDX-License-Identifier: MIT
//
// Paragraphs with real fonts: what lines hold is held against fresh shaping.

#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/paragraph/paragraph.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

using namespace typemesh;

namespace {

const char* const latin =
    "The quick brown AVATAR, To Ve and office fjord flows: \xE2\x80\x9CWe. Ta Yo\xE2\x80\x9D offices \xE2\x80\x94 "
    "efficient Tyres. A VA-VAT Wave, 1.000 LT.";
const char* const arabic =
    "\xD8\xA8\xD8\xB3\xD9\x85 \xD8\xA7\xD9\x84\xD9\x84\xD9\x87 \xD8\xA7\xD9\x84\xD8\xB1\xD8\xAD\xD9\x85\xD9\x86 "
    "\xD8\xA7\xD9\x84\xD8\xB1\xD8\xAD\xD9\x8A\xD9\x85 \xD8\xB9\xD8\xA7\xD9\x85 2024 "
    "\xD8\xA7\xD9\x84\xD8\xB3\xD9\x84\xD8\xA7\xD9\x85 "
    "\xD8\xB9\xD9\x84\xD9\x8A\xD9\x83\xD9\x85\xD8\x8C abc \xD9\x88\xD8\xB1\xD8\xAD\xD9\x85\xD8\xA9";
const char* const hindi =
    "\xE0\xA4\xB9\xE0\xA4\xBF\xE0\xA4\xA8\xE0\xA5\x8D\xE0\xA4\xA6\xE0\xA5\x80 \xE0\xA4\xAE\xE0\xA5\x87\xE0\xA4\x82 "
    "\xE0\xA4\x95\xE0\xA5\x8D\xE0\xA4\xB7\xE0\xA4\xA4\xE0\xA5\x8D\xE0\xA4\xB0\xE0\xA4\xBF\xE0\xA4\xAF "
    "\xE0\xA4\xB8\xE0\xA5\x8D\xE0\xA4\xA4\xE0\xA5\x8D\xE0\xA4\xB0\xE0\xA5\x80 \xE0\xA4\x95\xE0\xA5\x80 12 "
    "\xE0\xA4\x95\xE0\xA4\xB0";

struct sample {
    const char* font;
    const char* text;
};

const sample samples[] = {
    {"truetype/dejavu/DejaVuSans.ttf", latin},
    {"truetype/liberation/LiberationSerif-Regular.ttf", latin},
    {"truetype/inter-vf/Inter-roman.var.ttf", latin},
    {"opentype/comic-neue/ComicNeue-Regular.otf", latin},
    {"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", arabic},
    {"truetype/dejavu/DejaVuSans.ttf", arabic},
    {"truetype/awami/AwamiNastaliq-Regular.ttf", arabic},
    {"truetype/lohit-devanagari/Lohit-Devanagari.ttf", hindi},
};

using drawn = std::tuple<cluster_id, glyph_id>;

template <class Glyphs>
std::vector<drawn> glyphs_of(const Glyphs& glyphs)
{
    std::vector<drawn> all;
    for (const auto& g : glyphs) all.push_back({g.cluster, g.id});
    std::sort(all.begin(), all.end());
    return all;
}

/// The glyphs of text[first, last), its items shaped afresh, and how far those before text[visible] take the pen.
std::pair<std::vector<drawn>, double> fresh(harfbuzz_font& font, text_view text, std::span<const text_item> items,
                                            std::uint32_t first, std::uint32_t last, std::uint32_t visible)
{
    buffer<shaped_glyph> glyphs;
    for (text_item item : items) {
        if (item.last <= first || item.first >= last || silent_at(text, item.first) != 0) continue;
        item.first = std::max(item.first, first);
        item.last = std::min(item.last, last);
        REQUIRE_FALSE(font.shape(text, item, {}, glyphs));
    }
    double advance = 0.0;
    for (const shaped_glyph& g : glyphs) advance += g.cluster < visible ? g.advance : 0.0;
    return {glyphs_of(glyphs.view()), advance};
}

}  // namespace

TEST_CASE("every line holds the glyphs of its text shaped afresh, at any width and way of wrapping",
          "[adapt][harfbuzz][paragraph]")
{
    const sample s = GENERATE(from_range(std::begin(samples), std::end(samples)));
    const wrap_mode wrap = GENERATE(wrap_mode::none, wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme);
    INFO(s.font);
    auto font = test::required(harfbuzz_font::open(font_file(s.font).c_str()));
    paragraph words{*font};
    glyph_run run;
    REQUIRE(words.set(s.text));
    const text_view text{s.text};
    for (double width = 0.4; width < 60.0; width *= 1.3) {
        INFO("width " << width);
        REQUIRE(words.lay_out({.width = width, .wrap = wrap}, run));
        REQUIRE(run.lines.size() == words.lines().size());
        std::uint32_t at = 0;
        for (std::size_t k = 0; k < run.lines.size(); ++k) {
            const laid_line& line = words.lines()[k];
            CHECK(line.first == at);
            REQUIRE((line.last > at || text.empty()));
            at = line.last;
            const auto glyphs = run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count);
            std::uint32_t visible = line.last;  // without the white space that hangs
            while (visible > line.first && has(words.shaped().analysis.marks[visible - 1], text_mark::space)) --visible;
            const auto [expected, advance] = fresh(*font, text, words.shaped().items(), line.first, line.last, visible);
            CHECK(glyphs_of(glyphs) == expected);
            CHECK(std::fabs(run.lines[k].advance - advance) < 1e-6);
            if (wrap == wrap_mode::word_or_grapheme && width > 1.5) {
                // Only one grapheme may be wider than there is room. (In less room lines have no place that is safe.)
                std::size_t graphemes = 0;
                for (std::uint32_t u = line.first; u < line.last; ++u)
                    graphemes += has(words.shaped().analysis.marks[u], text_mark::grapheme) &&
                                         !has(words.shaped().analysis.marks[u], text_mark::space)
                                     ? 1u
                                     : 0u;
                if (graphemes > 1) CHECK(run.lines[k].advance <= width * font->units_per_em() + 1e-6);
            }
        }
        CHECK(at == text.size());
    }
}

TEST_CASE("lines of both directions are drawn as UAX #9 orders them", "[adapt][harfbuzz][paragraph]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    paragraph words{*font};
    glyph_run run;
    const auto clusters = [&](std::u16string_view text, direction d) {
        shape_options how;
        how.direction = d;
        REQUIRE(words.set(text, how));
        REQUIRE(words.lay_out({}, run));
        std::vector<cluster_id> all;
        for (const placed_glyph& g : run.glyphs) all.push_back(g.cluster);
        return all;
    };
    using order = std::vector<cluster_id>;
    CHECK(clusters(u"a \u05D0\u05D1 b", direction::automatic) == order{0, 1, 3, 2, 4, 5});
    CHECK(clusters(u"\u05D0 12 \u05D1", direction::automatic) == order{5, 4, 2, 3, 1, 0});
    CHECK(clusters(u"\u05D0 ab", direction::left_to_right) == order{0, 1, 2, 3});
    CHECK(clusters(u"ab \u05D0", direction::right_to_left) == order{3, 2, 0, 1});
    CHECK(clusters(u"a\u202E12\u202Cb", direction::automatic) == order{0, 1, 4, 3, 2, 5});
    CHECK(clusters(u"\u05D0\t12 3\t\u05D1", direction::automatic) == order{7, 5, 4, 2, 3, 0});
}

TEST_CASE("a line is drawn in the same order whether it is laid out alone or as a paragraph",
          "[adapt][harfbuzz][paragraph]")
{
    auto font = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    paragraph words{*font};
    const auto clusters = [](const glyph_run& run) {
        std::vector<cluster_id> all;
        for (const placed_glyph& g : run.glyphs) all.push_back(g.cluster);
        return all;
    };
    for (const char16_t* text : {u"abc.", u"\u05D0\u05D1.", u"\u05D0 ab, \u05D1!", u"ab \u05D0\u05D1 (12).",
                                 u"12 % \u05D0", u"(?", u"1.5", u"\u05D0\tab.\t\u05D1!", u"ab.\t\u05D0.\tcd."})
        for (const direction d : {direction::automatic, direction::left_to_right, direction::right_to_left}) {
            INFO(static_cast<int>(d));
            shape_options how;
            how.direction = d;
            glyph_run alone, laid;
            REQUIRE(layout(*font, text, how, {}, alone));
            REQUIRE(words.set(text, how));
            REQUIRE(words.lay_out({}, laid));
            CHECK(clusters(alone) == clusters(laid));
        }
}

TEST_CASE("a paragraph's first line can be no wider than its text, nor a word than its own line",
          "[adapt][harfbuzz][paragraph]")
{
    const sample s = GENERATE(from_range(std::begin(samples), std::end(samples)));
    INFO(s.font);
    auto font = test::required(harfbuzz_font::open(font_file(s.font).c_str()));
    paragraph words{*font};
    glyph_run run;
    REQUIRE(words.set(s.text));
    const paragraph_widths widths = words.widths();
    REQUIRE(widths.narrowest > 0.0);
    REQUIRE(widths.narrowest < widths.widest);
    REQUIRE(words.lay_out({.width = widths.widest}, run));
    CHECK(run.lines.size() == 1);
    REQUIRE(words.lay_out({.width = 0.99 * widths.widest}, run));
    CHECK(run.lines.size() > 1);
    REQUIRE(words.lay_out({.width = widths.narrowest, .wrap = wrap_mode::word}, run));
    const std::size_t lines = run.lines.size();
    REQUIRE(words.lay_out({.width = widths.narrowest, .wrap = wrap_mode::word_or_grapheme}, run));
    CHECK(run.lines.size() == lines);  // nothing was broken
}

namespace {

std::vector<glyph_id> arabic_glyphs(harfbuzz_font& font, std::u16string_view word)
{
    buffer<shaped_glyph> glyphs;
    const auto size = static_cast<std::uint32_t>(word.size());
    REQUIRE_FALSE(font.shape(word, {.last = size, .script = script_tag("Arab"), .level = 1}, {}, glyphs));
    std::vector<glyph_id> ids;
    for (const shaped_glyph& g : glyphs) ids.push_back(g.id);
    return ids;
}

/// With how many strokes, at one place, a word looks like that; 99 if it never does.
std::size_t strokes_in(harfbuzz_font& font, const std::u16string& word, const std::vector<glyph_id>& shown)
{
    if (arabic_glyphs(font, word) == shown) return 0;
    for (std::size_t n = 1; n <= line_justifier::max_strokes; ++n)
        for (std::size_t place = 1; place < word.size(); ++place) {
            std::u16string longer{word};
            longer.insert(place, n, u'\u0640');
            if (arabic_glyphs(font, longer) == shown) return n;
        }
    return 99;
}

}  // namespace

TEST_CASE("words with strokes are drawn as their text with U+0640, shaped afresh", "[adapt][harfbuzz][paragraph]")
{
    const char* const name = GENERATE("opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "truetype/dejavu/DejaVuSans.ttf");
    INFO(name);
    const std::u16string text =
        u"\u0628\u0650\u0633\u0652\u0645\u0650 \u0627\u0644\u0644\u0647 \u0627\u0644\u0631\u062D\u0645\u0646 "
        u"\u0627\u0644\u0631\u062D\u064A\u0645 \u0627\u0644\u0633\u0644\u0627\u0645 \u0639\u0644\u064A\u0643\u0645 "
        u"\u0648\u0631\u062D\u0645\u0629 \u0627\u0644\u0644\u0647 \u0648\u0628\u0631\u0643\u0627\u062A\u0647";
    auto font = test::required(harfbuzz_font::open(font_file(name).c_str()));
    paragraph words{*font};
    glyph_run run;
    REQUIRE(words.set(text));
    std::size_t strokes = 0;
    for (double width = 4.0; width < 16.0; width += 0.37) {
        REQUIRE(words.lay_out({.width = width, .align = alignment::justify, .justify = justification::kashida}, run));
        for (std::size_t k = 0; k + 1 < run.lines.size(); ++k) {
            const laid_line& line = words.lines()[k];
            std::size_t first = line.first, count = 0;
            for (; first < line.last; ++count) {
                const std::size_t last = std::min(text.find(u' ', first), text.size());
                std::vector<glyph_id> shown;
                for (const placed_glyph& g :
                     run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count))
                    if (g.cluster >= first && g.cluster < last) shown.push_back(g.id);
                const std::size_t n = strokes_in(*font, text.substr(first, last - first), shown);
                CHECK(n <= line_justifier::max_strokes);
                strokes += n;
                first = last + 1;
            }
            if (count > 1) CHECK(run.lines[k].advance == Approx(width * font->units_per_em()).epsilon(1e-9));
        }
    }
    CHECK(strokes > 100);
}

namespace {

/// Words of several scripts, marks, breaks and tabs between explicit directions, nested as deep as there are levels.
/// Without U+202D: HarfBuzz takes the context of Arabic that is read to the right for that of its other side.
std::u16string random_text(std::mt19937& random)
{
    static const std::u16string_view sorts[] = {u"abcAVTfiyo",
                                                u"\u05D0\u05D1\u05D2\u05DC",
                                                u"\u0628\u0644\u0627\u0645\u0651\u064E",
                                                u"  \t\u00A0\u3000",
                                                u"\u0915\u094D\u0937\u093F\u0930",
                                                u"0129%-,.",
                                                u"()[]\u201C",
                                                u"\u0301\u0308a",
                                                u"\u202A\u202B\u202E\u2066\u2067\u2068",
                                                u"\u202C\u2069",
                                                u"\n\r\u2028\u2029\u0085\u000B\u001D"};
    std::u16string text;
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
    if (below(4) == 0)
        for (int k = 0; k < 130; ++k) text += sorts[8][below(6)];
    for (std::size_t words = below(14); words > 0; --words) {
        const std::u16string_view sort = sorts[below(below(3) == 0 ? 11 : 7)];
        for (std::size_t k = 1 + below(5); k > 0; --k) text += sort[below(sort.size())];
    }
    return text;
}

layout_options random_options(std::mt19937& random)
{
    return {.width = 0.3 + static_cast<double>(random() % 900) / 60.0,
            .wrap = static_cast<wrap_mode>(random() % 4),
            .align = static_cast<alignment>(random() % 6),
            .anchor = static_cast<vertical_anchor>(random() % 5),
            .indent = static_cast<double>(random() % 5) / 2.0 - 1.0};
}

/// A caret's own point leads back to where it stands, and to its place and side where no other has that caret.
void check_carets(const paragraph<harfbuzz_font>& words)
{
    struct place {
        std::uint32_t unit;
        affinity side;
        caret at;
    };
    const laid_text laid = words.laid();
    const auto size = static_cast<std::uint32_t>(words.shaped().text().size());
    std::vector<place> all;
    for (std::uint32_t unit = 0; unit <= size; ++unit)
        if (unit == size || has(words.shaped().analysis.marks[unit], text_mark::grapheme))
            for (const affinity side : {affinity::downstream, affinity::upstream})
                all.push_back({unit, side, laid.caret_at(unit, side)});
    const auto same_caret = [](const caret& a, const caret& b) {
        return a.line == b.line && std::fabs(a.at.x - b.at.x) < 1e-9;
    };
    for (const place& one : all) {
        const text_place found = laid.caret_from(one.at.at);
        CHECK(same_caret(laid.caret_at(found.unit, found.side), one.at));
        const auto others = std::count_if(all.begin(), all.end(), [&](const place& p) {
            return same_caret(p.at, one.at) && (p.unit != one.unit || p.side != one.side);
        });
        if (others == 0) CHECK((found.unit == one.unit && found.side == one.side));
    }
}

}  // namespace

TEST_CASE("whatever text is laid out in whatever way, all of it is drawn once, as it is shaped, and carets lead back",
          "[adapt][harfbuzz][paragraph]")
{
    std::vector<harfbuzz_font> fonts;
    for (const char* name : {"truetype/dejavu/DejaVuSans.ttf", "opentype/fonts-hosny-amiri/Amiri-Regular.ttf",
                             "truetype/lohit-devanagari/Lohit-Devanagari.ttf"}) {
        fonts.push_back(std::move(*test::required(harfbuzz_font::open(font_file(name).c_str()))));
    }
    std::mt19937 random{14};
    std::uint8_t deepest = 0;
    for (int times = 0; times < 50; ++times) {
        INFO("text " << times);
        harfbuzz_font& font = fonts[random() % fonts.size()];
        const std::u16string text = random_text(random);
        paragraph words{font};
        glyph_run run;
        shape_options how;
        how.direction = static_cast<direction>(random() % 3);
        REQUIRE(words.set(text, how));
        for (const std::uint8_t level : words.shaped().analysis.levels) deepest = std::max(deepest, level);
        for (int layouts = 0; layouts < 2; ++layouts) {
            REQUIRE(words.lay_out(random_options(random), run));
            std::uint32_t at = 0;
            for (std::size_t k = 0; k < run.lines.size(); ++k) {
                const laid_line& line = words.lines()[k];
                CHECK(line.first == at);
                at = line.last;
                const auto glyphs = run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count);
                CHECK(glyphs_of(glyphs) ==
                      fresh(font, text, words.shaped().items(), line.first, line.last, line.last).first);
            }
            CHECK(at == text.size());
            check_carets(words);
        }
    }
    CHECK(deepest >= 124);
}
