// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// Where a warp moves a point of the plane, and how it moves the points around it: the columns of its Jacobian matrix.
struct warped_point {
    point at;  ///< the point's image
    point x;   ///< the derivative of the image by x
    point y;   ///< by y
};

/// A smooth map of the plane, for outlines: x along the text, y up, in em, relative to the text's own origin. Its
/// sibling in space is bend/deformation.hpp.
///
///     w(p)                 the image of a point, with the derivatives there: warped_point
///     w.bend(box)          bounds of the second derivatives at all points of a box: only xx, yy and xy matter, and
///                          x_jump if the derivative by x jumps where a path's curvature does
///     w.refused_options()  the error with which it refuses its options, or none
///     w.fitted(text)       optional: the same warp with its open options set for a text that fills this box, in em;
///                          refused_options() has found no error before
///     w.refused_text(text) optional: the error of a fitted warp for a text that fills this box, or none
///     w.keeps_lines        optional: `static constexpr bool keeps_lines = true`: the image of every line is a line
///     w.is_unfolded(box)   optional: whether its Jacobian determinant is positive in a box, if it knows without the
///                          bounds
///
/// Where its Jacobian determinant is not positive, it turns letters inside out: the text is then refused
/// (error::folds_over).
template <class W>
concept plane_warp = std::copyable<W> && requires(const W& w, point p, const box& b) {
    { w(p) } noexcept -> std::same_as<warped_point>;
    { w.bend(b) } noexcept -> std::same_as<bend_bounds>;
    { w.refused_options() } noexcept -> std::same_as<error>;
};

/// The warp for a text that fills this box.
template <plane_warp W>
[[nodiscard]] W fitted_to(const W& w, [[maybe_unused]] const box& text) noexcept
{
    if constexpr (requires { w.fitted(text); })
        return w.fitted(text);
    else
        return w;
}

/// Whether the images of lines are lines.
template <plane_warp W>
[[nodiscard]] constexpr bool keeps_lines() noexcept
{
    if constexpr (requires { W::keeps_lines; })
        return W::keeps_lines;
    else
        return false;
}

/// The width and the middle of a text's box, for warps that fit themselves to it. A box without a width counts as one
/// em to the right of its left end; an empty one starts at 0.
struct text_span {
    double width = 1.0;
    double left = 0.0;

    [[nodiscard]] static constexpr text_span of(const box& text) noexcept
    {
        if (text.empty()) return {};
        return {text.width() > 0.0 ? text.width() : 1.0, text.low.x};
    }
    [[nodiscard]] constexpr double middle() const noexcept { return left + 0.5 * width; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
