// SPDX-License-Identifier: MIT

#include "polylines.hpp"
#include "replay.hpp"

TEST_CASE("polylines that are kept, and random ones, are filled and triangulated", "[fuzz]")
{
    fuzz::replay("polylines", fuzz::polylines, 800, 96);
}
