// SPDX-License-Identifier: MIT

#include "corners.hpp"
#include "replay.hpp"

TEST_CASE("every edge of kept and random letters whose corners are parted or joined has two faces", "[fuzz]")
{
    fuzz::replay("corners", fuzz::corners, 400, 120);
}
