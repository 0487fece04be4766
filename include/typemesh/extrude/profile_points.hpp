// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

#include <cstddef>
#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// A point of a bevel's profile: t = distance from the wall as a share of the width, h = height as a share of the
/// bevel's depth.
///
///     h = 1  ..........______  cap       t never decreases. Where t is constant, the bevel has an upright riser; where
///                 ,--'                   h is constant, the bevel is level.
///               ,'
///     h = 0    |'
///        wall  |
///            t = 0    t = 1
struct profile_point {
    float t = 0.0f;
    float h = 0.0f;
};

/// A profile's points, from the wall inwards: at most 64.
class profile_points {
public:
    static constexpr std::size_t most = 64;

    constexpr profile_points() noexcept = default;
    constexpr profile_points(std::initializer_list<profile_point> points) noexcept
    {
        for (const profile_point p : points) add(p);
    }
    explicit constexpr profile_points(array_view<const profile_point> points) noexcept
    {
        for (const profile_point p : points) add(p);
    }

    /// Points beyond 64 are not kept, and the profile is then not valid.
    constexpr void add(profile_point p) noexcept
    {
        if (count_ < most)
            at_[count_++] = p;
        else
            fits_ = false;
    }

    [[nodiscard]] constexpr array_view<const profile_point> view() const noexcept { return {at_, count_}; }

    /// Whether the points are a valid profile: from (0, 0) to t = 1, t never decreasing, h between 0 and 1, everything
    /// finite, at most 64 points.
    [[nodiscard]] bool is_valid() const noexcept
    {
        if (!fits_ || count_ < 2 || !is_zero(at_[0].t) || !is_zero(at_[0].h) || !same(at_[count_ - 1].t, 1.0f))
            return false;
        float t = 0.0f;
        for (const profile_point p : view()) {
            if (!is_finite(as_double(p.t)) || !is_finite(as_double(p.h))) return false;
            if (p.t < t || p.h < 0.0f || p.h > 1.0f) return false;
            t = p.t;
        }
        return true;
    }

private:
    profile_point at_[most] = {};
    std::size_t count_ = 0;
    bool fits_ = true;
};

/// The size at which a profile is drawn on one glyph, in cells.
struct profile_scale {
    double width = 0.0;
    double depth = 0.0;
    double tolerance = 0.0;  ///< the text's tolerance; 0: unknown
    bool leans = false;      ///< whether upright sections lean by four cells: see text_options::corners
};

}  // namespace typemesh::inline TYPEMESH_ABI
