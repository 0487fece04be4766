// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/extrude/side_point.hpp>
#include <typemesh/extrude/texture_tangent.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The source of texture coordinates. v grows upwards, or downwards as 1 - v if the frame says uv_origin::top_left.
///
///     box           the text's (or line's, or glyph's) box becomes the square [0, 1], for caps and walls alike: walls
///                   repeat the texture at the caps' edge, stretched into lines along the depth. For pictures made for
///                   one text, and for formats limited to [0, 1]
///     em            the default: one texture tile is one em wide and high, everywhere, so coordinates go beyond [0, 1]
///                   caps    x and y from the text's origin
///                   walls   u is the distance from the contour's seam, in the contour's direction; v runs from 1 at
///                           the front down to 1 - depth (in em), so an image is upright if the wall's front edge is
///                           at the top
///     cylindrical   like em, but u runs from 0 to 1 once around each contour, like a label around a can. A picture
///                   whose left and right sides match has no visible seam on any letter
///
/// Each mapping is a small type below, a wall_mapping. It places the walls' seams when they are planned, and computes
/// u, v and tangent when they are written. A new mapping needs such a type, its name here and in texture_mappings, and
/// a line in with_mapping().
enum class texture_mapping : std::uint8_t { box, em, cylindrical };

/// All texture mappings.
inline constexpr texture_mapping texture_mappings[] = {texture_mapping::box, texture_mapping::em,
                                                       texture_mapping::cylindrical};

/// Texture coordinates of points by their position in the plane.
///
/// The upper edge of a box has v = 1 exactly, or 0 if v is flipped: the product is rounded to 32 bits before v is
/// flipped.
class planar_texture {
public:
    planar_texture(texture_mapping mapping, const placement& at) noexcept
        : pen_{mapping == texture_mapping::box ? at.texture_pen : at.em_pen},
          per_cell_{mapping == texture_mapping::box ? at.texture_per_cell : point{at.em_per_cell, at.em_per_cell}},
          base_{at.frame.uv == uv_origin::top_left ? 1.0f : 0.0f},
          sign_{at.frame.uv == uv_origin::top_left ? -1.0f : 1.0f}
    {
    }

    [[nodiscard]] vec2 operator()(grid_point p) const noexcept { return (*this)(placement::exact(p)); }

    /// The coordinates of any point, in cells; for a grid point, the result is bit for bit as above.
    [[nodiscard]] vec2 operator()(point p) const noexcept
    {
        return {static_cast<float>((p.x + pen_.x) * per_cell_.x),
                turned(static_cast<float>((p.y + pen_.y) * per_cell_.y))};
    }

    /// Converts a v that grows upwards to the v that is written.
    [[nodiscard]] float turned(float v) const noexcept { return base_ + sign_ * v; }

private:
    point pen_;
    point per_cell_;
    float base_;
    float sign_;
};

/// Texture coordinates of walls, and of parts that replace them, in em mapping: from the distance along the contour, in
/// cells, and the distance down from its front edge, in the unit of an extruder's heights.
class wall_texture {
public:
    explicit wall_texture(const placement& at) noexcept
        : planar_{texture_mapping::em, at},
          per_cell_{static_cast<float>(at.em_per_cell)},
          em_per_depth_{at.em_per_depth}
    {
    }

    [[nodiscard]] vec2 operator()(float along, double down) const noexcept { return {u(along), v(down)}; }
    [[nodiscard]] float u(float along) const noexcept { return along * per_cell_; }
    [[nodiscard]] float v(double down) const noexcept
    {
        return planar_.turned(1.0f - static_cast<float>(down * em_per_depth_));
    }

private:
    planar_texture planar_;
    float per_cell_;
    double em_per_depth_;
};

/// The data of a wall's or bevel's vertex that a mapping needs.
struct wall_place {
    point at;             ///< the point in the plane, in cells
    float along;          ///< side_point::along
    float v;              ///< the v that wall_texture gives
    vec2 outward;         ///< the normal in the plane
    vec3 normal{};        ///< the whole normal, in the text's own axes: only for bevels
    float facing = 1.0f;  ///< 1 on the front's bevel, -1 on the back's
    bool upright = true;  ///< whether the place is on a wall or a riser

    /// This place with another v.
    [[nodiscard]] wall_place with_v(float other) const noexcept
    {
        wall_place p = *this;
        p.v = other;
        return p;
    }
};

// A wall_mapping M:
//
//     M::plan(filled, sides)     places the seams of contours when a glyph is planned: changes `along`, `seam` and
//                                `doubled` of all side_points of a region (with normals, without lengths), and
//                                returns the number of doubled points. measure_sides() does it for lengths.
//     M::after_seam(along)       `along` of the wall after a seam, from `along` of the wall before it
//     M::max_apart(em)           the largest difference in `along` between corners of a bevel that share a vertex;
//                                negative: unlimited. em: in cells
//     M{at}.uv(place)            when written
//     M{at}.tangent(axes, place)

