// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/side_point.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The light of the faces that edges sweep, in the plane, and their texture: the values at a wall's two ends, carried
/// inwards.
///
///      a(t)______b(t)     At distance t, the face of an edge reaches from a(t) to b(t), the paths of its own corners.
///         /      \        Between them, normal and `along` change linearly from a's values to b's. Beyond them, where
///        /        \       neighbours have vanished and others have come, the values are constant.
///     __a__________b__
///
/// A join's face begins as a point. Its first normal is the normal of the wall before it, or the mean with the join
/// before it; its last normal likewise for the next. So a corner with several joins is shaded round. A normal more than
/// 45 degrees from the join's own normal is replaced by the own one. `along` is the corner's.
class bevel_light {
public:
    struct lit {
        point outward;  ///< unit vector in the plane, out of the edge
        double along;   ///< side_point::along
        point face;     ///< the outward unit vector of the flat face that the edge sweeps
    };

    /// `after_seam` belongs to the texture's mapping.
    explicit bevel_light(float (*after_seam)(float along) noexcept) noexcept : after_seam_{after_seam} {}

    /// One face for each edge and then for each join of `swept`, taken from `scratch`; false if out of memory.
    [[nodiscard]] bool prepare(const region& filled, array_view<const side_point> sides, const swept_region& swept,
                               workspace::scope& scratch) noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        const auto joins = static_cast<std::uint32_t>(swept.joins.size());
        faces_ = scratch.take<face>(std::size_t{n} + joins);
        if (faces_ == nullptr) return false;
        for (std::uint32_t k = 0; k < filled.loop_count(); ++k)
            for (std::uint32_t i = filled.starts()[k], end = filled.starts()[k + 1]; i < end; ++i)
                add_edge(filled, sides, i, i + 1 == end ? filled.starts()[k] : i + 1);
        for (std::uint32_t j = 0; j < joins; ++j) add_join(filled, sides, swept.joins[j], n + j);
        turn_corners(filled, swept, n);
        return true;
    }

    /// Reverses `along`, and makes normals point into the region: for the surroundings of another region.
    void turn_round(const region& filled, array_view<const side_point> sides, const swept_region& swept) noexcept
    {
        const auto n = static_cast<std::uint32_t>(filled.points().size());
        std::uint32_t join = 0;
        for (std::uint32_t k = 0; k < filled.loop_count(); ++k) {
            const std::uint32_t begin = filled.starts()[k], end = filled.starts()[k + 1];
            double whole = 0.0;
            for (std::uint32_t i = begin; i < end; ++i) whole = std::fmax(whole, as_double(sides[i].along));
            for (std::uint32_t i = begin; i < end; ++i) faces_[i].turn_round(whole);
            for (; join < swept.joins.size() && swept.joins[join].point < end; ++join)
                faces_[n + join].turn_round(whole);
        }
    }

    /// Whether some normal is more than 45 degrees from its flat face: the curve of one chord turns a lot there.
    [[nodiscard]] bool strays() const noexcept { return strays_; }

    /// The light at a node of that edge's face.
    [[nodiscard]] lit at(std::uint32_t edge, const swept_node& node) const noexcept
    {
        const face& f = faces_[edge];
        const double t = as_double(node.distance);
        const double from = f.start_speed * t, length = f.length + (f.end_speed - f.start_speed) * t;
        const double x = (static_cast<double>(node.at.x) - f.start.x) * f.direction.x +
                         (static_cast<double>(node.at.y) - f.start.y) * f.direction.y;
        double s = length > 0.0 ? (x - from) / length : 0.5;
        if (t <= 0.0 && f.length > 0.0) s = 2.0 * x > f.length ? 1.0 : 0.0;
        s = s > 0.0 ? s < 1.0 ? s : 1.0 : 0.0;
        return {unit((1.0 - s) * f.start_normal + s * f.end_normal), f.start_along + s * (f.end_along - f.start_along),
                f.own};
    }

