// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/plane_path.hpp>
#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The warp that bends letters along a path in the plane: x becomes the distance along the path, y the distance from
/// it. on_path.hpp uses it for joined letters; alone, `warped{along_path{&way}}`, it bends every letter.
///
/// Fails  error::bad_option: there is no path, it is empty or has failed ("path"); start is not within 2^40 of
///        0, where doubles still tell letters apart, or stretch is not positive and finite ("start", "stretch")
///        error::out_of_memory: the path ran out of it
///        error::folds_over: letters lie on a corner or a cusp, or reach the centre of the curvature
///        error::goes_around: the text is longer than a closed path
struct along_path {
    const plane_path* path = nullptr;  ///< must outlive the plan, and must not change before it is written
    double start = 0.0;                ///< the distance along the path of x = 0, in em; |start| <= 2^40
    double stretch = 1.0;              ///< em along the path for an em of text
    bool backwards = false;            ///< whether the path is walked from its end: letters stand on its other side

    /// See plane_warp.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (path == nullptr) return error::bad("path");
        if (error e = path->failure()) return e;
        if (path->empty()) return error::bad("path");
        if (!(std::fabs(start) <= 0x1p40)) return error::bad("start");
        return is_finite(stretch) && stretch > 0.0 ? error{} : error::bad("stretch");
    }

    /// See plane_warp.
    [[nodiscard]] error refused_text(const box& text) const noexcept
    {
        const bool fits =
            !path->is_closed() || text.empty() || stretch * text.width() <= path->length() * (1.0 + 0x1p-30);
        return fits ? error{} : error{error::goes_around};
    }

    /// The place on the path of a text's x, as it is walked.
    [[nodiscard]] plane_path::place place_at(double x) const noexcept
    {
        const double distance = start + stretch * x;
        if (!backwards) return path->at(distance);
        plane_path::place p = path->at(path->length() - distance);
        p.from = path->length() - p.from;
        p.tangent = -1.0 * p.tangent;
        p.curvature = 0.0 - p.curvature;
        return p;
    }

    /// See plane_warp.
    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        const plane_path::place on = place_at(p.x);
        const point left{0.0 - on.tangent.y, on.tangent.x};
        return {on.at + (start + stretch * p.x - on.from) * on.tangent + p.y * left,
                (stretch * (1.0 - on.curvature * p.y)) * on.tangent, left};
    }

    /// See plane_warp.
    [[nodiscard]] bend_bounds bend(const box& b) const noexcept
    {
        const plane_path::bounds by = bounds_in(b);
        const double turn = by.sharpest(), high = std::fmax(std::fabs(b.low.y), std::fabs(b.high.y));
        return {.xx = stretch * stretch * (by.by * high + turn * (1.0 + turn * high)),
                .xy = stretch * turn,
                .x_jump = stretch * by.jump * high};
    }

    /// See plane_warp.
    [[nodiscard]] bool is_unfolded(const box& b) const noexcept
    {
        const plane_path::bounds by = bounds_in(b);
        const double low = backwards ? 0.0 - by.high : by.low, high = backwards ? 0.0 - by.low : by.high;
        if (by.sharpest() >= plane_path::bounds::endless) return false;
        for (const double y : {b.low.y, b.high.y})
            for (const double turn : {low, high})
                if (!(1.0 - turn * y > 0x1p-20)) return false;
        return true;
    }

private:
    [[nodiscard]] plane_path::bounds bounds_in(const box& b) const noexcept
    {
        const double low = start + stretch * b.low.x, high = start + stretch * b.high.x, all = path->length();
        return backwards ? path->between(all - high, all - low) : path->between(low, high);
    }
};
static_assert(plane_warp<along_path>);

}  // namespace typemesh::inline TYPEMESH_ABI
