// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A `put` that does nothing. The concept below is checked with it.
struct ignore_points {
    constexpr void operator()(point, double) const noexcept {}
};

/// Flattens one curve: passes points of the curve to put(point, t), with ascending 0 < t <= 1. The last point is the
/// end of the curve, with t = 1. The start of the curve is not passed. Lines are never passed to a discretiser.
///
/// The compiler checks the signatures. The author promises the rest: every chord between consecutive points (including
/// the start) stays within `tolerance` of the curve, and the curve within `tolerance` of its chord. The tolerance is
/// positive and in the curve's unit. `put` is noexcept and takes any number of points. Broken fonts contain curves as
/// large as the grid, so limit the number of points. Assertions check that t ascends and that the curve's end comes
/// last.
///
///     struct thirds {                                             // a discretiser of your own
///         static constexpr bool keeps_no_tolerance = true;        // always three
///         template <class Curve, class Put>
///         void operator()(const Curve& c, double, Put&& put) const noexcept
///         {
///             for (int i = 1; i <= 3; ++i) put(c.at(i / 3.0), i / 3.0);
///         }
///     };
///
/// A discretiser that keeps no tolerance declares `static constexpr bool keeps_no_tolerance = true;`. It is then not
/// called again with a finer tolerance if contours start to cross.
///
/// A point where the curve stops and turns (a cusp, a reversal) becomes a hard corner of the walls automatically: the
/// two tangents there follow from the curve and t.
template <class D>
concept discretiser = requires(const D& d, const quadratic& q, const cubic& c, double tolerance, ignore_points put) {
    { d(q, tolerance, put) } noexcept;
    { d(c, tolerance, put) } noexcept;
};

/// Whether a finer tolerance brings a discretiser's chords closer to the curve.
template <class D>
inline constexpr bool keeps_tolerance = [] {
    if constexpr (requires { D::keeps_no_tolerance; })
        return !D::keeps_no_tolerance;
    else
        return true;
}();

}  // namespace typemesh::inline TYPEMESH_ABI
