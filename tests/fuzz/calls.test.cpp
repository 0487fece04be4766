// SPDX-License-Identifier: MIT

#include "calls.hpp"
#include "replay.hpp"

TEST_CASE("sequences of calls that are kept, and random ones, make what a fresh mesher makes", "[fuzz]")
{
    fuzz::replay("calls", fuzz::calls, 60, 120);
}
