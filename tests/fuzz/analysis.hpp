// SPDX-License-Identifier: MIT
#pragma once

#include "read_text.hpp"

#include <typemesh/unicode/hyphenating.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>
#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// UTF-8 and UTF-16 bytes -> analyser.
namespace fuzz {

namespace analysis_laws {

using namespace typemesh;

/// The places of a text's characters, and the text in the other encoding, with the places there.
struct other_encoding {
    std::string utf8;
    std::u16string utf16;
    std::vector<std::size_t> here, there;
    std::uint32_t invalid = 0;

    explicit other_encoding(text_view text)
    {
        const bool widens = text.encoding() == encoding::utf8;
        for (std::size_t i = 0; i < text.size();) {
            const code_point c = decode(text, i);
            here.push_back(i);
            there.push_back(widens ? utf16.size() : utf8.size());
            invalid += c.valid ? 0u : 1u;
            widens ? append_utf16(utf16, c.value) : append_utf8(utf8, c.value);
            i = c.next;
        }
    }
    [[nodiscard]] text_view view() const { return utf8.empty() ? text_view{utf16} : text_view{utf8}; }
};

/// Every unit has a level and marks, and paragraphs and script runs are in order.
inline broken_law of_places(text_view text, const text_analysis& found)
{
    const auto size = static_cast<std::uint32_t>(text.size());
    if (found.levels.size() != size || found.marks.size() != size) return "not one level and one set of marks a unit";
    std::uint32_t at = 0;
    for (const text_paragraph& p : found.paragraphs) {
        if (p.first != at || p.last < p.first) return "paragraphs leave a gap";
        at = p.last;
    }
    if (found.paragraphs.empty() || at != size) return "paragraphs do not cover the text";
    at = 0;
    for (const script_run& r : found.scripts) {
        if (r.first != at || r.last <= r.first) return "runs of scripts leave a gap";
        at = r.last;
        if (found.paragraph_of(r.first).last < r.last) return "a run of a script goes beyond its paragraph";
    }
    if (at != size) return "runs of scripts do not cover the text";
    for (const std::uint8_t level : found.levels)
        if (level > 126) return "a level beyond 126";
    return {};
}

/// Lines end and graphemes begin only where characters begin; a unit has its character's level.
inline broken_law of_marks(const text_analysis& found, const other_encoding& other)
{
    std::vector<bool> begins(found.marks.size(), false);
    for (const std::size_t i : other.here) begins[i] = true;
    constexpr text_mark of_first =
        text_mark::character | text_mark::grapheme | text_mark::may_break | text_mark::must_break;
    for (std::size_t i = 0; i < begins.size(); ++i) {
        if (has(found.marks[i], text_mark::character) != begins[i]) return "a character begins elsewhere";
        if (!begins[i] && has(found.marks[i], of_first)) return "a mark within a character";
        if (!begins[i] && found.levels[i] != found.levels[i - 1]) return "two levels in a character";
        if (has(found.marks[i], text_mark::must_break) && has(found.marks[i], text_mark::may_break))
            return "a line both must and may end";
    }
    if (!begins.empty() && !has(found.marks[0], text_mark::grapheme)) return "the text begins within a grapheme";
    if (found.invalid_units != other.invalid) return "places that are not valid UTF are miscounted";
    return {};
}

/// Both encodings have the same result for each character.
inline broken_law of_encodings(const text_analysis& a, const text_analysis& b, const other_encoding& places)
{
    for (std::size_t k = 0; k < places.here.size(); ++k) {
        const std::size_t i = places.here[k], j = places.there[k];
        if (a.levels[i] != b.levels[j]) return "levels depend on the encoding";
        if (a.marks[i] != b.marks[j]) return "marks depend on the encoding";
    }
    return a.paragraphs.size() == b.paragraphs.size() ? "" : "paragraphs depend on the encoding";
}

/// Rule L2 literally, unit by unit: from the highest level to the lowest odd one, all units of it or above are reversed.
inline std::vector<std::uint32_t> order_by_units(const std::vector<std::uint8_t>& levels, std::uint32_t first)
{
    std::vector<std::uint32_t> order(levels.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = first + static_cast<std::uint32_t>(i);
    for (unsigned level = 127; level > 0; --level)
        for (std::size_t i = 0; i < order.size(); ++i) {
            std::size_t end = i;
            while (end < order.size() && levels[order[end] - first] >= level) ++end;
            std::reverse(order.begin() + static_cast<std::ptrdiff_t>(i),
                         order.begin() + static_cast<std::ptrdiff_t>(end));
            i = end > i ? end : i;
        }
    return order;
}

/// Each paragraph has the same levels and marks by itself as in the text, except at its start.
inline broken_law of_parts(unicode_analyser& analyser, text_view text, const analysis_options& how,
                           const text_analysis& found)
{
    text_analysis single;
    for (const text_paragraph& p : found.paragraphs) {
        const std::size_t size = p.last - p.first;
        const text_view part = text.encoding() == encoding::utf8
                                   ? text_view{std::string_view{text.utf8() + p.first, size}}
                                   : text_view{std::u16string_view{text.utf16() + p.first, size}};
        if (analyser.analyse(part, how, single)) return "a paragraph of a text cannot be analysed by itself";
        for (std::size_t i = 0; i < size; ++i) {
            if (single.levels[i] != found.levels[p.first + i]) return "levels depend on other paragraphs";
            if (i != 0 && single.marks[i] != found.marks[p.first + i]) return "marks depend on other paragraphs";
        }
    }
    return {};
}

/// Hyphens add places where lines may end, only where graphemes begin, and change nothing else.
inline broken_law of_hyphens(text_view text, const analysis_options& how, const text_analysis& found,
                             std::uint32_t step)
{
    hyphenating analyser{unicode_analyser{}, any_hyphens{step}};
    text_analysis parted;
    if (analyser.analyse(text, how, parted)) return "a text cannot be hyphenated";
    constexpr text_mark added = text_mark::may_break | text_mark::hyphen;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const text_mark was = found.marks[i], is = parted.marks[i];
        if (parted.levels[i] != found.levels[i]) return "hyphens change a level";
        if (was == is) continue;
        if (!has(is, text_mark::hyphen) || !has(is, text_mark::may_break) || is != (was | added))
            return "hyphens change another mark";
        if (!has(is, text_mark::grapheme) || has(was, text_mark::may_break)) return "a hyphen in a wrong place";
    }
    return {};
}

/// Each line's runs contain every unit once, in the order of rule L2.
inline broken_law of_order(const text_analysis& found)
{
    buffer<visual_run> runs;
    for (const text_paragraph& p : found.paragraphs) {
        if (p.first == p.last) continue;
        if (!visual_runs(found, {p.first, p.last}, runs)) return "visual_runs() failed";
        std::vector<std::uint32_t> times(p.last - p.first, 0);
        for (const visual_run& r : runs)
            for (std::uint32_t i = r.first; i < r.last; ++i) ++times.at(i - p.first);
        for (const std::uint32_t n : times)
            if (n != 1) return "a unit is not in its line once";
        std::vector<std::uint8_t> levels(times.size());
        std::vector<std::uint32_t> order;
        for (const visual_run& r : runs) {
            for (std::uint32_t i = 0; i < r.last - r.first; ++i)
                order.push_back(r.level % 2 == 0 ? r.first + i : r.last - 1 - i);
            std::fill(levels.begin() + (r.first - p.first), levels.begin() + (r.last - p.first), r.level);
        }
        if (order != order_by_units(levels, p.first)) return "a line is not in the order of rule L2";
    }
    return {};
}

}  // namespace analysis_laws

inline broken_law analysis(values in)
{
    using namespace analysis_laws;
    analysis_options how;
    how.direction = in.one_of(
        {paragraph_direction::automatic, paragraph_direction::left_to_right, paragraph_direction::right_to_left});
    const read_text text{in, 400};
    const other_encoding other{text.view()};
    unicode_analyser analyser;
    text_analysis found, found_there;
    if (const error e = analyser.analyse(text.view(), how, found)) return e.message();
    if (const error e = analyser.analyse(other.view(), how, found_there)) return e.message();
    if (broken_law broken = of_places(text.view(), found); !broken.empty()) return broken;
    if (broken_law broken = of_marks(found, other); !broken.empty()) return broken;
    if (broken_law broken = of_encodings(found, found_there, other); !broken.empty()) return broken;
    if (broken_law broken = of_parts(analyser, text.view(), how, found); !broken.empty()) return broken;
    if (broken_law broken = of_hyphens(text.view(), how, found, 1 + in.below(4)); !broken.empty()) return broken;
    return of_order(found);
}

}  // namespace fuzz
