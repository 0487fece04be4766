// SPDX-License-Identifier: MIT

#include "colours.hpp"
#include "replay.hpp"

TEST_CASE("kept and random colour tables become layers that tile their silhouette, or one error", "[fuzz]")
{
    fuzz::replay("colours", fuzz::colours, 500, 48);
}
