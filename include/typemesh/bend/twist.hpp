// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/bend/double3.hpp>
#include <typemesh/core/impl/steady.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The deformation that twists text around a straight axis, like a screw: each place is turned by an angle that grows
/// along the axis. It is 0 at the text's origin.
///
///     axis along    the axis is parallel to the baseline, at the height `across`: 0.35 em is the middle of most fonts'
///                   capitals; the top of the letters first turns towards the reader
///     axis up       the axis is upright, at x = across
///
/// It keeps all volumes, so it folds nothing.
///
/// Fails  error::bad_option: a number is not finite ("degrees_per_em", "across", "depth")
struct twist {
    double degrees_per_em = 20.0;
    text_axis axis = text_axis::along;
    double across = 0.0;  ///< the axis's place in the text's plane, in em
    double depth = 0.0;   ///< the axis's z, in em; negative: behind the text's front

    static constexpr bool keeps_volume = true;  ///< see deformation.hpp

    /// See deformation.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (!is_finite(degrees_per_em)) return error::bad("degrees_per_em");
        if (!is_finite(across)) return error::bad("across");
        return is_finite(depth) ? error{} : error::bad("depth");
    }

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const bool along = axis == text_axis::along;
        const double turn = per_em(), angle = turn * (along ? p.x : p.y), sine = detail::steady_sine(angle),
                     cosine = detail::steady_cosine(angle);
        const double u = (along ? p.y : p.x) - across, w = p.z - depth;
        // In the plane across the axis, (u, w) becomes (u', w').
        const double new_u = u * cosine - w * sine, new_w = u * sine + w * cosine;
        if (along)
            return {{p.x, across + new_u, depth + new_w},
                    {1.0, -turn * new_w, turn * new_u},
                    {0.0, cosine, sine},
                    {0.0, -sine, cosine}};
        return {{across + new_u, p.y, depth + new_w},
                {cosine, 0.0, sine},
                {-turn * new_w, 1.0, turn * new_u},
                {-sine, 0.0, cosine}};
    }

    /// See deformation.
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const bool along = axis == text_axis::along;
        const double u = along ? detail::farthest(b.low.y, b.high.y, across)
                               : detail::farthest(b.low.x, b.high.x, across),
                     w = detail::farthest(b.low.z, b.high.z, depth), turn = std::fabs(per_em());
        const double bent = turn * turn * std::sqrt(u * u + w * w);
        if (along) return {.xx = bent, .xy = turn, .xz = turn};
        return {.yy = bent, .xy = turn, .yz = turn};
    }

private:
    /// The turn in radians per em.
    [[nodiscard]] double per_em() const noexcept { return degrees_per_em * 0.017453292519943295; }
};
static_assert(deformation<twist>);

}  // namespace typemesh::inline TYPEMESH_ABI
