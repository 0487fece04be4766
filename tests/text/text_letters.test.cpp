// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/required.hpp"
#include "support/toy_runs.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

TEST_CASE("a bar has a line and the word that it goes with, and its motion comes after those of the letters",
          "[letters]")
{
    const glyph_run run = test::run_of({{2, no_cluster, {0, -300}}, {5, 0, {0, 0}}, {5, 1, {600, 0}}});
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan(run));
    REQUIRE(plan->find_letters("ii"));
    std::uint32_t asked = 0;
    (void)plan->moved_bounds([&](const letter_place& l) noexcept {
        CHECK(l.is_bar() == (asked == 2));
        CHECK(l.word.count == 2);
        CHECK(l.line.count == 2);
        ++asked;
        return affine3{};
    });
    CHECK(asked == 3);
}

TEST_CASE("another plan of the mesher has no letters yet", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oE"));
    REQUIRE(plan->find_letters("oE"));
    plan->write_instances([](const glyph_instance& drawn) noexcept { CHECK(drawn.letter == drawn.glyph); });
    plan = test::required(mesher.plan("oEx"));
    plan->write_instances([](const glyph_instance& drawn) noexcept { CHECK(drawn.letter == not_a_letter); });
    REQUIRE(plan->find_letters("oEx"));
    CHECK(plan->letters().letters.size() == 3);
}
