// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/policy_key.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/glyph/glyph_builder.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Everything on which a built glyph depends, except its id. Two texts may share glyphs if, and only if, their
/// contexts are equal.
struct glyph_context {
    std::uint64_t font = 0;       ///< the caller's number for the font
    std::uint64_t variation = 0;  ///< the font's own key for its variation and face; see variation_of()
    std::uint64_t tolerance = 0;  ///< the bits of the double
    std::uint64_t fill = 0;       ///< 0: the outline source's own rule; otherwise the rule's number plus 1
    std::uint64_t max_pieces = 0;
    std::uint64_t max_points = 0;
    std::uint64_t corners = 0;  ///< 0: as drawn; otherwise the treatment, and the bits of glyph_settings::max_cells
    std::uint64_t depths = 0;   ///< the bits of solid_place::em_per_depth; 0 if corners are as drawn
    policy_key discretiser, triangulator, extruder, step;  ///< one for each kind of policy

    /// Whether all policies can be distinguished from others of their types: see cacheable_policy.
    [[nodiscard]] bool is_complete() const noexcept
    {
        return discretiser.type != nullptr && triangulator.type != nullptr && extruder.type != nullptr &&
               step.type != nullptr;
    }

    friend bool operator==(const glyph_context&, const glyph_context&) noexcept = default;

    /// A hash. Distinct contexts almost always have distinct hashes.
    [[nodiscard]] std::uint64_t hash() const noexcept
    {
        std::uint64_t h = 0;
        const auto mix = [&h](std::uint64_t v) noexcept { h = mixed_key(h, v); };
        mix(font);
        mix(variation);
        mix(tolerance);
        mix(fill);
        mix(max_pieces);
        mix(max_points);
        mix(corners);
        mix(depths);
        for (const policy_key* p : {&discretiser, &triangulator, &extruder, &step}) {
            mix(reinterpret_cast<std::uintptr_t>(p->type));
            for (const std::uint64_t word : p->options.words) mix(word);
        }
        return h;
    }
};

/// The context of glyphs that glyph_builder builds with these policies.
///
///     variation       the key of the font's variation: see variation_of()
///     em_per_depth    of the place for which they are built; matters only if corners are treated
[[nodiscard]] inline glyph_context context_of(std::uint64_t font_number, std::uint64_t variation,
                                              const glyph_settings& how, const policies& with,
                                              double em_per_depth) noexcept
{
    glyph_context c;
    c.font = font_number;
    c.variation = variation;
    c.tolerance = option_bits{how.tolerance}.words[0];
    c.fill = how.fill ? 1 + static_cast<std::uint64_t>(*how.fill) : 0;
    c.max_pieces = how.max_pieces;
    c.max_points = how.max_points;
    if (how.corners != touching::keep) {
        c.depths = option_bits{em_per_depth}.words[0];
        c.corners = option_bits{how.max_cells}.words[0] | static_cast<std::uint64_t>(how.corners);
    }
    c.discretiser = with.flatten.key();
    c.triangulator = with.cut.key();
    c.extruder = with.raise.key();
    c.step = with.step.key();
    return c;
}

}  // namespace typemesh::inline TYPEMESH_ABI
