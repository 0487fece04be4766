// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/profile_levels.hpp>
#include <typemesh/offset/sweep_inwards.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The result of a sweep of width 0: the region's own points and edges at level 0, without cells or a cap. False if out
/// of memory.
[[nodiscard]] inline bool sweep_nowhere(const region& filled, swept_region& out) noexcept
{
    const auto n = static_cast<std::uint32_t>(filled.points().size());
    if (!out.nodes.reserve(n) || !out.edges_at.reserve(n)) return false;
    for (const grid_point p : filled.points()) out.nodes.push_back_unchecked({p, 0.0f});
    for (std::uint32_t k = 0; k < filled.loop_count(); ++k)
        for (std::uint32_t i = filled.starts()[k], end = filled.starts()[k + 1]; i < end; ++i)
            out.edges_at.push_back_unchecked({i, i, i + 1 == end ? filled.starts()[k] : i + 1});
    return out.levels.push_back(0.0) && out.at_level.push_back(0) && out.at_level.push_back(n);
}

/// The sweep of a region for a bevel.
struct bevel_sweep {
    double mitre_limit = 2.0;  ///< as in sweep_options
    double tolerance = 0.0;
    bool round = true;
    bool outward = false;   ///< the region surrounds another one, at which the profile ends
    double joins_at = 0.0;  ///< as in sweep_options

    /// Sweeps the region to the levels of a profile; `out` is emptied first.
    ///
    /// Fails  as sweep_inwards() does
    [[nodiscard]] error operator()(const region& filled, array_view<const triangle> triangles,
                                   const profile_levels& profile, workspace& space, swept_region& out) const noexcept
    {
        const auto levels = profile.view();
        out.clear();
        if (levels.size() == 1) return sweep_nowhere(filled, out) ? error{} : error{error::out_of_memory};
        const double width = levels.back().distance;
        double distances[profile_points::most];
        for (std::size_t i = 0; i < levels.size(); ++i)
            distances[i] = outward ? width - levels[levels.size() - 1 - i].distance : levels[i].distance;
        workspace::scope scratch{space};
        sweep_options how{{distances, levels.size()}, mitre_limit, tolerance, round};
        how.speck = tolerance;
        how.joins_at = joins_at;
        return sweep_inwards(filled, triangles, how, scratch, out);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
