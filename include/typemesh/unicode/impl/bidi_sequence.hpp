// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/bidi_class.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An isolating run sequence of UAX #9: characters that are resolved together, gathered from the whole paragraph. It
/// does not contain the characters that rule X9 removes.
struct bidi_sequence {
    bidi_class* classes;
    const std::uint32_t* places;  ///< the places of the characters in the paragraph
    std::size_t size;
    std::uint8_t level;
    bidi_class start;  ///< sos and eos: l or r
    bidi_class end;

    [[nodiscard]] bidi_class embedding() const noexcept { return level % 2 == 0 ? bidi_class::l : bidi_class::r; }
};

/// The direction that neighbours see in rules N0 to N2: l, or r (also for digits). All other classes give on.
[[nodiscard]] constexpr bidi_class direction_beside(bidi_class c) noexcept
{
    using enum bidi_class;
    return c == l ? l : bidi_classes{r, al, en, an}.holds(c) ? r : on;
}

/// Rules W1 to W3: marks, Arabic digits and letters.
inline void resolve_marks(const bidi_sequence& sequence) noexcept
{
    using enum bidi_class;
    bidi_class before = sequence.start, letter = sequence.start;
    for (std::size_t k = 0; k < sequence.size; ++k) {
        bidi_class& c = sequence.classes[k];
        if (c == nsm) c = bidi_classes{lri, rli, fsi, pdi}.holds(before) ? on : before;
        before = c;
        if (bidi_classes{l, r, al}.holds(c)) letter = c;
        if (c == en && letter == al) c = an;
        if (c == al) c = r;
    }
}

/// Rules W4 to W7: separators, terminators, digits after Latin.
inline void resolve_numbers(const bidi_sequence& sequence) noexcept
{
    using enum bidi_class;
    bidi_class* const t = sequence.classes;
    const std::size_t n = sequence.size;
    bidi_class before =
        sequence.start;  // before these rules: no rule needs a separator's class after W4, because a digit follows it
    bool latin = sequence.start == l;
    for (std::size_t k = 0, next = 0; k < n; k = next) {
        next = k + 1;
        const bidi_class given = t[k];
        bidi_class c = given;
        if (c == es || c == cs) {
            const bidi_class after = next < n ? t[next] : on;
            c = before == after && (before == en || (before == an && c == cs)) ? before : on;
        } else if (c == et) {
            while (next < n && t[next] == et) ++next;
            c = before == en || (next < n && t[next] == en) ? en : on;
        }
        if (c == l || c == r) latin = c == l;
        before = given;
        if (c == en && latin) c = l;
        while (k < next) t[k++] = c;
    }
}

/// Rules N1 and N2: characters between two letters of one direction take it. All others take the embedding direction.
inline void resolve_neutrals(const bidi_sequence& sequence) noexcept
{
    bidi_class* const t = sequence.classes;
    const std::size_t n = sequence.size;
    bidi_class before = sequence.start;
    for (std::size_t k = 0, last = 0; k < n; k = last) {
        last = k;
        bidi_class after = sequence.end;
        while (last < n && (after = direction_beside(t[last])) == bidi_class::on) ++last;
        if (last == n) after = sequence.end;
        for (; k < last; ++k) t[k] = before == after ? before : sequence.embedding();
        before = after;
        ++last;
    }
}

/// Rules I1 and I2.
[[nodiscard]] constexpr std::uint8_t implicit_level(std::uint8_t level, bidi_class c) noexcept
{
    const bool odd = level % 2 != 0;
    if (c == bidi_class::l) return static_cast<std::uint8_t>(level + (odd ? 1 : 0));
    if (c == bidi_class::r) return static_cast<std::uint8_t>(level + (odd ? 0 : 1));
    return static_cast<std::uint8_t>(level + (odd ? 1 : 2));
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
