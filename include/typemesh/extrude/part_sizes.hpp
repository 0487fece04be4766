// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/part.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh {

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
