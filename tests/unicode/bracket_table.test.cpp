// SPDX-License-Identifier: MIT
#include "unicode/table_maker.hpp"

TEST_CASE("bracket_table.hpp agrees with the Unicode Character Database", "[tables]")
{
    if (!ucd::is_of_our_version()) return;
    ucd::check_or_make("bracket_table.hpp", ucd::bracket_table());
}
