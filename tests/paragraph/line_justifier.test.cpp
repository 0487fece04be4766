// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/laid_paragraph.hpp"

#include <typemesh/paragraph/total_fit.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace line_justifier_tests {
namespace {

const std::u16string mixed_text =
    u"AVATAR of the fifth \u0628\u0628\u0628 \u0628\u0628 office, \u05D0\u05D1 12 \u05D2\u05D3 and fi\u00ADfi\n"
    u"\u0628\u0628\u0628\u0628 a\u0301\u0302b\t\u0628\u0628\u0628\u0628 \u0662\u0663 \u0628\u0628\u0628 cd, "
    u"\u05D0\u05D1\u05D2 \u05D3 xyz.\r\nx  \n";
constexpr glyph_id stroke = 0x640;

template <class Breaker = first_fit>
struct justified : test::laid_paragraph<test::toy_shaper, Breaker> {
    justified(text_view text, double width, justification by, direction d = direction::automatic)
        : test::laid_paragraph<test::toy_shaper, Breaker>{
              text, {.width = width, .align = alignment::justify, .justify = by}, {.direction = d}}
    {
    }
    void again(double width, justification by, alignment align = alignment::justify)
    {
        test::laid_paragraph<test::toy_shaper, Breaker>::again({.width = width, .align = align, .justify = by});
    }
};

constexpr justification all_ways[] = {justification::automatic, justification::spaces, justification::letters,
                                      justification::kashida};

/// Whether the text of a line demands that it ends there.
bool is_last(const std::u16string& text, const laid_line& line)
{
    return line.last == text.size() || text[line.last - 1] == u'\n';
}

template <class Breaker>
void check_widths(double width, justification by)
{
    const justified<Breaker> p{mixed_text, width, by};
    for (std::size_t k = 0; k < p.run.lines.size(); ++k) {
        const laid_line& line = p.words.lines()[k];
        if (is_last(mixed_text, line) || line.width > width * 1000.0) continue;
        const std::u16string shown = mixed_text.substr(line.first, line.last - line.first);
        const std::size_t end = shown.find_last_not_of(u' ');
        if (shown.find(u' ') >= end || shown.find(u'\t') < end) continue;  // no space to stretch, or before a tab
        INFO(width << " " << static_cast<int>(by) << " line " << k);
        CHECK(std::fabs(line.left) <= 1e-9 * width * 1000.0);
        CHECK(std::fabs(line.width - width * 1000.0) <= 1e-9 * width * 1000.0);
    }
}

}  // namespace
}  // namespace line_justifier_tests

using namespace line_justifier_tests;

TEST_CASE("justified lines are as wide as the width, whatever makes them wider", "[paragraph]")
{
    for (const justification by : all_ways)
        for (double width = 3.0; width < 30.0; width *= 1.07) {
            check_widths<first_fit>(width, by);
            check_widths<total_fit>(width, by);
        }
}

TEST_CASE("every cluster of a justified text is drawn once, besides it hyphens and strokes only", "[paragraph]")
{
    for (const justification by : all_ways)
        for (double width = 2.0; width < 30.0; width *= 1.2) {
            justified<> plain{mixed_text, width, by}, p{mixed_text, width, by};
            plain.again(width, by, alignment::start);
            std::map<std::pair<cluster_id, glyph_id>, int> times;
            for (const placed_glyph& g : plain.run.glyphs) ++times[{g.cluster, g.id}];
            for (const placed_glyph& g : p.run.glyphs)
                if (g.id != stroke) --times[{g.cluster, g.id}];
            for (const auto& [glyph, count] : times) CHECK(count == 0);
            CHECK((by == justification::kashida || p.count(stroke) == 0));
        }
}

TEST_CASE("lines that need nothing are left as they are", "[paragraph]")
{
    for (const justification by : all_ways) {
        const std::u16string text =
            u"\u0628\u0628 ab \u0628\u0628\u0628";  // of 4000, in the only line and before a break
        for (const auto& shown : {text, text + u"\nab", text + u"  " + text}) {
            justified<> plain{shown, 4.0, by}, p{shown, 4.0, by};
            plain.again(4.0, by, alignment::start);
            CHECK(p.places() == plain.places());
        }
        justified<> last{text, 9.0, by};
        last.again(9.0, by, alignment::start);
        const auto before = last.places();
        last.again(9.0, by);
        CHECK(last.places() == before);
    }
}

