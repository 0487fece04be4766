// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/text_analyser.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

using namespace typemesh;

namespace {

/// Every letter is a line of its own, as a caller may write it over the ready analyser.
struct one_letter_a_line {
    unicode_analyser unicode;

    error analyse(text_view text, const analysis_options& how, text_analysis& found) noexcept
    {
        if (error e = unicode.analyse(text, how, found)) return e;
        for (text_mark& mark : found.marks)
            if (has(mark, text_mark::grapheme)) mark = mark | text_mark::may_break;
        return {};
    }
};
static_assert(text_analyser<one_letter_a_line>);

struct no_analyser {
    int analyse(text_view, const analysis_options&, text_analysis&) noexcept;
};
static_assert(!text_analyser<no_analyser>);
static_assert(!text_analyser<int>);

}  // namespace

TEST_CASE("an analyser over another may change its results", "[analysis]")
{
    one_letter_a_line analyser;
    text_analysis found;
    REQUIRE_FALSE(analyser.analyse("ab", {}, found));
    CHECK(has(found.marks[1], text_mark::may_break));
}
