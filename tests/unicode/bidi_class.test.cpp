// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/impl/character.hpp>

using namespace typemesh;

TEST_CASE("each bidi class belongs to a character", "[bidi]")
{
    constexpr char32_t some[] = {U'a',   0x05D0, 0x0627, U'1',   U'+',   U'$',   0x0661, U',',
                                 0x0301, 0x00AD, 0x2029, U'\t',  U' ',   U'!',   0x202A, 0x202D,
                                 0x202B, 0x202E, 0x202C, 0x2066, 0x2067, 0x2068, 0x2069};
    int wanted = 0;
    for (const char32_t c : some) CHECK(static_cast<int>(character_of(c).bidi) == wanted++);
    CHECK(wanted == static_cast<int>(bidi_class::pdi) + 1);
}
