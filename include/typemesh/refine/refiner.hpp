// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Where a refiner writes a region's cap, with the points that it added.
///
///     loops        the region's loops, in the same order, each beginning with the same point; points that were added
///                  to an edge lie between its ends, and the edges know their parts of the curves
///     inner        the points that were added inside
///     triangles    counter-clockwise; indices of loops.points, followed by inner
///     kept         the number of triangles that miss the refiner's aim
struct refined_cap {
    contours& loops;
    buffer<grid_point>& inner;
    triangle_list& triangles;
    std::uint32_t& kept;
};

/// The greatest limit for the points of a refined cap. n points have fewer than 2n triangles, whose half-edges are
/// numbered four apart in 32 bits.
inline constexpr std::uint32_t max_refined_points = (std::uint32_t{1} << 29) - 1;

/// Adds points to a region's triangles, inside and on the boundary, for meshes that will be bent, displaced or used in
/// a simulation.
///
///     R::scratch                       its working memory, made with a memory source
///     r(region, cap, scratch, out)     refines the triangles `cap` of a region, whose indices refer to its points. The
///                                      loops bound a valid region again, with as many holes and outer loops; the
///                                      triangles fill it exactly. Never called for an empty region
///     r.refused_options()              the error with which it refuses its options, or none
///     r.cache_key()                    its options, if there are any: option_bits.hpp
///
/// Fails  as the refiner says; error::out_of_memory. `out` is then unspecified
template <class R>
concept refiner = std::constructible_from<typename R::scratch, memory> &&
                  requires(const R& refine, const region& r, array_view<const triangle> cap,
                           typename R::scratch& scratch, const refined_cap& out) {
                      { refine(r, cap, scratch, out) } noexcept -> std::same_as<error>;
                      { refine.refused_options() } noexcept -> std::same_as<error>;
                  };

}  // namespace typemesh::inline TYPEMESH_ABI
