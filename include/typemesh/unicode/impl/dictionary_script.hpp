// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/script.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// A script without spaces between its words: only a dictionary knows where its lines may end.
struct dictionary_script {
    std::uint32_t tag = 0;           ///< as in script_run
    char language[3] = {};           ///< the language of the words below, BCP 47
    std::u16string_view words = {};  ///< two common words; they test whether a library has the dictionary
    std::uint32_t second_word = 0;   ///< the start of the second word; a grapheme of the first word ends before it
};

/// The words mean: the Thai language, the Lao language, there is water, the people of the world.
inline constexpr dictionary_script dictionary_scripts[] = {
    {script_tag("Thai"), "th", u"\u0E20\u0E32\u0E29\u0E32\u0E44\u0E17\u0E22", 4},
    {script_tag("Laoo"), "lo", u"\u0E9E\u0EB2\u0EAA\u0EB2\u0EA5\u0EB2\u0EA7", 4},
    {script_tag("Khmr"), "km", u"\u1798\u17B6\u1793\u1791\u17B9\u1780", 3},
    {script_tag("Mymr"), "my", u"\u1000\u1019\u1039\u1018\u102C\u101C\u1030\u101E\u102C\u1038", 5},
};
inline constexpr std::size_t dictionary_script_count = sizeof dictionary_scripts / sizeof dictionary_scripts[0];

/// The index of a script in that list. For other scripts, the number of entries.
[[nodiscard]] constexpr std::size_t dictionary_script_number(std::uint32_t tag) noexcept
{
    std::size_t k = 0;
    while (k < dictionary_script_count && dictionary_scripts[k].tag != tag) ++k;
    return k;
}

}  // namespace typemesh::inline TYPEMESH_ABI
