// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/cap_maker.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The result of a step.
struct stepped_region {
    region filled;                         ///< the region in the scratch, or the original region itself
    array_view<const triangle> triangles;  ///< the triangles of its cap
    bool grown = false;                    ///< whether the new region covers the drawn one: glyphs are then merged
                                           ///< where they meet after growing; otherwise where they meet as drawn
    bool narrowed = false;                 ///< whether the region has changed less than wanted: see solid_plan
    bool touching = false;                 ///< whether corners touch that should have been separated or joined
    std::uint32_t corners_moved = 0;       ///< the number of corners that the step has separated or joined
};

/// A step before the solid: turns each glyph's region into another one, for any extruder.
///
///     S::scratch                       its working memory, made with a memory source; clear() empties it:
///                                      inner_region.hpp, or a class derived from it
///     s(region, scratch, caps)         the new region, which refers to the scratch, or the given region; never called
///                                      for an empty region. Fails as an extruder's plan() does
///     s.refused_options()              the error with which it refuses its options, or none
///     s.cache_key()                    its options, if there are any: option_bits.hpp
///
/// A simple step returns the given region if it has nothing to change.
template <class S>
concept region_step = std::constructible_from<typename S::scratch, memory> &&
                      requires(const S& s, const region& r, typename S::scratch& scratch, no_caps& caps) {
                          { s(r, scratch, caps) } noexcept -> std::same_as<result<stepped_region>>;
                          { s.refused_options() } noexcept -> std::same_as<error>;
                          { scratch.clear() } noexcept;
                      };

/// A step that changes nothing: the solid is made of the glyph as it is drawn.
struct no_step {};

}  // namespace typemesh::inline TYPEMESH_ABI
