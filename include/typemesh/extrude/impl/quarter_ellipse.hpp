// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/profile_points.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A quarter ellipse in steps of equal angles. Convex, it leaves the wall upright and meets the cap level; concave, it
/// leaves the wall level and meets the cap upright.
///
/// The text's tolerance can set the number of steps: no chord is then farther from the ellipse. It is at least 4, so
/// that neighbours differ by less than 30 degrees if the ellipse is about as wide as it is deep; 8 if the tolerance is
/// unknown; at most 63.
///
/// One of n chords deviates from the unit circle by 1 - cos(a) <= a^2 / 2, with a = pi / (4 n). An ellipse stretches
/// this by at most its longer radius.
class quarter_ellipse {
public:
    /// The number of steps for the tolerance.
    [[nodiscard]] static std::uint32_t steps_for(const profile_scale& scale) noexcept
    {
        if (!(scale.tolerance > 0.0)) return 8;
        const double radius = scale.width > scale.depth ? scale.width : scale.depth;
        const double steps = std::ceil(quarter / 2.0 / std::sqrt(2.0 * scale.tolerance / radius));
        return steps < 4.0 ? 4u : steps > max_steps ? max_steps : static_cast<std::uint32_t>(steps);
    }

    /// Adds the points. For the angle, a convex point has t = 1 - cos and h = sin, a concave one t = sin and h = 1 -
    /// cos.
    static void add(std::uint32_t steps, bool convex, profile_points& out) noexcept
    {
        out.add({0.0f, 0.0f});
        for (std::uint32_t i = 1; i < steps && i <= max_steps; ++i) {
            const double angle = quarter * i / steps;
            const auto high = static_cast<float>(std::sin(angle)), low = static_cast<float>(1.0 - std::cos(angle));
            out.add(convex ? profile_point{low, high} : profile_point{high, low});
        }
        out.add({1.0f, 1.0f});
    }

private:
    static constexpr double quarter = 1.57079632679489661923;
    static constexpr std::uint32_t max_steps = profile_points::most - 1;
};

}  // namespace typemesh::inline TYPEMESH_ABI
