// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/line_break.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/text_analysis.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How many units of a text are not shaped, because a tab or a line break stands there; 0 for all else.
[[nodiscard]] inline std::size_t silent_at(text_view text, std::size_t i) noexcept
{
    return text.unit(i) == 0x09 ? 1 : line_break_at(text, i);
}

/// Cuts an analysed text into items: where the level changes, where the script does, and round every tab and every line
/// break, which are items of their own and not for a shaper.
///
///     items    emptied first; they cover the text in order
///     upright  for columns: all items are of level 0 and upright
///
/// Fails  error::out_of_memory
/// Cost   O(n)
inline error itemise(text_view text, const text_analysis& found, bool upright, buffer<text_item>& items) noexcept
{
    items.clear();
    const auto orientation = upright ? glyph_orientation::upright : glyph_orientation::horizontal;
    std::size_t script = 0;
    for (std::size_t i = 0; i < text.size();) {
        while (script + 1 < found.scripts.size() && i >= found.scripts[script].last) ++script;
        const std::size_t end = script < found.scripts.size() ? found.scripts[script].last : text.size();
        std::size_t last = i + silent_at(text, i);
        const std::uint8_t level = found.levels[i];
        if (last == i) do
                ++last;
            while (last < end && (upright || found.levels[last] == level) && silent_at(text, last) == 0);
        const std::uint32_t tag = script < found.scripts.size() ? found.scripts[script].script : 0;
        if (!items.push_back({.first = static_cast<std::uint32_t>(i),
                              .last = static_cast<std::uint32_t>(last),
                              .script = tag,
                              .level = upright ? std::uint8_t{0} : level,
                              .orientation = orientation}))
            return error::out_of_memory;
        i = last;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
