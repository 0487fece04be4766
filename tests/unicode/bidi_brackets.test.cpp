// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/impl/bidi_brackets.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// The pairs of a text as UAX #9 lists them: the places of both brackets, sorted by the first.
std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_of(const std::u32string& text)
{
    std::vector<bidi_class> classes;
    std::vector<std::uint32_t> places;
    for (const char32_t c : text) {
        classes.push_back(character_of(c).bidi);
        places.push_back(static_cast<std::uint32_t>(places.size()));
    }
    std::vector<detail::opened_bracket> opened(text.size() + 1);
    const std::size_t count = detail::pair_brackets(
        {classes.data(), places.data(), text.size(), 0, bidi_class::l, bidi_class::l}, text.data(), opened.data());
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < count; ++i)
        if (opened[i].closing != detail::opened_bracket::none) pairs.emplace_back(opened[i].place, opened[i].closing);
    return pairs;
}

using pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

}  // namespace

// The examples of UAX #9, 3.1.3.
TEST_CASE("brackets are paired by definition BD16", "[bidi]")
{
    CHECK(pairs_of(U"a)b(c").empty());
    CHECK(pairs_of(U"a(b]c").empty());
    CHECK(pairs_of(U"a(b)c") == pairs{{1, 3}});
    CHECK(pairs_of(U"a(b[c)d]") == pairs{{1, 5}});
    CHECK(pairs_of(U"a(b]c)d") == pairs{{1, 5}});
    CHECK(pairs_of(U"a(b)c)d") == pairs{{1, 3}});
    CHECK(pairs_of(U"a(b(c)d") == pairs{{3, 5}});
    CHECK(pairs_of(U"a(b(c)d)") == pairs{{1, 7}, {3, 5}});
    CHECK(pairs_of(U"a(b{c}d)") == pairs{{1, 7}, {3, 5}});
}

TEST_CASE("canonically equivalent brackets make a pair", "[bidi]")
{
    CHECK(pairs_of(U"\u2329a\u3009") == pairs{{0, 2}});
    CHECK(pairs_of(U"\u3008a\u232A") == pairs{{0, 2}});
    CHECK(opening_bracket(0x232A, bracket_kind::closing) == opening_bracket(0x3008, bracket_kind::opening));
}

TEST_CASE("each bracket has an opening bracket, which is its own", "[bidi]")
{
    std::size_t closing = 0;
    for (char32_t c = 0; c < 0x110000; ++c) {
        const bracket_kind kind = character_of(c).bracket;
        if (kind == bracket_kind::none) continue;
        const char32_t opening = opening_bracket(c, kind);
        CHECK(character_of(opening).bracket == bracket_kind::opening);
        CHECK(opening_bracket(opening, bracket_kind::opening) == opening);
        closing += kind == bracket_kind::closing ? 1 : 0;
    }
    CHECK(closing == 64);
}

TEST_CASE("the 64th open bracket ends the search for pairs", "[bidi]")
{
    const std::u32string text = U"()" + std::u32string(63, U'(') + std::u32string(63, U')');
    CHECK(pairs_of(text).size() == 64);
    CHECK(pairs_of(U"()" + std::u32string(64, U'(') + std::u32string(64, U')')) == pairs{{0, 1}});
}

TEST_CASE("both brackets and the marks on them take a direction", "[bidi]")
{
    using enum bidi_class;
    const std::vector<bidi_class> given{r, on, on, l, on, on, r}, original{r, on, nsm, l, on, nsm, r};
    const std::vector<std::uint32_t> places{0, 1, 2, 3, 4, 5, 6};
    const auto resolved = [&](std::uint8_t level, bidi_class inside) {
        std::vector<bidi_class> classes = given;
        std::vector<detail::opened_bracket> opened{{1, 4, bidi_classes{inside}}};
        detail::resolve_brackets({classes.data(), places.data(), 7, level, l, l}, original.data(), opened.data(), 1);
        return classes;
    };
    CHECK(resolved(0, l) == std::vector<bidi_class>{r, l, l, l, l, l, r});  // the embedding's, which is between them
    CHECK(resolved(1, l) == std::vector<bidi_class>{r, r, r, l, r, r, r});  // the context's, if only the other is
    CHECK(resolved(0, on) == given);                                        // none without a letter between them
}
