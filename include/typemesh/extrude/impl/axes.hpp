// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>
#include <typemesh/extrude/placement.hpp>

#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// A placement prepared for many points, for any frame: computes exactly what placement does.
class free_axes {
public:
    explicit free_axes(const placement& at) noexcept : at_{at} {}

    /// The common part of a point's positions at all heights.
    [[nodiscard]] placement::footprint foot(grid_point p) const noexcept { return at_.foot(p); }
    [[nodiscard]] placement::footprint foot(point p) const noexcept { return at_.foot(p); }
    [[nodiscard]] vec3 position(placement::footprint f, float z) const noexcept { return at_.position(f, z); }
    [[nodiscard]] vec3 direction(float x, float y, float z) const noexcept { return at_.frame(x, y, z); }

private:
    placement at_;  // a copy: writing vertices cannot alias it, so it stays in registers
};

/// The same, in less than half the time, for frames whose first two axes are the text's own and whose third is parallel
/// to z, which most frames are. The omitted terms are products with 0 and 1, so the results are equal.
class upright_axes {
public:
    explicit upright_axes(const placement& at) noexcept
        : pen_{at.pen}, scale_{at.unit_per_cell}, toward_{at.frame.toward.z}
    {
    }

    /// Whether they suit a placement.
    [[nodiscard]] static bool fit(const placement& at) noexcept { return fit(at.frame) && is_zero(at.rise); }

    /// Compares bits, because this runs for each part of each glyph; a frame with a -0 uses free_axes.
    [[nodiscard]] static bool fit(const frame& f) noexcept
    {
        const auto differ = [](float a, float b) noexcept {
            std::uint32_t of_a = 0, of_b = 0;
            std::memcpy(&of_a, &a, sizeof a);
            std::memcpy(&of_b, &b, sizeof b);
            return of_a ^ of_b;
        };
        const vec3 r = f.right, u = f.up, t = f.toward;
        const std::uint32_t other_z = differ(t.z, 1.0f) & 0x7FFF'FFFFu;  // either sign
        return (differ(r.x, 1.0f) | differ(r.y, 0.0f) | differ(r.z, 0.0f) | differ(u.x, 0.0f) | differ(u.y, 1.0f) |
                differ(u.z, 0.0f) | differ(t.x, 0.0f) | differ(t.y, 0.0f) | other_z) == 0;
    }

    [[nodiscard]] vec2 foot(grid_point p) const noexcept { return foot(placement::exact(p)); }
    [[nodiscard]] vec2 foot(point p) const noexcept
    {
        return {static_cast<float>((p.x + pen_.x) * scale_), static_cast<float>((p.y + pen_.y) * scale_)};
    }
    [[nodiscard]] vec3 position(vec2 f, float z) const noexcept { return {f.x, f.y, z * toward_}; }
    [[nodiscard]] vec3 direction(float x, float y, float z) const noexcept { return {x, y, z * toward_}; }

private:
    point pen_;
    double scale_;
    float toward_;
};

/// Calls f with the class that suits the placement's frame.
template <class F>
void with_axes(const placement& at, F&& f) noexcept
{
    if (upright_axes::fit(at))
        f(upright_axes{at});
    else
        f(free_axes{at});
}

}  // namespace typemesh::inline TYPEMESH_ABI
