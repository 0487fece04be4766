// SPDX-License-Identifier: MIT

#include "calls.hpp"
#include "replay.hpp"

TEST_CASE("kept and random sequences of calls make what a fresh mesher makes", "[fuzz]")
{
    fuzz::replay("calls", fuzz::calls, 60, 120);
}
