// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/refine/impl/off_centre.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Adds rings of inner points along the boundary of a mesh, at the distances where a round stroke has risen by 22.5,
/// 45, 67.5 and 90 degrees; a point on each edge that crosses from boundary to boundary, where the mesh would stay
/// flat; and points where edges inside are still too long.
///
///      height  |            _ - o - _            a stroke whose height's square is 2 r d - d^2 at distance d has
///              |        o             o          risen by the angle p at d = r (1 - cos p)
///              |     o                   o
///              |   o                       o     r is half the width of a straight stroke: the slope of the membrane
///              +---o-----------------------o     at its boundary
///                d
///
/// Between rings an angle of p apart, triangles are as far as r (1 - cos(p / 2)) below the round section. On thick
/// strokes, where steps of 22.5 degrees would leave more than `longest` / 24, steps are 11.25 degrees. On thin ones,
/// where the top is flatter than that without it, the ring at 90 degrees is left out.
///
/// A ring ends where it would be farther from the one before than the mesh's own points, and a point is not added if it
/// would come too near to another or to the boundary. All points keep the mesh Delaunay.
class rim_rings {
public:
    static constexpr std::uint32_t none = refinable_mesh::none;

    /// Adds a point on or beside each inner edge between two points of the boundary: front and back would share such an
    /// edge. Edges stay where the grid has no place for a point in the two triangles. False if out of memory.
    [[nodiscard]] static bool divide_crossings(refinable_mesh& mesh) noexcept
    {
        for (std::uint32_t before = none; mesh.vertex_count() != before;) {  // insertions exchange half-edges
            before = mesh.vertex_count();
            for (std::uint32_t h = 0; h < mesh.end(); h = h % 4 == 2 ? h + 2 : h + 1)
                if (is_crossing(mesh, h) && !divide(mesh, h)) return false;
        }
        return true;
    }

    /// Adds the rings of all boundary points. `rise` is the slope of the membrane at each point of the mesh that lies
    /// on the boundary, and `longest` the length of the longest edge, in cells. False if out of memory.
    [[nodiscard]] static bool add_rings(refinable_mesh& mesh, const double* rise, double longest) noexcept
    {
        const std::uint32_t count = mesh.vertex_count();
        const double least = longest / flatness;
        for (std::size_t ring = 0; ring < distances.size(); ++ring)
            for (std::uint32_t v = 0; v < count; ++v) {
                if (mesh.at(v).boundary == none) continue;
                const double r = rise[v];
                const std::size_t step = distances[0] * r > least ? 1 : 2;
                if (ring % step != step - 1) continue;
                if (ring + 1 == distances.size() && distances[1] * r <= least) continue;
                const double gap = distances[ring] - (ring < step ? 0.0 : distances[ring - step]);
                if (gap * r > max_gap * longest) continue;
                if (!add_at(mesh, v, distances[ring] * r, gap * r)) return false;
                if (ring == step - 1 && !lower(mesh, v, rise, distances[ring])) return false;
            }
        return true;
    }

    /// Adds points until no inner edge is longer than so many cells: the centre of the circle around a triangle that
    /// has such an edge, or the middle of the edge where the centre lies near the boundary or beyond it. Edges stay
    /// where the grid has no place. It ends early if the mesh has more than max_points. False if out of memory.
    [[nodiscard]] static bool divide_long(refinable_mesh& mesh, double longest, std::uint32_t max_points) noexcept
    {
        for (std::uint32_t before = none; mesh.vertex_count() != before;) {
            before = mesh.vertex_count();
            for (std::uint32_t t = 0; t < mesh.triangle_count() && mesh.vertex_count() <= max_points; ++t) {
                const std::uint32_t h = long_edge(mesh, t, longest * longest);
                if (h == none) continue;
                const auto [inside, p] = centre_of(mesh, t, nearest_centre * longest);
                if (inside != none ? mesh.insert(inside, p) == none : !divide(mesh, h)) return false;
            }
        }
        return true;
    }

    /// Adds a point inside each triangle whose three edges lie on the boundary: such a speck would have no height. It
    /// stays as it is where the grid has no place inside. False if out of memory.
    [[nodiscard]] static bool raise_specks(refinable_mesh& mesh) noexcept
    {
        for (std::uint32_t t = 0, count = mesh.triangle_count(); t < count; ++t)
            if (mesh.is_boundary(4 * t) && mesh.is_boundary(4 * t + 1) && mesh.is_boundary(4 * t + 2) &&
                !add_inside(mesh, t))
                return false;
        return true;
    }

private:
    // Shares of the longest edge.
    static constexpr double flatness = 24.0;        // triangles may be this part of it below the round section
    static constexpr double max_gap = 0.75;         // between rings; farther apart, the mesh's own points are enough
    static constexpr double nearest_centre = 0.25;  // from the boundary to a centre that becomes a point

