// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/required.hpp"
#include "support/toy_covering_font.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/typemesh.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

const std::u32string covered =
    U" aefgiostxhmnrlwdA.,:()$0123456789-'\"\u00E9\u0301\u0628\u0627\u062D\u05D0\u05D1\u05D2\u0E01\u0E02\u4E00\u3002";

struct found_letters {
    std::string letters, words;  ///< each in brackets; blanks between words are left out
    std::vector<text_letter> rows;
    std::vector<letter_group> lines, paragraphs;
    std::uint32_t graphemes = 0;
};

found_letters letters_in(const char* text, const letter_options& how = {}, const text_options& options = {})
{
    test::toy_covering_font font{covered};
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan(text, options));
    REQUIRE(plan->find_letters(text, how));
    const letter_rows rows = plan->letters();
    found_letters all;
    const auto quote = [text](const text_range& r) { return "[" + std::string{text + r.first, text + r.last} + "]"; };
    for (const text_letter& l : rows.letters) all.letters += quote(l.text);
    for (const letter_group& w : rows.words)
        all.words += quote({rows.letters[w.first].text.first, rows.letters[w.first + w.count - 1].text.last});
    all.rows.assign(rows.letters.begin(), rows.letters.end());
    all.lines.assign(rows.lines.begin(), rows.lines.end());
    all.paragraphs.assign(rows.paragraphs.begin(), rows.paragraphs.end());
    all.graphemes = rows.graphemes;
    return all;
}

}  // namespace

TEST_CASE("a letter is a grapheme with its marks, or what the font and the script do not divide", "[letters]")
{
    const found_letters plain = letters_in("e\u0301a fig");
    CHECK(plain.letters == "[e\u0301][a][fi][g]");
    REQUIRE(plain.rows.size() == 4);
    CHECK(plain.rows[0].bonds == letter_bond::several_glyphs);
    CHECK(plain.rows[1].bonds == letter_bond::none);
    CHECK(has(plain.rows[2].bonds, letter_bond::ligature));
    CHECK(plain.rows[2].grapheme == 3);
    CHECK(plain.rows[2].graphemes == 2);
    CHECK(plain.graphemes == 6);

    // Beh joins what follows, alef does not.
    const found_letters joined = letters_in("\u0628\u0628\u0627\u062D\u0628");
    CHECK(joined.letters == "[\u0628\u0628\u0627][\u062D\u0628]");
    CHECK(joined.rows[0].bonds == letter_bond::joined);
    const found_letters apart = letters_in("\u0628\u0628\u0627\u062D\u0628", {.keep_joins = false});
    CHECK(apart.rows.size() == 5);
    for (const text_letter& l : apart.rows) CHECK(l.bonds == letter_bond::joined);
    CHECK(letters_in("\u0628\u200C\u0628").rows.size() == 2);  // a non-joiner between them
    CHECK(letters_in("\u0628\u0301\u0628").letters == "[\u0628\u0301\u0628]");
    CHECK(letters_in("\u0628 \u0628").rows.size() == 2);
}

TEST_CASE("letters are numbered as they are read, in any direction", "[letters]")
{
    const char* text = GENERATE("\u05D0\u05D1 \u05D2", "a\u05D0\u05D1b \u05D2", "ex\n\n\u05D0\u05D1\nat");
    const found_letters all = letters_in(text);
    for (std::size_t i = 1; i < all.rows.size(); ++i) CHECK(all.rows[i - 1].text.last <= all.rows[i].text.first);
    CHECK(all.rows.front().text.first == 0);
    const found_letters hebrew = letters_in("\u05D0\u05D1\u05D2");
    CHECK(hebrew.rows[0].pivot.x > hebrew.rows[1].pivot.x);
    CHECK(hebrew.rows[1].pivot.x > hebrew.rows[2].pivot.x);
}

TEST_CASE("punctuation belongs to the word that it touches, or is a word of its own", "[letters]")
{
    CHECK(letters_in("(hello, \"west\"): it's 3.14, $5").words == "[(hello,][\"west\"):][it's][3.14,][$5]");
    CHECK(letters_in("hello, it's 3.14", {.attach_punctuation = false}).words == "[hello][,][it's][3.14]");
    CHECK(letters_in("- . ( a").words == "[-][.][(][a]");
    CHECK(letters_in("a\u3002\u4E00\u4E00").words == "[a\u3002][\u4E00][\u4E00]");
    CHECK(letters_in("\u0E01\u0E02\u0E01 \u0E01").words == "[\u0E01\u0E02\u0E01][\u0E01]");  // no dictionary: one word
}

