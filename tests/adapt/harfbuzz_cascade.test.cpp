// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

using namespace typemesh;

namespace {

/// Latin, Arabic and Han, of three fonts of different units; the first has no other script.
struct three_fonts {
    result<harfbuzz_font> latin = open("opentype/comic-neue/ComicNeue-Regular.otf");
    result<harfbuzz_font> arabic = open("opentype/fonts-hosny-amiri/Amiri-Regular.ttf");
    result<harfbuzz_font> han = open("truetype/wqy/wqy-microhei.ttc");

    static result<harfbuzz_font> open(const char* file)
    {
        auto font = test::required(harfbuzz_font::open(font_file(file).c_str()));
        return font;
    }
    /// Whether one of them has all characters of a text.
    [[nodiscard]] bool has(text_view text) const
    {
        for (const harfbuzz_font* font : {&*latin, &*arabic, &*han}) {
            bool all = true;
            for (std::size_t u = 0; u < text.size();) {
                const code_point c = decode(text, u);
                hb_codepoint_t id = 0;
                all = all &&
                      (is_default_ignorable(c.value) || hb_font_get_nominal_glyph(font->handle(), c.value, &id) != 0);
                u = c.next;
            }
            if (all) return true;
        }
        return false;
    }
};

const std::u16string mixed =
    u"Tea, \u0634\u0627\u064A \u0623\u062E\u0636\u0631 (12) and \u7DD1\u8336 \u2013 "
    u"\u0643\u064F\u062A\u064F\u0628 e\u0301a\u0489 office AVAT \u6587\u5B57!";

struct drawn_glyph {
    cluster_id cluster;
    std::uint32_t face;
    glyph_id id;
    friend auto operator<=>(const drawn_glyph&, const drawn_glyph&) = default;
};

template <class Glyphs, class FaceOf>
std::vector<drawn_glyph> sorted(const Glyphs& glyphs, const FaceOf& face_of)
{
    std::vector<drawn_glyph> all;
    for (const auto& g : glyphs) all.push_back({g.cluster, face_of(g), g.id});
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("three fonts set a line of Latin, Arabic and Han", "[adapt][harfbuzz][fallback]")
{
    three_fonts f;
    font_cascade fonts{*f.latin, *f.arabic, *f.han};
    text_mesher mesher{fonts};
    const auto plan = test::required(mesher.plan(u"ab \u0628\u0628 \u4E00"));
    CHECK(plan->report().complete());
    const glyph_run& run = plan->run();
    REQUIRE(run.glyphs.size() == 7);
    const std::uint32_t faces[] = {0, 0, 0, 1, 1, 0, 2};
    const cluster_id clusters[] = {0, 1, 2, 4, 3, 5, 6};
    for (std::size_t i = 0; i < 7; ++i) {
        CHECK(run.glyph_styles[run.glyphs[i].glyph_style].face == faces[i]);
        CHECK(run.glyphs[i].cluster == clusters[i]);
    }
    // The two letters join, as in their own font alone.
    buffer<shaped_glyph> own;
    REQUIRE_FALSE(f.arabic->shape(u"\u0628\u0628", {.last = 2, .script = script_tag("Arab"), .level = 1}, {}, own));
    CHECK(run.glyphs[3].id == own[0].id);
    CHECK(run.glyphs[4].id == own[1].id);
    CHECK(run.glyphs[3].id != run.glyphs[4].id);
}

TEST_CASE("a cascade whose first font has all is that font, glyph for glyph", "[adapt][harfbuzz][fallback]")
{
    three_fonts f;
    auto sans = three_fonts::open("truetype/dejavu/DejaVuSans.ttf");
    font_cascade fonts{*sans, *f.arabic, *f.han};
    paragraph words{fonts};
    paragraph alone{*sans};
    for (const char16_t* text : {u"office AVAT fi", u"\u0643\u064F\u062A\u064F\u0628 12 x", u"\u05D0\u05D1 (x) 12"}) {
        glyph_run found, expected;
        REQUIRE(layout(fonts, text, {}, {}, found));
        REQUIRE(layout(*sans, text, {}, {}, expected));
        for (int way = 0; way < 2; ++way) {
            REQUIRE(found.glyphs.size() == expected.glyphs.size());
            for (std::size_t i = 0; i < found.glyphs.size(); ++i) {
                CHECK(found.glyphs[i].id == expected.glyphs[i].id);
                CHECK(found.glyphs[i].origin == expected.glyphs[i].origin);
            }
            CHECK(found.glyph_styles.empty());
            REQUIRE(words.set(text));
            REQUIRE(alone.set(text));
            REQUIRE(words.lay_out({.width = 3.0}, found));
            REQUIRE(alone.lay_out({.width = 3.0}, expected));
        }
    }
}

TEST_CASE("every line of a paragraph in several fonts holds the glyphs of its text shaped afresh",
          "[adapt][harfbuzz][fallback]")
{
    three_fonts f;
    font_cascade fonts{*f.latin, *f.arabic, *f.han};
    const wrap_mode wrap = GENERATE(wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme);
    paragraph words{fonts};
    glyph_run run;
    REQUIRE(words.set(mixed));
    for (double width = 0.4; width < 40.0; width *= 1.25) {
        INFO("width " << width);
        REQUIRE(words.lay_out({.width = width, .wrap = wrap}, run));
        std::uint32_t at = 0;
        for (std::size_t k = 0; k < run.lines.size(); ++k) {
            const laid_line& line = words.lines()[k];
            CHECK(line.first == at);
            at = line.last;
            buffer<shaped_glyph> fresh;
            for (text_item item : words.shaped().items()) {
                if (item.last <= line.first || item.first >= line.last) continue;
                item.first = std::max(item.first, line.first);
                item.last = std::min(item.last, line.last);
                REQUIRE_FALSE(fonts.shape(mixed, item, {}, fresh));
            }
            const auto glyphs = run.glyphs.view().subspan(run.lines[k].first_glyph, run.lines[k].glyph_count);
            CHECK(sorted(glyphs, [&](const placed_glyph& g) {
                      return run.glyph_styles.empty() ? 0 : run.glyph_styles[g.glyph_style].face;
                  }) == sorted(fresh, [](const shaped_glyph& g) { return std::uint32_t{g.face}; }));
        }
        CHECK(at == mixed.size());
        CHECK(run.missing == 0);
    }
}

TEST_CASE("no grapheme of random texts comes from two fonts, and what is missing is what no font has",
          "[adapt][harfbuzz][fallback]")
{
    three_fonts f;
    font_cascade fonts{*f.latin, *f.arabic, *f.han};
    paragraph words{fonts};
    glyph_run run;
    std::mt19937 random{2};
    const std::u16string parts[] = {u"a",      u"e\u0301", u"\u0628", u"\u064E", u"\u200D",     u"\u0301",
                                    u"\uFE0F", u"\u4E00",  u"\u0489", u" ",      u"\U0001F468", u"\u0E01",
                                    u"\u0E33", u"\u0915",  u"\u093F", u"\u1100", u"\u1161",     u"\U0001F1E6",
                                    u"\u20DD", u"fi",      u"\u0644", u"\u0627", u"\u200C",     u"1"};
    bool two_faces = false, lacks_what_is_there = false;
    std::size_t lines = 0, missing = 0;
    for (int round = 0; round < 400; ++round) {
        std::u16string text;
        for (int i = 0; i < 12; ++i) text.append(parts[random() % std::size(parts)]);
        REQUIRE(words.set(text));
        const bool wrapped = round % 2 == 0;
        if (wrapped)
            REQUIRE(words.lay_out({.width = 2.0}, run));
        else
            REQUIRE(layout(fonts, text, {}, {}, run));
        lines += run.lines.size();
        missing += run.missing;

        std::vector<std::uint32_t> grapheme(text.size());
        for (std::uint32_t u = 0; u < text.size(); ++u)
            grapheme[u] = u == 0 || has(words.shaped().analysis.marks[u], text_mark::grapheme) ? u : grapheme[u - 1];
        for (std::size_t k = 1; wrapped && k < words.lines().size(); ++k)  // it may end between a space and its mark
            for (std::uint32_t u = words.lines()[k].first, from = grapheme[u]; u < text.size() && grapheme[u] == from;
                 ++u)
                grapheme[u] = words.lines()[k].first;

        std::vector<int> face_of(text.size(), -1);
        std::vector<bool> begins(text.size() + 1, false);  // HarfBuzz' clusters may be more than a grapheme, or less
        for (const placed_glyph& g : run.glyphs) {
            const int face = run.glyph_styles.empty() ? 0 : static_cast<int>(run.glyph_styles[g.glyph_style].face);
            int& known = face_of[grapheme[g.cluster]];
            two_faces = two_faces || (known >= 0 && known != face);
            known = face;
            begins[g.cluster] = grapheme[g.cluster] == g.cluster;
        }
        begins[0] = begins[text.size()] = true;
        for (const placed_glyph& g : run.glyphs) {
            if (!g.missing) continue;
            std::size_t first = g.cluster, last = g.cluster + std::size_t{1};
            while (!begins[first]) --first;
            while (!begins[last]) ++last;
            if (f.has(std::u16string_view{text}.substr(first, last - first))) lacks_what_is_there = true;
        }
    }
    CHECK_FALSE(two_faces);
    CHECK_FALSE(lacks_what_is_there);
    CHECK(lines > 900);
    CHECK(missing > 1000);
}
