// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/glyph/built_glyph.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The owner of a triangle of merged glyphs that belongs to more than one glyph.
inline constexpr std::uint32_t shared_glyph = 0xFFFF'FFFFu;

/// Several glyphs merged into one.
struct merged_group {
    const built_glyph* built = nullptr;
    point origin;                    ///< font units: the first glyph's origin, rounded to the grid
    std::uint32_t first_member = 0;  ///< into merged_glyphs::members
    std::uint32_t member_count = 0;
    std::uint32_t first_owner = 0;  ///< into merged_glyphs::owners
};

/// The groups of a text and their members; glyphs are given by their index in the run. All empty if nothing is merged.
struct merged_glyphs {
    buffer<std::uint32_t> first_of;  ///< for each glyph of the run, the first of its group; itself if it is not merged
    buffer<merged_group> groups;     ///< the groups of at least two glyphs, in the order of their first members
    buffer<std::uint32_t> members;   ///< [ first group's glyphs, ascending | second group's | ... ]
    buffer<std::uint32_t> owners;    ///< [ first group's contour points | ... ]: whose outline leads from there to the
                                     ///< next point

    explicit merged_glyphs(memory source) noexcept : first_of{source}, groups{source}, members{source}, owners{source}
    {
    }

    void clear() noexcept
    {
        first_of.clear();
        groups.clear();
        members.clear();
        owners.clear();
    }

    [[nodiscard]] array_view<const std::uint32_t> members_of(const merged_group& g) const noexcept
    {
        return members.view().subspan(g.first_member, g.member_count);
    }
    [[nodiscard]] array_view<const std::uint32_t> owners_of(const merged_group& g) const noexcept
    {
        return owners.view().subspan(g.first_owner, g.built->form().points.size());
    }

    /// The owner of a cap triangle: the glyph whose outline all edges at its three corners follow, or shared_glyph.
    [[nodiscard]] std::uint32_t owner_of(const merged_group& g, const triangle& t) const noexcept
    {
        const auto owner = owners_of(g);
        const auto starts = g.built->form().starts;
        const std::uint32_t first = owner[t.a];
        for (const std::uint32_t corner : {t.a, t.b, t.c}) {
            const std::size_t loop = range_of(starts, corner);
            const std::uint32_t before = corner == starts[loop] ? starts[loop + 1] - 1 : corner - 1;
            if (owner[corner] != first || owner[before] != first) return shared_glyph;
        }
        return first;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
