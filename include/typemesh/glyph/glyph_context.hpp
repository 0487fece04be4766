// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/outline/variation_key.hpp>

#include <concepts>
#include <cstdint>
#include <optional>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// What distinguishes one policy from another: its type, and those of its options that matter.
struct policy_key {
    const void* type = nullptr;
    option_bits options;

    friend bool operator==(const policy_key&, const policy_key&) noexcept = default;
};

/// A policy that states its options itself: `option_bits cache_key() const noexcept`.
template <class P>
concept says_cache_key = requires(const P& p) {
    { p.cache_key() } noexcept -> std::convertible_to<option_bits>;
};

/// A policy's key. One without data members needs no cache_key(): its type is enough.
template <class Policy>
[[nodiscard]] policy_key key_of(const Policy& p) noexcept
{
    static_assert(
        says_cache_key<Policy> || std::is_empty_v<Policy>,
        "typemesh: a policy with data members needs `typemesh::option_bits cache_key() const noexcept` "
        "before its glyphs can be kept in a glyph_cache, which otherwise could not tell those of different options "
        "apart; see typemesh/core/option_bits.hpp.");
    policy_key key{&detail::place_of_type<Policy>, {}};
    if constexpr (says_cache_key<Policy>) key.options = p.cache_key();
    return key;
}

/// Everything that a built glyph depends on except its id: two texts may share glyphs exactly if theirs are equal.
struct glyph_context {
    std::uint64_t font = 0;       ///< the caller's number for the font
    std::uint64_t variation = 0;  ///< what the font itself reports of its variation and face; see variation_of()
    std::uint64_t tolerance = 0;  ///< the bits of the double
    std::uint64_t fill = 0;       ///< 0: the outline source's own rule; else one more than the rule
    std::uint64_t most_pieces = 0;
    std::uint64_t most_points = 0;
    std::uint64_t corners = 0;  ///< 0: as they are drawn; else which way, and the bits of glyph_settings::most_cells
    policy_key discretiser, triangulator, extruder;

    friend bool operator==(const glyph_context&, const glyph_context&) noexcept = default;

    /// A hash: mostly different for different contexts.
    [[nodiscard]] std::uint64_t hash() const noexcept
    {
        std::uint64_t h = 0;
        const auto mix = [&h](std::uint64_t v) noexcept { h = mixed_key(h, v); };
        mix(font);
        mix(variation);
        mix(tolerance);
        mix(fill);
        mix(most_pieces);
        mix(most_points);
        mix(corners);
        for (const policy_key* p : {&discretiser, &triangulator, &extruder}) {
            mix(reinterpret_cast<std::uintptr_t>(p->type));
            for (const std::uint64_t word : p->options.words) mix(word);
        }
        return h;
    }
};

/// The context of glyphs that glyph_builder builds with these policies.
template <class Font, class... Policy>
[[nodiscard]] glyph_context context_of(std::uint64_t font_number, const Font& font, const glyph_settings& how,
                                       const policies<Policy...>& with) noexcept
{
    glyph_context c;
    c.font = font_number;
    c.variation = variation_of(font);
    c.tolerance = option_bits{how.tolerance}.words[0];
    c.fill = how.fill ? 1 + static_cast<std::uint64_t>(*how.fill) : 0;
    c.most_pieces = how.most_pieces;
    c.most_points = how.most_points;
    if (how.corners != touching::keep)
        c.corners = option_bits{how.most_cells}.words[0] | static_cast<std::uint64_t>(how.corners);
    c.discretiser = key_of(with.flatten);
    c.triangulator = key_of(with.cut);
    c.extruder = key_of(with.raise);
    return c;
}

}  // namespace typemesh::inline TYPEMESH_ABI
