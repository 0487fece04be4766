// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/extrude/bevel_profile.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A cubic Bezier curve from (0, 0) by two control points to (1, end), in steps of equal parameter. Its t may not
/// decrease.
///
/// With `steps` 0 as many as the text's tolerance asks for, by Wang's bound; 8 if that is unknown; at most 63.
///
/// From  R. Goldman, Pyramid Algorithms (2003), 5.6.3: n = sqrt(d(d-1)/8 * max|second difference| / tolerance)
struct bezier_profile {
    profile_point first = {0.0f, 0.5f};
    profile_point second = {0.5f, 1.0f};
    float end = 1.0f;
    std::uint32_t steps = 0;

    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_bits bits{first.t, first.h, second.t, second.h};
        bits.words[0] |= option_bits{end}.words[0] << 32;
        bits.words[1] |= std::uint64_t{steps} << 32;
        return bits;
    }

    void operator()(const profile_scale& scale, profile_points& out) const noexcept
    {
        const cubic c{{}, at(first), at(second), {1.0, as_double(end)}};
        const std::uint32_t n = steps != 0 ? steps : steps_for(c, scale);
        out.add({0.0f, 0.0f});
        for (std::uint32_t i = 1; i < n && i < profile_points::most; ++i) {
            const point p = c.at(static_cast<double>(i) / n);
            out.add({static_cast<float>(p.x), static_cast<float>(p.y)});
        }
        out.add({1.0f, end});
    }

private:
    static point at(profile_point p) noexcept { return {as_double(p.t), as_double(p.h)}; }

    static std::uint32_t steps_for(const cubic& c, const profile_scale& scale) noexcept
    {
        if (!(scale.tolerance > 0.0)) return 8;
        const auto bend = [&scale](point a, point b, point d) noexcept {
            const point difference = a - 2.0 * b + d;
            return length({scale.width * difference.x, scale.depth * difference.y});
        };
        const double most = std::fmax(bend(c.p0, c.p1, c.p2), bend(c.p1, c.p2, c.p3));
        const double n = std::ceil(std::sqrt(0.75 * most / scale.tolerance));
        return n >= 1.0 && n < 63.0 ? static_cast<std::uint32_t>(n) : n < 1.0 ? 1u : 63u;
    }
};
static_assert(bevel_profile<bezier_profile>);

}  // namespace typemesh::inline TYPEMESH_ABI
