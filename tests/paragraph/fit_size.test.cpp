// SPDX-License-Identifier: MIT
#include "support/laid_paragraph.hpp"

#include <typemesh/paragraph/fit_size.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#include <algorithm>
#include <limits>
#include <string>

using namespace typemesh;

namespace fit_size_tests {
namespace {

const std::u16string sample =
    u"AVATAR of the fifth office, \u05D0\u05D1 12 \u05D2\u05D3 and fi\u00ADfi.\nThe next a\u0301\u0302b\tline  ends "
    u"here";

template <class Breaker = first_fit>
struct fitted : test::laid_paragraph<test::toy_shaper, Breaker> {
    layout_options how;

    explicit fitted(text_view shown, const layout_options& options = {})
        : test::laid_paragraph<test::toy_shaper, Breaker>{shown}, how{options}
    {
    }
    double size(double width, double height)
    {
        const auto found = fit_size(this->words, width, height, how);
        REQUIRE(found);
        return *found;
    }
    /// Measured from the lines themselves.
    bool fits(double size, double width, double height, wrap_mode wrap)
    {
        layout_options at = how;
        at.width = width / size;
        at.wrap = wrap;
        at.anchor = vertical_anchor::top;
        this->again(at);
        const auto lines = this->words.lines();
        double longest = 0.0;
        for (const laid_line& line : lines) longest = (std::max)(longest, line.width);
        const double high = 200.0 - lines.back().origin.y;  // the toy's descender is -200
        constexpr double rounding = 1.0 + 1e-9;
        return longest / 1000.0 * size <= width * rounding && high / 1000.0 * size <= height * rounding &&
               lines.back().last == this->words.shaped().text().size();
    }
};

}  // namespace
}  // namespace fit_size_tests

using namespace fit_size_tests;

TEST_CASE("the fitted size fits, and a size greater by a thousandth does not", "[paragraph]")
{
    for (const wrap_mode wrap : {wrap_mode::none, wrap_mode::word, wrap_mode::word_or_grapheme, wrap_mode::grapheme})
        for (const alignment align : {alignment::start, alignment::justify})
            for (double width = 0.5; width < 100.0; width *= 1.9)
                for (double height = 0.7; height < 60.0; height *= 2.3) {
                    fitted<> p{sample, {.wrap = wrap, .align = align}};
                    const double size = p.size(width, height);
                    INFO(static_cast<int>(wrap) << ": " << width << " x " << height << ": " << size);
                    CHECK(p.fits(size, width, height, wrap));
                    const wrap_mode whole = wrap == wrap_mode::word_or_grapheme ? wrap_mode::word : wrap;
                    CHECK_FALSE(p.fits(1.001 * size, width, height, whole));
                }
}

TEST_CASE("the box decides: its height for a short text, its width for a long line", "[paragraph]")
{
    fitted<> word{u"abcd"};
    CHECK(word.size(100.0, 9.0) == Approx(10.0));  // ascender and descender are 0.9 em
    CHECK(word.size(3.0, 9.0) == Approx(1.5));     // no word is broken
    CHECK(fitted<>{u"ab\ncd"}.size(50.0, 9.5) == Approx(5.0));
    fitted<> columns{u"abcd", {.wrap = wrap_mode::grapheme}};
    CHECK(columns.size(3.0, 9.0) == Approx(3.0));  // two letters a line would be 1.9 em high
    fitted<> two{u"aa bb cc dd", {.max_lines = 2}};
    CHECK(two.size(4.5, 100.0) == Approx(2.0).epsilon(1e-5));
}

TEST_CASE("a size is found with total_fit, and the text fits at it", "[paragraph]")
{
    for (double width = 2.0; width < 60.0; width *= 1.7) {
        fitted<total_fit> p{sample, {.align = alignment::justify}};
        CHECK(p.fits(p.size(width, 10.0), width, 10.0, wrap_mode::word_or_grapheme));
    }
}

TEST_CASE("a text of nothing has a size, too", "[paragraph]")
{
    CHECK(fitted<>{u""}.size(3.0, 9.0) == Approx(10.0));
    CHECK(fitted<>{u"   "}.size(3.0, 9.0) == Approx(10.0));
}

TEST_CASE("fit_size refuses boxes of no size, and what can never fit", "[paragraph]")
{
    fitted<> p{u"a b"};
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double bad : {0.0, -1.0, infinite, std::numeric_limits<double>::quiet_NaN()}) {
        CHECK(fit_size(p.words, bad, 1.0).error() == error::bad_option);
        CHECK(fit_size(p.words, 1.0, bad).error() == error::bad_option);
    }
    fitted<> lines{u"a\nb\nc"};
    CHECK(fit_size(lines.words, 1.0, 1.0, {.max_lines = 2}).error() == error::bad_option);
    CHECK(fit_size(p.words, 1.0, 1.0, {.indent = infinite}).error() == error::bad_option);
    test::toy_shaper font;
    paragraph<test::toy_shaper> none{font};
    CHECK(fit_size(none, 1.0, 1.0).error() == error::bad_option);
}
