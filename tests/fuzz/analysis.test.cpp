// SPDX-License-Identifier: MIT

#include "analysis.hpp"
#include "replay.hpp"

TEST_CASE("kept and random texts are analysed alike in both encodings", "[fuzz]")
{
    fuzz::replay("analysis", fuzz::analysis, 4000, 200);
}
