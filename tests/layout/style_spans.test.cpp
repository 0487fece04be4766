// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/each_failure.hpp"

#include <typemesh/layout/style_spans.hpp>

#include <algorithm>
#include <limits>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;
using test::analysed;

namespace {

style_spans read_spans(const std::vector<style_span>& given, const text_analysis& found)
{
    style_spans spans;
    REQUIRE_FALSE(spans.read(given, found, 1));
    return spans;
}

style_span painted(std::uint32_t first, std::uint32_t last, std::uint32_t number)
{
    return {first, last, {.style = style_id{number}}};
}

std::uint32_t colour_at(const style_spans& spans, std::uint32_t unit)
{
    return static_cast<std::uint32_t>(spans[spans.number_at(unit)].style);
}

}  // namespace

TEST_CASE("ends are moved out of graphemes that are joined later, and are counted", "[paragraph][styles]")
{
    text_analysis found = analysed("a12b");
    style_spans spans =
        read_spans({{0, 2, {.size = 2.0, .style = style_id{7}}}, {2, 3, {.style = style_id{8}}}}, found);
    CHECK(spans.moved() == 0);
    CHECK(spans.borders().size() == 2);
    found.marks[2] = text_mark::none;
    REQUIRE_FALSE(spans.move_out_of(found));
    CHECK(spans.moved() == 2);
    CHECK(colour_at(spans, 2) == 7);
    CHECK(spans.spans().size() == 1);
    REQUIRE(spans.borders().size() == 2);
    CHECK(spans.borders()[1] == 3);
}

TEST_CASE("a unit has the style of its span, or is plain", "[paragraph][styles]")
{
    const text_analysis found = analysed("abcdef");
    style_spans spans = read_spans({painted(4, 5, 9), painted(1, 3, 7), painted(2, 2, 8), painted(0, 0, 6)}, found);
    for (std::uint32_t unit = 0; unit < 8; ++unit)
        CHECK(colour_at(spans, unit) == (unit == 4 ? 9u : unit == 1 || unit == 2 ? 7u : 0u));
    CHECK(spans.borders().empty());
    CHECK(spans.moved() == 0);
    CHECK(spans.number_at(0) == 0);
}

TEST_CASE("text is shaped apart only where its shaping changes", "[paragraph][styles]")
{
    const text_analysis found = analysed("abcdefghij");
    const text_style large{.size = 2.0}, red_large{.size = 2.0, .style = style_id{1}}, red{.style = style_id{1}};
    style_spans spans = read_spans({{1, 3, large}, {3, 5, red_large}, {5, 7, red}, {8, 10, large}}, found);
    CHECK(std::vector<std::uint32_t>(spans.borders().begin(), spans.borders().end()) ==
          std::vector<std::uint32_t>{1, 5, 8, 10});
}

TEST_CASE("ends inside a grapheme are moved out, which is counted", "[paragraph][styles]")
{
    const std::u16string text = u"ab\u0301\u0302cd\u0301";
    const text_analysis found = analysed(text);
    style_spans spans;
    const style_span out[] = {painted(2, 6, 1)};
    REQUIRE_FALSE(spans.read(out, found, 1));
    CHECK(spans.moved() == 2);
    CHECK(colour_at(spans, 0) == 0);
    for (std::uint32_t unit = 1; unit < 7; ++unit) CHECK(colour_at(spans, unit) == 1);

    const style_span meet[] = {painted(3, 5, 2), painted(0, 2, 1), painted(2, 3, 3)};  // all in the b's grapheme
    REQUIRE_FALSE(spans.read(meet, found, 1));
    CHECK(spans.moved() == 4);
    for (std::uint32_t unit = 0; unit < 7; ++unit)
        CHECK(colour_at(spans, unit) == (unit < 4 ? 1u : unit == 4 ? 2u : 0u));
}

