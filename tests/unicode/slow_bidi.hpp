// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/bidi_brackets.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// The bidirectional algorithm in the words of UAX #9: rule by rule over the whole text, with a search for each "find".
/// It is quadratic, and shares no code with the library.
namespace slow_bidi {

using typemesh::bidi_class;
using enum typemesh::bidi_class;
using classes = std::vector<bidi_class>;

inline bool is_one(bidi_class c, std::initializer_list<bidi_class> all)
{
    return std::find(all.begin(), all.end(), c) != all.end();
}
inline bool initiates(bidi_class c) { return is_one(c, {lri, rli, fsi}); }
inline bool removed(bidi_class c) { return is_one(c, {rle, lre, rlo, lro, pdf, bn}); }

/// BD9; the text's size if there is none.
inline std::size_t matching_pdi(const classes& text, std::size_t initiator)
{
    std::size_t depth = 1;
    for (std::size_t i = initiator + 1; i < text.size(); ++i) {
        if (initiates(text[i])) ++depth;
        if (text[i] == pdi && --depth == 0) return i;
    }
    return text.size();
}

/// P2 and P3 for [first, last).
inline int level_by_first_letter(const classes& text, std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i) {
        if (is_one(text[i], {l})) return 0;
        if (is_one(text[i], {r, al})) return 1;
        if (initiates(text[i])) i = matching_pdi(text, i);
    }
    return 0;
}

/// X1 to X8: levels, and the classes that overrides change.
inline std::vector<int> explicit_levels(const classes& original, classes& text, int base)
{
    struct entry {
        int level;
        bidi_class override_to;
        bool isolate;
    };
    std::vector<entry> stack{{base, on, false}};
    int overflow_isolates = 0, overflow_embeddings = 0, valid_isolates = 0;
    std::vector<int> levels(text.size(), base);
    const auto odd = [&] { return (stack.back().level + 1) | 1; };
    const auto even = [&] { return (stack.back().level + 2) & ~1; };
    for (std::size_t i = 0; i < text.size(); ++i) {
        bidi_class c = original[i];
        if (is_one(c, {rle, lre, rlo, lro})) {
            const int level = is_one(c, {rle, rlo}) ? odd() : even();
            if (level <= 125 && overflow_isolates == 0 && overflow_embeddings == 0)
                stack.push_back({level, c == rlo ? r : c == lro ? l : on, false});
            else if (overflow_isolates == 0)
                ++overflow_embeddings;
        } else if (initiates(c)) {
            levels[i] = stack.back().level;
            if (stack.back().override_to != on) text[i] = stack.back().override_to;
            if (c == fsi) c = level_by_first_letter(original, i + 1, matching_pdi(original, i)) == 1 ? rli : lri;
            const int level = c == rli ? odd() : even();
            if (level <= 125 && overflow_isolates == 0 && overflow_embeddings == 0) {
                ++valid_isolates;
                stack.push_back({level, on, true});
            } else
                ++overflow_isolates;
        } else if (c == pdi) {
            if (overflow_isolates > 0)
                --overflow_isolates;
            else if (valid_isolates > 0) {
                overflow_embeddings = 0;
                while (!stack.back().isolate) stack.pop_back();
                stack.pop_back();
                --valid_isolates;
            }
            levels[i] = stack.back().level;
            if (stack.back().override_to != on) text[i] = stack.back().override_to;
        } else if (c == pdf) {
            if (overflow_isolates > 0) continue;
            if (overflow_embeddings > 0)
                --overflow_embeddings;
            else if (!stack.back().isolate && stack.size() >= 2)
                stack.pop_back();
        } else if (c == b)
            levels[i] = base;
        else if (c != bn) {
            levels[i] = stack.back().level;
            if (stack.back().override_to != on) text[i] = stack.back().override_to;
        }
    }
    return levels;
}

/// BD13: the characters of each isolating run sequence, in order.
inline std::vector<std::vector<std::size_t>> sequences(const classes& original, const std::vector<int>& levels)
{
    std::vector<std::vector<std::size_t>> runs;
    for (std::size_t i = 0; i < original.size(); ++i) {
        if (removed(original[i])) continue;
        if (runs.empty() || levels[runs.back().back()] != levels[i]) runs.emplace_back();
        runs.back().push_back(i);
    }
    const auto has_initiator = [&](std::size_t at) {
        for (std::size_t i = 0; i < at; ++i)
            if (initiates(original[i]) && matching_pdi(original, i) == at) return true;
        return false;
    };
    std::vector<std::vector<std::size_t>> all;
    for (const auto& run : runs) {
        if (original[run.front()] == pdi && has_initiator(run.front())) continue;
        auto sequence = run;
        while (initiates(original[sequence.back()])) {
            const std::size_t partner = matching_pdi(original, sequence.back());
            const auto next =
                std::find_if(runs.begin(), runs.end(), [&](const auto& r) { return r.front() == partner; });
            if (next == runs.end()) break;
            sequence.insert(sequence.end(), next->begin(), next->end());
        }
        all.push_back(sequence);
    }
    return all;
}

