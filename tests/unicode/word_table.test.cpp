// SPDX-License-Identifier: MIT
#include "unicode/table_maker.hpp"

TEST_CASE("word_table.hpp agrees with the Unicode Character Database", "[tables]")
{
    if (!ucd::is_of_our_version()) return;
    ucd::check_or_make("word_table.hpp", ucd::word_table());
}
