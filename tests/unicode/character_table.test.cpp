// SPDX-License-Identifier: MIT
#include "unicode/table_maker.hpp"

TEST_CASE("character_table.hpp is what the Unicode Character Database gives", "[tables]")
{
    if (!ucd::is_of_our_version()) return;
    ucd::check_or_make("character_table.hpp", ucd::character_table());
}
