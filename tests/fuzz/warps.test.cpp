// SPDX-License-Identifier: MIT

#include "warps.hpp"
#include "replay.hpp"

TEST_CASE("kept and random outlines are warped within their tolerances, by every warp", "[fuzz]")
{
    fuzz::replay("warps", fuzz::warps, 200, 80);
}
