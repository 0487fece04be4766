// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/vertex/frame.hpp>

#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// A point of a solid as its extruder computes it, not rounded to a grid.
struct solid_point {
    double x = 0.0;  ///< the coordinates in the plane, in cells, like the region's points
    double y = 0.0;
    double z = 0.0;  ///< the height, in the unit of the extruder's heights()
};

/// The position of a glyph and the size of a cell in output units: the map from grid cells to the caller's coordinates.
///
///     output = frame((cell + pen) * unit_per_cell)        z = depth * unit_per_depth
///
///     at.position({x, y, z})          any point, in double precision; bit for bit as for a grid point
///     at.direction({x, y, z})         a normal or a tangent: x along the text, y up, z towards the reader
///     at.cells_per_depth()            for slopes: cells per unit of heights
///     planar_texture, wall_texture    texture coordinates: texture.hpp
///     texture_tangent                 and their tangents: texture_tangent.hpp
///
/// Sum and product are computed in double precision, and the result is rounded to the 24 bits of a float. The
/// operations are identical everywhere, so equal sums give equal floats. Because of this rounding the frame's products
/// are exact, whether or not a compiler fuses them with additions (FMA). If the frame's axes are not parallel to the
/// coordinate axes, the sum of the products is rounded once more.
struct placement {
    /// The position of a point of the plane z = 0, in the caller's axes; position() lifts it to a height.
    struct footprint {
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
    };

    point pen = {};               ///< the glyph's origin, in cells
    double rise = 0.0;            ///< added to the heights of positions, in output units
    double unit_per_cell = 1.0;   ///< output units per cell
    double unit_per_depth = 1.0;  ///< output units per unit of depths (that unit is an em, unless
                                  ///< text_options::depth_in says otherwise)
    double em_per_depth = 1.0;    ///< em per unit of depths
    double em_per_cell = 1.0;     ///< em per cell
    point em_pen = {};            ///< em mapping: the glyph's origin, in cells, relative to the text's own origin
    point texture_pen = {};       ///< box mapping: the glyph's origin, in cells, from the box's lower left corner
    point texture_per_cell = {};  ///< box mapping: the growth of u and v per cell; 0 where the box has no extent
    typemesh::frame frame = {};
    glyph_id glyph = no_glyph;        ///< the glyph of vertices that want it
    cluster_id cluster = no_cluster;  ///< the glyph's position in the caller's text, for vertices that want it
    style_id style = no_style;        ///< the glyph's style_id, for vertices that want it

    /// The common part of a grid point's positions at all heights.
    [[nodiscard]] footprint foot(grid_point p) const noexcept { return foot(exact(p)); }

    /// The common part for a point in double precision, in cells.
    [[nodiscard]] footprint foot(point p) const noexcept
    {
        const double x = to_24_bits((p.x + pen.x) * unit_per_cell), y = to_24_bits((p.y + pen.y) * unit_per_cell);
        const typemesh::frame& f = frame;
        return {as_double(f.right.x) * x + as_double(f.up.x) * y, as_double(f.right.y) * x + as_double(f.up.y) * y,
                as_double(f.right.z) * x + as_double(f.up.z) * y};
    }

    /// The position of a foot lifted to height z, in output units.
    [[nodiscard]] vec3 position(footprint f, float z) const noexcept
    {
        const double height = to_24_bits(as_double(z) + rise);
        const vec3 t = frame.toward;
        return {static_cast<float>(f.x + as_double(t.x) * height), static_cast<float>(f.y + as_double(t.y) * height),
                static_cast<float>(f.z + as_double(t.z) * height)};
    }

    /// The position of a grid point at height z, in output units.
    [[nodiscard]] vec3 position(grid_point p, float z) const noexcept { return position(foot(p), z); }

    /// The position of any point.
    [[nodiscard]] vec3 position(const solid_point& p) const noexcept
    {
        return position(foot(point{p.x, p.y}), height(p.z));
    }

    /// An extruder's height, in output units, without `rise`.
    [[nodiscard]] float height(double depth) const noexcept { return static_cast<float>(depth * unit_per_depth); }

    /// Cells per unit of heights.
    [[nodiscard]] double cells_per_depth() const noexcept { return unit_per_depth / unit_per_cell; }

    /// Converts a direction from the text's own axes (x along the text, y up, z towards the reader) to the caller's
    /// axes.
    [[nodiscard]] vec3 direction(vec3 d) const noexcept { return frame(d.x, d.y, d.z); }
    [[nodiscard]] vec3 direction(float x, float y, float z) const noexcept { return frame(x, y, z); }

    /// Converts a wall's normal in the plane to the caller's axes.
    [[nodiscard]] vec3 normal(vec2 n) const noexcept
    {
        return {frame.right.x * n.x + frame.up.x * n.y, frame.right.y * n.x + frame.up.y * n.y,
                frame.right.z * n.x + frame.up.z * n.y};
    }

    /// A grid point in double precision.
    [[nodiscard]] static constexpr point exact(grid_point p) noexcept
    {
        return {static_cast<double>(p.x), static_cast<double>(p.y)};
    }

private:
    /// The result of a cast to float and back, computed on the bits. If it saw the casts, -ffast-math would compute the
    /// whole position in floats, where FMA does matter, and differently in each loop.
    [[nodiscard]] static double to_24_bits(double v) noexcept
    {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &v, sizeof bits);
        bits = (bits + 0x0FFF'FFFFu + ((bits >> 29) & 1u)) & ~std::uint64_t{0x1FFF'FFFFu};
        std::memcpy(&v, &bits, sizeof v);
        return v;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
