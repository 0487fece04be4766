// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/text_analyser.hpp>
#include <typemesh/unicode/utf.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Finds the levels, scripts and graphemes of a text, and, with `LineEnds`, where lines may end: line_opportunities or
/// no_line_ends. See unicode_analyser and bidi_analyser.
template <class LineEnds>
class basic_analyser {
public:
    explicit basic_analyser(memory source = heap()) noexcept
        : space_{source}, values_{source}, places_{source}, bidi_{source}, characters_{source}, levels_{source}
    {
    }

    error analyse(text_view text, const analysis_options& how, text_analysis& found) noexcept
    {
        found.clear();
        if (const std::uint64_t length = text.size(); length > 0xFFFF'FFFFu) return error::too_large;
        const error e = fill_in(text, how, found);
        if (e) found.clear();
        return e;
    }

private:
    error fill_in(text_view text, const analysis_options& how, text_analysis& found) noexcept
    {
        const std::size_t size = text.size();
        if (size > 0 && (found.levels.append(size) == nullptr || found.marks.append(size) == nullptr))
            return error::out_of_memory;
        std::size_t begin = 0;
        bool more = true;
        while (more) {
            std::size_t end = begin;
            if constexpr (!LineEnds::finds_any)
                if (how.direction != paragraph_direction::right_to_left && is_ascii_paragraph(text, end, more)) {
                    if (error e = mark_ascii(text, begin, end, found)) return e;
                    begin = end;
                    continue;
                }
            if (error e = read_paragraph(text, end, more, found)) return e;
            if (levels_.size() < values_.size() && levels_.append(values_.size() - levels_.size()) == nullptr)
                return error::out_of_memory;
            const auto level = find_levels(how.direction);
            if (!level) return level.error();
            if (!found.paragraphs.push_back(
                    {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end), *level}))
                return error::out_of_memory;
            if (error e = mark(found)) return e;
            begin = end;
        }
        return {};
    }

    /// Finds the end of a paragraph of printable ASCII and tabs. Returns false if it has other characters.
    static bool is_ascii_paragraph(text_view text, std::size_t& at, bool& more) noexcept
    {
        std::size_t end = at;
        const std::size_t size = text.size();
        while (end < size && ((text.unit(end) >= 0x20 && text.unit(end) < 0x7F) || text.unit(end) == 0x09)) ++end;
        more = end < size;
        if (more && text.unit(end) != 0x0A && text.unit(end) != 0x0D) return false;
        if (more) end += text.unit(end) == 0x0D && end + 1 < size && text.unit(end + 1) == 0x0A ? 2u : 1u;
        at = end;
        return true;
    }

