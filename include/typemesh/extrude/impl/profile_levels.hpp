// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/extrude/profile_points.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cmath>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A distance from the wall at which a profile bends, and the heights at which it arrives and leaves there. The two
/// differ at a riser.
struct profile_level {
    double distance = 0.0;  ///< in cells
    float arrives = 0.0f;   ///< as a share of the bevel's depth; at the first level, the end of the wall
    float leaves = 0.0f;    ///< at the last level, the height of the cap

    /// Whether the level has a riser.
    [[nodiscard]] bool has_riser() const noexcept { return !same(arrives, leaves); }
    /// The height of its riser, as a share of the bevel's depth.
    [[nodiscard]] double riser() const noexcept { return std::fabs(as_double(leaves) - as_double(arrives)); }
};

/// The levels of a profile on one glyph: distances rising from 0 to the width, at least four cells apart.
///
///     leaves 2 .  ____           Points of the profile closer together become one level: a riser if their heights
///                |               differ by four cells or more, otherwise a bend at the middle of their heights. The
///     arrives 2 _|               first and the last height are kept. A profile narrower than four cells is one riser
///            .'                  at the wall, or none if the two heights differ by less than four cells. A profile
///          .'    level 2         shallower than four cells does not rise at all. Where nothing rises, the wall reaches
///     level 0, 1 ...             up to the cap.
///
/// If edges must have two faces each (profile_scale::leans), a riser away from the wall becomes a steep slope, four
/// cells wide, or vanishes. An upright riser would have edges with four faces where the boundary touches itself at its
/// distance.
class profile_levels {
public:
    static constexpr double finest = finest_band;

    /// `points` are valid; the tolerance of the scale does not matter.
    profile_levels(const profile_points& points, const profile_scale& scale) noexcept
    {
        const auto all = points.view();
        TYPEMESH_ASSERT(points.is_valid(), "profile_levels need a valid profile");
        if (scale.depth < finest) {
            add(0.0, 1.0f, 1.0f);
            if (scale.width >= finest) add(scale.width, 1.0f, 1.0f);
            return;
        }
        const auto distance = [&](std::size_t i) noexcept { return as_double(all[i].t) * scale.width; };
        std::size_t last = all.size() - 1;  // the first point of the last level
        while (last > 0 && scale.width - distance(last - 1) < finest) --last;
        for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
            end = i + 1;
            while (end < last && distance(end) - distance(i) < finest) ++end;
            if (i == last) end = all.size();
            const bool first = i == 0, is_last = i == last;
            float from = all[i].h, to = all[end - 1].h;
            const bool bends = std::fabs(as_double(to) - as_double(from)) * scale.depth < finest;
            if (bends) from = to = is_last ? to : first ? from : 0.5f * (from + to);
            add(first ? 0.0 : is_last ? scale.width : distance(i), from, to);
        }
        if (scale.leans) lean();
    }

    [[nodiscard]] array_view<const profile_level> view() const noexcept { return {levels_, count_}; }

private:
    /// Splits the levels that have a riser. Each was made of at least two points, so there is room for them.
    void lean() noexcept
    {
        profile_level upright[profile_points::most];
        const std::size_t n = count_;
        for (std::size_t i = 0; i < n; ++i) upright[i] = levels_[i];
        count_ = 1;
        for (std::size_t i = 1; i < n; ++i) {
            const auto [at, arrives, leaves] = upright[i];
            const bool last = i + 1 == n;
            const bool before = at - levels_[count_ - 1].distance >= 2.0 * finest,
                       after = !last && upright[i + 1].distance - at >= 2.0 * finest;
            if (!upright[i].has_riser()) {
                add(at, arrives, leaves);
            } else if (after || before) {
                add(after ? at : at - finest, arrives, arrives);
                add(after ? at + finest : at, leaves, leaves);
            } else {
                const float h = last ? leaves : 0.5f * (arrives + leaves);
                add(at, h, h);
            }
        }
    }

    void add(double distance, float arrives, float leaves) noexcept { levels_[count_++] = {distance, arrives, leaves}; }

    profile_level levels_[profile_points::most];
    std::size_t count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
