// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The properties of one unit of a text: a set, joined by |.
///
/// The first four marks and the last one are set on a character's first unit, the others on all its units.
enum class text_mark : std::uint8_t {
    none = 0,
    character = 1u << 0,   ///< a code point begins here
    grapheme = 1u << 1,    ///< a grapheme begins here: what a reader sees as one character (UAX #29)
    may_break = 1u << 2,   ///< a line may end before this unit (UAX #14)
    must_break = 1u << 3,  ///< a line ends before this unit, for example after a line feed
    space = 1u << 4,       ///< white space, which may extend beyond the width at a line's end; not no-break spaces
    trailing = 1u << 5,    ///< a space or an invisible character, which gets the paragraph's level at a line's end (L1)
    separator = 1u << 6,   ///< a tab or a paragraph separator, which gets it anywhere, together with trailing units
                           ///< before it
    hyphen = 1u << 7,      ///< a line that ends before this unit shows a hyphen; U+00AD needs no mark
};

[[nodiscard]] constexpr text_mark operator|(text_mark a, text_mark b) noexcept
{
    return static_cast<text_mark>(static_cast<std::uint8_t>(a) | static_cast<std::uint8_t>(b));
}

/// A set without the marks of another.
[[nodiscard]] constexpr text_mark without(text_mark set, text_mark others) noexcept
{
    return static_cast<text_mark>(static_cast<std::uint8_t>(set) & ~static_cast<unsigned>(others));
}

/// Whether a set contains a mark. With several marks: whether it contains any of them.
[[nodiscard]] constexpr bool has(text_mark set, text_mark one) noexcept
{
    return (static_cast<std::uint8_t>(set) & static_cast<std::uint8_t>(one)) != 0;
}

}  // namespace typemesh::inline TYPEMESH_ABI
