// SPDX-License-Identifier: MIT

#include "reliefs.hpp"
#include "replay.hpp"

TEST_CASE("kept and random shapes become closed balloons, domes and carved letters", "[fuzz]")
{
    fuzz::replay("reliefs", fuzz::reliefs, 150, 120);
}
