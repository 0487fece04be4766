// SPDX-License-Identifier: MIT

#include "bends.hpp"
#include "replay.hpp"

TEST_CASE("kept and random shapes are bent within their tolerances, by every deformation", "[fuzz]")
{
    fuzz::replay("bends", fuzz::bends, 150, 120);
}
