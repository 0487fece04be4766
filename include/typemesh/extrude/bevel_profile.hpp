// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/extrude/impl/bezier_section.hpp>
#include <typemesh/extrude/impl/quarter_ellipse.hpp>
#include <typemesh/extrude/profile_points.hpp>

#include <concepts>
#include <cstdint>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// The section of a bevel, as a value: either points, or a curve whose number of points depends on the bevel's size.
///
///     bevelled{.profile = round_profile(4)}
///     bevelled{.profile = {{0, 0}, {0.2f, 0.8f}, {1, 1}}}                 your own points: see profile_points
///     bevelled{.profile = sampled_profile([](float t) { return t * t; })}
///
/// Using an invalid profile gives error::bad_option. For the rules see profile_points.
class bevel_profile {
public:
    /// One straight slope.
    bevel_profile() noexcept = default;
    bevel_profile(std::initializer_list<profile_point> points) noexcept : points_{points} {}
    bevel_profile(const profile_points& points) noexcept : points_{points} {}

    /// The points of the profile on one glyph. Their number depends on the scale if the profile is a curve without a
    /// number of steps.
    [[nodiscard]] profile_points at(const profile_scale& scale) const noexcept
    {
        if (is_ == kind::points) return points_;
        profile_points out;
        if (is_ == kind::bezier)
            curve_.add(steps_ != 0 ? steps_ : curve_.steps_for(scale), out);
        else
            quarter_ellipse::add(steps_ != 0 ? steps_ : quarter_ellipse::steps_for(scale), is_ == kind::round, out);
        return out;
    }

    /// Whether the points are a valid profile (profile_points), at every scale.
    [[nodiscard]] bool is_valid() const noexcept
    {
        return at(finest).is_valid() && (is_ != kind::bezier || steps_ != 0 || curve_.is_valid());
    }

    /// A scale that requests the largest possible number of points.
    static constexpr profile_scale finest{1.0, 1.0, 0x1p-60};

    /// Two distinct profiles have equal keys with a probability of about 2^-128.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_hash all;
        all.add(std::uint64_t{steps_} << 8 | static_cast<std::uint64_t>(is_));
        if (is_ == kind::points)
            for (const profile_point p : points_.view()) all.add(option_bits{p.t, p.h});
        if (is_ == kind::bezier) all.add(curve_.key());
        return {all.first, all.second};
    }

    friend bevel_profile round_profile(std::uint32_t steps) noexcept;
    friend bevel_profile concave_profile(std::uint32_t steps) noexcept;
    friend bevel_profile bezier_profile(const bezier_section& curve, std::uint32_t steps) noexcept;

private:
    enum class kind : std::uint8_t { points, round, concave, bezier };

    bevel_profile(kind is, std::uint32_t steps) noexcept : is_{is}, steps_{steps} {}

    kind is_ = kind::points;
    std::uint32_t steps_ = 0;  // 0: the text's tolerance sets the number of steps
    bezier_section curve_;
    profile_points points_{{0.0f, 0.0f}, {1.0f, 1.0f}};
};

/// One straight slope: the default.
[[nodiscard]] inline bevel_profile chamfer_profile() noexcept { return {}; }

/// A quarter ellipse, convex: it leaves the wall upright and meets the cap level. At most 63 steps; 0: the text's
/// tolerance sets their number.
[[nodiscard]] inline bevel_profile round_profile(std::uint32_t steps = 0) noexcept
{
    return {bevel_profile::kind::round, steps};
}
/// A quarter ellipse, concave: it leaves the wall level and meets the cap upright.
[[nodiscard]] inline bevel_profile concave_profile(std::uint32_t steps = 0) noexcept
{
    return {bevel_profile::kind::concave, steps};
}

/// Two equal steps: a level tread, then an upright riser, twice.
[[nodiscard]] inline bevel_profile stepped_profile() noexcept
{
    return {{0.0f, 0.0f}, {0.5f, 0.0f}, {0.5f, 0.5f}, {1.0f, 0.5f}, {1.0f, 1.0f}};
}

/// A profile that rises to full height at half the width and falls again, so that a rim surrounds the cap.
[[nodiscard]] inline bevel_profile engraved_profile() noexcept { return {{0.0f, 0.0f}, {0.5f, 1.0f}, {1.0f, 0.0f}}; }

/// A cubic with your own control points. At most 63 steps; 0: the text's tolerance sets their number.
[[nodiscard]] inline bevel_profile bezier_profile(const bezier_section& curve, std::uint32_t steps = 0) noexcept
{
    bevel_profile made{bevel_profile::kind::bezier, steps};
    made.curve_ = curve;
    return made;
}

/// A profile from your own function: height(t) at `steps` + 1 equal distances from the wall, where it must be 0. At
/// most 63 steps. The points are computed at once; the function is not kept.
template <class Height>
    requires requires(const Height& height) {
        { height(0.0f) } noexcept -> std::convertible_to<float>;
    }
[[nodiscard]] bevel_profile sampled_profile(const Height& height, std::uint32_t steps = 16) noexcept
{
    profile_points points;
    for (std::uint32_t i = 0; i <= steps && i <= profile_points::most; ++i) {  // more points are not valid
        const float t = i == steps ? 1.0f : static_cast<float>(i) / static_cast<float>(steps);
        points.add({t, height(t)});
    }
    return points;
}

}  // namespace typemesh::inline TYPEMESH_ABI
