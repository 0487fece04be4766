// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/character.hpp>

#include <cstddef>
#include <initializer_list>
#include <vector>

/// The line breaking algorithm as UAX #14 words it: each place is asked by itself, and looks at all before and behind it.
namespace slow_breaks {

using typemesh::line_class;
using enum typemesh::line_class;
using classes = std::vector<line_class>;

inline bool is_one(line_class c, std::initializer_list<line_class> all)
{
    for (const line_class a : all)
        if (a == c) return true;
    return false;
}

/// LB9 and LB10: marks go with what they stand on, or are letters.
inline classes without_marks(const classes& given)
{
    classes kept;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const bool mark = is_one(given[i], {cm, zwj});
        const bool alone = i == 0 || is_one(given[i - 1], {bk, cr, lf, nl, sp, zw});
        if (!mark || alone) kept.push_back(mark ? al : given[i]);
    }
    return kept;
}

/// Whether a line may end before character i; 2 if it must.
inline int breaks(classes all, std::size_t i)
{
    for (line_class& c : all) c = c == sa ? al : c == sa_mark ? cm : c == cj ? ns : c;
    const line_class raw_a = all[i - 1], raw_b = all[i];
    if (raw_a == bk) return 2;                      // LB4
    if (raw_a == cr && raw_b == lf) return 0;       // LB5
    if (is_one(raw_a, {cr, lf, nl})) return 2;      //
    if (is_one(raw_b, {bk, cr, lf, nl})) return 0;  // LB6
    if (is_one(raw_b, {sp, zw})) return 0;          // LB7
    std::size_t k = i;
    while (k > 0 && all[k - 1] == sp) --k;
    if (k > 0 && all[k - 1] == zw) return 1;                // LB8
    if (raw_a == zwj) return 0;                             // LB8a
    if (is_one(raw_b, {cm, zwj}) && raw_a != sp) return 0;  // LB9

    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(i);
    classes left = without_marks({all.begin(), middle}), right = without_marks({middle, all.end()});
    const line_class a = left.back(), b = right.front();
    const line_class second = right.size() > 1 ? right[1] : al;
    classes bare = left;  // without the spaces at its end
    while (!bare.empty() && bare.back() == sp) bare.pop_back();
    const line_class c = bare.empty() ? al : bare.back();

    if (b == wj || a == wj || a == gl) return 0;                                          // LB11, LB12
    if (b == gl && !is_one(a, {sp, ba, hy})) return 0;                                    // LB12a
    if (is_one(b, {cl, cp, ex, is, sy})) return 0;                                        // LB13
    if (is_one(c, {op, op_wide})) return 0;                                               // LB14
    if (c == qu && is_one(b, {op, op_wide})) return 0;                                    // LB15
    if (is_one(c, {cl, cp}) && b == ns) return 0;                                         // LB16
    if (c == b2 && b == b2) return 0;                                                     // LB17
    if (a == sp) return 1;                                                                // LB18
    if (a == qu || b == qu) return 0;                                                     // LB19
    if (a == cb || b == cb) return 1;                                                     // LB20
    if (is_one(b, {ba, hy, ns}) || a == bb) return 0;                                     // LB21
    if (left.size() > 1 && left[left.size() - 2] == hl && is_one(a, {hy, ba})) return 0;  // LB21a
    if (a == sy && b == hl) return 0;                                                     // LB21b
    if (b == in) return 0;                                                                // LB22
    const bool letter_a = is_one(a, {al, hl}), letter_b = is_one(b, {al, hl});
    if ((letter_a && b == nu) || (a == nu && letter_b)) return 0;                                      // LB23
    if (a == pr && is_one(b, {id, picto, eb, em})) return 0;                                           // LB23a
    if (is_one(a, {id, picto, eb, em}) && b == po) return 0;                                           //
    if (is_one(a, {pr, po}) && letter_b) return 0;                                                     // LB24
    if (letter_a && is_one(b, {pr, po})) return 0;                                                     //
    if (is_one(a, {pr, po}) && (b == nu || (is_one(b, {op, op_wide, hy}) && second == nu))) return 0;  // LB25
    if (is_one(a, {op, op_wide, hy}) && b == nu) return 0;                                             //
    classes number = left;
    const bool closed = is_one(a, {cl, cp});
    if (closed) number.pop_back();
    while (!number.empty() && is_one(number.back(), {sy, is})) number.pop_back();
    const bool in_number = !number.empty() && number.back() == nu;
    if (in_number && ((!closed && is_one(b, {nu, sy, is, cl, cp})) || is_one(b, {po, pr}))) return 0;
    if (a == jl && is_one(b, {jl, jv, h2, h3})) return 0;      // LB26
    if (is_one(a, {jv, h2}) && is_one(b, {jv, jt})) return 0;  //
    if (is_one(a, {jt, h3}) && b == jt) return 0;              //
    if (is_one(a, {jl, jv, jt, h2, h3}) && b == po) return 0;  // LB27
    if (a == pr && is_one(b, {jl, jv, jt, h2, h3})) return 0;  //
    if (letter_a && letter_b) return 0;                        // LB28
    if (a == is && letter_b) return 0;                         // LB29
    if ((letter_a || a == nu) && b == op) return 0;            // LB30
    if (a == cp && (letter_b || b == nu)) return 0;            //
    std::size_t flags = 0;
    while (flags < left.size() && left[left.size() - 1 - flags] == ri) ++flags;
    if (flags % 2 == 1 && b == ri) return 0;          // LB30a
    if (is_one(a, {eb, picto}) && b == em) return 0;  // LB30b
    return 1;
}

}  // namespace slow_breaks