TEST_CASE("spans that overlap or are nonsense are refused, and leave none", "[paragraph][styles]")
{
    const text_analysis found = analysed("abcdef");
    style_spans spans;
    const auto refusal = [&](const std::vector<style_span>& given, std::uint32_t faces = 1) {
        const error e = spans.read(given, found, faces);
        CHECK(spans.empty());
        CHECK(spans.borders().empty());
        return e;
    };
    const error nested = refusal({painted(1, 5, 1), painted(2, 3, 2)});
    CHECK(nested == error::overlapping_spans);
    CHECK(nested.cluster == 2);
    CHECK(refusal({painted(3, 5, 1), painted(1, 4, 2)}) == error::overlapping_spans);
    CHECK(refusal({painted(3, 5, 1), painted(3, 5, 1)}) == error::overlapping_spans);
    for (const style_span& s : {painted(3, 2, 1), painted(3, 7, 1), painted(7, 7, 1)})
        CHECK(std::string{refusal({s}).option} == "spans");
    CHECK(refusal({{0, 1, {.face = 2}}}, 2) == error::no_such_face);
    constexpr double endless = std::numeric_limits<double>::infinity();
    CHECK(std::string{refusal({{0, 1, {.size = 0.0}}}).option} == "size");
    CHECK(std::string{refusal({{0, 1, {.size = endless}}}).option} == "size");
    CHECK(std::string{refusal({{0, 1, {.letter_spacing = endless}}}).option} == "letter_spacing");
    CHECK(std::string{refusal({{0, 1, {.word_spacing = endless}}}).option} == "word_spacing");
    CHECK(std::string{refusal({{0, 1, {.rise = endless}}}).option} == "rise");
    CHECK(std::string{refusal({{0, 1, {.slant = -endless}}}).option} == "slant");
}

TEST_CASE("spans mean the same in any order", "[paragraph][styles]")
{
    const std::u16string text = u"ab\u0301c\u0301\u0302 d\U0001F1E6\U0001F1E8e";
    const text_analysis found = analysed(text);
    const auto size = static_cast<std::uint32_t>(text.size());
    std::mt19937 random{7};
    std::size_t accepted = 0;
    for (int round = 0; round < 4000; ++round) {
        std::vector<style_span> given(random() % 5);
        for (std::uint32_t i = 0; i < given.size(); ++i) {
            const auto a = static_cast<std::uint32_t>(random() % (size + 1)),
                       b = static_cast<std::uint32_t>(random() % (size + 1));
            given[i] = painted(std::min(a, b), std::max(a, b), i + 1);
            if (random() % 2 == 0) given[i].style.size = 2.0;
        }
        std::size_t most = 0;  // spans that hold one unit
        for (std::uint32_t unit = 0; unit < size; ++unit)
            most = std::max(
                most, static_cast<std::size_t>(std::count_if(given.begin(), given.end(), [&](const style_span& s) {
                    return s.first <= unit && unit < s.last;
                })));
        style_spans spans, shuffled;
        const error e = spans.read(given, found, 1);
        CHECK((e == error::overlapping_spans) == (most > 1));
        std::shuffle(given.begin(), given.end(), random);
        CHECK(shuffled.read(given, found, 1).code == e.code);
        accepted += e ? 0u : 1u;
        for (std::uint32_t unit = 0, begin = 0; unit < size; ++unit) {
            if (has(found.marks[unit], text_mark::grapheme)) begin = unit;
            CHECK(colour_at(spans, unit) == colour_at(shuffled, unit));
            CHECK(colour_at(spans, unit) == colour_at(spans, begin));  // graphemes are whole
            const text_range alike = spans.range_at(unit);
            CHECK((alike.first <= unit && unit < alike.last));
            CHECK(spans.number_at(alike.first) == spans.number_at(unit));
            CHECK(spans.number_at((alike.last < size ? alike.last : size) - 1) == spans.number_at(unit));
            const auto own = std::find_if(given.begin(), given.end(),
                                          [&](const style_span& s) { return s.first <= begin && begin < s.last; });
            if (!e && own != given.end()) CHECK(spans[spans.number_at(begin)].style == own->style.style);
        }
        for (const std::uint32_t at : spans.borders()) CHECK((at == size || has(found.marks[at], text_mark::grapheme)));
    }
    CHECK(accepted > 500);
}

TEST_CASE("spans without memory say so", "[paragraph][styles]")
{
    const text_analysis found = analysed("abcdef");
    const style_span given[] = {{0, 1, {.size = 2.0}}, {3, 4, {.size = 2.0}}};
    const std::size_t needed = test::check_each_failure([&](memory source) {
        style_spans spans{source};
        const error e = spans.read(given, found, 1);
        CHECK(spans.empty() == bool(e));
        return e;
    });
    CHECK(needed >= 2);
}
