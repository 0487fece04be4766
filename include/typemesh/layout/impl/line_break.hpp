// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/text_view.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The length of the line break at text[i], in units, or 0 if there is none.
///
/// The mandatory breaks of UAX #14: LF, CR, CR LF (one break), VT, FF, NEL (U+0085), U+2028, U+2029. Precondition: i <
/// text.size().
[[nodiscard]] inline std::size_t line_break_at(text_view text, std::size_t i) noexcept
{
    const std::uint32_t unit = text.unit(i);
    const std::size_t left = text.size() - i;
    if (unit >= 0x0A && unit <= 0x0D) return unit == 0x0D && left > 1 && text.unit(i + 1) == 0x0A ? 2 : 1;
    if (unit < 0x80) return 0;
    if (text.encoding() == encoding::utf16) return unit == 0x85 || unit == 0x2028 || unit == 0x2029 ? 1 : 0;
    if (unit == 0xC2) return left > 1 && text.unit(i + 1) == 0x85 ? 2 : 0;
    if (unit != 0xE2 || left < 3 || text.unit(i + 1) != 0x80) return 0;
    return text.unit(i + 2) == 0xA8 || text.unit(i + 2) == 0xA9 ? 3 : 0;
}

}  // namespace typemesh::inline TYPEMESH_ABI
