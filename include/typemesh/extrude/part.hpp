// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace typemesh {

/// The parts of a mesh that may carry materials of their own. In the output each part's vertices lie together, and so
/// do each part's indices, in this order.
enum class part : std::uint8_t { front, back, side };

inline constexpr part all_parts[] = {part::front, part::back, part::side};

/// One number for each part.
struct part_counts {
    std::uint32_t of[3] = {};

    [[nodiscard]] constexpr std::uint32_t operator[](part p) const noexcept { return of[static_cast<std::size_t>(p)]; }
    [[nodiscard]] constexpr std::uint32_t& operator[](part p) noexcept { return of[static_cast<std::size_t>(p)]; }
};

/// How many vertices and triangles a shape gives to each part.
struct part_sizes {
    part_counts vertices;
    part_counts triangles;
};

}  // namespace typemesh
