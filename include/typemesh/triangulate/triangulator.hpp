// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Divides a region into counter-clockwise triangles over its own points. No point is added or dropped.
///
///     t(r, space, out)    appends r.triangle_count() triangles of indices into r.points() to `out`
///
/// The region is proven: region.hpp lists its guarantees. Its boundary cycles may pass through a point more than once
/// (is_touching), each time along a separate sector of interior; here each visit is a separate point. Every edge of the
/// region must be an edge of exactly one triangle, so that the walls on it meet the caps without a crack. No triangle
/// may have zero area. Assertions check the cheap parts: the number, corners, orientation and area of the triangles.
///
/// Scratch memory comes from `space`. If memory runs out, the result is error::out_of_memory, and `out` is unchanged.
/// If r.order() is not empty, it lists the points from left to right, which saves a sort.
template <class T>
concept triangulator = requires(const T& t, const region& r, workspace& space, triangle_list& out) {
    { t(r, space, out) } noexcept -> std::same_as<error>;
};

/// A triangulator that also takes unproven loops, and proves while it works that they bound a region.
///
///     t.prove(loops, space, out)    returns the region that the loops bound and appends its triangles to `out`; or
///                                   returns error::crossing_contours and leaves `out` unchanged. The error does not
///                                   prove that contours cross: the loops then go through fill. Its count is 1 if two
///                                   equal points stopped the proof and no other fault had been found.
///
/// It may refuse any loops. It may accept only loops that do not cross, touch or overlap, and whose interior lies on
/// the left of every edge under both the even-odd and the non-zero rule (see fill/orient.hpp).
template <class T>
concept proving_triangulator =
    triangulator<T> && requires(const T& t, const contours& loops, workspace& space, triangle_list& out) {
        { t.prove(loops, space, out) } noexcept -> std::same_as<result<region>>;
    };

/// A proving triangulator that also takes loops that pass through a point more than once.
///
///     t.prove_touching(loops, space, out)    as prove(). In each such point, every pass must keep to its own sector
///                                            of interior; this is proven too.
template <class T>
concept touching_triangulator =
    proving_triangulator<T> && requires(const T& t, const contours& loops, workspace& space, triangle_list& out) {
        { t.prove_touching(loops, space, out) } noexcept -> std::same_as<result<region>>;
    };

/// Whether a triangulator's diagonals must not be changed. A triangulator declares this by `static constexpr bool
/// has_final_diagonals = true;`. For all other triangulators, edges of triangles that are too thin for 32-bit floats
/// are flipped when caps are made (see cut_region.hpp); nothing else about the triangles changes.
template <class T>
inline constexpr bool has_final_diagonals = [] {
    if constexpr (requires { T::has_final_diagonals; })
        return T::has_final_diagonals;
    else
        return false;
}();

}  // namespace typemesh::inline TYPEMESH_ABI
