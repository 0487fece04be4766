// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Cuts a region into counter-clockwise triangles over its own points; adds no point and drops none.
///
///     t(r, space, out)    appends r.triangle_count() triangles of indices into r.points() to `out`
///
/// The region is proven: see region.hpp for what may be relied on. Its boundary cycles may pass through a point more
/// than once (is_touching), each time along a sector of interior of their own, and each visit is a point of its own
/// here. Every edge of the region must be an edge of exactly one triangle, so that the walls on it meet the caps
/// without a crack; no triangle may have zero area. What can be checked at once (number, corners, orientation and area
/// of the triangles) is asserted.
///
/// Scratch memory comes from `space`. When memory runs out: error::out_of_memory, and `out` is unchanged. Where
/// r.order() is not empty, it is the order of the points from left to right, which saves a sort.
template <class T>
concept triangulator = requires(const T& t, const region& r, workspace& space, triangle_list& out) {
    { t(r, space, out) } noexcept -> std::same_as<error>;
};

/// A triangulator that also takes loops about which nothing is proven, and proves them while it works.
///
///     t.prove(loops, space, out)    the region that the loops bound, its triangles appended to `out`; or
///                                   error::crossing_contours, `out` being unchanged: a refusal, not a verdict. The
///                                   loops then go through fill. The error's count may be 1 to say that two equal
///                                   points were in the way, and nothing else so far.
///
/// It may refuse anything, but must accept only loops that do not cross, touch or overlap and whose interior, by
/// even-odd and by non-zero winding alike, lies on the left of every edge (see fill/orient.hpp).
template <class T>
concept proving_triangulator =
    triangulator<T> && requires(const T& t, const contours& loops, workspace& space, triangle_list& out) {
        { t.prove(loops, space, out) } noexcept -> std::same_as<result<region>>;
    };

/// A proving triangulator that also takes loops which pass through a point more than once.
///
///     t.prove_touching(loops, space, out)    as prove(). In each such point every pass must keep to a sector of
///                                            interior of its own (see fill/impl/touching_cycles.hpp), which is
///                                            proven too.
template <class T>
concept touching_triangulator =
    proving_triangulator<T> && requires(const T& t, const contours& loops, workspace& space, triangle_list& out) {
        { t.prove_touching(loops, space, out) } noexcept -> std::same_as<result<region>>;
    };

/// Whether a triangulator's diagonals must stay as they are, which it declares by `static constexpr bool
/// has_final_diagonals = true;`. In all others, edges of triangles too low for 32-bit floats are flipped when caps are
/// made (see cut_region.hpp); nothing else about the triangles changes.
template <class T>
inline constexpr bool has_final_diagonals = [] {
    if constexpr (requires { T::has_final_diagonals; })
        return T::has_final_diagonals;
    else
        return false;
}();

}  // namespace typemesh::inline TYPEMESH_ABI
