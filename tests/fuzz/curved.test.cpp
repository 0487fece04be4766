// SPDX-License-Identifier: MIT

#include "curved.hpp"
#include "replay.hpp"

TEST_CASE("kept and random outlines are filled by curved triangles as their curves require", "[fuzz]")
{
    fuzz::replay("curved", fuzz::curved, 200, 80);
}
