// SPDX-License-Identifier: MIT
#include "support/analysed.hpp"

#include <typemesh/unicode/impl/dictionary_script.hpp>

using namespace typemesh;

TEST_CASE("an analyser without a dictionary leaves the sample words of its script unbroken", "[unicode]")
{
    for (const dictionary_script& s : dictionary_scripts) {
        INFO(s.language);
        const text_analysis found = test::analysed(s.words);
        REQUIRE(found.unbroken.size() == 1);
        CHECK((found.unbroken[0].first == 0 && found.unbroken[0].last == s.words.size()));
        REQUIRE(found.scripts.size() == 1);
        CHECK(found.scripts[0].script == s.tag);
        REQUIRE(s.second_word > 1);
        REQUIRE(s.second_word < s.words.size());
        CHECK(has(found.marks[s.second_word], text_mark::grapheme));
    }
}

TEST_CASE("a script without a dictionary has a number after the list", "[unicode]")
{
    for (std::size_t k = 0; k < dictionary_script_count; ++k)
        CHECK(dictionary_script_number(dictionary_scripts[k].tag) == k);
    CHECK(dictionary_script_number(script_tag("Latn")) == dictionary_script_count);
    CHECK(dictionary_script_number(0) == dictionary_script_count);
}
