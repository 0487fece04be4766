// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A set of cells of an arrangement of up to five layers. A cell is known by its label, whose bit k says whether layer
/// k covers it; the set has one bit for each of the 32 labels.
///
///     constexpr cell_set letters = cells_of_layer(0), plate = cells_of_layer(1);
///     plate & ~letters                          the plate outside the letters
struct cell_set {
    std::uint32_t labels = 0;

    /// Whether cells with this label belong to the set. label < 32.
    [[nodiscard]] constexpr bool contains(std::uint32_t label) const noexcept { return (labels >> label & 1u) != 0; }
    /// Whether it contains the cells that no layer covers. They have no bound, so no solid can fill them.
    [[nodiscard]] constexpr bool is_unbounded() const noexcept { return contains(0); }

    friend constexpr cell_set operator&(cell_set a, cell_set b) noexcept { return {a.labels & b.labels}; }
    friend constexpr cell_set operator|(cell_set a, cell_set b) noexcept { return {a.labels | b.labels}; }
    friend constexpr cell_set operator~(cell_set a) noexcept { return {~a.labels}; }
    friend constexpr bool operator==(cell_set, cell_set) noexcept = default;
};

inline constexpr std::uint32_t max_layers = 5;  ///< the greatest number of layers

/// The cells that a layer covers. layer < max_layers.
[[nodiscard]] constexpr cell_set cells_of_layer(std::uint32_t layer) noexcept
{
    cell_set made;
    for (std::uint32_t label = 0; label < 32; ++label) made.labels |= (label >> layer & 1u) << label;
    return made;
}

}  // namespace typemesh::inline TYPEMESH_ABI
