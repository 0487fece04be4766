// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/impl/column_runs.hpp>
#include <typemesh/layout/impl/line_break.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/text_analysis.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The length of the line end at text[i], in units: a line break, or U+001C to U+001E, which end a paragraph by UAX #9.
/// It is 0 if there is none.
[[nodiscard]] inline std::size_t line_end_at(text_view text, std::size_t i) noexcept
{
    return text.unit(i) >= 0x1C && text.unit(i) <= 0x1E ? 1 : line_break_at(text, i);
}

/// Whether a line end ends a paragraph by UAX #9, too, so that the next line begins one.
[[nodiscard]] constexpr bool ends_paragraph(char32_t line_end) noexcept
{
    return line_end != 0x0B && line_end != 0x0C && line_end != 0x2028;
}

/// The number of units at text[i] that are not shaped, because they are a tab or the end of a line; otherwise 0.
[[nodiscard]] inline std::size_t silent_at(text_view text, std::size_t i) noexcept
{
    const std::uint32_t unit = text.unit(i);
    if (unit >= 0x20 && unit < 0x80) return 0;
    return unit == 0x09 ? 1 : line_end_at(text, i);
}

/// Splits an analysed text into items. It splits where the level, the script or the orientation in columns changes, at
/// the given borders, and around every tab and every line break. Tabs and line breaks are separate items that no shaper
/// gets. An item that would end inside a grapheme ends after it. Such an item, and a combined one, has the level and
/// the script of its beginning.
///
///     borders    places in the text, ascending
///     columns    for columns: see find_column_runs(). Empty: for lines
///     items      emptied first; they cover the text in order
///
/// Fails  error::out_of_memory
/// Cost   O(n)
inline error itemise(text_view text, const text_analysis& found, array_view<const std::uint32_t> borders,
                     array_view<const column_run> columns, buffer<text_item>& items) noexcept
{
    items.clear();
    constexpr column_run line{.orientation = glyph_orientation::horizontal};
    std::size_t script = 0, border = 0, run = 0;
    for (std::size_t i = 0; i < text.size();) {
        while (script + 1 < found.scripts.size() && i >= found.scripts[script].last) ++script;
        while (border < borders.size() && i >= borders[border]) ++border;
        while (run < columns.size() && i >= columns[run].last) ++run;
        const column_run& column = run < columns.size() ? columns[run] : line;
        const bool combined = column.orientation == glyph_orientation::combined;
        std::size_t end = text.size();
        if (script < found.scripts.size() && !combined) end = found.scripts[script].last;
        if (border < borders.size() && borders[border] < end && !combined) end = borders[border];
        if (run < columns.size() && column.last < end) end = column.last;
        std::size_t last = i + silent_at(text, i);
        const std::uint8_t level = column.level(found.levels[i]);
        const auto goes_on = [&](std::size_t k) noexcept {
            if (!has(found.marks[k], text_mark::grapheme)) return true;
            return k < end && (combined || column.level(found.levels[k]) == level) && silent_at(text, k) == 0;
        };
        const bool silent = last != i;
        // Printable ASCII at one level goes on in any case: this quick loop takes half the instructions.
        while (!silent && last < end && found.levels[last] == found.levels[i] && text.unit(last) >= 0x20 &&
               text.unit(last) < 0x80)
            ++last;
        if (last == i) ++last;
        while (!silent && last < text.size() && goes_on(last)) ++last;
        const std::uint32_t tag = script < found.scripts.size() ? found.scripts[script].script : 0;
        if (!items.push_back({.first = static_cast<std::uint32_t>(i),
                              .last = static_cast<std::uint32_t>(last),
                              .script = tag,
                              .level = level,
                              .orientation = column.orientation}))
            return error::out_of_memory;
        i = last;
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
