// SPDX-License-Identifier: MIT

#include "polylines.hpp"
#include "replay.hpp"

TEST_CASE("kept and random polylines are filled and triangulated", "[fuzz]")
{
    fuzz::replay("polylines", fuzz::polylines, 800, 96);
}
