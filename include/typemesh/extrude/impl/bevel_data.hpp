// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/extrude/side_point.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A vertex of a bevel: of the front's, and of the back's, which is its mirror image.
struct bevel_vertex {
    grid_point at;
    vec2 outward;        ///< unit vector in the plane: its normal before the profile tilts it
    float along = 0.0f;  ///< along the contour, as side_point::along
    float share = 0.0f;  ///< its place across the strip: 0 at the strip's outer end, 1 at its inner
    std::uint32_t strip = 0;
};

/// Three bevel vertices, counter-clockwise seen from the front.
struct bevel_triangle {
    triangle corners;
};

/// The part of a bevel between two levels, or a riser at one level; from the wall inwards.
struct bevel_strip {
    float run = 0.0f;   ///< its width in the plane, in cells; 0: a riser
    float from = 0.0f;  ///< its height at both ends, as a share of the bevel's depth
    float to = 0.0f;
    bool smooth_before = false;  ///< the neighbour (the wall, the cap) has the same normals at this end
    bool smooth_after = false;
};

/// The data of a bevel for its neighbours.
struct bevel_rims {
    float wall = 0.0f;            ///< the end of the wall, as a share of the bevel's depth
    float cap = 0.0f;             ///< the height of the cap
    float top = 0.0f;             ///< the greatest height of anything
    float width = 0.0f;           ///< of the bevel, in em
    bool own_cap = false;         ///< the cap is the region's own: the bevel has no width, or lies outside of it
    bool outward = false;         ///< the walls do not stand on the region's own edges
    bool touches = false;         ///< front and back meet inside the outline, and low walls are not possible
    std::uint32_t vertices = 0;   ///< the bevel's own; an outward bevel's walls follow, whose
    std::uint32_t triangles = 0;  ///< vertices come in pairs, at the back and at the front

    /// Whether the cap on a side (bevelled or not) is the region's own.
    [[nodiscard]] bool has_own_cap(bool is_bevelled) const noexcept { return own_cap || is_bevelled == outward; }
};

/// The plan data of bevelled.
///
///     side_point      one for each contour point
///     bevel_vertex, bevel_triangle, bevel_strip       of one bevel
///     bevel_rims      one
///     grid_point, triangle        of the cap within the bevel
///     grid_point, std::uint32_t   for an outward bevel: points and starts of its walls' loops, which bound that cap
///
/// Also the working memory of plan(), kept for the next glyph.
struct bevel_data : plan_arrays<side_point, bevel_vertex, bevel_triangle, bevel_strip, bevel_rims, grid_point, triangle,
                                std::uint32_t> {
    /// One edge's face at a node, and its vertex there.
    struct corner {
        std::uint32_t edge;
        std::uint32_t vertex;
        std::uint32_t next;  ///< the next corner of the same node
    };
    /// The normals of the corners that share a vertex.
    struct corner_normals {
        point first, sum;
        point right, left;  ///< the outermost of these normals and of the flat faces' normals, less than 180 degrees
                            ///< apart

        corner_normals(point n, point face) noexcept : first{n}, sum{n}, right{n}, left{n} { widen(face); }

        void add(point n, point face) noexcept
        {
            sum = sum + n;
            widen(n);
            widen(face);
        }
        /// Whether, with one more normal, all differ by less than 90 degrees from their sum.
        [[nodiscard]] bool stays_near(point n, point face) const noexcept
        {
            corner_normals more = *this;
            if (!more.widen(n) || !more.widen(face)) return false;
            more.sum = sum + n;
            constexpr double least = 0x1p-10;
            return dot(more.sum, more.right) > least && dot(more.sum, more.left) > least;
        }

    private:
        /// False if the range would go all the way around the vertex.
        bool widen(point n) noexcept
        {
            const bool to_right = cross(right, n) < 0.0, to_left = cross(left, n) > 0.0;
            if (to_right && to_left) return false;
            if (to_right) right = n;
            if (to_left) left = n;
            return true;
        }
    };

    swept_region swept;
    contours around;          ///< the surroundings of the region, for outward bevels
    triangle_list triangles;  ///< their triangles
    buffer<corner> corners;
    buffer<corner_normals> normals;  ///< of each bevel vertex

    explicit bevel_data(memory source = heap()) noexcept
        : plan_arrays{source}, swept{source}, around{source}, triangles{source}, corners{source}, normals{source}
    {
    }

    /// Empties the plan arrays; their storage is kept.
    void clear() noexcept { plan_arrays::clear(); }
};

}  // namespace typemesh::inline TYPEMESH_ABI