TEST_CASE("letters move apart evenly, except those that are written joined", "[paragraph]")
{
    justified<> p{u"abc de \u0628\u0628 x yyyyyyyy", 6.5, justification::letters};
    REQUIRE(p.run.lines.size() == 2);
    // 12 letters and spaces before the edge, 11 distances, one of them between joined letters; 1000 to fill
    const std::vector<double> x = p.places();
    const double each = (6500.0 - p.words.shaped().advance(0, 11)) / 9.0;
    double pen = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(x[k] == Approx(pen));
        pen += (k == 3 ? 250.0 : 500.0) + each;
    }
    const auto glyphs = p.run.glyphs.view();
    for (std::size_t k = 0; k + 1 < glyphs.size(); ++k)
        if (glyphs[k].id == 0x628 && glyphs[k + 1].id == 0x628) CHECK(x[k + 1] - x[k] == 500.0);
    CHECK(p.run.lines[0].advance == Approx(6500.0));

    justified<> kana{u"\u304B\u306A\u304B\u306A\u304B\u306A", 2.2, justification::letters};  // no spaces at all
    CHECK(kana.run.lines[0].advance == Approx(2200.0));
    CHECK(kana.places()[3] == Approx(1700.0));
}

TEST_CASE("by default Chinese and Japanese fill their lines between ideographs, other lines by their spaces",
          "[paragraph]")
{
    const std::u16string chinese = u"\u6F22\u5B57\u3001\u304B\u306A\u6F22\u5B57";
    justified<> p{chinese, 2.2, justification::automatic};
    REQUIRE(p.run.lines.size() == 2);
    CHECK(p.run.lines[0].advance == Approx(2200.0));
    const std::vector<double> x = p.places();
    for (std::size_t k = 0; k < 4; ++k) CHECK(x[k] == Approx(static_cast<double>(k) * (500.0 + 200.0 / 3.0)));
    CHECK(x[4] == 0.0);  // the last line is not justified

    // A word of Latin is moved as a whole, and a space grows like a gap beside an ideograph.
    justified<> mixed_line{u"\u6F22\u5B57ab c\u6F22 \u5B57\u5B57\u5B57\u5B57", 4.6, justification::automatic};
    const std::vector<double> y = mixed_line.places();
    const double each = (4600.0 - mixed_line.words.shaped().advance(0, 10)) / 6.0;
    for (const auto& [k, apart] : {std::pair{0u, 500.0 + each}, {1u, 500.0 + each}, {2u, 500.0}, {4u, 250.0 + each}})
        CHECK(y[k + 1] - y[k] == Approx(apart));

    justified<> korean{u"\uAC00\uAC01 \uAC00\uAC01 \uAC00\uAC01", 3.0, justification::automatic};
    justified<> spaces{u"\uAC00\uAC01 \uAC00\uAC01 \uAC00\uAC01", 3.0, justification::spaces};
    CHECK(korean.places() == spaces.places());
    justified<> latin{mixed_text, 5.0, justification::automatic}, as_before{mixed_text, 5.0, justification::spaces};
    CHECK(latin.places() == as_before.places());
}

TEST_CASE("letters end at both edges of lines of both directions", "[paragraph]")
{
    using d = direction;
    for (const auto& [text, way] : {std::pair{u"\u05D0\u05D1 ab cd xxxxxxxx", d::right_to_left},
                                    {u"\u05D0\u05D1 ab cd xxxxxxxx", d::left_to_right},
                                    {u"ab \u05D0\u05D1 cd xxxxxxxx", d::left_to_right},
                                    {u"ab cd \u05D0\u05D1 xxxxxxxx", d::right_to_left},
                                    {u"ab cd \u05D0\u05D1 xxxxxxxx", d::left_to_right}}) {
        justified<> p{text, 4.7, justification::letters, way};
        double left = 1e9, right = 0.0;
        for (const placed_glyph& g : p.glyphs_of(0)) {
            if (g.id == ' ') continue;
            left = (std::min)(left, g.origin.x);
            right = (std::max)(right, g.origin.x + 500.0);
        }
        CHECK(left == Approx(0.0).margin(1e-6));
        CHECK(right == Approx(4700.0));
    }
}

TEST_CASE("strokes stand between joined letters, each belongs to the letter before it", "[paragraph]")
{
    justified<> p{u"\u0628\u0628\u0628 \u0628\u0628 \u0628 xxxxxxxxxx", 5.7, justification::kashida};
    REQUIRE(p.count(stroke) == 4);  // 2200 to fill: four of 500, the rest in two spaces
    CHECK(p.run.lines[0].advance == Approx(5700.0));
    std::map<cluster_id, int> of;
    const auto glyphs = p.glyphs_of(0);
    for (std::size_t k = 0; k < glyphs.size(); ++k)
        if (glyphs[k].id == stroke) {
            ++of[glyphs[k].cluster];
            CHECK(glyphs[k].origin.x - glyphs[k - 1].origin.x == Approx(500.0));
            CHECK(glyphs[k + 1].origin.x - glyphs[k].origin.x == Approx(500.0));
        }
    CHECK(of == std::map<cluster_id, int>{{1, 2}, {4, 2}});
}

TEST_CASE("strokes in a column lie on their side as the letters that they join", "[paragraph]")
{
    const justified<> p{u"\u0628\u0628\u0628 \u0628\u0628 \u0628 xxxxxxxxxx", 5.7, justification::kashida,
                        direction::top_to_bottom};
    REQUIRE(p.count(stroke) == 4);
    for (const placed_glyph& g : p.run.glyphs) {
        if (g.id != 0x628 && g.id != stroke) continue;
        CHECK(p.run.glyph_styles[g.glyph_style].map == quarter_turn);
        CHECK(g.origin.x == p.run.glyphs[0].origin.x);
    }
}

