// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"
#include "support/laid_paragraph.hpp"

#include <string>

using namespace typemesh;

namespace {

std::size_t graphemes(const std::u16string& text)
{
    text_analysis found = test::analysed(text);
    keep_syllables_whole(text, found);
    std::size_t n = 0;
    for (const text_mark m : found.marks) n += has(m, text_mark::grapheme) ? 1u : 0u;
    return n;
}

}  // namespace

TEST_CASE("vowels and tones of Burmese are of their consonant's grapheme", "[paragraph]")
{
    CHECK(graphemes(u"\u1000\u1019\u1039\u1018\u102C\u101C\u1030\u101E\u102C\u1038") == 4);
    CHECK(graphemes(u"\u102C\u1000") == 2);  // nothing stands before
    CHECK(graphemes(u" \u102C") == 2);       // or no letter
    CHECK(graphemes(u"a\u102C\u102C") == 3);
    CHECK(graphemes(u"\u0E01\u0E32") == 2);  // Thai has its vowels apart
}

TEST_CASE("no line, no ellipsis and no caret parts a stack of Khmer or Burmese", "[paragraph]")
{
    const std::u16string khmer = u"\u179F\u178F\u17B7\u179F\u1798\u17D2\u1794\u1787\u1789\u17D2\u1789\u17C8";
    const std::u16string burmese =
        u"\u1000\u1019\u1039\u1018\u102C\u101C\u1030\u1019\u1004\u103A\u1039\u1002\u101C\u102C";
    for (const std::u16string& text : {khmer, burmese}) {
        const auto is_inner = [&](std::size_t i) {  // a sign, or a letter that one stacks
            const line_class line = character_of(text[i]).line;
            return line == line_class::sa_mark || (i > 0 && (text[i - 1] == 0x17D2 || text[i - 1] == 0x1039));
        };
        test::laid_paragraph<> p{text};
        for (const wrap_mode wrap : {wrap_mode::word_or_grapheme, wrap_mode::grapheme})
            for (double width = 0.1; width < 8.0; width += 0.1) {
                p.again({.width = width, .wrap = wrap});
                for (const laid_line& line : p.words.lines()) CHECK_FALSE(is_inner(line.first));
                p.again({.width = width, .wrap = wrap, .max_lines = 1, .ellipsis = "."});
                const std::size_t shown = p.run.glyphs.size() - p.count('.');
                if (shown < text.size()) CHECK_FALSE(is_inner(shown));
            }
        p.again({});
        for (std::uint32_t i = 0; i < text.size(); ++i)
            if (is_inner(i)) CHECK(p.laid().caret_at(i).at == p.laid().caret_at(i - 1).at);
    }
}
