// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/character.hpp>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <vector>

/// The line breaking algorithm in the words of UAX #14: each place by itself, with a look at all characters around it.
///
/// It also has two older editions, for libraries of other versions of Unicode. 15 describes ICU 70 to 73: the rules of
/// Unicode 15.0, with ICU's own for hyphens at the start of a word and for numbers with a leading full stop.
namespace slow_breaks {

using typemesh::line_class;
using enum typemesh::line_class;

struct letter {
    line_class line = al;
    bool wide = false;
    bool is_2010 = false;  ///< U+2010, the only hyphen of Unicode 16 outside ASCII
};
using letters = std::vector<letter>;

inline bool is_one(line_class c, std::initializer_list<line_class> all)
{
    return std::find(all.begin(), all.end(), c) != all.end();
}
inline bool is_quote(line_class c) { return is_one(c, {qu, qu_pi, qu_pf}); }
inline bool is_letter(line_class c) { return is_one(c, {al, hl, circle, al_picto}); }
inline bool is_aksara(line_class c) { return is_one(c, {ak, as, circle}); }

/// LB9 and LB10: marks belong to the character before them, or are letters.
inline letters without_marks(const letters& given)
{
    letters kept;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const bool mark = is_one(given[i].line, {cm, zwj});
        const bool single = i == 0 || is_one(given[i - 1].line, {bk, cr, lf, nl, sp, zw});
        if (!mark || single) kept.push_back(mark ? letter{} : given[i]);
    }
    return kept;
}

/// A place without its marks: the letters before it, the nearest last, and those after it.
struct place {
    letters left, right;
    [[nodiscard]] line_class before(std::size_t n = 0) const  // bk at the start of the text
    {
        return n < left.size() ? left[left.size() - 1 - n].line : bk;
    }
    [[nodiscard]] bool wide_before(std::size_t n) const { return n < left.size() && left[left.size() - 1 - n].wide; }
    [[nodiscard]] line_class after(std::size_t n = 0) const { return n < right.size() ? right[n].line : bk; }
    [[nodiscard]] bool wide_after(std::size_t n) const { return n < right.size() && right[n].wide; }
};

/// LB25: whether the place is inside a number, or beside a part of one.
inline bool in_number(const place& at, int edition)
{
    const line_class a = at.before(), b = at.after();
    const bool sign = is_one(a, {pr, po});
    if (sign && b == nu) return true;
    if (sign && edition == 15 && is_one(b, {op, op_wide, hy}) && at.after(1) == nu) return true;
    if (sign && edition > 15 && is_one(b, {op, op_wide})) {
        if (at.after(1) == nu || (at.after(1) == is && at.after(2) == nu)) return true;
    }
    if (is_one(a, {op, op_wide, hy, is}) && b == nu) return true;
    const bool closed = is_one(a, {cl, cp});
    std::size_t n = closed ? 1 : 0;
    while (is_one(at.before(n), {sy, is})) ++n;
    if (at.before(n) != nu) return false;
    return is_one(b, {po, pr}) || (!closed && is_one(b, {nu, sy, is, cl, cp}));
}

/// LB28a.
inline bool in_syllable(const place& at)
{
    const line_class a = at.before(), b = at.after();
    if (a == ap && is_aksara(b)) return true;
    if (is_aksara(a) && is_one(b, {vf, vi})) return true;
    if (a == vi && is_aksara(at.before(1)) && is_one(b, {ak, circle})) return true;
    return is_aksara(a) && is_aksara(b) && at.after(1) == vf;
}

/// LB15, LB15a and LB15b. `n`: the number of spaces before the place.
inline bool beside_quote(const place& at, std::size_t n, int edition)
{
    const line_class c = at.before(n), b = at.after();
    if (edition == 15) return n < at.left.size() && is_quote(c) && is_one(b, {op, op_wide});
    const line_class d = at.before(n + 1), e = at.after(1);
    if (c == qu_pi && (is_quote(d) || is_one(d, {bk, cr, lf, nl, op, op_wide, gl, sp, zw}))) return true;
    return b == qu_pf && (is_quote(e) || is_one(e, {sp, gl, wj, cl, cp, ex, is, sy, bk, cr, lf, nl, zw}));
}

/// LB19 and LB19a.
inline bool with_quote(const place& at, int edition)
{
    const line_class a = at.before(), b = at.after();
    if (edition == 15) return is_quote(a) || is_quote(b);
    if (is_one(b, {qu, qu_pf}) || is_one(a, {qu, qu_pi})) return true;
    if (is_quote(b) && (!at.wide_before(0) || !at.wide_after(1))) return true;
    return is_quote(a) && (!at.wide_after(0) || !at.wide_before(1));
}

