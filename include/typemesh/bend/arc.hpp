// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/impl/farthest.hpp>
#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The warp that puts text on a circular arc, as on a stamp. The letters themselves are bent: their stems point to the
/// circle's centre.
///
///         _.-"T"-._            The baseline keeps its length: it becomes an arc that turns by `degrees` over the
///      .-"         "-.         width of the text. Higher places are stretched, lower ones shrink.
///     E               T
///                              degrees > 0    arched upwards, the centre is below the text
///             +                degrees < 0    a bowl, the centre is above
///
/// With width = 0, the arc is fitted to the text: its middle is the middle of the text. Otherwise the curvature is the
/// same for every text: so many degrees on `width` em, and only x = middle stays where it is.
///
/// Fails  error::bad_option: a number is not finite, degrees is beyond 2^20, width is negative or below 2^-20, but
///        not 0 ("degrees", "width", "middle")
///        error::goes_around: the text is longer than a full turn; error::folds_over: the letters reach the centre
struct arc {
    double degrees = 90.0;
    double width = 0.0;   ///< in em; 0: as wide as the text
    double middle = 0.0;  ///< the top of the arc, in em; matters only if there is a width

    /// See plane_warp.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(degrees) || std::fabs(degrees) > 0x1p20) return error::bad("degrees");
        if (!is_finite(width) || width < 0.0 || (width > 0.0 && width < 0x1p-20)) return error::bad("width");
        return is_finite(middle) ? error{} : error::bad("middle");
    }

    [[nodiscard]] arc fitted(const box& text) const noexcept
    {
        if (width > 0.0) return *this;
        const text_span span = text_span::of(text);
        return {degrees, span.width, span.middle()};
    }

    /// See plane_warp.
    [[nodiscard]] error refused_text(const box& text) const noexcept
    {
        constexpr double full_turn = 360.0 * (1.0 + 0x1p-30);
        return std::fabs(degrees) * text.width() <= full_turn * width ? error{} : error{error::goes_around};
    }

    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        const double turn = per_em(), x = p.x - middle;
        if (std::fabs(turn) < 0x1p-200) return {p, {1.0, 0.0}, {0.0, 1.0}};  // doubles do not see such a turn
        const double sine = detail::steady_sine(turn * x), cosine = detail::steady_cosine(turn * x),
                     half = detail::steady_sine(0.5 * turn * x), grown = 1.0 + turn * p.y;
        return {{middle + sine / turn + p.y * sine, p.y * cosine - 2.0 * half * half / turn},
                {grown * cosine, -grown * sine},
                {sine, cosine}};
    }

    /// See plane_warp.
    [[nodiscard]] bend_bounds bend(const box& b) const noexcept
    {
        const double turn = std::fabs(per_em());
        return {.xx = turn * (1.0 + turn * detail::farthest(b.low.y, b.high.y, 0.0)), .xy = turn};
    }

private:
    /// The turn in radians per em.
    [[nodiscard]] double per_em() const noexcept
    {
        return degrees * 0.017453292519943295 / (width > 0.0 ? width : 1.0);
    }
};
static_assert(plane_warp<arc>);

}  // namespace typemesh::inline TYPEMESH_ABI