    /// mark() for such a paragraph, which is read to the right and has at most one script. Cost: a tenth of it
    static error mark_ascii(text_view text, std::size_t begin, std::size_t end, text_analysis& found) noexcept
    {
        constexpr text_mark one = text_mark::character | text_mark::grapheme;
        constexpr text_mark tab = one | text_mark::space | text_mark::separator;
        bool letters = false;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t unit = text.unit(i);
            found.levels[i] = 0;
            found.marks[i] = unit > 0x20 ? one : unit < 0x20 ? tab : one | text_mark::space | text_mark::trailing;
            letters = letters || ((unit | 0x20) >= 'a' && (unit | 0x20) <= 'z');
        }
        if (end - begin > 1 && text.unit(end - 1) == 0x0A && text.unit(end - 2) == 0x0D)
            found.marks[end - 1] = without(tab, text_mark::grapheme);
        const auto first = static_cast<std::uint32_t>(begin), last = static_cast<std::uint32_t>(end);
        if (!found.paragraphs.push_back({first, last, 0})) return error::out_of_memory;
        if (first == last) return {};
        const script_run all{first, last, letters ? script_tag("Latn") : script_tag("Zyyy")};
        return found.scripts.push_back(all) ? error{} : error{error::out_of_memory};
    }

    /// The levels of a paragraph's characters, and the level of the paragraph itself. Text without right-to-left
    /// letters, Arabic digits and controls, in a paragraph that is read to the right, has only level 0.
    result<std::uint8_t> find_levels(paragraph_direction direction) noexcept
    {
        using enum bidi_class;
        constexpr bidi_classes raising{r, al, an, lre, lro, rle, rlo, pdf, lri, rli, fsi, pdi};
        if (direction != paragraph_direction::right_to_left && !seen_.meets(raising)) {
            for (std::uint8_t& level : levels_.view().first(values_.size())) level = 0;
            return std::uint8_t{0};
        }
        detail::bidi_resolver resolve{values_.data(), bidi_.data(), values_.size(), levels_.data()};
        return resolve(direction, space_);
    }

    /// Decodes a paragraph and looks up its characters. `places_` has one more entry, the paragraph's end.
    ///
    ///     at      the start of the paragraph; afterwards the start of the next one
    ///     more    whether a separator ends it
    error read_paragraph(text_view text, std::size_t& at, bool& more, text_analysis& found) noexcept
    {
        values_.clear();
        places_.clear();
        bidi_.clear();
        characters_.clear();
        seen_ = {};
        for (more = false; at < text.size() && !more;) {
            code_point c = decode(text, at);
            if (!c.valid && found.invalid_units++ == 0) found.first_invalid_unit = static_cast<std::uint32_t>(at);
            const character properties = character_of(c.value);
            more = properties.bidi == bidi_class::b &&
                   !(c.value == 0x0D && c.next < text.size() && text.unit(c.next) == 0x0A);
            if (!values_.push_back(c.value) || !places_.push_back(static_cast<std::uint32_t>(at)) ||
                !bidi_.push_back(properties.bidi) || !characters_.push_back(properties))
                return error::out_of_memory;
            seen_.add(properties.bidi);
            at = c.next;
        }
        return places_.push_back(static_cast<std::uint32_t>(at)) ? error{} : error{error::out_of_memory};
    }

    /// Finds the levels and marks of the paragraph's units, its script runs, and the ranges that need a dictionary.
    error mark(text_analysis& found) noexcept
    {
        grapheme_boundaries begins;
        [[maybe_unused]] LineEnds opportunity{characters_.data(), characters_.size()};
        script_itemiser scripts{found.scripts};
        [[maybe_unused]] bool unbroken = false;  // the previous character has a script that needs a dictionary
        for (std::size_t k = 0; k < values_.size(); ++k) {
            const character& c = characters_[k];
            const std::size_t runs = found.scripts.size();
            const bool begun = begins(c.grapheme);
            if (!begun)
                scripts.add_mark(values_[k]);
            else if (error e = scripts.add(values_[k], c.bracket, places_[k]))
                return e;
            if (found.scripts.size() != runs) unbroken = false;  // another script needs another dictionary

            const text_mark whole = marks_of(c);
            text_mark first = whole | text_mark::character;
            if (begun) first = first | text_mark::grapheme;
            if constexpr (LineEnds::finds_any) {
                const auto before = opportunity(k);
                if (before == LineEnds::allowed) first = first | text_mark::may_break;
                if (before == LineEnds::mandatory || (k == 0 && places_[0] != 0)) first = first | text_mark::must_break;
            }
            for (std::size_t i = places_[k]; i < places_[k + 1]; ++i) {
                found.levels[i] = levels_[k];
                found.marks[i] = i == places_[k] ? first : whole;
            }

            if constexpr (LineEnds::finds_any) {
                const bool needs = c.line == line_class::sa || (unbroken && c.line == line_class::sa_mark);
                if (needs && !unbroken && !found.unbroken.push_back({places_[k], places_[k]}))
                    return error::out_of_memory;
                if (needs) found.unbroken.back().last = places_[k + 1];
                unbroken = needs;
            }
        }
        return scripts.end(places_[values_.size()]);
    }

    [[nodiscard]] static text_mark marks_of(const character& c) noexcept
    {
        using enum bidi_class;
        text_mark marks = text_mark::none;
        if (bidi_classes{ws, s, b}.holds(c.bidi) && c.line != line_class::gl) marks = text_mark::space;
        if (bidi_classes{s, b}.holds(c.bidi)) return marks | text_mark::separator;
        if (bidi_classes{ws, bn, lre, rle, lro, rlo, pdf, lri, rli, fsi, pdi}.holds(c.bidi))
            marks = marks | text_mark::trailing;
        return marks;
    }

    workspace space_;
    buffer<char32_t> values_;
    buffer<std::uint32_t> places_;
    buffer<bidi_class> bidi_;
    buffer<character> characters_;
    buffer<std::uint8_t> levels_;
    bidi_classes seen_;  // in the paragraph
};

}  // namespace typemesh::inline TYPEMESH_ABI
