// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/deformation.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/impl/bent_data.hpp>
#include <typemesh/extrude/impl/bent_measure.hpp>
#include <typemesh/extrude/impl/bevel_bisection.hpp>
#include <typemesh/refine/impl/edge_bisection.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A cap_maker that divides the slopes of bevels as far as they bend: see bendable_caps.
template <cap_maker Caps, class Solid, deformation Deformation>
class bending_caps : public caps_of_region<Caps> {
public:
    bending_caps(Caps& caps, bent_data<Solid>& data, const bent_measure<Deformation>& measure,
                 std::uint32_t max_points) noexcept
        : caps_of_region<Caps>{caps, data.flat.triangles.view()},
          working_{data.slopes},
          measure_{measure},
          max_points_{max_points}
    {
    }

    error divide(swept_region& swept, const swept_heights& heights) noexcept
    {
        return working_.run(swept, heights, measure_, max_points_);
    }

private:
    bevel_bisection& working_;
    const bent_measure<Deformation>& measure_;
    std::uint32_t max_points_;
};

/// Refines the caps of a solid that makes its own, and keeps their edges: see bendable_caps. Nothing here asks how many
/// holes they have, so their regions do not count them.
template <class Solid, deformation Deformation>
class bent_caps {
public:
    bent_caps(bent_data<Solid>& data, const bent_measure<Deformation>& measure, std::uint32_t max_points) noexcept
        : data_{data}, measure_{measure}, max_points_{max_points}
    {
    }

    /// The edges stay as they are, so thin triangles between them may turn, within the tolerance.
    ///
    /// Fails  error::out_of_memory, error::too_many_points
    error region_cap(std::uint32_t& added) noexcept
    {
        auto& flat = data_.flat;
        if (error e = refine(region::proven(flat.loops, 0, 0), flat.triangles.view())) return e;
        return take(flat.loops.points, flat.triangles, added);
    }
    error cap(buffer<grid_point>& points, array_view<const std::uint32_t> starts, buffer<triangle>& triangles,
              std::uint32_t& added) noexcept
    {
        contours& rim = data_.rim;
        rim.clear();
        contour_edge* const edges = rim.edges.append(points.size());
        if (edges == nullptr || !rim.points.append(points.view()) || !rim.starts.append(starts))
            return error::out_of_memory;
        for (std::size_t i = 0; i < points.size(); ++i) edges[i] = {};
        if (error e = refine(region::proven(rim, 0, 0), triangles.view())) return e;
        return take(points, triangles, added);
    }

private:
    error refine(const region& r, array_view<const triangle> triangles) noexcept
    {
        edge_bisection& working = data_.working;
        if (error e = working.run(r, triangles, measure_, max_points_, edge_bisection::boundary::keep)) return e;
        std::uint32_t kept = 0;
        if (error e = working.write({data_.same_rim, data_.inner, data_.triangles, kept})) return e;
        return {};
    }
    error take(buffer<grid_point>& points, buffer<triangle>& triangles, std::uint32_t& added) noexcept
    {
        triangles.clear();
        if (!points.append(data_.inner.view()) || !triangles.append(data_.triangles.view()))
            return error::out_of_memory;
        added = static_cast<std::uint32_t>(data_.inner.size());
        return {};
    }

    bent_data<Solid>& data_;
    const bent_measure<Deformation>& measure_;
    std::uint32_t max_points_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