namespace detail {

/// Measures lengths along each contour, from its first doubled point. If it has none, its first point becomes doubled.
/// Returns the number of doubled points after that.
inline std::uint32_t measure_sides(const region& filled, array_view<side_point> all) noexcept
{
    const grid_point* points = filled.points().data();
    side_point* sides = all.data();
    std::uint32_t doubled = 0;
    for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop) {
        const std::uint32_t first = filled.starts()[loop], last = filled.starts()[loop + 1] - 1;
        std::uint32_t seam = first;
        while (seam < last && !sides[seam].doubled) ++seam;
        if (!sides[seam].doubled) seam = first;
        sides[seam].doubled = sides[seam].seam = true;
        double along = 0.0;
        const auto add_lengths = [&](std::uint32_t from, std::uint32_t to) noexcept {
            for (std::uint32_t i = from; i < to; ++i) {
                const grid_point a = points[i], b = points[i + 1];  // below 2^28: the differences fit, and integers are
                                                                    // cheaper
                along += length(point{static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y)});
                sides[i + 1].along = static_cast<float>(along);
                doubled += sides[i + 1].doubled;
            }
        };
        add_lengths(seam, last);
        along += length(delta(points[last], points[first]));
        sides[first].along = static_cast<float>(along);
        doubled += sides[first].doubled;
        add_lengths(first, seam);
    }
    return doubled;
}

}  // namespace detail

/// The wall_mapping of texture_mapping::box.
class box_mapping {
public:
    [[nodiscard]] static std::uint32_t plan(const region&, array_view<const side_point> sides) noexcept
    {
        std::uint32_t doubled = 0;
        for (const side_point& s : sides) doubled += s.doubled;
        return doubled;
    }
    [[nodiscard]] static float after_seam(float along) noexcept { return along; }
    [[nodiscard]] static constexpr double max_apart(double) noexcept { return -1.0; }

    explicit box_mapping(const placement& at) noexcept : planar_{texture_mapping::box, at}, tangents_{at.frame} {}

    [[nodiscard]] vec2 uv(const wall_place& p) const noexcept { return planar_(p.at); }
    template <class Axes>
    [[nodiscard]] vec4 tangent(const Axes& axes, const wall_place& p) const noexcept
    {
        return p.upright ? tangents_.on_wall(axes, p.outward) : tangents_.on_rim(axes, p.normal, p.facing);
    }

private:
    planar_texture planar_;
    texture_tangent tangents_;
};

/// The wall_mapping of texture_mapping::em.
class em_mapping {
public:
    [[nodiscard]] static std::uint32_t plan(const region& filled, array_view<side_point> sides) noexcept
    {
        return detail::measure_sides(filled, sides);
    }
    [[nodiscard]] static float after_seam(float) noexcept { return 0.0f; }
    [[nodiscard]] static constexpr double max_apart(double em) noexcept { return em / 1024.0; }

    explicit em_mapping(const placement& at) noexcept : tangents_{at.frame}, walls_{at} {}

    [[nodiscard]] vec2 uv(const wall_place& p) const noexcept { return {walls_.u(p.along), p.v}; }
    template <class Axes>
    [[nodiscard]] vec4 tangent(const Axes& axes, const wall_place& p) const noexcept
    {
        return tangents_.on_wall(axes, p.outward);
    }

private:
    texture_tangent tangents_;
    wall_texture walls_;
};

/// The wall_mapping of texture_mapping::cylindrical.
class cylindrical_mapping {
public:
    [[nodiscard]] static std::uint32_t plan(const region& filled, array_view<side_point> sides) noexcept
    {
        const std::uint32_t doubled = detail::measure_sides(filled, sides);
        for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop) {
            const auto own = sides.subspan(filled.starts()[loop], filled.starts()[loop + 1] - filled.starts()[loop]);
            float whole = 0.0f;
            for (const side_point& s : own) whole = s.along > whole ? s.along : whole;
            for (side_point& s : own) s.along = s.along < whole ? s.along / whole : 1.0f;  // 1 with -ffast-math too
        }
        return doubled;
    }
    [[nodiscard]] static float after_seam(float) noexcept { return 0.0f; }
    [[nodiscard]] static constexpr double max_apart(double) noexcept { return 0x1p-10; }

    explicit cylindrical_mapping(const placement& at) noexcept : tangents_{at.frame} {}

    [[nodiscard]] vec2 uv(const wall_place& p) const noexcept { return {p.along, p.v}; }
    template <class Axes>
    [[nodiscard]] vec4 tangent(const Axes& axes, const wall_place& p) const noexcept
    {
        return tangents_.on_wall(axes, p.outward);
    }

private:
    texture_tangent tangents_;
};

/// Calls `what`, a lambda with a type parameter, with the type of a mapping: once per part, so that no loop over
/// vertices has to branch.
template <class What>
#if defined(__GNUC__)
[[gnu::always_inline]]  // otherwise a whole placement is stored for each letter and part: 2 % of a warm short text
#endif
inline decltype(auto)
with_mapping(texture_mapping mapping, What&& what) noexcept
{
    switch (mapping) {
    case texture_mapping::box: return what.template operator()<box_mapping>();
    case texture_mapping::cylindrical: return what.template operator()<cylindrical_mapping>();
    case texture_mapping::em: break;
    }
    return what.template operator()<em_mapping>();
}

}  // namespace typemesh::inline TYPEMESH_ABI
