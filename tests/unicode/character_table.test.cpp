// SPDX-License-Identifier: MIT
#include "unicode/table_maker.hpp"

#include <typemesh/unicode/impl/character.hpp>

TEST_CASE("character_table.hpp agrees with the Unicode Character Database", "[tables]")
{
    if (!ucd::is_of_our_version()) return;
    ucd::check_or_make("character_table.hpp", ucd::character_table());
}

TEST_CASE("every character has its orientation of VerticalOrientation.txt", "[tables]")
{
    if (!ucd::is_of_our_version()) return;
    const auto wanted = ucd::property("VerticalOrientation.txt");
    const std::string names[] = {"R", "U", "Tr", "Tu"};
    std::size_t wrong = 0;
    for (char32_t c = 0; c < 0x110000; ++c)
        wrong += names[static_cast<std::size_t>(typemesh::character_of(c).orientation)] != wanted[c] ? 1u : 0u;
    CHECK(wrong == 0);
}
