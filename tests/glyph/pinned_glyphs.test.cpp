// SPDX-License-Identifier: MIT

#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/glyph/impl/pinned_glyphs.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <utility>

using namespace typemesh;

namespace {

/// Counts the calls of its cache.
struct counting_lock {
    static inline int calls = 0;

    void lock() noexcept { ++calls; }
    void unlock() noexcept {}
};

using cache_type = glyph_cache<counting_lock>;

/// A blank glyph, pinned.
const built_glyph* pinned(cache_type& cache, glyph_id id)
{
    const built_glyph* found = cache.find({}, id);
    return found != nullptr ? found : cache.keep({}, id, {});
}

/// How many calls it has had since the last time.
int calls() { return std::exchange(counting_lock::calls, 0); }

}  // namespace

TEST_CASE("every pin is returned once: by release, by another text, or at the end", "[glyph][pinned_glyphs]")
{
    cache_type cache;
    {
        pinned_glyphs held;
        for (int round = 0; round < 3; ++round) {
            REQUIRE(held.reserve(5, cache, 5));  // gives back what the round before has left
            CHECK(cache.statistics().pinned == 0);
            for (std::size_t i = 0; i < 5; ++i) CHECK(held[i] == nullptr);
            for (std::size_t i = 0; i < 4; ++i) held.set(i, pinned(cache, static_cast<glyph_id>(i)));
            cache.clear();
            CHECK(cache.statistics().entries == 4);
            CHECK(cache.statistics().pinned == 4);
            if (round == 1) held.release(), held.release();
            if (round == 1) CHECK(cache.statistics().pinned == 0);
        }
        CHECK(cache.statistics().pinned == 4);
        pinned_glyphs moved{std::move(held)};
        CHECK(cache.statistics().pinned == 4);
        held = std::move(moved);
        CHECK(cache.statistics().pinned == 4);
    }
    CHECK(cache.statistics().pinned == 0);
}

TEST_CASE("unpinned glyphs are not returned to a cache", "[glyph][pinned_glyphs]")
{
    cache_type cache;
    pinned_glyphs held;
    calls();
    REQUIRE(held.reserve(3, cache, 3));
    REQUIRE(held.reserve(3));
    CHECK(calls() == 1);
    const built_glyph* one = pinned(cache, 1);
    held.set(1, one);
    calls();
    held.clear();
    CHECK(calls() == 0);
    cache.release({&one, 1});
}

TEST_CASE("nothing is pinned if memory has run out", "[glyph][pinned_glyphs]")
{
    cache_type cache;
    test::counting_memory failing{.fail_at = 1};
    calls();
    {
        pinned_glyphs held{failing.source()};
        CHECK_FALSE(held.reserve(1000, cache, 1000));
    }
    CHECK(calls() == 0);
}
