// SPDX-License-Identifier: MIT

#include "markup.hpp"
#include "replay.hpp"

TEST_CASE("kept and random sources of mark-up lose no letter, and are printed and read again", "[fuzz]")
{
    fuzz::replay("markup", fuzz::markup, 3000, 100);
}
