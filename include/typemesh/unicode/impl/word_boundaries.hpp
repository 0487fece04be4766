// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/unicode/impl/class_set.hpp>
#include <typemesh/unicode/impl/word_table.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How a character joins its neighbours in a word: Word_Break of UAX #29, with Extended_Pictographic.
enum class word_class : std::uint8_t {
    other,
    cr,
    lf,
    newline,
    extend,  ///< marks
    format,  ///< invisible characters
    zwj,
    regional_indicator,
    katakana,
    hebrew_letter,
    letter,
    letter_pictographic,  ///< letters that are also pictures, such as a circled M
    single_quote,
    double_quote,
    mid_num_let,  ///< within words and numbers, such as the full stop
    mid_letter,   ///< within words, such as the colon
    mid_num,      ///< within numbers, such as the comma
    numeric,
    extend_num_let,  ///< such as the underscore
    space,
    pictographic,
};

/// Whether a letter is written together with its neighbours: Joining_Type of The Unicode Standard, 9.2.
enum class joining_type : std::uint8_t {
    none,
    right,  ///< joins the letter before it: on its right, as these scripts are read to the left
    left,   ///< joins the letter after it
    dual,
    causing,      ///< joins both, whatever they are, such as the tatweel
    transparent,  ///< marks, which do not separate two letters that join
};

/// What the letters of a text are made of: the properties of one code point.
struct word_character {
    word_class word;
    joining_type joining;
};

/// Cost: O(log(ranges)), none for letters of ASCII
[[nodiscard]] inline word_character word_character_of(char32_t c) noexcept
{
    using detail::word_ranges;
    if ((c | 0x20) >= U'a' && (c | 0x20) <= U'z') return {word_class::letter, joining_type::none};
    if (c > 0x10FFFF) c = 0xFFFD;
    const auto begins_behind = [c](std::size_t i) noexcept { return word_ranges[i] >> 8 > c; };
    const std::uint32_t found =
        word_ranges[first_where(1, sizeof word_ranges / sizeof word_ranges[0], begins_behind) - 1];
    return {static_cast<word_class>(found & 0x1F), static_cast<joining_type>(found >> 5 & 7)};
}

/// Whether the first of two neighbouring letters joins the second one, marks apart.
[[nodiscard]] constexpr bool join(joining_type first, joining_type second) noexcept
{
    using enum joining_type;
    return (first == left || first == dual || first == causing) &&
           (second == right || second == dual || second == causing);
}

/// Finds where the segments of UAX #29 begin: words, numbers, and each punctuation mark, ideograph or series of spaces
/// between them.
class word_boundaries {
public:
    /// Whether a segment begins with this character. Call it for each character of a text in order.
    ///
    ///     next    next() gives the class of the next character after it, the one after that, and so on; at the end of
    ///             the text newline. It is called only after a mark that may stand within a word, up to the next
    ///             character that is not extend, format or zwj: O(n) for a text
    template <class Next>
    [[nodiscard]] bool operator()(word_class c, const Next& next) noexcept
    {
        const bool inside = !first_ && joins_directly(c);
        const bool goes_on = inside || (!first_ && !separates(c) && (is_ignored(c) || joins(c, next)));
        const bool apart = first_ || separates(c) || separates(direct_);
        if (apart || !is_ignored(c)) {
            half_a_flag_ = c == word_class::regional_indicator && (!goes_on || !half_a_flag_);
            before_ = base_;
            base_ = c;
        }
        direct_ = c;
        first_ = false;
        return !goes_on;
    }

private:
    using classes = class_set<word_class>;

    [[nodiscard]] static bool is_ignored(word_class c) noexcept
    {
        using enum word_class;
        return classes{extend, format, zwj}.holds(c);
    }
    [[nodiscard]] static bool is_letter(word_class c) noexcept
    {
        using enum word_class;
        return classes{letter, letter_pictographic, hebrew_letter}.holds(c);
    }

    /// Rules WB3a and WB3b.
    [[nodiscard]] bool separates(word_class c) const noexcept
    {
        using enum word_class;
        return classes{cr, lf, newline}.holds(c) || classes{cr, lf, newline}.holds(direct_);
    }

    /// Rules WB3, WB3c and WB3d, which concern neighbours without marks between them.
    [[nodiscard]] bool joins_directly(word_class c) const noexcept
    {
        using enum word_class;
        if (direct_ == cr) return c == lf;
        if (direct_ == zwj) return classes{pictographic, letter_pictographic}.holds(c);
        return direct_ == space && c == space;
    }

    template <class Next>
    [[nodiscard]] static word_class base_after(const Next& next) noexcept
    {
        word_class c = next();
        while (is_ignored(c)) c = next();
        return c;
    }

    /// Rules WB5 to WB16.
    template <class Next>
    [[nodiscard]] bool joins(word_class c, const Next& next) const noexcept
    {
        using enum word_class;
        constexpr classes in_words{mid_letter, mid_num_let, single_quote},
            in_numbers{mid_num, mid_num_let, single_quote};
        if (is_letter(base_)) {
            if (is_letter(c) || c == numeric || c == extend_num_let) return true;
            if (base_ == hebrew_letter && c == single_quote) return true;
            if (base_ == hebrew_letter && c == double_quote) return base_after(next) == hebrew_letter;
            return in_words.holds(c) && is_letter(base_after(next));
        }
        if (base_ == numeric) {
            if (is_letter(c) || c == numeric || c == extend_num_let) return true;
            return in_numbers.holds(c) && base_after(next) == numeric;
        }
        if (is_letter(c) && is_letter(before_) && in_words.holds(base_)) return true;
        if (c == hebrew_letter && before_ == hebrew_letter && base_ == double_quote) return true;
        if (c == numeric && before_ == numeric && in_numbers.holds(base_)) return true;
        if (base_ == katakana) return c == katakana || c == extend_num_let;
        if (base_ == extend_num_let) return is_letter(c) || classes{numeric, katakana, extend_num_let}.holds(c);
        return base_ == regional_indicator && c == regional_indicator && half_a_flag_;
    }

    word_class direct_ = word_class::other;  // the previous character
    word_class base_ = word_class::other;    // the last character that is not ignored, and the one before it
    word_class before_ = word_class::other;
    bool half_a_flag_ = false;
    bool first_ = true;
};

}  // namespace typemesh::inline TYPEMESH_ABI
