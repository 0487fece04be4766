// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/fill/resolve.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The union of the regions of several glyphs, placed on one grid.
///
///      +----+  +----+             +-------------+       begin(grid)          starts a group on this grid
///      | a ++--++ c |     ->      |             |       add(region, ...)      adds a member
///      |   ++--++   |             |             |       join(space)           makes the union
///      +----+b +----+             +-------------+       member_of(curve)      the member that a curve comes from
///
/// The members' curves are copied and renumbered, and the edges of the union refer to the copies. If boundaries of
/// several members coincide, the edge belongs to the first of these members. Crossings between members count as real,
/// however shallow they are. The tolerance is the largest tolerance of a member. Memory is kept for the next group.
class region_union {
public:
    explicit region_union(memory source = heap()) noexcept : loops_{source}, curves_{source}, first_curves_{source} {}

    /// Removes all members. `corners` selects the treatment of the union's corners that touch.
    void begin(const grid& onto, touching corners = touching::keep) noexcept
    {
        loops_.clear();
        loops_.corners = corners;
        loops_.grid = onto;
        curves_.clear();
        first_curves_.clear();
    }

    /// Adds a region. Each of its points p is placed at scale * p + (x, y), rounded to the grid.
    ///
    ///     scale    cells of this grid per cell of the region's own grid. The scale is a power of two if both grids
    ///              come from fonts with equal units per em; at scale 1 nothing is rounded
    ///
    /// Fails  error::outline_beyond_grid: a point would be farther than grid::reach from 0
    ///        error::too_large: 2^32 - 1 points or curves or more
    ///        error::out_of_memory; the group is then unchanged
    [[nodiscard]] result<void> add(const region& r, double scale, std::int64_t x, std::int64_t y) noexcept
    {
        const std::size_t points = loops_.points.size(), edges = loops_.edges.size(), starts = loops_.starts.size(),
                          curves = curves_.size();
        const error e = append(r, scale, x, y);
        if (e) {
            loops_.points.truncate(points);
            loops_.edges.truncate(edges);
            loops_.starts.truncate(starts);
            curves_.truncate(curves);
        }
        return e;
    }

    /// The region that the members fill together. The region lies in this group's memory and is valid until the next
    /// begin().
    ///
    ///     parting    receives the number of corners that touched, and whether some of them still touch
    ///
    /// Fails  as resolve() and corner_parting do
    template <class = void>  // see resolve()
    [[nodiscard]] result<region> join(workspace& space, std::uint32_t max_pieces, corner_parting& parting) noexcept
    {
        loops_.curves = curves_.view();
        parting = {};
        const auto made = resolve(loops_, fill_rule::non_zero, space, {.max_pieces = max_pieces});
        if (!made || !made->is_touching() || loops_.corners == touching::keep) return made;
        return parting(loops_, curves_, space, max_pieces);
    }
    template <class = void>
    [[nodiscard]] result<region> join(workspace& space, std::uint32_t max_pieces = default_max_pieces) noexcept
    {
        corner_parting unread;
        return join(space, max_pieces, unread);
    }

    /// The number of curves of the members. Curves with higher numbers belong to corners that were separated or joined.
    [[nodiscard]] std::size_t curve_count() const noexcept { return curves_.size(); }

    /// The member that a curve of the union comes from: 0 for the first member added.
    [[nodiscard]] std::uint32_t member_of(std::uint32_t curve) const noexcept
    {
        return static_cast<std::uint32_t>(range_of(first_curves_.view(), curve));
    }

private:
    error append(const region& r, double scale, std::int64_t x, std::int64_t y) noexcept
    {
        constexpr std::size_t most = 0xFFFF'FFFEu;
        const std::size_t first = loops_.points.size(), count = r.points().size();
        const auto first_curve = static_cast<std::uint32_t>(curves_.size());
        if (count > most - first || r.curves().size() > most - curves_.size()) return error::too_large;

        grid_point* points = loops_.points.append(count);
        contour_edge* edges = loops_.edges.append(count);
        if (count != 0 && (points == nullptr || edges == nullptr)) return error::out_of_memory;
        for (std::size_t i = 0; i < count; ++i) {
            const double px = std::nearbyint(scale * r.points()[i].x) + static_cast<double>(x);
            const double py = std::nearbyint(scale * r.points()[i].y) + static_cast<double>(y);
            if (std::fabs(px) > grid::reach || std::fabs(py) > grid::reach) return error::outline_beyond_grid;
            points[i] = {static_cast<std::int32_t>(px), static_cast<std::int32_t>(py)};
            edges[i] = r.edges()[i];
            edges[i].curve += first_curve;
        }
        if (loops_.starts.empty() && !loops_.starts.push_back(0)) return error::out_of_memory;
        for (std::size_t loop = 1; loop < r.starts().size(); ++loop)
            if (!loops_.starts.push_back(static_cast<std::uint32_t>(first + r.starts()[loop])))
                return error::out_of_memory;
        if (!curves_.append(r.curves()) || !first_curves_.push_back(first_curve)) return error::out_of_memory;
        if (loops_.tolerance < scale * r.tolerance()) loops_.tolerance = scale * r.tolerance();
        return {};
    }

    contours loops_;
    buffer<curve> curves_;
    buffer<std::uint32_t> first_curves_;  // the number of each member's first curve
};

}  // namespace typemesh::inline TYPEMESH_ABI
