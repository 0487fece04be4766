// SPDX-License-Identifier: MIT

#include "paths.hpp"
#include "replay.hpp"

TEST_CASE("kept and random path data is drawn up to its mistake, and written and read again", "[fuzz]")
{
    fuzz::replay("paths", fuzz::paths, 3000, 100);
}
