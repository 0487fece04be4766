// SPDX-License-Identifier: MIT

#include "refinements.hpp"
#include "replay.hpp"

TEST_CASE("kept and random shapes are refined validly by both refiners", "[fuzz]")
{
    fuzz::replay("refinements", fuzz::refinements, 150, 120);
}
