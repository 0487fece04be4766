// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/bend/impl/farthest.hpp>
#include <typemesh/bend/text_path.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The deformation that bends text along a curve in space: x becomes the distance along the curve, y and z are kept in
/// the curve's moving frame (text_path.hpp). The letters themselves are bent.
///
///     text_path path;
///     if (error e = path.through(points)) ...
///     bent<along_curve>{.how = {.path = &path, .start = 0.5}}      x = 0 is half an em behind the first point
///
/// A centred text begins before its origin: set start to length() / 2. Beyond its ends the curve goes on straight for
/// an em, for letters that reach out a little.
///
/// Fails  error::bad_option: there is no path, or it is empty ("path"); start is not finite, or the text begins more
///        than an em before the curve ("start")
///        error::goes_around: the text ends more than an em after the curve
///        error::folds_over: the curve bends more tightly than the letters are high or deep
struct along_curve {
    const text_path* path = nullptr;  ///< must outlive the plan, and must not change before it is written
    double start = 0.0;               ///< the distance along the curve of the text's origin, in em

    /// See deformation.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (path == nullptr || path->empty()) return error::bad("path");
        return is_finite(start) ? error{} : error::bad("start");
    }

    /// See deformation.
    [[nodiscard]] error refused_text(const box3& text) const noexcept
    {
        constexpr double beyond = text_path::beyond;
        if (!(start + text.low.x >= -beyond)) return error::bad("start");
        return start + text.high.x <= path->length() + beyond ? error{} : error{error::goes_around};
    }

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const text_path::frame f = path->at(start + p.x);
        return {f.at + p.y * f.up + p.z * f.toward, f.speed + p.y * f.up_by + p.z * f.toward_by, f.up, f.toward};
    }

    /// See deformation.
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const text_path::bounds by = path->between(start + b.low.x, start + b.high.x);
        const double across = detail::farthest(b.low.y, b.high.y, 0.0) + detail::farthest(b.low.z, b.high.z, 0.0);
        return {.xx = by.bend + across * by.turn_2, .xy = by.turn, .xz = by.turn};
    }
};
static_assert(deformation<along_curve>);

}  // namespace typemesh::inline TYPEMESH_ABI