/// BD16.
inline std::vector<std::pair<std::size_t, std::size_t>> bracket_pairs(const std::u32string& text, const classes& t,
                                                                      const std::vector<std::size_t>& places)
{
    std::vector<std::pair<char32_t, std::size_t>> stack;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (t[k] != on) continue;
        const char32_t c = text[places[k]];
        const auto kind = typemesh::character_of(c).bracket;
        if (kind == typemesh::bracket_kind::opening) {
            if (stack.size() == 63) break;
            stack.emplace_back(typemesh::opening_bracket(c, kind), k);
        }
        if (kind != typemesh::bracket_kind::closing) continue;
        for (std::size_t d = stack.size(); d-- > 0;)
            if (stack[d].first == typemesh::opening_bracket(c, kind)) {
                pairs.emplace_back(stack[d].second, k);
                stack.resize(d);
                break;
            }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

inline bidi_class strong(bidi_class c) { return c == l ? l : is_one(c, {r, al, en, an}) ? r : on; }

/// W1 to W7.
inline void weak(classes& t, bidi_class sos)
{
    const std::size_t n = t.size();
    for (std::size_t k = 0; k < n; ++k)
        if (t[k] == nsm) t[k] = k == 0 ? sos : initiates(t[k - 1]) || t[k - 1] == pdi ? on : t[k - 1];
    const auto letter_before = [&](std::size_t k) {
        while (k-- > 0)
            if (is_one(t[k], {l, r, al})) return t[k];
        return sos;
    };
    for (std::size_t k = 0; k < n; ++k)
        if (t[k] == en && letter_before(k) == al) t[k] = an;
    for (bidi_class& c : t)
        if (c == al) c = r;
    for (std::size_t k = 1; k + 1 < n; ++k) {
        if (is_one(t[k], {es, cs}) && t[k - 1] == en && t[k + 1] == en) t[k] = en;
        if (t[k] == cs && t[k - 1] == an && t[k + 1] == an) t[k] = an;
    }
    for (std::size_t k = 0; k < n; ++k)
        if (t[k] == en) {
            for (std::size_t i = k; i-- > 0 && t[i] == et;) t[i] = en;
            for (std::size_t i = k + 1; i < n && t[i] == et; ++i) t[i] = en;
        }
    for (bidi_class& c : t)
        if (is_one(c, {es, et, cs})) c = on;
    for (std::size_t k = 0; k < n; ++k)
        if (t[k] == en && letter_before(k) == l) t[k] = l;
}

/// N0 to N2.
inline bidi_class first_strong(const classes& t, std::size_t from, int step, bidi_class otherwise)
{
    for (std::size_t i = from; i < t.size(); i += static_cast<std::size_t>(step))
        if (strong(t[i]) != on) return strong(t[i]);
    return otherwise;
}

inline void neutral(classes& t, bidi_class sos, bidi_class eos, bidi_class embedding, const std::u32string& text,
                    const classes& before_w1, const std::vector<std::size_t>& places)
{
    for (const auto& [opening, closing] : bracket_pairs(text, t, places)) {
        bool same = false, other = false;
        for (std::size_t k = opening + 1; k < closing; ++k) {
            same = same || strong(t[k]) == embedding;
            other = other || (strong(t[k]) != on && strong(t[k]) != embedding);
        }
        if (!same && !other) continue;
        const bidi_class to = same ? embedding : first_strong(t, opening - 1, -1, sos);
        for (const std::size_t bracket : {opening, closing}) {
            t[bracket] = to;
            for (std::size_t k = bracket + 1; k < t.size() && before_w1[k] == nsm; ++k) t[k] = to;
        }
    }
    const classes given = t;
    for (std::size_t k = 0; k < t.size(); ++k) {
        if (strong(given[k]) != on) continue;
        const bidi_class before = first_strong(given, k - 1, -1, sos), after = first_strong(given, k + 1, 1, eos);
        t[k] = before == after ? before : embedding;
    }
}

/// The levels of a paragraph, -1 for what rule X9 removes. `base` is its level, or -1 to find it.
inline std::vector<int> levels(const std::u32string& text, const classes& original, int& base)
{
    if (base < 0) base = level_by_first_letter(original, 0, original.size());
    classes types = original;
    std::vector<int> levels = explicit_levels(original, types, base);
    const std::vector<int> given = levels;
    const auto level_beside = [&](std::size_t from, int step) {
        for (std::size_t i = from + static_cast<std::size_t>(step); i < original.size();
             i += static_cast<std::size_t>(step))
            if (!removed(original[i])) return given[i];
        return base;
    };
    for (const auto& places : sequences(original, given)) {
        classes t;
        for (const std::size_t i : places) t.push_back(types[i]);
        const int level = given[places.front()];
        const int before = level_beside(places.front(), -1);
        const int after = initiates(original[places.back()]) ? base : level_beside(places.back(), 1);
        const auto letter = [&](int beside) { return std::max(level, beside) % 2 == 0 ? l : r; };
        const classes before_w1 = t;
        weak(t, letter(before));
        neutral(t, letter(before), letter(after), level % 2 == 0 ? l : r, text, before_w1, places);
        for (std::size_t k = 0; k < t.size(); ++k)
            levels[places[k]] = level + (level % 2 == 0 ? (t[k] == r ? 1 : t[k] == l ? 0 : 2) : (t[k] == r ? 0 : 1));
    }
    for (std::size_t i = 0; i < original.size(); ++i)
        if (removed(original[i])) levels[i] = -1;
    return levels;
}

}  // namespace slow_bidi
