// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/unicode/impl/script_runs.hpp>

#include <random>
#include <string>

using namespace typemesh;

namespace {

/// The runs of a text, with script and length, as "Latn3 Hebr4".
std::string runs_of(const std::u32string& text)
{
    buffer<script_run> runs;
    script_itemiser itemiser{runs};
    std::uint32_t place = 0;
    for (const char32_t c : text) REQUIRE_FALSE(itemiser.add(c, character_of(c).bracket, place++));
    REQUIRE_FALSE(itemiser.end(place));
    std::string s;
    std::uint32_t end = 0;
    for (const script_run& run : runs) {
        REQUIRE(run.first == end);
        REQUIRE(run.last > run.first);
        end = run.last;
        if (!s.empty()) s += ' ';
        for (int shift = 24; shift >= 0; shift -= 8) s += static_cast<char>(run.script >> shift & 0xFF);
        s += std::to_string(run.last - run.first);
    }
    REQUIRE(end == text.size());
    return s;
}

}  // namespace

TEST_CASE("a text is cut where its script changes", "[script]")
{
    CHECK(runs_of(U"") == "");
    CHECK(runs_of(U"Hello") == "Latn5");
    CHECK(runs_of(U"123 %") == "Zyyy5");
    CHECK(runs_of(U"12 Hello, 34!") == "Latn13");
    CHECK(runs_of(U"Hello שלום 5") == "Latn6 Hebr6");
    CHECK(runs_of(U"漢字かなカナ") == "Hani6");  // one script for shapers
    CHECK(runs_of(U"かな漢字、ㄅ한") == "Hira6 Hang1");
    CHECK(runs_of(U"カ漢b漢") == "Kana2 Latn1 Hani1");
    CHECK(runs_of(U"カー") == "Kana2");
    CHECK(runs_of(U"ーカ") == "Kana2");
    CHECK(runs_of(U"e\u0301") == "Latn2");
}

TEST_CASE("a closing bracket has the script of its opening bracket", "[script]")
{
    CHECK(runs_of(U"ab (שלום) 1") == "Latn4 Hebr4 Latn3");
    CHECK(runs_of(U"ab (שלום [мир] ש) cd") == "Latn4 Hebr6 Cyrl3 Hebr3 Latn4");
    CHECK(runs_of(U"(ab)") == "Latn4");
    CHECK(runs_of(U"(ab מ)") == "Latn4 Hebr1 Latn1");
    CHECK(runs_of(U"ab)ש)") == "Latn3 Hebr2");
    CHECK(runs_of(U"ab[ש)") == "Latn3 Hebr2");
    std::u32string deep(100, U'(');
    deep += U"aש";
    deep.append(100, U')');
    CHECK(runs_of(deep) == "Latn101 Hebr1 Latn100");
}

TEST_CASE("the runs of any text follow each other, and neighbours differ", "[script]")
{
    std::mt19937 random{2};
    const std::u32string letters = U"ab 12()[]שлカー漢\u0301\u0951\u0660।\u060C";
    for (int repeat = 0; repeat < 500; ++repeat) {
        std::u32string text(random() % 40, U' ');
        for (char32_t& c : text) c = letters[random() % letters.size()];
        runs_of(text);
    }
}

TEST_CASE("script runs report that memory ran out", "[script]")
{
    test::counting_memory heap{.fail_at = 1};
    buffer<script_run> runs{heap.source()};
    script_itemiser itemiser{runs};
    CHECK_FALSE(itemiser.add(U'a', bracket_kind::none, 0));
    CHECK(itemiser.end(1) == error::out_of_memory);
}
