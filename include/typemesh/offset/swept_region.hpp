// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The least distance between two levels, in cells: rounding nodes to the grid would destroy anything finer.
inline constexpr double finest_band = 4.0;

/// A point that the moving boundary of a region has passed, and the distance at which it did.
struct swept_node {
    grid_point at;
    float distance = 0.0f;  ///< the distance in cells, from 0 at the region's boundary to the width
};

/// The area that one edge sweeps between two levels. Splits and joins can give this area the shape of any polygon, so
/// its triangles are listed instead of its outline.
struct swept_cell {
    std::uint32_t edge = 0;            ///< the edge of the region; numbers from the region's number of points on are
                                       ///< joins
    std::uint32_t band = 0;            ///< the cell lies between levels[band] and levels[band + 1]
    std::uint32_t first_triangle = 0;  ///< the triangles end before the next cell's first triangle
};

/// The position of a moving edge at a level: from node a to node b, the interior on the left.
struct swept_edge_at {
    std::uint32_t edge = 0;
    std::uint32_t a = 0, b = 0;
};

/// An edge of zero length, inserted at a reflex corner sharper than the mitre limit: it grows as its neighbours move.
struct swept_join {
    std::uint32_t point = 0;  ///< the point of the region
    vec2 inward;              ///< unit vector: its direction of movement
};

/// A region's boundary swept inwards: the faces of its straight skeleton up to a width, divided at levels, and the
/// region that remains inside.
///
///     +-----------------+      nodes      the first n are the region's own points, in its order, at distance 0
///     | \_____________/ |      cells      ordered by band; the last one only ends the triangles of the one before
///     |  |           |  |      triangles  counter-clockwise, of nodes; they cover the region without its cap exactly
///     |  |    cap    |  |                 once; none is flat in the plane
///     |  |___________|  |      levels     distances in cells, ascending, from 0 to the width
///     | /             \ |      at_level   edges_at[at_level[k]] .. edges_at[at_level[k + 1]] are the edges at level k
///     +-----------------+      cap        the region at the last level: loops over nodes at that level; cap_nodes
///                                         lists the node of each point; its edges refer to no curve yet
///                                         (name_cap_edges)
/// At the first level edges_at are the region's edges, at the last level the cap's edges.
struct swept_region {
    buffer<swept_node> nodes;
    buffer<swept_cell> cells;
    buffer<triangle> triangles;
    buffer<double> levels;
    buffer<swept_edge_at> edges_at;
    buffer<std::uint32_t> at_level;
    buffer<swept_join> joins;
    contours cap;
    buffer<std::uint32_t> cap_nodes;
    /// The distance at which the first connected component that is no speck (sweep_options) was swept completely. If
    /// all components were swept and are specks, the distance of the last component; otherwise -1.
    double first_loss = -1.0;
    std::uint32_t lost = 0;  ///< the number of connected components that were swept completely, including specks
    /// The amount of work, only for tests and benchmarks.
    std::size_t events = 0;     ///< how often the boundary's topology or the triangulation changed
    std::size_t schedules = 0;  ///< how often a triangle's collapse time was computed; with events, a sweep's work

    explicit swept_region(memory source = heap()) noexcept
        : nodes{source},
          cells{source},
          triangles{source},
          levels{source},
          edges_at{source},
          at_level{source},
          joins{source},
          cap{source},
          cap_nodes{source}
    {
    }

    /// Empties everything; keeps the storage.
    void clear() noexcept
    {
        nodes.clear();
        cells.clear();
        triangles.clear();
        levels.clear();
        edges_at.clear();
        at_level.clear();
        joins.clear();
        cap.clear();
        cap_nodes.clear();
        first_loss = -1.0;
        lost = 0;
        events = schedules = 0;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
