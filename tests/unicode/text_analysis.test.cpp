// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"

#include <typemesh/unicode/text_analysis.hpp>

using namespace typemesh;

TEST_CASE("each unit belongs to the paragraph that contains it", "[analysis]")
{
    const text_analysis found = test::analysed(u8"ab\n\nשל\n");
    REQUIRE(found.paragraphs.size() == 4);
    const int wanted[] = {0, 0, 0, 1, 2, 2, 2, 2, 2, 3};
    for (std::size_t i = 0; i < std::size(wanted); ++i)
        CHECK(&found.paragraph_of(i) == &found.paragraphs[static_cast<std::size_t>(wanted[i])]);
    CHECK(found.paragraph_of(4).level == 1);
    CHECK(found.paragraph_of(9).level == 0);
    CHECK(found.paragraph_of(100).first == 9);
}

TEST_CASE("a line of an analysis is ordered by the level of its paragraph", "[analysis]")
{
    text_analysis found = test::analysed(u"ab\nשל ab ");
    buffer<visual_run> runs;
    REQUIRE(visual_runs(found, {3, 9}, runs));
    REQUIRE(runs.size() == 3);
    CHECK((runs[0].first == 8 && runs[0].level == 1));  // the space at the end moves to the left end of the line
    CHECK((runs[1].first == 6 && runs[1].last == 8 && runs[1].level == 2));
    CHECK((runs[2].first == 3 && runs[2].last == 6));
    found.clear();
    CHECK(found.levels.empty());
    CHECK(found.paragraphs.empty());
}
