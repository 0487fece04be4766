// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/impl/exact_fill.hpp>
#include <typemesh/fill/corner_parting.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// A region made of loops that a step or an extruder has found, with its triangles. It is suitable as the scratch of a
/// region_step.
///
///     inner.loops = ...                loops that already bound a region: points, edges with their curves, starts,
///                                      grid, tolerance
///     auto filled = inner.fill(caps)   the region refers to inner.loops; inner.triangles are its cap
struct inner_region {
    contours loops;               ///< its boundary
    triangle_list triangles;      ///< its cap
    buffer<curve> parted_curves;  ///< the curves of the loops, if corners were separated or joined
    corner_parting parting;       ///< the changes to the corners

    explicit inner_region(memory source = heap()) noexcept : loops{source}, triangles{source}, parted_curves{source} {}

    void clear() noexcept
    {
        loops.clear();
        triangles.clear();
        parting = {};
    }

    /// Makes the region of `loops`, which refers to these loops, and its triangles. Where the loops touch themselves,
    /// their corners are treated as `loops` says.
    ///
    /// Fails  as fill_exactly() and corner_parting do
    template <cap_maker Caps>
    [[nodiscard]] result<region> fill(Caps& caps) noexcept
    {
        triangles.clear();
        parting = {};
        auto made = fill_exactly(loops, caps, triangles);
        if (!made || !made->is_touching() || loops.corners == touching::keep) return made;
        parted_curves.clear();
        if (!parted_curves.append(loops.curves)) return error::out_of_memory;
        made = parting(loops, parted_curves, caps.space());
        triangles.clear();
        if (!made || made->points().empty()) return made;
        if (error e = caps(*made, triangles)) return e;
        return made;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
