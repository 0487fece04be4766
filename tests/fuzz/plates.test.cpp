// SPDX-License-Identifier: MIT

#include "plates.hpp"
#include "replay.hpp"

TEST_CASE("kept and random layers become closed solids of slabs", "[fuzz]")
{
    fuzz::replay("plates", fuzz::plates, 1000, 200);
}