private:
    struct face {
        point start, direction;  // the unit direction of the edge, interior on the left
        double length;           // at distance 0,
        double start_speed;      // and the speed of its ends along the direction
        double end_speed;
        point start_normal, end_normal;
        double start_along, end_along;
        point own;  // of the flat face

        void turn_round(double whole) noexcept
        {
            own = -1.0 * own;
            start_normal = -1.0 * start_normal;
            end_normal = -1.0 * end_normal;
            start_along = whole - start_along;
            end_along = whole - end_along;
        }
    };

    void add_edge(const region& filled, array_view<const side_point> sides, std::uint32_t i,
                  std::uint32_t next) noexcept
    {
        const point along = delta(filled.points()[i], filled.points()[next]);
        const side_point &a = sides[i], &b = sides[next];
        faces_[i] = {placed(filled.points()[i]),
                     unit(along),
                     length(along),
                     0.0,
                     0.0,
                     wide(a.after),
                     wide(b.before),
                     as_double(a.seam ? after_seam_(a.along) : a.along),
                     as_double(b.along),
                     outward(unit(along))};
        strays_ =
            strays_ || !is_near(faces_[i].own, faces_[i].start_normal) || !is_near(faces_[i].own, faces_[i].end_normal);
    }

    /// Whether two unit vectors are less than 45 degrees apart.
    static bool is_near(point a, point b) noexcept { return dot(a, b) > 0.7072; }

    void add_join(const region& filled, array_view<const side_point> sides, const swept_join& j,
                  std::uint32_t to) noexcept
    {
        const point inward = unit(wide(j.inward)), out = -1.0 * inward;
        const double along = as_double(sides[j.point].along);
        faces_[to] = {
            placed(filled.points()[j.point]), {inward.y, -inward.x}, 0.0, 0.0, 0.0, out, out, along, along, out};
    }

    /// Turns every corner from its previous edge to its next edge, through its joins, which are sorted by their points.
    void turn_corners(const region& filled, const swept_region& swept, std::uint32_t n) noexcept
    {
        const auto joins = static_cast<std::uint32_t>(swept.joins.size());
        std::uint32_t join = 0;
        for (std::uint32_t k = 0; k < filled.loop_count(); ++k) {
            std::uint32_t before = filled.starts()[k + 1] - 1;
            for (std::uint32_t i = filled.starts()[k]; i < filled.starts()[k + 1]; before = i++) {
                for (; join < joins && swept.joins[join].point == i; before = n + join++) turn(before, n + join, n);
                turn(before, i, n);
            }
        }
    }

    /// Sets the speed of the corner between two faces, and the normals of joins there; edges keep their normals.
    void turn(std::uint32_t before, std::uint32_t after, std::uint32_t n) noexcept
    {
        face &f = faces_[before], &g = faces_[after];
        set_speeds(f, g);
        const bool joins_f = before >= n, joins_g = after >= n;
        if (!joins_f && !joins_g) return;
        const point own_f = outward(f.direction), own_g = outward(g.direction);
        const point shared = !joins_f ? f.end_normal : !joins_g ? g.start_normal : own_f + own_g;
        if (joins_f) f.end_normal = turned(own_f, shared);
        if (joins_g) g.start_normal = turned(own_g, shared);
    }

    /// A join's normal at one end: the shared one, or its own if the two differ by more than 45 degrees.
    static point turned(point own, point shared) noexcept
    {
        return dot(own, shared) >= std::fabs(cross(own, shared)) && dot(shared, shared) > 0.0 ? unit(shared) : own;
    }

    /// The speed of the corner between two edges along each of them; the corner has the same distance from both.
    static void set_speeds(face& f, face& g) noexcept
    {
        const double cosine = dot(f.direction, g.direction);
        const double half = cross(f.direction, g.direction) / (1.0 + cosine + 0x1p-40);  // the tangent of half the turn
        f.end_speed = -half;
        g.start_speed = half;
    }

    static point placed(grid_point p) noexcept { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }
    static point wide(vec2 v) noexcept { return {as_double(v.x), as_double(v.y)}; }

    float (*after_seam_)(float along) noexcept;
    face* faces_ = nullptr;
    bool strays_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
