// SPDX-License-Identifier: MIT

#include "offset/swept_hash.hpp"

#include "support/catch.hpp"

TEST_CASE("what is swept is the same, bit for bit, where the compiler has no integers of 128 bits", "[offset]")
{
    const swept_hash hash = hash_of_stars();
    CHECK(hash.failures == 0);
    CHECK(hash.triangles > 10'000);
    CHECK(hash.joins > 1000);
    CHECK(hash.value == test::hash_without_int128());
}
