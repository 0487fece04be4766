// SPDX-License-Identifier: MIT

#include "merges.hpp"
#include "replay.hpp"

TEST_CASE("kept and random glyphs are merged to what they fill together", "[fuzz]")
{
    fuzz::replay("merges", fuzz::merges, 500, 48);
}