    /// Points of rings keep this share of the gap between two rings from other points and from the boundary. Gaps below
    /// `least_gap` cells have no room for a ring.
    static constexpr double spacing = 0.5, least_gap = 8.0;

    /// The cosines of the angles in which the outline turns at a corner. Up to the first, 60 degrees, one point on the
    /// bisector serves both edges. Beyond the second, 154, the sum of both directions is too short to be a bisector.
    static constexpr double bisected = 0.5, reversed = -0.9;

    /// A triangle at the outline that is this many times as high as the first ring gets a point over its edge.
    static constexpr double max_rise = 2.0;

    /// 1 - cos of 11.25 degrees and its multiples.
    static constexpr std::array distances = {
        0.0192147195967696, 0.0761204674887133, 0.1685303876974548, 0.2928932188134524,
        0.4444297669803978, 0.6173165676349102, 0.8049096779838718, 1.0};

    /// A cell and the eight cells around it, the nearest ones first.
    static constexpr std::array<grid_point, 9> near_places = {
        {{0, 0}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

    [[nodiscard]] static bool is_crossing(const refinable_mesh& mesh, std::uint32_t h) noexcept
    {
        return !mesh.is_boundary(h) && mesh.at(mesh.origin(h)).boundary != none &&
               mesh.at(mesh.target(h)).boundary != none;
    }

    /// A point and the triangle that it lies in, or none.
    struct place_inside {
        std::uint32_t triangle = none;
        grid_point place = {};
    };

    /// An inner edge of a triangle whose square is greater than that, or none.
    [[nodiscard]] static std::uint32_t long_edge(const refinable_mesh& mesh, std::uint32_t t, double square) noexcept
    {
        const grid_point p[] = {mesh.start(4 * t), mesh.start(4 * t + 1), mesh.start(4 * t + 2)};
        for (std::uint32_t k = 0; k < 3; ++k)
            if (static_cast<double>(squared_distance(p[k], p[k == 2 ? 0 : k + 1])) > square &&
                !mesh.is_boundary(4 * t + k))
                return 4 * t + k;
        return none;
    }

    /// The centre of the circle around a triangle, unless it lies beyond the boundary or so near to it.
    [[nodiscard]] static place_inside centre_of(const refinable_mesh& mesh, std::uint32_t t, double nearest) noexcept
    {
        const grid_point p = off_centre(mesh.start(4 * t), mesh.start(4 * t + 1), mesh.start(4 * t + 2), grid::reach);
        t = mesh.locate(t, p).triangle;
        if (t == none) return {};
        for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h)
            if (mesh.is_boundary(h) && distance_to(mesh, h, p) < nearest * nearest) return {};
        return {t, p};
    }

    /// Adds a point in the middle of an inner edge, or in a cell next to that. False if out of memory.
    [[nodiscard]] static bool divide(refinable_mesh& mesh, std::uint32_t h) noexcept
    {
        const grid_point a = mesh.start(h), b = mesh.place(mesh.target(h));
        const grid_point middle{a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2};
        for (const auto& [x, y] : near_places) {
            const grid_point p{middle.x + x, middle.y + y};
            for (const std::uint32_t t : {h / 4, mesh.twin(h) / 4})
                if (is_inside(mesh, t, h, p)) return mesh.insert(t, p) != none;
        }
        return true;
    }

    /// Adds a point in the middle of a triangle, or in a cell next to that. False if out of memory.
    [[nodiscard]] static bool add_inside(refinable_mesh& mesh, std::uint32_t t) noexcept
    {
        const grid_point a = mesh.start(4 * t), b = mesh.start(4 * t + 1), c = mesh.start(4 * t + 2);
        const auto middle_of = [](std::int32_t p, std::int32_t q, std::int32_t r) noexcept {
            return static_cast<std::int32_t>((std::int64_t{p} + q + r) / 3);
        };
        const grid_point middle{middle_of(a.x, b.x, c.x), middle_of(a.y, b.y, c.y)};
        for (const auto& [x, y] : near_places) {
            const grid_point p{middle.x + x, middle.y + y};
            if (is_inside(mesh, t, mesh.end(), p)) return mesh.insert(t, p) != none;
        }
        return true;
    }

    /// Whether a point lies strictly inside a triangle, or on its inner edge h or the edge's twin.
    [[nodiscard]] static bool is_inside(const refinable_mesh& mesh, std::uint32_t t, std::uint32_t h,
                                        grid_point p) noexcept
    {
        for (std::uint32_t e = 4 * t; e < 4 * t + 3; ++e) {
            const std::int64_t side = orientation(mesh.start(e), mesh.place(mesh.target(e)), p);
            if (side < 0 || (side == 0 && e != h && mesh.twin(e) != h)) return false;
        }
        return true;
    }

    /// Adds a point at a distance from a boundary point; at reflex corners three, which go around it.
    [[nodiscard]] static bool add_at(refinable_mesh& mesh, std::uint32_t v, double distance, double gap) noexcept
    {
        const std::uint32_t next = mesh.next_on_boundary(v), before = mesh.previous_on_boundary(v);
        const grid_point at = mesh.place(v);
        const point in = inward(mesh.place(before), at), out = inward(at, mesh.place(next));
        const double cosine = dot(in, out), turn = cross(in, out);
        if (cosine > bisected) return add(mesh, v, (1.0 / length(in + out)) * (in + out), distance, gap);
        if (turn > 0.0) return true;  // a convex corner: the rings of its neighbours meet there
        const bool turns_back = cosine <= reversed;
        const point middle = turns_back ? point{in.y - out.y, out.x - in.x} : in + out;
        return add(mesh, v, (1.0 / length(middle)) * middle, distance, gap) && add(mesh, v, in, distance, gap) &&
               add(mesh, v, out, distance, gap);
    }

    /// Adds a point of the first ring over the middle of an edge whose triangle rises much higher.
    [[nodiscard]] static bool lower(refinable_mesh& mesh, std::uint32_t v, const double* rise, double distance) noexcept
    {
        const std::uint32_t h = mesh.at(v).boundary, b = mesh.target(h);
        const grid_point p = mesh.place(v), q = mesh.place(b), c = mesh.place(mesh.apex(h));
        const double along = length(point{static_cast<double>(q.x) - p.x, static_cast<double>(q.y) - p.y}),
                     height = static_cast<double>(orientation(p, q, c)) / along;
        const double wanted = distance * 0.5 * (rise[v] + rise[b]);
        if (height < max_rise * wanted) return true;
        const point up = inward(p, q);
        const grid_point middle{p.x + (q.x - p.x) / 2, p.y + (q.y - p.y) / 2};
        return add_from(mesh, h / 4, middle, up, wanted, wanted);
    }

    [[nodiscard]] static bool add(refinable_mesh& mesh, std::uint32_t v, point direction, double distance,
                                  double gap) noexcept
    {
        return add_from(mesh, mesh.at(v).boundary / 4, mesh.place(v), direction, distance, gap);
    }

    /// Adds a point in a direction from a place, unless it is too near to others. t is a triangle at the place.
    [[nodiscard]] static bool add_from(refinable_mesh& mesh, std::uint32_t t, grid_point from, point direction,
                                       double distance, double gap) noexcept
    {
        if (gap < least_gap) return true;
        const grid_point p{from.x + rounded(distance * direction.x), from.y + rounded(distance * direction.y)};
        t = mesh.locate(t, p).triangle;
        if (t == none) return true;
        const double nearest = spacing * spacing * gap * gap;
        for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h) {
            if (distance_to(mesh, h, p) < nearest) return true;
            if (mesh.is_boundary(h)) continue;
            const std::uint32_t g = mesh.twin(h);
            if (static_cast<double>(squared_distance(mesh.place(mesh.apex(g)), p)) < nearest) return true;
        }
        return mesh.insert(t, p) != none;
    }

    /// The square of the distance from an edge's first point, or from the whole edge if it lies on the boundary.
    [[nodiscard]] static double distance_to(const refinable_mesh& mesh, std::uint32_t h, grid_point p) noexcept
    {
        const grid_point a = mesh.start(h), b = mesh.place(mesh.target(h));
        const auto corner = static_cast<double>(squared_distance(a, p));
        if (!mesh.is_boundary(h)) return corner;
        const auto area = static_cast<double>(orientation(a, b, p));
        const double line = area / static_cast<double>(squared_distance(a, b)) * area;
        return line < corner ? line : corner;
    }

    /// The unit vector from a boundary edge into the region.
    [[nodiscard]] static point inward(grid_point a, grid_point b) noexcept
    {
        const point along{static_cast<double>(b.x) - a.x, static_cast<double>(b.y) - a.y};
        const double scale = 1.0 / length(along);
        return {-scale * along.y, scale * along.x};
    }

    [[nodiscard]] static std::int32_t rounded(double v) noexcept
    {
        return static_cast<std::int32_t>(std::floor(v + 0.5));
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
