// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/script.hpp>
#include <typemesh/unicode/text_analyser.hpp>
#include <typemesh/unicode/utf.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The concept below uses it instead of hyphenating's function object.
struct ignore_place {
    void operator()(std::size_t) const noexcept {}
};

}  // namespace detail

/// Knows where words may be divided with a hyphen: patterns, a dictionary, a service of the system.
///
///     h.hyphenate(text, word, language, put)   calls put(place) for each unit of `word` that may follow a hyphen, in
///                                              any order. Places outside the word or inside a grapheme are
///                                              ignored. `language` is analysis_options::language.
template <class H>
concept hyphenator = requires(H& h, text_view text, text_range word, std::string_view language) {
    { h.hyphenate(text, word, language, detail::ignore_place{}) } noexcept;
};

/// An analyser that adds hyphenation to another analyser: it also finds where words may be divided with a hyphen.
///
///     paragraph words{font, heap(), hyphenating{unicode_analyser{}, my_patterns}};
///
/// A word is a run of letters and their marks; a digit, an apostrophe or a hyphen ends it. If a word contains soft
/// hyphens, it is divided only there.
template <text_analyser Analyser, hyphenator Hyphenator>
class hyphenating {
public:
    hyphenating(Analyser analyser, Hyphenator words) noexcept : analyser_{std::move(analyser)}, words_{std::move(words)}
    {
    }

    /// The policies; you may change their options between texts.
    [[nodiscard]] Analyser& analyser() noexcept { return analyser_; }
    [[nodiscard]] Hyphenator& hyphenator() noexcept { return words_; }

    error analyse(text_view text, const analysis_options& how, text_analysis& found) noexcept
    {
        if (error e = analyser_.analyse(text, how, found)) return e;
        text_range word;
        bool open = false, soft = false;
        for (std::size_t i = 0; i < text.size();) {
            const code_point c = decode(text, i);
            const kind is = kind_of(c.value, open);
            if (is == kind::letter && !open) {
                word.first = static_cast<std::uint32_t>(i);
                open = true;
                soft = false;
            }
            soft = soft || is == kind::soft_hyphen;
            if (is == kind::other && open) {
                word.last = static_cast<std::uint32_t>(i);
                if (!soft) part(text, word, how.language, found);
                open = false;
            }
            i = c.next;
        }
        word.last = static_cast<std::uint32_t>(text.size());
        if (open && !soft) part(text, word, how.language, found);
        return {};
    }

private:
    enum class kind : std::uint8_t { other, letter, mark, soft_hyphen };

    [[nodiscard]] static kind kind_of(char32_t c, bool in_word) noexcept
    {
        if (c < 0x80) return (c | 0x20) >= U'a' && (c | 0x20) <= U'z' ? kind::letter : kind::other;
        if (c == 0xAD) return in_word ? kind::soft_hyphen : kind::other;
        const line_class line = character_of(c).line;
        using enum line_class;
        if (class_set<line_class>{cm, zwj, vf, vi}.holds(line)) return in_word ? kind::mark : kind::other;
        const bool letter = class_set<line_class>{al, hl, ak, as, ap}.holds(line);
        return letter && script_set::range_of(c).number != 0 ? kind::letter : kind::other;
    }

    void part(text_view text, text_range word, std::string_view language, text_analysis& found) noexcept
    {
        words_.hyphenate(text, word, language, [&found, word](std::size_t place) noexcept {
            if (place <= word.first || place >= word.last) return;
            text_mark& mark = found.marks[place];
            if (has(mark, text_mark::grapheme) && !has(mark, text_mark::may_break | text_mark::must_break))
                mark = mark | text_mark::may_break | text_mark::hyphen;
        });
    }

    Analyser analyser_;
    Hyphenator words_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
