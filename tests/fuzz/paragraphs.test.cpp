// SPDX-License-Identifier: MIT

#include "paragraphs.hpp"
#include "replay.hpp"

TEST_CASE("kept and random paragraphs are complete, and their carets lead back", "[fuzz]")
{
    fuzz::replay("paragraphs", fuzz::paragraphs, 2000, 160);
}
