// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/finite.hpp>

#include <limits>

namespace typemesh::inline TYPEMESH_ABI {

/// The warp that lets a text recede, like letters on a long wall: a projective map. Lines stay lines.
///
///     |\ _
///     | | `|'-. .          The left end keeps its size; the right end is `scale` times as large. Higher and lower
///     |-|--|--|-|- - -     places approach the horizon; the text becomes narrower as well. scale > 1: it comes nearer.
///     | |_.|.-' '
///     |/
///
/// With width = 0 the ends are the text's.
///
/// Fails  error::bad_option: scale is not 1/1024 to 1024, another number is not finite, width is negative or below
///        2^-20, but not 0 ("scale", "horizon", "width", "left"); error::folds_over: letters reach behind the reader
struct perspective {
    /// See plane_warp.
    static constexpr bool keeps_lines = true;

    double scale = 0.5;     ///< of the right end
    double horizon = 0.35;  ///< the height that stays straight, in em; 0.35 is the middle of most fonts' capitals
    double width = 0.0;     ///< in em; 0: as wide as the text
    double left = 0.0;      ///< the left end, in em; matters only if there is a width

    /// See plane_warp.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!(scale >= 0x1p-10 && scale <= 0x1p10)) return error::bad("scale");
        if (!is_finite(horizon)) return error::bad("horizon");
        if (!is_finite(width) || width < 0.0 || (width > 0.0 && width < 0x1p-20)) return error::bad("width");
        return is_finite(left) ? error{} : error::bad("left");
    }

    /// See plane_warp.
    [[nodiscard]] perspective fitted(const box& text) const noexcept
    {
        if (width > 0.0) return *this;
        const text_span span = text_span::of(text);
        return {scale, horizon, span.width, span.left};
    }

    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        const double a = per_em(), x = p.x - left, y = p.y - horizon, s = 1.0 / (1.0 + a * x);
        return {{left + x * s, horizon + y * s}, {s * s, -a * y * s * s}, {0.0, s}};
    }

    /// See plane_warp.
    [[nodiscard]] bend_bounds bend(const box& b) const noexcept
    {
        const double a = per_em(), one = 1.0 + a * (b.low.x - left), other = 1.0 + a * (b.high.x - left),
                     least = one < other ? one : other;
        if (!(least > 0x1p-20)) {
            constexpr double unbounded = (std::numeric_limits<double>::max)();
            return {.xx = unbounded, .yy = unbounded, .xy = unbounded};
        }
        const double s = 1.0 / least, size = a < 0.0 ? -a : a, low = b.low.y - horizon, high = b.high.y - horizon,
                     y = high > -low ? high : -low;
        return {.xx = 2.0 * size * s * s * s * (1.0 + size * y), .xy = size * s * s};
    }

    /// Its Jacobian determinant is a power of 1 / (1 + a x): positive exactly if that is at both ends.
    [[nodiscard]] bool is_unfolded(const box& b) const noexcept
    {
        const double a = per_em();
        return 1.0 + a * (b.low.x - left) > 0x1p-20 && 1.0 + a * (b.high.x - left) > 0x1p-20;
    }

private:
    [[nodiscard]] double per_em() const noexcept { return (1.0 / scale - 1.0) / (width > 0.0 ? width : 1.0); }
};
static_assert(plane_warp<perspective>);

}  // namespace typemesh::inline TYPEMESH_ABI
