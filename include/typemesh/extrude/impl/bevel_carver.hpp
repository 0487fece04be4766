// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/bevel_sweep.hpp>
#include <typemesh/extrude/impl/profile_levels.hpp>
#include <typemesh/extrude/profile_points.hpp>
#include <typemesh/offset/swept_region.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The input of a bevel's sweep: a region with its triangles.
struct region_to_carve {
    const region& filled;
    array_view<const triangle> triangles;
};

/// Sweeps a region for a bevel, and narrows the bevel if its full width is impossible.
struct bevel_carver {
    bevel_sweep sweep;
    bool fits = false;  ///< wanted: at most 0.9 times the width at which a part of the region would lose its cap

    bool touches = false;  ///< set by make(): it refuses because corners touch; a hundredth less may prevent this

    bool narrowed = false;  ///< afterwards: the bevel is narrower than wanted because the remaining region was refused

    /// `points_of(scale)` returns the profile, `make(swept)` makes a cap of the remaining region, `scale.width` becomes
    /// the width of the bevel. It is halved if the sweep or the cap is refused with error::crossing_contours.
    ///
    /// Fails  with any other error of the two
    template <class Points, class Make>
    error operator()(const region_to_carve& given, const Points& points_of, profile_scale& scale, workspace& space,
                     swept_region& out, const Make& make) noexcept
    {
        bool is_wanted = !fits;
        // The result measured at one width holds at a narrower one if corners move alike.
        if (fits && sweep.joins_at < scale.width) sweep.joins_at = scale.width;
        int slight = 0;  // how often the width was reduced by a hundredth
        narrowed = false;
        for (;;) {
            error e = sweep(given.filled, given.triangles, {points_of(scale), scale}, space, out);
            if (!e && !is_wanted && out.first_loss >= 0.0) {
                scale.width = 0.9 * out.first_loss;
                is_wanted = true;
                narrowed = false;  // a loss found at a narrower width is still the first
                continue;
            }
            if (!e) e = make(out);
            if (!e || e != error::crossing_contours || scale.width < profile_levels::finest) return e;
            if (taken(touches) && slight++ < 16) {
                scale.width *= 0.99;
                continue;
            }
            scale.width *= 0.5;
            narrowed = true;
        }
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
