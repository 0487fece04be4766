// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/layer_arrangement.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The walls of a layered solid: see layered_solid.hpp. Sets of levels are numbers with one bit for each level.
struct slab_walls {
    static constexpr std::size_t max_slabs = 8;

    std::uint32_t slab_count = 0;
    cell_set filled[max_slabs];
    float height[max_slabs + 1] = {};

    /// A wall on one piece, between two levels.
    ///
    ///      4----------7     Its vertices, from bottom to top: first the levels `at_from`, then the levels `at_to`.
    ///      3          |     Both contain the lowest and the highest level of the wall. The triangles between the two
    ///      |          6     columns go up in steps: the column whose next level is lower goes first.
    ///      2----------5
    struct wall {
        std::int32_t side = 0;  // 1: the solid lies on the left of the piece; -1: on its right
        std::uint32_t at_from = 0, at_to = 0;

        [[nodiscard]] std::uint32_t vertex_count() const noexcept { return count(at_from) + count(at_to); }
        [[nodiscard]] std::uint32_t triangle_count() const noexcept { return vertex_count() - 2; }

        template <class Put>
        static void each_height(std::uint32_t levels, Put&& put) noexcept
        {
            for (std::uint32_t level = 0; levels >> level != 0; ++level)
                if ((levels >> level & 1u) != 0) put(level);
        }

        /// Calls put(a, b, c) for each triangle, counter-clockwise as seen from the right of the piece.
        template <class Put>
        void each_triangle(Put&& put) const noexcept
        {
            std::uint32_t a = 0, b = count(at_from);
            std::uint32_t left = drop_lowest(at_from), right = drop_lowest(at_to);
            while (left != 0 || right != 0) {
                const bool goes_left = right == 0 || (left != 0 && lowest(left) < lowest(right));
                if (goes_left) {
                    put(a, b, a + 1);
                    ++a;
                    left = drop_lowest(left);
                } else {
                    put(a, b, b + 1);
                    ++b;
                    right = drop_lowest(right);
                }
            }
        }

    private:
        static constexpr std::uint32_t lowest(std::uint32_t levels) noexcept { return levels & (~levels + 1); }
        static constexpr std::uint32_t drop_lowest(std::uint32_t levels) noexcept { return levels & (levels - 1); }
        static constexpr std::uint32_t count(std::uint32_t levels) noexcept
        {
            std::uint32_t sum = 0;
            for (; levels != 0; levels = drop_lowest(levels)) ++sum;
            return sum;
        }
    };

    /// The levels at which an edge of the mesh runs along the piece: those where its sides change. `hanging` is
    /// increased by one if the solid passes from one side to the other at some level.
    [[nodiscard]] std::uint32_t levels_of(const layer_arrangement::piece& s, std::uint32_t& hanging) const noexcept
    {
        std::uint32_t levels = 0;
        std::int32_t before = 0;
        bool hangs = false;
        for (std::uint32_t k = 0; k <= slab_count; ++k) {
            const std::int32_t side = k < slab_count ? s.side(filled[k]) : 0;
            if (side != before) levels |= 1u << k;
            hangs |= side * before < 0;
            before = side;
        }
        hanging += hangs;
        return levels;
    }

    /// Calls put(wall) for each wall on a piece, from bottom to top.
    ///
    ///     at_from, at_to    the levels at which edges of the mesh end in the piece's two points
    template <class Put>
    void each(const layer_arrangement::piece& s, std::uint32_t at_from, std::uint32_t at_to, Put&& put) const noexcept
    {
        for (std::uint32_t first = 0, k = 0; k < slab_count; first = k) {
            const std::int32_t side = s.side(filled[first]);
            for (k = first + 1; k < slab_count && s.side(filled[k]) == side;) ++k;
            if (side == 0) continue;
            const std::uint32_t own = (2u << k) - (1u << first);  // levels first to k
            put(wall{side, at_from & own, at_to & own});
        }
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
