// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/impl/bidi_sequence.hpp>

#include <vector>

using namespace typemesh;
using enum bidi_class;

namespace {

using classes = std::vector<bidi_class>;

/// A rule applied to a sequence of level 0 or 1 between two letters.
template <class Rule>
classes after(Rule rule, bidi_class start, classes given, bidi_class end, std::uint8_t level = 0)
{
    rule(detail::bidi_sequence{given.data(), nullptr, given.size(), level, start, end});
    return given;
}

const auto mark_rules = [](const detail::bidi_sequence& s) { detail::resolve_marks(s); };
const auto number_rules = [](const detail::bidi_sequence& s) { detail::resolve_numbers(s); };
const auto neutral_rules = [](const detail::bidi_sequence& s) { detail::resolve_neutrals(s); };

}  // namespace

// The examples of UAX #9, 3.3.4 and 3.3.6.
TEST_CASE("rules W1 to W3 resolve marks, Arabic numbers and letters", "[bidi]")
{
    CHECK(after(mark_rules, r, {al, nsm, nsm}, r) == classes{r, r, r});
    CHECK(after(mark_rules, r, {nsm}, r) == classes{r});
    CHECK(after(mark_rules, l, {lri, nsm}, l) == classes{lri, on});
    CHECK(after(mark_rules, l, {pdi, nsm}, l) == classes{pdi, on});
    CHECK(after(mark_rules, l, {al, en}, l) == classes{r, an});
    CHECK(after(mark_rules, l, {al, on, en}, l) == classes{r, on, an});
    CHECK(after(mark_rules, r, {on, en}, r) == classes{on, en});
    CHECK(after(mark_rules, l, {l, on, en}, l) == classes{l, on, en});
    CHECK(after(mark_rules, r, {r, on, en}, r) == classes{r, on, en});
}

TEST_CASE("rules W4 to W7 resolve separators, terminators and digits", "[bidi]")
{
    CHECK(after(number_rules, r, {en, es, en}, r) == classes{en, en, en});
    CHECK(after(number_rules, r, {en, cs, en}, r) == classes{en, en, en});
    CHECK(after(number_rules, r, {an, cs, an}, r) == classes{an, an, an});
    CHECK(after(number_rules, r, {an, es, an}, r) == classes{an, on, an});
    CHECK(after(number_rules, r, {en, cs, cs, en}, r) == classes{en, on, on, en});
    CHECK(after(number_rules, r, {en, cs, an}, r) == classes{en, on, an});
    CHECK(after(number_rules, r, {et, et, en}, r) == classes{en, en, en});
    CHECK(after(number_rules, r, {en, et, et}, r) == classes{en, en, en});
    CHECK(after(number_rules, r, {an, et, en}, r) == classes{an, en, en});
    CHECK(after(number_rules, r, {an, et}, r) == classes{an, on});
    CHECK(after(number_rules, r, {en, et, es, en}, r) == classes{en, en, on, en});
    CHECK(after(number_rules, r, {l, es, en}, r) == classes{l, on, l});
    CHECK(after(number_rules, r, {l, on, en, et}, r) == classes{l, on, l, l});
    CHECK(after(number_rules, r, {r, on, en}, r) == classes{r, on, en});
    CHECK(after(number_rules, l, {en, et}, r) == classes{l, l});
}

TEST_CASE("rules N1 and N2 give neutrals the direction on both sides, or else the embedding's", "[bidi]")
{
    CHECK(after(neutral_rules, l, {r, on, r}, l) == classes{r, r, r});
    CHECK(after(neutral_rules, l, {r, on, ws, an}, l) == classes{r, r, r, an});
    CHECK(after(neutral_rules, l, {an, on, en}, l) == classes{an, r, en});
    CHECK(after(neutral_rules, l, {r, on, l}, l, 0) == classes{r, l, l});
    CHECK(after(neutral_rules, l, {r, on, l}, l, 1) == classes{r, r, l});
    CHECK(after(neutral_rules, r, {on, on}, r, 0) == classes{r, r});
    CHECK(after(neutral_rules, l, {on, on}, r, 1) == classes{r, r});
    CHECK(after(neutral_rules, l, {}, r).empty());
}

TEST_CASE("rules I1 and I2 give letters and digits their levels", "[bidi]")
{
    CHECK(detail::implicit_level(0, l) == 0);
    CHECK(detail::implicit_level(0, r) == 1);
    CHECK(detail::implicit_level(0, an) == 2);
    CHECK(detail::implicit_level(0, en) == 2);
    CHECK(detail::implicit_level(1, l) == 2);
    CHECK(detail::implicit_level(1, r) == 1);
    CHECK(detail::implicit_level(1, an) == 2);
    CHECK(detail::implicit_level(125, en) == 126);
}
