// SPDX-License-Identifier: MIT

#include <typemesh/glyph/impl/glyph_store.hpp>

#include "draft.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <cstdint>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

std::vector<test::draft> drafts(std::uint64_t seed, int count)
{
    test::dice d{seed};
    std::vector<test::draft> all;
    for (int i = 0; i < count; ++i) all.emplace_back(d);
    return all;
}

}  // namespace

TEST_CASE("a store keeps every glyph in its place when more follow", "[glyph][glyph_store]")
{
    test::counting_memory memory;
    {
        glyph_store store{memory.source()};
        for (int round = 0; round < 4; ++round) {
            const auto given = drafts(static_cast<std::uint64_t>(round), 400);
            std::vector<const built_glyph*> kept;
            for (const test::draft& g : given) {
                kept.push_back(store.keep(g.parts()));
                REQUIRE(kept.back() != nullptr);
                REQUIRE(reinterpret_cast<std::uintptr_t>(kept.back()) % alignof(built_glyph) == 0);
            }
            for (std::size_t i = 0; i < given.size(); ++i) REQUIRE(given[i].is(*kept[i]));
            glyph_store moved{std::move(store)};
            for (std::size_t i = 0; i < given.size(); ++i) REQUIRE(given[i].is(*kept[i]));
            store = std::move(moved);
            store.clear();
        }
    }
    CHECK(memory.bytes_held == 0);
}

TEST_CASE("a cleared store requests no memory until it holds more than before", "[glyph][glyph_store]")
{
    test::counting_memory memory;
    glyph_store store{memory.source()};
    const auto given = drafts(7, 500);
    std::size_t after_first = 0;
    for (int round = 0; round < 5; ++round) {
        for (const test::draft& g : given) REQUIRE(store.keep(g.parts()) != nullptr);
        store.clear();
        if (round == 0) after_first = memory.requests;
        CHECK(memory.requests == after_first);
    }
}

TEST_CASE("a store reports a lack of memory and keeps its glyphs", "[glyph][glyph_store]")
{
    test::counting_memory memory{.fail_at = 3};
    {
        glyph_store store{memory.source()};
        const auto given = drafts(8, 2000);
        std::vector<const built_glyph*> kept;
        for (const test::draft& g : given) {
            const built_glyph* made = store.keep(g.parts());
            if (made == nullptr) break;
            kept.push_back(made);
        }
        REQUIRE(kept.size() < given.size());
        for (std::size_t i = 0; i < kept.size(); ++i) REQUIRE(given[i].is(*kept[i]));
        CHECK(store.keep(given[kept.size()].parts()) == nullptr);
    }
    CHECK(memory.bytes_held == 0);
}
