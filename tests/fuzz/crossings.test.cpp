// SPDX-License-Identifier: MIT

#include "crossings.hpp"
#include "replay.hpp"

TEST_CASE("kept and random outlines whose curves nearly touch are filled as their curves require", "[fuzz]")
{
    fuzz::replay("crossings", fuzz::crossings, 300, 80);
}
