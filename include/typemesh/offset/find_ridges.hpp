// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/offset/impl/ridge_graph.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The role of a ridge's point in its polyline.
enum class ridge_step : std::uint32_t {
    on,      ///< the polyline goes on to this point
    begins,  ///< a ridge begins here
    floor,   ///< an outline of the floor begins here; it ends with the same point
};

/// A point of a ridge, and its distance from the outline, in cells.
struct ridge_point {
    grid_point at;
    float distance = 0.0f;
    ridge_step step = ridge_step::on;  ///< its role in the polyline
};

/// Finds the ridges of a region that was swept inwards in one band: the lines where its slopes meet and fall to both
/// sides. Appends them as polylines, each ridge once.
///
///     +---------------+     A ridge ends at a convex corner of the outline, at distance 0; where three ridges or more
///     | \           / |     meet; or at the last level, on the outline of the region that remains. Along a smooth
///     |   >-------<   |     outline it begins where the faces on its two sides turn by more than the crease angle. A
///     | /           \ |     ridge around a hole may have no end: it returns to its first point. If a component of the
///     +---------------+     region has no ridge, its deepest point is a polyline of one point.
///
///     crease       the cosine of the crease angle
///     is_corner    says of a convex point of the region whether a ridge goes to it
///
/// The ridges of a component are connected if it is wider than a few cells everywhere. If only a valley connects two
/// ridges, it is kept.
///
/// Fails  error::out_of_memory
/// Cost   O(n)
template <class IsCorner>
[[nodiscard]] error find_ridges(const region& r, const swept_region& swept, double crease, const IsCorner& is_corner,
                                workspace::scope& scratch, buffer<ridge_point>& out) noexcept
{
    if (swept.levels.size() != 2 || swept.triangles.empty()) return {};
    detail::ridge_graph graph{r, swept, scratch};
    if (!graph.build()) return error::out_of_memory;
    // To 2^-30: the standard libraries' cosines differ in the last bits.
    graph.prune(static_cast<std::int64_t>(std::floor(crease * static_cast<double>(detail::unit_one) + 0.5)), is_corner);
    const bool fits = graph.chains([&](std::uint32_t node, bool begins) noexcept {
        const swept_node& n = swept.nodes[node];
        return out.push_back({n.at, n.distance, begins ? ridge_step::begins : ridge_step::on});
    });
    return fits ? error{} : error{error::out_of_memory};
}

}  // namespace typemesh::inline TYPEMESH_ABI
