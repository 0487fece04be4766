// SPDX-License-Identifier: MIT

#include "paragraphs.hpp"
#include "replay.hpp"

TEST_CASE("paragraphs that are kept, and random ones, are whole, and their carets lead back", "[fuzz]")
{
    fuzz::replay("paragraphs", fuzz::paragraphs, 2000, 160);
}
