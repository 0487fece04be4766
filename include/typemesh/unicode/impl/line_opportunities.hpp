// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/class_set.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a line may end, or must end, before a character.
enum class line_opportunity : std::uint8_t { none, allowed, mandatory };

/// Finds where the lines of a text may end: the line breaking algorithm of UAX #14, with no rule changed. Small kana do
/// not begin a line (strict). There are no opportunities inside Thai and other scripts whose words need a dictionary.
///
///     all, size    the text's characters
///     i            call it for each character in order, from 0
///
/// Cost   O(n) in total; marks after a quotation mark or before a number are read once more
class line_opportunities {
    using classes = class_set<line_class>;

public:
    static constexpr bool finds_any = true;
    static constexpr line_opportunity allowed = line_opportunity::allowed, mandatory = line_opportunity::mandatory;

    line_opportunities(const character* all, std::size_t size) noexcept : all_{all}, size_{size} {}

    [[nodiscard]] line_opportunity operator()(std::size_t i) noexcept
    {
        using enum line_class;
        line_class c = resolved(all_[i].line);
        bool wide = all_[i].wide;
        const line_class previous = i == 0 ? wj : all_[i - 1].line;
        const bool starts = i == 0 || classes{bk, cr, lf, nl}.holds(previous);
        const bool joined = previous == zwj && i > 0;
        if (c == cm || c == zwj) {
            if (!starts && !spaces_ && before_ != zw) return line_opportunity::none;  // LB9
            c = al;                                                                   // LB10
            wide = false;
        }
        line_opportunity found = line_opportunity::none;
        if (i > 0 && starts)
            found = previous == cr && c == lf ? line_opportunity::none : line_opportunity::mandatory;  // LB4, LB5
        else if (i > 0 && !joined && breaks(i, c, wide))
            found = line_opportunity::allowed;
        pass(c, wide, starts);
        return found;
    }

private:
    static constexpr classes quotes{line_class::qu, line_class::qu_pi, line_class::qu_pf};
    static constexpr classes brackets{line_class::op, line_class::op_wide};
    static constexpr classes letters{line_class::al, line_class::hl, line_class::circle, line_class::al_picto};
    static constexpr classes aksaras{line_class::ak, line_class::as, line_class::circle};

    /// LB1, as far as the tables have not applied it.
    [[nodiscard]] static constexpr line_class resolved(line_class c) noexcept
    {
        using enum line_class;
        return c == sa ? al : c == sa_mark ? cm : c == cj ? ns : c;
    }

    /// The place of the next character that is not a mark on character i; `size_` at the end of the text.
    [[nodiscard]] std::size_t after(std::size_t i) const noexcept
    {
        using enum line_class;
        do ++i;
        while (i < size_ && classes{cm, zwj, sa_mark}.holds(all_[i].line));
        return i;
    }
    [[nodiscard]] bool is_at(std::size_t i, classes wanted) const noexcept
    {
        return i < size_ && wanted.holds(resolved(all_[i].line));
    }

    /// LB6 to LB31 without LB8a to LB10.
    [[nodiscard]] bool breaks(std::size_t i, line_class c, bool wide) const noexcept
    {
        using enum line_class;
        if (classes{bk, cr, lf, nl, sp, zw}.holds(c)) return false;
        if (before_ == zw) return true;
        if (classes{wj, cl, cp, ex, sy}.holds(c)) return false;
        if (c == gl && !spaces_ && !classes{ba, hy, hh}.holds(before_)) return false;
        if (brackets.holds(before_) || opening_) return false;  // LB14, LB15a
        if (c == qu_pf && closes(i)) return false;              // LB15b
        if (c == is) return spaces_ && is_at(after(i), nu);     // LB15c, LB15d
        if ((before_ == cl || before_ == cp) && c == ns) return false;
        if (before_ == b2 && c == b2) return false;
        if (spaces_) return true;
        if (before_ == wj || before_ == gl) return false;
        if (quotes.holds(c) && (c != qu_pi || !before_wide_ || !is_wide_at(after(i)))) return false;
        if (quotes.holds(before_) && (before_ != qu_pf || !wide || !earlier_wide_)) return false;  // LB19, LB19a
        if (c == cb || before_ == cb) return true;
        if (first_hyphen_ && letters.holds(c)) return false;  // LB20a
        if (hebrew_hyphen_ && c != hl) return false;          // LB21a
        return !(in_number(i, c) || in_syllable(i, c) || (c == ri && half_a_flag_) || joins(before_, c));
    }

