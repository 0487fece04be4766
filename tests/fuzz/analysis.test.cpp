// SPDX-License-Identifier: MIT

#include "analysis.hpp"
#include "replay.hpp"

TEST_CASE("texts that are kept, and random ones, are analysed alike in both encodings", "[fuzz]")
{
    fuzz::replay("analysis", fuzz::analysis, 4000, 200);
}
