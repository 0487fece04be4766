// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/impl/farthest.hpp>
#include <typemesh/bend/plane_warp.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/steady.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The warp that lifts the middle of a text along a parabola; upright stems stay upright. The ends stay where they are.
///
///        _.-"""-._        tops rise by `rise`        baseline = rise     the whole text is arched ("arch")
///     .-"         "-.                                baseline = 0        the baseline stays straight ("arc upper")
///     |  A R C H    |                                baseline = -rise    the text swells ("bulge")
///     '-------------'     the baseline by `baseline`
///
/// In between and beyond, the lift changes evenly from the baseline (y = 0) to `top`. Negative lifts go down. With
/// width = 0 the parabola is fitted to the text.
///
/// Fails  error::bad_option: a number is not finite, top is nearer to 0 than 2^-20, width is negative or below
///        2^-20, but not 0 ("rise", "baseline", "top", "width", "middle")
///        error::folds_over: the baseline rises through the tops
struct arch {
    double rise = 0.3;      ///< of the height `top`, in the middle of the text, in em
    double baseline = 0.0;  ///< of the baseline
    double top = 0.7;       ///< in em; 0.7 is about the height of capitals
    double width = 0.0;     ///< in em; 0: as wide as the text
    double middle = 0.0;    ///< in em; matters only if there is a width

    /// See plane_warp.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(rise)) return error::bad("rise");
        if (!is_finite(baseline)) return error::bad("baseline");
        if (!is_finite(top) || !(std::fabs(top) >= 0x1p-20)) return error::bad("top");
        if (!is_finite(width) || width < 0.0 || (width > 0.0 && width < 0x1p-20)) return error::bad("width");
        return is_finite(middle) ? error{} : error::bad("middle");
    }

    [[nodiscard]] arch fitted(const box& text) const noexcept
    {
        if (width > 0.0) return *this;
        const text_span span = text_span::of(text);
        return {rise, baseline, top, span.width, span.middle()};
    }

    [[nodiscard]] warped_point operator()(point p) const noexcept
    {
        const double half = half_width(), s = (p.x - middle) / half, lift = lift_at(p.y);
        return {{p.x, p.y + lift * (1.0 - s * s)},
                {1.0, -2.0 * lift * s / half},
                {0.0, 1.0 + per_height() * (1.0 - s * s)}};
    }

    /// See plane_warp.
    [[nodiscard]] bend_bounds bend(const box& b) const noexcept
    {
        const double half = half_width(), low = std::fabs(lift_at(b.low.y)), high = std::fabs(lift_at(b.high.y)),
                     aside = detail::farthest(b.low.x, b.high.x, middle);
        return {.xx = 2.0 * (low > high ? low : high) / (half * half),
                .xy = 2.0 * std::fabs(per_height()) * aside / (half * half)};
    }

private:
    [[nodiscard]] double half_width() const noexcept { return width > 0.0 ? 0.5 * width : 0.5; }
    [[nodiscard]] double per_height() const noexcept { return (rise - baseline) / top; }
    [[nodiscard]] double lift_at(double y) const noexcept { return baseline + per_height() * y; }
};
static_assert(plane_warp<arch>);

}  // namespace typemesh::inline TYPEMESH_ABI
