// SPDX-License-Identifier: MIT

#include "tubes.hpp"
#include "replay.hpp"

TEST_CASE("kept and random shapes become closed tubes that do not meet", "[fuzz]")
{
    fuzz::replay("tubes", fuzz::tubes, 600, 200);
}
