// SPDX-License-Identifier: MIT

#include <typemesh/glyph/pinned_glyphs.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <map>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// A cache that counts the pins of each glyph, and how often it was asked to take some back.
struct counting_cache {
    std::map<const built_glyph*, int> pins;
    int calls = 0;

    const built_glyph* pinned(std::size_t i)
    {
        const auto* glyph = reinterpret_cast<const built_glyph*>(blocks + i);  // never looked into
        ++pins[glyph];
        return glyph;
    }
    void release(std::span<const built_glyph* const> glyphs) noexcept
    {
        ++calls;
        for (const built_glyph* g : glyphs)
            if (g != nullptr) --pins[g];
    }
    [[nodiscard]] int left() const
    {
        int sum = 0;
        for (const auto& [glyph, count] : pins) sum += count;
        return sum;
    }

    double blocks[8] = {};
};

}  // namespace

TEST_CASE("every pin is given back once: by release, clear, another text, or the end", "[glyph][pinned_glyphs]")
{
    counting_cache cache;
    {
        pinned_glyphs held;
        for (int round = 0; round < 3; ++round) {
            REQUIRE(held.reserve(5, &cache));  // gives back what the round before has left
            CHECK(cache.left() == 0);
            for (std::size_t i = 0; i < 5; ++i) CHECK(held[i] == nullptr);
            for (std::size_t i = 0; i < 4; ++i) held.set(i, cache.pinned(i));
            CHECK(held[2] == reinterpret_cast<const built_glyph*>(cache.blocks + 2));
            CHECK(cache.left() == 4);
            if (round == 1) held.release(), held.release();
            if (round == 1) CHECK(cache.left() == 0);
        }
        CHECK(cache.left() == 4);
        pinned_glyphs moved{std::move(held)};
        CHECK(cache.left() == 4);
        held = std::move(moved);
        CHECK(cache.left() == 4);
    }
    CHECK(cache.left() == 0);
    CHECK(cache.calls == 3);
}

TEST_CASE("glyphs that nobody pins are given back to nobody", "[glyph][pinned_glyphs]")
{
    counting_cache cache;
    pinned_glyphs held;
    REQUIRE(held.reserve(3, &cache));
    REQUIRE(held.reserve(3));
    CHECK(cache.calls == 1);
    held.set(1, reinterpret_cast<const built_glyph*>(cache.blocks));
    held.clear();
    CHECK(cache.calls == 1);
}

TEST_CASE("room that the memory does not give pins nothing", "[glyph][pinned_glyphs]")
{
    counting_cache cache;
    test::counting_memory failing{.fail_at = 1};
    {
        pinned_glyphs held{failing.source()};
        CHECK_FALSE(held.reserve(1000, &cache));
    }
    CHECK(cache.calls == 0);
}
