// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/shape_options.hpp>
#include <typemesh/unicode/script.hpp>
#include <typemesh/unicode/text_view.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether the columns of a script follow each other to the right: Mongolian and its relatives.
[[nodiscard]] constexpr bool goes_right_in_columns(std::uint32_t script) noexcept
{
    return script == script_tag("Mong") || script == script_tag("Phag") || script == script_tag("Ougr") ||
           script == script_tag("Sogd") || script == script_tag("Sogo");
}

/// Whether each column of a text is to the right of the previous one. The options decide, otherwise the script that
/// they name, otherwise the script of the text's first letter. It is false for lines. Cost: O(n) up to that letter
[[nodiscard]] inline bool columns_go_right(text_view text, const shape_options& how) noexcept
{
    if (how.direction != direction::top_to_bottom) return false;
    if (how.columns.progress != column_progress::automatic) return how.columns.progress == column_progress::rightwards;
    if (how.script.size() == 4) {
        std::uint32_t tag = 0;
        for (const char letter : how.script) tag = tag << 8 | static_cast<unsigned char>(letter);
        return goes_right_in_columns(tag);
    }
    for (std::size_t i = 0; i < text.size();) {
        const code_point c = decode(text, i);
        const script_set scripts = script_set::of(c.value);
        if (!scripts.universal()) return goes_right_in_columns(scripts.tag());
        i = c.next;
    }
    return false;
}

}  // namespace typemesh::inline TYPEMESH_ABI
