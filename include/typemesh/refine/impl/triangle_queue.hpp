// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <bit>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A triangle of a mesh that changes, with its corners: if it has other corners by now, it was replaced.
struct queued_triangle {
    std::uint32_t t, a, b, c;

    [[nodiscard]] static queued_triangle of(const refinable_mesh& mesh, std::uint32_t t) noexcept
    {
        return {t, mesh.origin(4 * t), mesh.origin(4 * t + 1), mesh.origin(4 * t + 2)};
    }
    [[nodiscard]] bool is_in(const refinable_mesh& mesh) const noexcept
    {
        return mesh.origin(4 * t) == a && mesh.origin(4 * t + 1) == b && mesh.origin(4 * t + 2) == c;
    }
};

/// Triangles in the order of a rank, the lowest first; of one rank, the last one first.
///
/// Cost   O(1) for each push() and pop()
class triangle_queue {
public:
    static constexpr std::uint32_t ranks = 256;

    explicit triangle_queue(memory source = heap()) noexcept : entries_{source} { clear(); }

    void clear() noexcept
    {
        entries_.clear();
        free_ = none;
        lowest_ = ranks;
        for (std::uint32_t& first : first_) first = none;
    }

    /// Whether a triangle is left. It moves on to the lowest rank that has one.
    [[nodiscard]] bool has_more() noexcept
    {
        while (lowest_ < ranks && first_[lowest_] == none) ++lowest_;
        return lowest_ < ranks;
    }

    /// rank < ranks. False if out of memory.
    [[nodiscard]] bool push(std::uint32_t rank, const queued_triangle& one) noexcept
    {
        std::uint32_t at = free_;
        if (at != none) {
            free_ = entries_[at].next;
            entries_[at] = {one, first_[rank]};
        } else {
            at = static_cast<std::uint32_t>(entries_.size());
            if (!entries_.push_back({one, first_[rank]})) return false;
        }
        first_[rank] = at;
        if (rank < lowest_) lowest_ = rank;
        return true;
    }

    /// The first triangle, which leaves the queue. Precondition: has_more().
    [[nodiscard]] queued_triangle pop() noexcept
    {
        const std::uint32_t at = first_[lowest_];
        entry& taken = entries_[at];
        first_[lowest_] = taken.next;
        taken.next = free_;
        free_ = at;
        return taken.one;
    }

    /// A rank for a square of a length: 0 to 127, two for each doubling of the square.
    [[nodiscard]] static std::uint32_t rank_of(std::int64_t square) noexcept
    {
        const auto bits = static_cast<std::uint64_t>(square);
        const auto width = static_cast<std::uint32_t>(std::bit_width(bits));
        return width < 2 ? width : 2 * width - 2 + static_cast<std::uint32_t>((bits >> (width - 2)) & 1u);
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    struct entry {
        queued_triangle one;
        std::uint32_t next;
    };

    buffer<entry> entries_;
    std::uint32_t first_[ranks];
    std::uint32_t free_ = none;
    std::uint32_t lowest_ = ranks;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