TEST_CASE("lines are the run's, paragraphs the text's, with or without letters", "[letters]")
{
    const found_letters all = letters_in("ah\n\nge t\n", {}, {.layout = {.align = alignment::right}});
    CHECK(all.letters == "[a][h][g][e][t]");  // what has no glyph at a line's end belongs to no letter
    for (const text_letter& l : all.rows) CHECK(l.bonds == letter_bond::none);
    REQUIRE(all.lines.size() == 4);
    CHECK(all.lines[0].count == 2);
    CHECK(all.lines[1].count == 0);
    CHECK(all.lines[2].first == 2);
    CHECK(all.lines[2].count == 3);
    REQUIRE(all.paragraphs.size() == 3);
    CHECK(all.paragraphs[1].count == 0);
    CHECK(all.paragraphs[2].count == 3);
    CHECK(all.rows[2].line == 2);
    CHECK(all.rows[2].paragraph == 2);
    CHECK(all.rows[4].word == 2);
    CHECK(letters_in("").rows.empty());
    CHECK(letters_in(" \n ").rows.empty());
}

TEST_CASE("a pivot is on the baseline, in the centre or in the middle of the line", "[letters]")
{
    // Squares of 0.1 em, half an em apart; lines are an em apart.
    const auto pivot = [](letter_pivot how, const text_options& options) {
        return letters_in("ha\nto", {.pivot = how}, options).rows[3];
    };
    const text_letter base = pivot(letter_pivot::baseline, {});
    CHECK(base.pivot.x == Catch::Approx(0.55));
    CHECK(base.pivot.y == Catch::Approx(-1.0));
    CHECK(base.pivot.z == 0.0f);
    CHECK(base.extent.x == Catch::Approx(0.1));
    CHECK(base.extent.y == Catch::Approx(0.1));
    CHECK(base.extent.z == Catch::Approx(0.2));
    const text_letter centre = pivot(letter_pivot::centre, {.size = 10.0});
    CHECK(centre.pivot == centre.centre);
    CHECK(centre.pivot.y == Catch::Approx(-9.5));
    CHECK(centre.pivot.z == Catch::Approx(-1.0));
    CHECK(pivot(letter_pivot::line, {}).pivot.y == Catch::Approx(-0.95));
    CHECK(pivot(letter_pivot::baseline, {.frame = right_handed_z_up}).pivot.z == Catch::Approx(-1.0));

    const found_letters columns = letters_in("ha", {.down = true}, {.shape = {.direction = direction::top_to_bottom}});
    CHECK(columns.rows[0].pivot.x == columns.rows[1].pivot.x);
    CHECK(columns.rows[0].pivot.y > columns.rows[1].pivot.y);
}

TEST_CASE("merged letters are one letter, and a bar goes with the letters beside it", "[letters]")
{
    const glyph_run run = [] {
        glyph_run made = test::run_of({{5, 0, {0, 0}}, {5, 1, {50, 0}}, {5, 2, {600, 0}}});
        return made;
    }();
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan(run, {.merge = true}));
    REQUIRE(plan->find_letters("iii"));
    CHECK(plan->letters().letters.size() == 2);
    CHECK(plan->letters().letters[0].bonds == letter_bond::merged);
    CHECK(plan->letters().letters[0].graphemes == 2);
    CHECK(plan->letters().words.size() == 1);

    const glyph_run barred = test::run_of({{5, 0, {0, 0}}, {5, 1, {600, 0}}, {2, no_cluster, {0, -300}}});
    plan = test::required(mesher.plan(barred));
    REQUIRE(plan->find_letters("ii"));
    CHECK(plan->letters().letters.size() == 2);
    REQUIRE(plan->letters().bars.size() == 1);
    CHECK(plan->letters().bars[0].bonds == letter_bond::bar);
    CHECK(plan->letters().bars[0].text.first == 0);
    CHECK(plan->letters().bars[0].text.last == 1);
    CHECK(plan->letters().bars[0].graphemes == 1);
    CHECK(plan->letter_of(1) == 1);
    CHECK(plan->letter_of(2) == not_a_letter);
}

TEST_CASE("letters are not found in another text, with a pivot that does not exist, or without memory", "[letters]")
{
    test::counting_memory counted;
    test::toy_font font;
    text_mesher mesher{font, counted.source()};
    const auto plan = test::required(mesher.plan("oEi xo"));
    const auto refused = plan->find_letters("oE");
    CHECK(refused.error() == error::bad_option);
    CHECK(std::string{refused.error().option} == "text");
    CHECK(plan->find_letters("oEi xo", {.pivot = static_cast<letter_pivot>(3)}).error() == error::bad_option);
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 100; ++n) {
        text_mesher fresh{font, counted.source()};
        const auto other = test::required(fresh.plan("oEi xo\noo"));
        counted.fail_at = counted.requests + n;
        const auto found = other->find_letters("oEi xo\noo");
        counted.fail_at = 0;
        if (found) break;
        ++failures;
        CHECK(found.error() == error::out_of_memory);
        REQUIRE(other->find_letters("oEi xo\noo"));
        CHECK(other->letters().letters.size() == 7);
    }
    CHECK(failures == 7);
}
