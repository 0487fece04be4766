// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/text/impl/glyph_set.hpp>

#include <map>
#include <random>
#include <vector>

using namespace typemesh;

TEST_CASE("different glyphs get the numbers 0, 1, 2, ... in the order in which they came, equal ones the same",
          "[text]")
{
    const glyph_id spread = GENERATE(10u, 300u, 70'000u, 0xFFFF'FFFFu);
    std::mt19937 random{7};
    glyph_set set;
    for (int text = 0; text < 3; ++text) {
        std::map<glyph_id, std::uint32_t> expected;
        for (int i = 0; i < 5000; ++i) {
            const glyph_id id = static_cast<glyph_id>(random()) % spread;
            const auto [known, fresh] = expected.try_emplace(id, static_cast<std::uint32_t>(expected.size()));
            REQUIRE(set.number_of({id, 0}) == known->second);
            REQUIRE(set.keys()[known->second] == glyph_key{id, 0});
        }
        CHECK(set.keys().size() == expected.size());
        set.clear();
        CHECK(set.keys().empty());
    }
}

TEST_CASE("a set whose memory fails says so and knows what it knew", "[text]")
{
    for (std::size_t n = 1; n < 14; ++n) {
        test::counting_memory counted{.fail_at = n, .fail_once = true};
        glyph_set set{counted.source()};
        std::size_t refused = 0;
        for (glyph_id id = 0; id < 300; ++id) {
            if (set.number_of({id, 0}) != glyph_set::no_room) continue;
            ++refused;
            REQUIRE(set.number_of({id, 0}) == id);
        }
        CHECK(refused == (n <= counted.requests ? 1u : 0u));
        CHECK(set.keys().size() == 300);
    }
}

TEST_CASE("a glyph in two glyph styles is two glyphs", "[text]")
{
    glyph_set set;
    for (std::uint32_t style = 0; style < 50; ++style)
        for (glyph_id id = 0; id < 50; ++id) REQUIRE(set.number_of({id, style}) == 50 * style + id);
    for (std::uint32_t style = 0; style < 50; ++style)
        for (glyph_id id = 0; id < 50; ++id) REQUIRE(set.number_of({id, style}) == 50 * style + id);
    CHECK(set.keys()[61] == glyph_key{11, 1});
}
