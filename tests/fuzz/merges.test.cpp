// SPDX-License-Identifier: MIT

#include "merges.hpp"
#include "replay.hpp"

TEST_CASE("glyphs that are kept, and random ones, are merged to what they fill together", "[fuzz]")
{
    fuzz::replay("merges", fuzz::merges, 500, 48);
}
