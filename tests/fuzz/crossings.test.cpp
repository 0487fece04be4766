// SPDX-License-Identifier: MIT

#include "crossings.hpp"
#include "replay.hpp"

TEST_CASE("outlines that are kept, and random ones whose curves nearly touch, are filled as the curves say", "[fuzz]")
{
    fuzz::replay("crossings", fuzz::crossings, 300, 80);
}
