// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/extrude/impl/bevel_data.hpp>
#include <typemesh/extrude/impl/profile_levels.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The shading of a bevel across its profile.
enum class bevel_shading : std::uint8_t {
    by_slope,  ///< each strip by its own slope; neighbours that differ by less than the crease angle share the mean of
               ///< their normals
    rounded,   ///< from the wall's normal at the outer end to the cap's at the inner, by the length of the profile: a
               ///< chamfer that looks round. Not for profiles that fall. From section 8.2 of "Study of mesh generation
               ///< and optimization techniques applied to parametric forms", J. Vandenbergh, 2020
};

/// A direction across a profile: outwards in the plane and towards the reader, on the front.
struct bevel_tilt {
    double out, up;
};

[[nodiscard]] inline bevel_tilt unit(bevel_tilt v) noexcept
{
    const double scale = 1.0 / std::sqrt(v.out * v.out + v.up * v.up);
    return {scale * v.out, scale * v.up};
}

/// The unit normal of a strip, for a bevel of this depth in cells.
[[nodiscard]] inline bevel_tilt tilt_of(const bevel_strip& s, double depth) noexcept
{
    return unit(bevel_tilt{(as_double(s.to) - as_double(s.from)) * depth, as_double(s.run)});
}

/// Makes the strips of a profile's levels: a riser if a level has one, then the strip between this level and the next.
///
///     crease_degrees    the limit of smooth neighbours, with the profile drawn as wide as it is deep; risers are
///                       never smooth. Half of it towards the wall and the cap, because a round profile differs from
///                       them by half a step
///
/// False if out of memory.
[[nodiscard]] inline bool add_strips(const profile_levels& profile, float crease_degrees, bevel_shading shading,
                                     buffer<bevel_strip>& out) noexcept
{
    const auto levels = profile.view();
    if (!out.reserve(2 * levels.size())) return false;
    for (std::size_t k = 0; k < levels.size(); ++k) {
        const profile_level& at = levels[k];
        if (at.has_riser()) out.push_back_unchecked({0.0f, at.arrives, at.leaves});
        if (k + 1 == levels.size()) break;
        const profile_level& next = levels[k + 1];
        out.push_back_unchecked({static_cast<float>(next.distance - at.distance), at.leaves, next.arrives});
    }
    const auto smooth = [&](bevel_tilt a, bevel_tilt b, double crease) noexcept {
        return shading == bevel_shading::rounded || a.out * b.out + a.up * b.up >= crease;
    };
    // A profile's floats change the angle by about 2^-24: an angle equal to the crease angle is smooth.
    constexpr double slack = 0x1p-20;
    const double between = crease_cosine(crease_degrees) - slack,
                 at_ends = crease_cosine(0.5f * crease_degrees) - slack;
    const double depth = levels.back().distance;
    for (std::size_t i = 0; i < out.size(); ++i) {
        if (is_zero(out[i].run)) continue;
        const bevel_tilt own = tilt_of(out[i], depth);
        if (i == 0) out[i].smooth_before = smooth({1.0, 0.0}, own, at_ends);
        if (i + 1 == out.size())
            out[i].smooth_after = smooth(own, {0.0, 1.0}, at_ends);
        else if (!is_zero(out[i + 1].run))
            out[i].smooth_after = out[i + 1].smooth_before = smooth(own, tilt_of(out[i + 1], depth), between);
    }
    return true;
}

/// A vertex's height as a share of the bevel's depth; at a strip's end, the end's height to the bit.
[[nodiscard]] inline float height_of(const bevel_vertex& v, array_view<const bevel_strip> strips) noexcept
{
    const bevel_strip& s = strips[v.strip];
    if (!(v.share > 0.0f)) return s.from;
    if (!(v.share < 1.0f)) return s.to;
    const auto risen = static_cast<float>(as_double(v.share) * (as_double(s.to) - as_double(s.from)));
    return static_cast<float>(as_double(s.from) + as_double(risen));
}

/// The strips of a bevel for writing: heights, lengths and normals across its profile.
class bevel_slopes {
public:
    /// `depth` in cells.
    bevel_slopes(array_view<const bevel_strip> strips, double depth, bevel_shading shading) noexcept : strips_{strips}
    {
        double begin = 0.0;
        for (std::size_t i = 0; i < strips.size(); ++i) {
            const bevel_strip& s = strips[i];
            const double rise = (as_double(s.to) - as_double(s.from)) * depth, run = as_double(s.run);
            slopes_[i].begin = begin;
            slopes_[i].length = std::sqrt(rise * rise + run * run);
            begin += slopes_[i].length;
        }
        for (std::size_t i = 0; i < strips.size(); ++i) {
            const bevel_strip& s = strips[i];
            const bevel_tilt own = tilt_of(s, depth);
            bevel_tilt before = own, after = own;
            if (shading == bevel_shading::rounded && !is_zero(s.run)) {
                before = off_level(rounded_at(slopes_[i].begin / begin), own);
                after = off_level(rounded_at((slopes_[i].begin + slopes_[i].length) / begin), own);
            } else {  // between two strips the middle is above both, and turned towards one it may be below the other
                if (s.smooth_before)
                    before = i == 0 ? off_level({1.0, 0.0}, own) : middle(tilt_of(strips[i - 1], depth), own);
                if (s.smooth_after)
                    after = i + 1 == strips.size() ? off_level({0.0, 1.0}, own)
                                                   : middle(own, tilt_of(strips[i + 1], depth));
            }
            slopes_[i].before = before;
            slopes_[i].after = after;
        }
    }

    /// See height_of().
    [[nodiscard]] float height(const bevel_vertex& v) const noexcept { return height_of(v, strips_); }

    /// The length of the profile from the wall, in cells.
    [[nodiscard]] double length(const bevel_vertex& v) const noexcept
    {
        const slope& s = slopes_[v.strip];
        return s.begin + as_double(v.share) * s.length;
    }

    /// The normal across the profile, of unit length.
    [[nodiscard]] bevel_tilt tilt(const bevel_vertex& v) const noexcept
    {
        const slope& s = slopes_[v.strip];
        const double share = as_double(v.share);
        if (!(share > 0.0)) return s.before;
        if (!(share < 1.0)) return s.after;
        return unit(bevel_tilt{(1.0 - share) * s.before.out + share * s.after.out,
                               (1.0 - share) * s.before.up + share * s.after.up});
    }

    [[nodiscard]] bool is_riser(const bevel_vertex& v) const noexcept { return is_zero(strips_[v.strip].run); }

private:
    struct slope {
        double begin, length;
        bevel_tilt before, after;  // at both ends
    };

    static bevel_tilt middle(bevel_tilt a, bevel_tilt b) noexcept
    {
        return unit(bevel_tilt{a.out + b.out, a.up + b.up});
    }
    /// Turns a normal that is perpendicular to its strip's own (like a wall's and a level strip's) slightly towards it.
    static bevel_tilt off_level(bevel_tilt n, bevel_tilt own) noexcept
    {
        constexpr double least = 0x1p-6;
        if (n.out * own.out + n.up * own.up >= least) return n;
        return unit(bevel_tilt{n.out + 2.0 * least * own.out, n.up + 2.0 * least * own.up});
    }
    static bevel_tilt rounded_at(double share) noexcept { return unit(bevel_tilt{1.0 - share, share}); }

    array_view<const bevel_strip> strips_;
    slope slopes_[2 * profile_points::most];
};

}  // namespace typemesh::inline TYPEMESH_ABI
