// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/glyph/glyph_shape.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh {

/// Which glyph a triangle of merged glyphs belongs to, when it is not one's alone.
inline constexpr std::uint32_t shared_glyph = 0xFFFF'FFFFu;

/// One cluster of glyphs that are merged to one shape.
struct merged_cluster {
    const glyph_shape* shape = nullptr;
    point origin;                    ///< font units: that of its first glyph, rounded to the grid
    std::uint32_t first_member = 0;  ///< into merged_glyphs::members
    std::uint32_t member_count = 0;
    std::uint32_t first_owner = 0;   ///< into merged_glyphs::owners
};

/// The clusters of a text, and who is in them; glyphs go by their places in the run. All empty where nothing is merged.
struct merged_glyphs {
    buffer<std::uint32_t> groups;     ///< for each glyph of the run the first of its cluster; itself where it is alone
    buffer<merged_cluster> clusters;  ///< those of two glyphs and more, in the order of their first ones
    buffer<std::uint32_t> members;    ///< [ first cluster's glyphs, ascending | second cluster's | ... ]
    buffer<std::uint32_t> owners;     ///< [ first cluster's contour points | ... ]: whose outline runs from there to the
                                      ///< next point

    explicit merged_glyphs(memory source) noexcept
        : groups{source}, clusters{source}, members{source}, owners{source}
    {
    }

    void clear() noexcept
    {
        groups.clear();
        clusters.clear();
        members.clear();
        owners.clear();
    }

    [[nodiscard]] std::span<const std::uint32_t> members_of(const merged_cluster& c) const noexcept
    {
        return members.view().subspan(c.first_member, c.member_count);
    }
    [[nodiscard]] std::span<const std::uint32_t> owners_of(const merged_cluster& c) const noexcept
    {
        return owners.view().subspan(c.first_owner, c.shape->form().points.size());
    }

    /// Whose a cap triangle is: the one glyph's whose outline all edges at its three corners follow, or shared_glyph.
    [[nodiscard]] std::uint32_t owner_of(const merged_cluster& c, const triangle& t) const noexcept
    {
        const auto owner = owners_of(c);
        const auto starts = c.shape->form().starts;
        const std::uint32_t first = owner[t.a];
        for (const std::uint32_t corner : {t.a, t.b, t.c}) {
            std::size_t loop = 0, end = starts.size() - 1;
            while (end - loop > 1) {
                const std::size_t middle = (loop + end) / 2;
                (starts[middle] <= corner ? loop : end) = middle;
            }
            const std::uint32_t before = corner == starts[loop] ? starts[loop + 1] - 1 : corner - 1;
            if (owner[corner] != first || owner[before] != first) return shared_glyph;
        }
        return first;
    }
};

}  // namespace typemesh