TEST_CASE("a line without spaces is filled by strokes that overlap, up to so many in a word", "[paragraph]")
{
    justified<> p{u"\u0628\u0628\u0628 xxxxxxxxxxxxx", 2.3, justification::kashida};
    CHECK(p.count(stroke) == 2);
    CHECK(p.run.lines[0].advance == Approx(2300.0));
    p.again(6.0, justification::kashida);
    CHECK(p.count(stroke) == line_justifier::max_strokes);
    CHECK(p.run.lines[0].advance == Approx(1500.0 + 500.0 * line_justifier::max_strokes));
}

TEST_CASE("a word is shaped with its strokes whole, also before a hyphen", "[paragraph]")
{
    struct reader : test::toy_shaper {
        std::u32string word;  // the last with a stroke in it
        error shape(text_view text, const text_item& item, const shape_options& how,
                    buffer<shaped_glyph>& glyphs) noexcept
        {
            std::u32string read;
            for (std::size_t i = item.first; i < item.last;) {
                const code_point c = decode(text, i, item.last);
                read.push_back(c.value);
                i = c.next;
            }
            if (read.size() > 1 && read.find(char32_t{stroke}) != read.npos) word = read;
            const std::size_t before = glyphs.size();
            const error e = test::toy_shaper::shape(text, item, how, glyphs);
            for (shaped_glyph& g : glyphs.view().subspan(before)) g.flags = g.flags | glyph_flags::unsafe_to_break;
            return e;
        }
    };
    const test::laid_paragraph<reader> p{
        "\xD8\xA8\xD8\xA8\xC2\xAD\xD8\xA8\xD8\xA8\xD8\xA8",  // UTF-8, U+00AD in it
        {.width = 2.3, .align = alignment::justify, .justify = justification::kashida}};
    REQUIRE(p.run.lines.size() == 2);
    CHECK(p.font.word == U"\u0628\u0640\u0640\u0628\u00AD");
}

TEST_CASE("without a stroke in the font spaces fill the line", "[paragraph]")
{
    struct without_strokes : test::toy_shaper {
        error shape(text_view text, const text_item& item, const shape_options& how,
                    buffer<shaped_glyph>& glyphs) noexcept
        {
            if (item.first < item.last && decode(text, item.first).value == stroke) return {};
            return test::toy_shaper::shape(text, item, how, glyphs);
        }
    };
    const test::laid_paragraph<without_strokes> p{
        u"\u0628\u0628 \u0628\u0628 xxxxxxxxxx",
        {.width = 4.0, .align = alignment::justify, .justify = justification::kashida}};
    CHECK(p.run.lines[0].advance == 4000.0);
    CHECK(p.count(stroke) == 0);
}

TEST_CASE("a caret's own point leads back to its place in lines of every justification", "[paragraph]")
{
    for (const justification by : all_ways) {
        const justified<> p{mixed_text, 7.0, by};
        const laid_text laid = p.words.laid();
        for (std::uint32_t u = 0; u < mixed_text.size(); ++u) {
            if (!has(p.words.shaped().analysis.marks[u], text_mark::grapheme)) continue;
            const caret at = laid.caret_at(u);
            const text_place back = laid.caret_from(at.at);
            CHECK(laid.caret_at(back.unit, back.side).at == at.at);
        }
    }
}

TEST_CASE("lines that total_fit has made too full are narrowed to the width", "[paragraph]")
{
    const std::u16string text = u"aa bb cc dd ee ff gg hh ii jj kk ll";
    for (const justification by : all_ways) {
        const justified<total_fit> p{text, 7.0, by};
        REQUIRE(p.run.lines.size() == 2);  // of 7250 by nature
        for (const text_line& line : p.run.lines) CHECK(line.advance == Approx(7000.0));
    }
}

TEST_CASE("justifying reports a memory that gives nothing, wherever it does, and keeps what it has", "[paragraph]")
{
    for (const justification by : all_ways) {
        const layout_options how{.width = 6.0, .align = alignment::justify, .justify = by};
        test::check_each_failure([&how](memory source) {
            test::toy_shaper font;
            paragraph words{font, source, unicode_analyser{source}};
            glyph_run run;
            const error e = words.set(mixed_text).error();
            return e ? e : words.lay_out(how, run).error();
        });
        test::toy_shaper font;
        test::counting_memory counted;
        paragraph words{font, counted.source(), unicode_analyser{counted.source()}};
        glyph_run run{counted.source()};
        REQUIRE(words.set(mixed_text));
        REQUIRE(words.lay_out(how, run));
        const std::size_t before = counted.requests;
        for (int k = 0; k < 3; ++k) REQUIRE(words.lay_out(how, run));
        CHECK(counted.requests == before);
    }
}
