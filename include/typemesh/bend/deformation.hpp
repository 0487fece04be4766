// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/double3.hpp>
#include <typemesh/core/error.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One of the text's axes in its plane: along the text (x) or up (y).
enum class text_axis : std::uint8_t { along, up };

/// Where a deformation moves a point, and how it moves the points around it: the columns of its Jacobian matrix.
struct deformed_point {
    double3 at;  ///< the point's image
    double3 x;   ///< the derivative of the image by x
    double3 y;   ///< by y
    double3 z;   ///< by z
};

/// Upper bounds of the lengths of a deformation's second derivatives: xy is the bound of the derivative by x and by y.
struct bend_bounds {
    double xx = 0.0;      ///< by x twice
    double yy = 0.0;      ///< by y twice
    double zz = 0.0;      ///< by z twice
    double xy = 0.0;      ///< by x and by y
    double xz = 0.0;      ///< by x and by z
    double yz = 0.0;      ///< by y and by z
    double x_jump = 0.0;  ///< the sum of the jumps of the first derivative by x, which only warps may have
};

/// A smooth map of space that bends flat text: x along the text, y up, z towards the reader, in em, relative to the
/// text's own origin. The text is at z = 0, and behind it if it has a depth.
///
///     d(p)                 the image of a point, with the derivatives there: deformed_point
///     d.bend(box)          bounds of the second derivatives at all points of a box: bend_bounds. All promises about
///                          bent meshes rest on it
///     d.refused_options()  the error with which it refuses its options, or none
///     d.refused_text(box)  optional: the error for a text that fills this box, or none; for deformations that bring
///                          two places of a long text together although they do not fold it
///     D::keeps_volume      optional: true if its Jacobian determinant is 1 everywhere, so that it can fold nothing
///     d.cache_key()        not needed: bent letters are not cached
///
/// Its second derivatives need not be continuous, but its first derivatives must be. Where its Jacobian determinant is
/// not positive, it turns letters inside out: the text is then refused (error::folds_over).
template <class D>
concept deformation = std::copyable<D> && requires(const D& d, const double3& p, const box3& b) {
    { d(p) } noexcept -> std::same_as<deformed_point>;
    { d.bend(b) } noexcept -> std::same_as<bend_bounds>;
    { d.refused_options() } noexcept -> std::same_as<error>;
};

/// The error for a whole text that fills a box, or none.
template <deformation D>
[[nodiscard]] error refused_text([[maybe_unused]] const D& d, [[maybe_unused]] const box3& text) noexcept
{
    if constexpr (requires { d.refused_text(text); })
        return d.refused_text(text);
    else
        return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