    /// LB15b: whether the characters after a quotation mark show that it closes.
    [[nodiscard]] bool closes(std::size_t i) const noexcept
    {
        using enum line_class;
        const std::size_t next = after(i);
        return next == size_ || is_at(next, {sp, gl, wj, cl, qu, qu_pi, qu_pf, cp, ex, is, sy, bk, cr, lf, nl, zw});
    }
    [[nodiscard]] bool is_wide_at(std::size_t i) const noexcept { return i < size_ && all_[i].wide; }

    /// LB25: a number with the characters before and after it.
    [[nodiscard]] bool in_number(std::size_t i, line_class c) const noexcept
    {
        using enum line_class;
        if (number_ != number::none && (c == po || c == pr)) return true;
        if (number_ == number::digits && c == nu) return true;
        if (before_ != po && before_ != pr) return false;
        if (c == nu) return true;
        if (!brackets.holds(c)) return false;
        i = after(i);
        return is_at(i, nu) || (is_at(i, is) && is_at(after(i), nu));
    }

    /// The part of LB28a that looks beyond a neighbour.
    [[nodiscard]] bool in_syllable(std::size_t i, line_class c) const noexcept
    {
        using enum line_class;
        if (stacks_ && (c == ak || c == circle)) return true;
        return aksaras.holds(before_) && aksaras.holds(c) && is_at(after(i), vf);
    }

    /// The rules of LB21 to LB30b about two neighbours: for each class, the classes that must stay with it.
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
            for (classes& c : after) c = {ba, hh, hy, ns, in};  // LB21, LB22
            for (std::size_t c = 0; c < count; ++c) after[static_cast<std::size_t>(bb)].add(static_cast<line_class>(c));
            join({sy}, {hl});                                                     // LB21b
            join({al, hl, circle, al_picto}, letters | classes{nu, pr, po, op});  // LB23, LB24, LB28, LB30
            join({nu}, letters | classes{op});                                    // LB23, LB30
            join({pr}, {id, picto, eb, em});                                      // LB23a
            join({id, picto, eb, em}, {po});                                      //
            join({pr, po, is, cp}, letters);                                      // LB24, LB29, LB30
            join({hy, is, cp}, {nu});                                             // LB25, LB30
            join({ap}, {ak, as, circle});                                         // LB28a
            join({ak, as, circle}, {vf, vi});                                     //
            join({jl}, {jl, jv, h2, h3});                                         // LB26
            join({jv, h2}, {jv, jt});                                             //
            join({jt, h3}, {jt});                                                 //
            join({jl, jv, jt, h2, h3}, {po});                                     // LB27
            join({pr}, {jl, jv, jt, h2, h3});                                     //
            join({eb, picto, al_picto}, {em});                                    // LB30b
        }
    };

    [[nodiscard]] static bool joins(line_class before, line_class c) noexcept
    {
        static constexpr neighbours all;
        return all.after[static_cast<std::size_t>(before)].holds(c);
    }

    /// Stores what the next character must know about this one.
    void pass(line_class c, bool wide, bool starts) noexcept
    {
        using enum line_class;
        if (starts) before_ = bk;
        if (c == sp) {
            spaces_ = true;
            number_ = number::none;
            half_a_flag_ = hebrew_hyphen_ = first_hyphen_ = stacks_ = false;
            return;
        }
        const bool hyphen = c == hy || c == hh, apart = spaces_ || before_ == bk || before_ == zw || before_ == gl;
        hebrew_hyphen_ = hyphen && before_ == hl && !spaces_;  // LB21a
        first_hyphen_ = hyphen && (apart || before_ == cb);    // LB20a
        opening_ = c == qu_pi && (apart || brackets.holds(before_) || quotes.holds(before_));
        stacks_ = c == vi && aksaras.holds(before_) && !spaces_;
        half_a_flag_ = c == ri && !half_a_flag_;  // LB30a
        if (c == nu)
            number_ = number::digits;
        else if (number_ == number::digits && (c == cl || c == cp))
            number_ = number::closed;
        else if (number_ != number::digits || (c != sy && c != is))
            number_ = number::none;
        earlier_wide_ = before_wide_ && !spaces_ && before_ != bk;
        before_wide_ = wide;
        before_ = c;
        spaces_ = false;
    }

    enum class number : std::uint8_t { none, digits, closed };

    const character* all_;
    std::size_t size_;
    line_class before_ = line_class::bk;  // the last character that is not a space, nor a mark on another one
    bool before_wide_ = false;
    bool earlier_wide_ = false;  // of the character before before_
    bool spaces_ = false;        // after before_
    number number_ = number::none;
    bool half_a_flag_ = false;
    bool hebrew_hyphen_ = false;
    bool first_hyphen_ = false;  // the hyphen begins a word
    bool opening_ = false;       // an opening quotation mark, maybe with spaces after it
    bool stacks_ = false;        // a letter with a sign that stacks the next letter
};

}  // namespace typemesh::inline TYPEMESH_ABI
