// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/character.hpp>
#include <typemesh/unicode/class_set.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a line may end, or ends, before a character.
enum class line_opportunity : std::uint8_t { none, allowed, mandatory };

/// Finds where the lines of a text may end: the line breaking algorithm of UAX #14, with numbers kept together as the
/// example 7 of its section 8.2 proposes. Small kana do not begin a line (strict). Words of Thai and other scripts that
/// need a dictionary are not found: there is no opportunity in them.
///
///     all, size    the text's characters
///     i            called for each in turn, from 0
///
/// Cost   O(n) for all
class line_opportunities {
    using classes = class_set<line_class>;

public:
    line_opportunities(const character* all, std::size_t size) noexcept : all_{all}, size_{size} {}

    [[nodiscard]] line_opportunity operator()(std::size_t i) noexcept
    {
        using enum line_class;
        line_class c = resolved(all_[i].line);
        const line_class previous = i == 0 ? wj : all_[i - 1].line;
        const bool starts = i == 0 || classes{bk, cr, lf, nl}.holds(previous);
        const bool joined = previous == zwj && i > 0;
        if (c == cm || c == zwj) {
            if (!starts && !spaces_ && before_ != zw) return line_opportunity::none;  // LB9
            c = al;                                                                   // LB10
        }
        line_opportunity found = line_opportunity::none;
        if (i > 0 && starts)
            found = previous == cr && c == lf ? line_opportunity::none : line_opportunity::mandatory;  // LB4, LB5
        else if (i > 0 && !joined && breaks(i, c))
            found = line_opportunity::allowed;
        pass(c, starts);
        return found;
    }

private:
    /// LB1, as far as tables have not done it.
    [[nodiscard]] static constexpr line_class resolved(line_class c) noexcept
    {
        using enum line_class;
        return c == sa ? al : c == sa_mark ? cm : c == cj ? ns : c;
    }

    /// LB6 to LB31 without LB8a to LB10.
    [[nodiscard]] bool breaks(std::size_t i, line_class c) const noexcept
    {
        using enum line_class;
        if (classes{bk, cr, lf, nl, sp, zw}.holds(c)) return false;
        if (before_ == zw) return true;
        if (classes{wj, cl, cp, ex, is, sy}.holds(c)) return false;
        if (before_ == op || before_ == op_wide) return false;
        if (before_ == qu && (c == op || c == op_wide)) return false;
        if ((before_ == cl || before_ == cp) && c == ns) return false;
        if (before_ == b2 && c == b2) return false;
        if (spaces_) return true;
        if (before_ == wj || before_ == gl || c == qu || before_ == qu) return false;
        if (c == gl && before_ != ba && before_ != hy) return false;
        if (c == cb || before_ == cb) return true;
        return !(hebrew_hyphen_ || in_number(i, c) || (c == ri && half_a_flag_) || joins(before_, c));
    }

    /// LB25: a number with what stands before and behind it.
    [[nodiscard]] bool in_number(std::size_t i, line_class c) const noexcept
    {
        using enum line_class;
        if (number_ != number::none && (c == po || c == pr)) return true;
        if (number_ == number::digits && c == nu) return true;
        if (before_ != po && before_ != pr) return false;
        if (c == nu) return true;
        if (c != op && c != op_wide && c != hy) return false;
        do ++i;
        while (i < size_ && classes{cm, zwj, sa_mark}.holds(all_[i].line));
        return i < size_ && all_[i].line == nu;
    }

    /// LB21 to LB30b, those of two neighbours: for each class, those that may not be parted from it.
    struct neighbours {
        static constexpr std::size_t count = static_cast<std::size_t>(line_class::sa_mark) + 1;
        classes after[count];

        constexpr void join(std::initializer_list<line_class> before, classes behind) noexcept
        {
            for (const line_class c : before) after[static_cast<std::size_t>(c)].add(behind);
        }
        constexpr neighbours() noexcept
        {
            using enum line_class;
            for (classes& c : after) c = {ba, hy, ns, in};  // LB21, LB22
            for (std::size_t c = 0; c < count; ++c) after[static_cast<std::size_t>(bb)].add(static_cast<line_class>(c));
            join({sy}, {hl});                          // LB21b
            join({al, hl}, {al, hl, nu, pr, po, op});  // LB23, LB24, LB28, LB30
            join({nu}, {al, hl, op});                  // LB23, LB30
            join({pr}, {id, picto, eb, em});           // LB23a
            join({id, picto, eb, em}, {po});           //
            join({pr, po, is, cp}, {al, hl});          // LB24, LB29, LB30
            join({hy, cp}, {nu});                      // LB25, LB30
            join({jl}, {jl, jv, h2, h3});              // LB26
            join({jv, h2}, {jv, jt});                  //
            join({jt, h3}, {jt});                      //
            join({jl, jv, jt, h2, h3}, {po});          // LB27
            join({pr}, {jl, jv, jt, h2, h3});          //
            join({eb, picto}, {em});                   // LB30b
        }
    };

    [[nodiscard]] static bool joins(line_class before, line_class c) noexcept
    {
        static constexpr neighbours all;
        return all.after[static_cast<std::size_t>(before)].holds(c);
    }

    /// Remembers what the next character needs to know of this one.
    void pass(line_class c, bool starts) noexcept
    {
        using enum line_class;
        if (starts) before_ = bk;
        if (c == sp) {
            spaces_ = true;
            number_ = number::none;
            half_a_flag_ = hebrew_hyphen_ = false;
            return;
        }
        hebrew_hyphen_ = before_ == hl && !spaces_ && (c == hy || c == ba);  // LB21a
        half_a_flag_ = c == ri && !half_a_flag_;                             // LB30a
        if (c == nu)
            number_ = number::digits;
        else if (number_ == number::digits && (c == cl || c == cp))
            number_ = number::closed;
        else if (number_ != number::digits || (c != sy && c != is))
            number_ = number::none;
        before_ = c;
        spaces_ = false;
    }

    enum class number : std::uint8_t { none, digits, closed };

    const character* all_;
    std::size_t size_;
    line_class before_ = line_class::bk;  // the last that is no space, and no mark on another
    bool spaces_ = false;                 // behind that
    number number_ = number::none;
    bool half_a_flag_ = false;
    bool hebrew_hyphen_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
