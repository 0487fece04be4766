// SPDX-License-Identifier: MIT

#include "solids.hpp"
#include "replay.hpp"

TEST_CASE("solids of polylines that are kept, and of random ones, are closed and as large as they should be", "[fuzz]")
{
    fuzz::replay("solids", fuzz::solids, 700, 120);
}
