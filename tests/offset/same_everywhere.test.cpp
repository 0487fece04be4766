// SPDX-License-Identifier: MIT

#include "offset/swept_hash.hpp"

#include "support/catch.hpp"

TEST_CASE("a sweep is the same, bit for bit, with and without 128-bit integers of the compiler", "[offset]")
{
    const swept_hash hash = hash_of_stars();
    CHECK(hash.failures == 0);
    CHECK(hash.triangles > 10'000);
    CHECK(hash.joins > 1000);
    CHECK(hash.value == test::hash_without_int128());
}
