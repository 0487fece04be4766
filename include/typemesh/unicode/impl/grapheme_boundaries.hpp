// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/class_set.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Finds where graphemes begin. A reader sees a grapheme as one character: a letter with its marks, a conjunct of Indic
/// scripts, a stack of Khmer or Burmese, an emoji of several code points. (UAX #29: extended grapheme clusters)
class grapheme_boundaries {
public:
    /// Whether a grapheme begins with this character. Call it for each character of a text in order.
    [[nodiscard]] bool operator()(grapheme_class c) noexcept
    {
        const bool begins = first_ || !joins(c);
        first_ = false;
        if (c == grapheme_class::pictographic)
            emoji_ = emoji::picture;
        else if (c == grapheme_class::zwj && emoji_ == emoji::picture)
            emoji_ = emoji::joiner;
        else if (!is_mark(c) || emoji_ != emoji::picture)
            emoji_ = emoji::none;
        if (c == grapheme_class::consonant)
            conjunct_ = conjunct::consonant;
        else if (c == grapheme_class::linker && conjunct_ != conjunct::none)
            conjunct_ = conjunct::linked;
        else if (c != grapheme_class::extend && c != grapheme_class::zwj && c != grapheme_class::linker)
            conjunct_ = conjunct::none;
        half_a_flag_ = c == grapheme_class::regional_indicator && (begins || !half_a_flag_);
        before_ = c;
        return begins;
    }

private:
    /// The part of an emoji sequence (GB11) before the current character: a picture with its marks, or also a joiner.
    enum class emoji : std::uint8_t { none, picture, joiner };

    /// The part of a conjunct (GB9c) before it: a consonant with its marks, or also a linker among them.
    enum class conjunct : std::uint8_t { none, consonant, linked };

    [[nodiscard]] static bool is_mark(grapheme_class c) noexcept
    {
        using enum grapheme_class;
        return class_set<grapheme_class>{extend, linker, non_joiner}.holds(c);
    }

    /// Rules GB3 to GB13.
    [[nodiscard]] bool joins(grapheme_class c) const noexcept
    {
        using enum grapheme_class;
        using classes = class_set<grapheme_class>;
        if (before_ == cr && c == lf) return true;
        if (classes{control, cr, lf}.holds(before_) || classes{control, cr, lf}.holds(c)) return false;
        if (classes{extend, linker, non_joiner, zwj, spacing_mark}.holds(c) || before_ == prepend) return true;
        if (c == consonant) return conjunct_ == conjunct::linked;
        if (before_ == l) return classes{l, v, lv, lvt}.holds(c);
        if (before_ == lv || before_ == v) return c == v || c == t;
        if (before_ == lvt || before_ == t) return c == t;
        if (before_ == regional_indicator) return c == regional_indicator && half_a_flag_;
        return c == pictographic && emoji_ == emoji::joiner;
    }

    grapheme_class before_ = grapheme_class::other;
    emoji emoji_ = emoji::none;
    conjunct conjunct_ = conjunct::none;
    bool half_a_flag_ = false;  // the previous character is the first of two regional indicators
    bool first_ = true;
};

}  // namespace typemesh::inline TYPEMESH_ABI
