// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A `put` that does nothing: the concept below is checked with it.
struct ignore_points {
    constexpr void operator()(point, double) const noexcept {}
};

/// Flattens one curve: hands out points on it by put(point, t), with 0 < t <= 1 ascending, the last at t = 1 and the
/// curve's own end. The start is not handed out. Lines never come here.
///
/// The compiler checks the signatures. The author promises the rest: every chord between consecutive points (the start
/// included) stays within `tolerance` of the curve, and the curve within `tolerance` of its chord. The tolerance is
/// positive and in the curve's own unit. `put` is noexcept and takes any number of points, but broken fonts hold
/// curves as large as the grid: cap the count. That t ascends and that the curve's end comes last is asserted.
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
/// A discretiser that keeps no tolerance declares `static constexpr bool keeps_no_tolerance = true;`: it is then not
/// called again with a finer tolerance where contours come to cross.
///
/// A point where the curve stops and turns (a cusp, a reversal) becomes a hard corner of the walls by itself: the two
/// tangents there are found from the curve and t (see core/impl/tangent.hpp).
template <class D>
concept discretiser = requires(const D& d, const quadratic& q, const cubic& c, double tolerance, ignore_points put) {
    { d(q, tolerance, put) } noexcept;
    { d(c, tolerance, put) } noexcept;
};

/// Whether a finer tolerance brings its chords closer to the curve.
template <class D>
inline constexpr bool keeps_tolerance = [] {
    if constexpr (requires { D::keeps_no_tolerance; })
        return !D::keeps_no_tolerance;
    else
        return true;
}();

}  // namespace typemesh::inline TYPEMESH_ABI
