// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/unicode/impl/bidi_sequence.hpp>
#include <typemesh/unicode/impl/bracket_table.hpp>
#include <typemesh/unicode/impl/character.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The opening bracket of a bracket's pair: Bidi_Paired_Bracket. The result is the same for the two canonically
/// equivalent kinds of angle brackets.
[[nodiscard]] constexpr char32_t opening_bracket(char32_t bracket, bracket_kind kind) noexcept
{
    if (kind == bracket_kind::closing) {
        constexpr std::size_t count = sizeof detail::bracket_pairs / sizeof detail::bracket_pairs[0];
        const std::size_t k =
            first_where(0, count, [&](std::size_t i) noexcept { return detail::bracket_pairs[i] >> 16 >= bracket; });
        if (k < count && detail::bracket_pairs[k] >> 16 == bracket) bracket = detail::bracket_pairs[k] & 0xFFFF;
    }
    return bracket == 0x2329 ? 0x3008 : bracket;
}

namespace detail {

/// An opening bracket in a sequence, and its partner, if any.
struct opened_bracket {
    static constexpr std::uint32_t none = 0xFFFF'FFFF;

    std::uint32_t place;  ///< in the sequence
    std::uint32_t closing = none;
    bidi_classes inside = {};  ///< l, r: the directions between the two
};

/// Finds the pairs of a sequence, as defined in BD16: at most 63 are open at a time.
///
///     opened    gets all opening brackets in order; it needs one element for each
///
/// Returns their number. Cost: O(n)
inline std::size_t pair_brackets(const bidi_sequence& sequence, const char32_t* text, opened_bracket* opened) noexcept
{
    struct entry {
        char32_t bracket;
        std::uint32_t number;
    };
    constexpr std::size_t most = 63;
    entry open[most];
    std::size_t depth = 0, count = 0;
    for (std::size_t k = 0; k < sequence.size; ++k) {
        const bidi_class c = sequence.classes[k];
        if (c != bidi_class::on) {
            if (depth > 0) opened[open[depth - 1].number].inside.add(direction_beside(c));
            continue;
        }
        const char32_t value = text[sequence.places[k]];
        const bracket_kind kind = character_of(value).bracket;
        if (kind == bracket_kind::none) continue;
        const char32_t bracket = opening_bracket(value, kind);
        if (kind == bracket_kind::opening) {
            if (depth == most) break;
            open[depth++] = {bracket, static_cast<std::uint32_t>(count)};
            opened[count++] = {static_cast<std::uint32_t>(k)};
            continue;
        }
        std::size_t partner = depth;
        while (partner > 0 && open[partner - 1].bracket != bracket) --partner;
        if (partner == 0) continue;
        // Characters inside a pair of brackets are also inside all pairs around it.
        for (; depth >= partner; --depth)
            if (depth > 1) opened[open[depth - 2].number].inside.add(opened[open[depth - 1].number].inside);
        opened[open[partner - 1].number].closing = static_cast<std::uint32_t>(k);
    }
    return count;
}

/// Rule N0: if the direction of the embedding occurs between a pair of brackets, both brackets take this direction. If
/// only the other direction occurs, they take the direction of the context. Marks on a bracket take its direction.
///
///     original   the classes of all characters of the paragraph, before any rule
inline void resolve_brackets(const bidi_sequence& sequence, const bidi_class* original, const opened_bracket* opened,
                             std::size_t count) noexcept
{
    const bidi_class embedding = sequence.embedding();
    const auto set = [&](std::size_t k, bidi_class to) noexcept {
        do sequence.classes[k] = to;
        while (++k < sequence.size && sequence.classes[k] == bidi_class::on &&
               original[sequence.places[k]] == bidi_class::nsm);
    };
    bidi_class context = sequence.start;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const opened_bracket& b = opened[i];
        if (b.closing == opened_bracket::none) continue;
        for (; seen < b.place; ++seen)
            if (const bidi_class c = direction_beside(sequence.classes[seen]); c != bidi_class::on) context = c;
        if (!b.inside.meets({bidi_class::l, bidi_class::r})) continue;
        const bidi_class to = b.inside.holds(embedding) ? embedding : context;
        set(b.place, to);
        set(b.closing, to);
    }
}

}  // namespace detail
}  // namespace typemesh::inline TYPEMESH_ABI
