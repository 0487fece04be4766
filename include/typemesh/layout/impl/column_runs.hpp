// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/layout/column_options.hpp>
#include <typemesh/layout/text_item.hpp>
#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/text_mark.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A range of a text with its own style in columns.
struct column_span {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    column_style style = column_style::automatic;
};

/// A part of a text with one orientation in a column.
struct column_run {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    glyph_orientation orientation = glyph_orientation::upright;
    bool downwards = false;  ///< it is read down, whatever the direction of its letters

    /// The level at which text with the bidi level `own` is set.
    [[nodiscard]] constexpr std::uint8_t level(std::uint8_t own) const noexcept
    {
        return static_cast<std::uint8_t>(downwards ? own + (own & 1u) : own);
    }
};

/// The orientation of a grapheme in columns, UAX #50: as its first character, or upright if a mark encloses it.
[[nodiscard]] inline vertical_orientation grapheme_orientation(text_view text, std::size_t first,
                                                               std::size_t last) noexcept
{
    const code_point base = decode(text, first, last);
    const vertical_orientation found = character_of(base.value).orientation;
    for (std::size_t i = base.next; i < last;) {
        const code_point mark = decode(text, i, last);
        const char32_t c = mark.value;  // General_Category Me
        if ((c >= 0x20DD && c <= 0x20E4 && c != 0x20E1) || c == 0x0488 || c == 0x0489 || c == 0x1ABE ||
            (c >= 0xA670 && c <= 0xA672))
            return vertical_orientation::upright;
        i = mark.next;
    }
    return found;
}

namespace detail {

/// Finds column runs grapheme by grapheme: see find_column_runs().
template <class HasForm>
class column_run_finder {
public:
    column_run_finder(text_view text, array_view<const text_mark> marks, const column_options& how,
                      const HasForm& has_form, buffer<column_run>& runs) noexcept
        : text_{text}, marks_{marks}, how_{how}, has_form_{has_form}, runs_{runs}
    {
    }

    /// Appends the runs of text[first, last), all of one style.
    error add(std::size_t first, std::size_t last, column_style style) noexcept
    {
        switch (style) {
        case column_style::upright: return append(first, last, glyph_orientation::upright, true);
        case column_style::sideways: return append(first, last, glyph_orientation::sideways, false);
        case column_style::combined: return append(first, last, glyph_orientation::combined, true);
        case column_style::automatic: break;
        }
        for (std::size_t i = first; i < last;) {
            const std::size_t digits = digits_from(i, last);
            std::size_t end = digits != i ? digits : end_of(i, last);
            const bool combined = digits != i && digits - i <= how_.combined_digits;
            const auto orientation = combined                              ? glyph_orientation::combined
                                     : how_.latin == column_latin::upright ? glyph_orientation::upright
                                                                           : orientation_of(i, end);
            if (error e = append(i, end, orientation, combined || how_.latin == column_latin::upright)) return e;
            i = end;
        }
        return {};
    }

    /// The end of the grapheme at text[i].
    [[nodiscard]] std::size_t end_of(std::size_t i, std::size_t last) const noexcept
    {
        do ++i;
        while (i < last && !has(marks_[i], text_mark::grapheme));
        return i;
    }

private:
    /// The end of the number that begins at text[i]; i if there is none.
    [[nodiscard]] std::size_t digits_from(std::size_t i, std::size_t last) const noexcept
    {
        while (i < last && text_.unit(i) >= '0' && text_.unit(i) <= '9' && end_of(i, last) == i + 1) ++i;
        return i;
    }

    [[nodiscard]] glyph_orientation orientation_of(std::size_t first, std::size_t last) const noexcept
    {
        switch (grapheme_orientation(text_, first, last)) {
        case vertical_orientation::upright:
        case vertical_orientation::transformed_upright: return glyph_orientation::upright;
        case vertical_orientation::transformed_rotated:
            return stands_transformed(decode(text_, first, last).value) ? glyph_orientation::upright
                                                                        : glyph_orientation::sideways;
        case vertical_orientation::rotated: break;
        }
        return glyph_orientation::sideways;
    }

    /// Whether a Tr character is upright: it has a vertical form, or it is a colon or semicolon and brackets have one.
    [[nodiscard]] bool stands_transformed(char32_t c) const noexcept
    {
        return has_form_(c) || ((c == U'\uFF1A' || c == U'\uFF1B') && has_form_(U'\u300C'));
    }

    error append(std::size_t first, std::size_t last, glyph_orientation orientation, bool downwards) noexcept
    {
        if (first == last) return {};
        const auto end = static_cast<std::uint32_t>(last);
        if (!runs_.empty() && orientation != glyph_orientation::combined && runs_.back().orientation == orientation &&
            runs_.back().downwards == downwards) {
            runs_.back().last = end;
            return {};
        }
        const column_run run{static_cast<std::uint32_t>(first), end, orientation, downwards};
        return runs_.push_back(run) ? error{} : error{error::out_of_memory};
    }

    text_view text_;
    array_view<const text_mark> marks_;
    const column_options& how_;
    const HasForm& has_form_;
    buffer<column_run>& runs_;
};

}  // namespace detail

/// Finds the orientation of the parts of a text in columns (UAX #50), grapheme by grapheme.
///
///     HH (2024) HH,        upright: characters that are upright in Unicode (H: an ideograph), with the font's vertical
///     |  |      |          forms; sideways: all others, and also characters that are upright only by a vertical form
///     U  S      U          (U+30FC, U+300C) that the font lacks. Exception: full-width colons and semicolons. They are
///                          upright in Chinese, and the semicolon in Japanese, too. They intentionally have no such
///                          form in a font that has one for U+300C.
///
///     marks      the marks of the text's analysis; only the graphemes are used
///     styles     ranges with their own style: ascending and not nested. A grapheme belongs to the range that contains
///                its first unit. Each combined range is a separate run.
///     has_form   has_form(c): whether the font has a vertical form of a character
///     runs       emptied first; they cover the text in order
///
/// Fails  error::out_of_memory
/// Cost   O(n), plus the cost of has_form
template <class HasForm>
error find_column_runs(text_view text, array_view<const text_mark> marks, const column_options& how,
                       array_view<const column_span> styles, const HasForm& has_form, buffer<column_run>& runs) noexcept
{
    runs.clear();
    detail::column_run_finder<HasForm> find{text, marks, how, has_form, runs};
    const auto behind = [&](std::size_t i, std::size_t before) noexcept {  // the end of the grapheme that is cut at i
        if (i <= before) return before;
        if (i >= text.size()) return text.size();
        return has(marks[i], text_mark::grapheme) ? i : find.end_of(i, text.size());
    };
    std::size_t at = 0;
    for (const column_span& s : styles) {
        const std::size_t first = behind(s.first, at), last = behind(s.last, first);
        if (error e = find.add(at, first, column_style::automatic)) return e;
        if (error e = find.add(first, last, s.style)) return e;
        at = last;
    }
    return find.add(at, text.size(), column_style::automatic);
}

}  // namespace typemesh::inline TYPEMESH_ABI
