// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The warp that moves text up and down in a wave, like a flag: y += height * sin(2 pi (x - left) / length + phase).
/// Baseline and tops make the same wave; upright stems stay upright. It keeps all areas, so it folds nothing. Moving
/// flags are phases that change from frame to frame.
///
/// With length = 0 one wave fits the text. The wave that moves text towards the reader is wave.hpp.
///
/// Fails  error::bad_option: a number is not finite, length is negative or below 2^-20, but not 0 ("height",
///        "length", "left", "phase")
struct flag {
    double height = 0.2;  ///< of a crest above the baseline, in em
    double length = 0.0;  ///< from crest to crest, in em; 0: as wide as the text
    double left = 0.0;    ///< the beginning of a wave, in em; matters only if there is a length
    double phase = 0.0;   ///< in degrees

    /// See plane_warp.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(height)) return error::bad("height");
        if (!is_finite(length) || length < 0.0 || (length > 0.0 && length < 0x1p-20)) return error::bad("length");
        if (!is_finite(left)) return error::bad("left");
        return is_finite(phase) ? error{} : error::bad("phase");
    }

    /// See plane_warp.
    [[nodiscard]] flag fitted(const box& text) const noexcept
    {
        if (length > 0.0) return *this;
        const text_span span = text_span::of(text);
        return {height, span.width, span.left, phase};
    }

    /// Its Jacobian determinant is 1.
    [[nodiscard]] static bool is_unfolded(const box&) noexcept { return true; }

    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        const double k = per_em(), angle = k * (p.x - left) + phase * 0.017453292519943295;
        return {{p.x, p.y + height * detail::steady_sine(angle)},
                {1.0, height * k * detail::steady_cosine(angle)},
                {0.0, 1.0}};
    }

    /// See plane_warp.
    [[nodiscard]] bend_bounds bend(const box&) const noexcept
    {
        return {.xx = std::fabs(height) * per_em() * per_em()};
    }

private:
    [[nodiscard]] double per_em() const noexcept { return 6.283185307179586 / (length > 0.0 ? length : 1.0); }
};
static_assert(plane_warp<flag>);

}  // namespace typemesh::inline TYPEMESH_ABI