/// LB20a to LB21b, and LB20.9 of ICU for the edition 15.
inline bool with_hyphen(const place& at, int edition)
{
    const line_class a = at.before(), b = at.after(), c = at.before(1);
    const bool old = edition < 17, hyphen = a == hy || (a == hh && (!old || at.left.back().is_2010));
    bool first = is_one(c, {bk, cr, lf, nl, sp, zw, cb}) || (c == gl && edition > 15);
    std::size_t spaces = 1;
    while (at.before(spaces) == sp) ++spaces;
    if (edition == 15 && is_one(at.before(spaces), {op, op_wide})) first = false;  // ICU's: only after a break
    if (hyphen && first && is_letter(b) && (b != hl || !old)) return true;
    if (is_one(b, {ba, hh, hy, ns}) || a == bb) return true;
    if (c == hl && is_one(a, {hy, hh}) && (edition == 15 || b != hl)) return true;
    if (c == hl && old && a == ba && (edition == 15 || (!at.wide_before(0) && b != hl))) return true;
    return a == sy && b == hl;
}

/// Whether a line may end before character i; 2 if it must.
inline int breaks(letters all, std::size_t i, int edition = 17)
{
    for (letter& l : all) {
        line_class& c = l.line;
        c = c == sa ? al : c == sa_mark ? cm : c == cj ? ns : c;
        if (edition == 15) c = is_one(c, {ak, as, ap}) ? al : is_one(c, {vf, vi}) ? cm : c;
    }
    const line_class raw_a = all[i - 1].line, raw_b = all[i].line;
    if (raw_a == bk) return 2;                      // LB4
    if (raw_a == cr && raw_b == lf) return 0;       // LB5
    if (is_one(raw_a, {cr, lf, nl})) return 2;      //
    if (is_one(raw_b, {bk, cr, lf, nl})) return 0;  // LB6
    if (is_one(raw_b, {sp, zw})) return 0;          // LB7
    std::size_t k = i;
    while (k > 0 && all[k - 1].line == sp) --k;
    if (k > 0 && all[k - 1].line == zw) return 1;           // LB8
    if (raw_a == zwj) return 0;                             // LB8a
    if (is_one(raw_b, {cm, zwj}) && raw_a != sp) return 0;  // LB9

    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(i);
    const place at{without_marks({all.begin(), middle}), without_marks({middle, all.end()})};
    const line_class a = at.before(), b = at.after();
    std::size_t spaces = 0;
    while (at.before(spaces) == sp) ++spaces;
    const line_class c = spaces < at.left.size() ? at.before(spaces) : al;

    if (b == wj || a == wj || a == gl) return 0;                           // LB11, LB12
    if (b == gl && !is_one(a, {sp, ba, hy, hh})) return 0;                 // LB12a
    if (is_one(b, {cl, cp, ex, sy})) return 0;                             // LB13
    if (is_one(c, {op, op_wide})) return 0;                                // LB14
    if (beside_quote(at, spaces, edition)) return 0;                       // LB15
    if (a == sp && b == is && at.after(1) == nu) return 1;                 // LB15c
    if (b == is) return 0;                                                 // LB15d
    if (is_one(c, {cl, cp}) && b == ns) return 0;                          // LB16
    if (c == b2 && b == b2) return 0;                                      // LB17
    if (a == sp) return 1;                                                 // LB18
    if (with_quote(at, edition)) return 0;                                 // LB19
    if (a == cb || b == cb) return 1;                                      // LB20
    if (with_hyphen(at, edition)) return 0;                                // LB20a, LB21
    if (b == in) return 0;                                                 // LB22
    if ((is_letter(a) && b == nu) || (a == nu && is_letter(b))) return 0;  // LB23
    if (a == pr && is_one(b, {id, picto, eb, em})) return 0;               // LB23a
    if (is_one(a, {id, picto, eb, em}) && b == po) return 0;               //
    if (is_one(a, {pr, po}) && is_letter(b)) return 0;                     // LB24
    if (is_letter(a) && is_one(b, {pr, po})) return 0;                     //
    if (in_number(at, edition)) return 0;                                  // LB25
    if (a == jl && is_one(b, {jl, jv, h2, h3})) return 0;                  // LB26
    if (is_one(a, {jv, h2}) && is_one(b, {jv, jt})) return 0;              //
    if (is_one(a, {jt, h3}) && b == jt) return 0;                          //
    if (is_one(a, {jl, jv, jt, h2, h3}) && b == po) return 0;              // LB27
    if (a == pr && is_one(b, {jl, jv, jt, h2, h3})) return 0;              //
    if (is_letter(a) && is_letter(b)) return 0;                            // LB28
    if (in_syllable(at)) return 0;                                         // LB28a
    if (a == is && is_letter(b)) return 0;                                 // LB29
    if ((is_letter(a) || a == nu) && b == op) return 0;                    // LB30
    if (a == cp && (is_letter(b) || b == nu)) return 0;                    //
    std::size_t flags = 0;
    while (at.before(flags) == ri) ++flags;
    if (flags % 2 == 1 && b == ri) return 0;                    // LB30a
    if (is_one(a, {eb, picto, al_picto}) && b == em) return 0;  // LB30b
    return 1;
}

}  // namespace slow_breaks
