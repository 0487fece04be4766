// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/bevel_profile.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One straight slope.
struct chamfer_profile {
    void operator()(const profile_scale&, profile_points& out) const noexcept
    {
        out.add({0.0f, 0.0f});
        out.add({1.0f, 1.0f});
    }
};
static_assert(bevel_profile<chamfer_profile>);

/// A quarter ellipse in steps of equal angles. Convex, it leaves the wall upright and meets the cap level; concave, it
/// leaves the wall level and meets the cap upright.
///
/// With `steps` 0 as many as the text's tolerance asks for: no chord is then farther from the ellipse. At least 4, so
/// that neighbours differ by less than 30 degrees if it is about as wide as it is deep; 8 if the tolerance is unknown;
/// at most 63.
///
/// A chord of n is off by 1 - cos(a) <= a^2 / 2 of the unit circle, a = pi / (4 n); an ellipse stretches that by its
/// longer radius at most.
class quarter_ellipse {
public:
    /// How many steps the tolerance asks for.
    [[nodiscard]] static std::uint32_t steps_for(const profile_scale& scale) noexcept
    {
        if (!(scale.tolerance > 0.0)) return 8;
        const double radius = scale.width > scale.depth ? scale.width : scale.depth;
        const double steps = std::ceil(quarter / 2.0 / std::sqrt(2.0 * scale.tolerance / radius));
        return steps < 4.0 ? 4u : steps > most_steps ? most_steps : static_cast<std::uint32_t>(steps);
    }

    /// Adds the points; a convex one's t is 1 - cos, its h sin of the angle, and a concave one's sin and 1 - cos.
    static void add(std::uint32_t steps, bool convex, profile_points& out) noexcept
    {
        out.add({0.0f, 0.0f});
        for (std::uint32_t i = 1; i < steps && i <= most_steps; ++i) {
            const double angle = quarter * i / steps;
            const auto high = static_cast<float>(std::sin(angle)), low = static_cast<float>(1.0 - std::cos(angle));
            out.add(convex ? profile_point{low, high} : profile_point{high, low});
        }
        out.add({1.0f, 1.0f});
    }

private:
    static constexpr double quarter = 1.57079632679489661923;
    static constexpr std::uint32_t most_steps = profile_points::most - 1;
};

/// A convex quarter ellipse.
struct round_profile {
    std::uint32_t steps = 0;  ///< at most 63; 0: by the text's tolerance

    [[nodiscard]] option_bits cache_key() const noexcept { return {steps}; }
    void operator()(const profile_scale& scale, profile_points& out) const noexcept
    {
        quarter_ellipse::add(steps != 0 ? steps : quarter_ellipse::steps_for(scale), true, out);
    }
};
static_assert(bevel_profile<round_profile>);

/// A concave one.
struct concave_profile {
    std::uint32_t steps = 0;  ///< at most 63; 0: by the text's tolerance

    [[nodiscard]] option_bits cache_key() const noexcept { return {steps}; }
    void operator()(const profile_scale& scale, profile_points& out) const noexcept
    {
        quarter_ellipse::add(steps != 0 ? steps : quarter_ellipse::steps_for(scale), false, out);
    }
};
static_assert(bevel_profile<concave_profile>);

/// Two equal steps: a level tread, then an upright riser, twice.
struct stepped_profile {
    void operator()(const profile_scale&, profile_points& out) const noexcept
    {
        for (const profile_point p :
             {profile_point{0.0f, 0.0f}, {0.5f, 0.0f}, {0.5f, 0.5f}, {1.0f, 0.5f}, {1.0f, 1.0f}})
            out.add(p);
    }
};
static_assert(bevel_profile<stepped_profile>);

/// Up to full height at half the width and down again, so that a rim surrounds the cap.
struct engraved_profile {
    void operator()(const profile_scale&, profile_points& out) const noexcept
    {
        for (const profile_point p : {profile_point{0.0f, 0.0f}, {0.5f, 1.0f}, {1.0f, 0.0f}}) out.add(p);
    }
};
static_assert(bevel_profile<engraved_profile>);

}  // namespace typemesh::inline TYPEMESH_ABI
