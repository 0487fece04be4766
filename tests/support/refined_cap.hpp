// SPDX-License-Identifier: MIT
#pragma once

// A cap that a refiner has refined, and the laws of every refined cap.

#include "support/regions.hpp"

#include <typemesh/inspect/boundary_check.hpp>
#include <typemesh/inspect/delaunay_check.hpp>
#include <typemesh/inspect/simplicity.hpp>
#include <typemesh/refine/impl/stretched_circle.hpp>
#include <typemesh/refine/refiner.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// A refined cap in memory of its own.
struct refined_result {
    typemesh::contours loops;
    typemesh::buffer<typemesh::grid_point> inner;
    typemesh::triangle_list triangles;
    std::uint32_t kept = 0;

    explicit refined_result(typemesh::memory source = typemesh::heap())
        : loops{source}, inner{source}, triangles{source}
    {
    }
    [[nodiscard]] typemesh::refined_cap out() { return {loops, inner, triangles, kept}; }

    /// The points that the triangles refer to.
    [[nodiscard]] std::vector<typemesh::grid_point> points() const
    {
        std::vector<typemesh::grid_point> all(loops.points.begin(), loops.points.end());
        all.insert(all.end(), inner.begin(), inner.end());
        return all;
    }
    [[nodiscard]] typemesh::region boundary(const typemesh::region& of) const
    {
        return typemesh::region::proven(loops, of.holes(), of.outers(), of.is_touching());
    }
};

/// The edges of a cap: from, to -> the corner opposite. Of equal edges, there is only one.
class cap_edges {
public:
    using ends = std::pair<std::uint32_t, std::uint32_t>;
    using entry = std::pair<ends, std::uint32_t>;

    explicit cap_edges(const typemesh::triangle_list& triangles)
    {
        all_.reserve(3 * triangles.size());
        for (const typemesh::triangle t : triangles) {
            all_.push_back({{t.a, t.b}, t.c});
            all_.push_back({{t.b, t.c}, t.a});
            all_.push_back({{t.c, t.a}, t.b});
        }
        std::sort(all_.begin(), all_.end());
        all_.erase(
            std::unique(all_.begin(), all_.end(), [](const entry& a, const entry& b) { return a.first == b.first; }),
            all_.end());
    }
    [[nodiscard]] auto begin() const { return all_.begin(); }
    [[nodiscard]] auto end() const { return all_.end(); }
    [[nodiscard]] std::size_t size() const { return all_.size(); }
    [[nodiscard]] std::vector<entry>::const_iterator find(ends edge) const
    {
        const auto found =
            std::lower_bound(begin(), end(), edge, [](const entry& a, const ends& wanted) { return a.first < wanted; });
        return found != end() && found->first == edge ? found : end();
    }
    [[nodiscard]] std::size_t count(ends edge) const { return find(edge) == end() ? 0u : 1u; }

private:
    std::vector<entry> all_;
};

inline cap_edges edges_of(const refined_result& cap) { return cap_edges{cap.triangles}; }

/// The first law that a refined cap of a region breaks; "" if it breaks none. Exact.
inline std::string broken_refinement(const typemesh::region& before, const refined_result& cap)
{
    using namespace typemesh;
    const region after = cap.boundary(before);
    const std::vector<grid_point> points = cap.points();
    if (after.loop_count() != before.loop_count()) return "a loop is lost";
    // The region's own points remain, in their order.
    for (std::uint32_t loop = 0; loop < before.loop_count(); ++loop) {
        std::uint32_t next = before.starts()[loop];
        for (std::uint32_t i = after.starts()[loop]; i < after.starts()[loop + 1]; ++i)
            if (next < before.starts()[loop + 1] && after.points()[i] == before.points()[next]) ++next;
        if (next != before.starts()[loop + 1]) return "a point of the region is lost";
    }
    if (const std::string why = inspect::check_boundary(inspect::loops_of(after)).broken(); !why.empty()) return why;
    if (cap.triangles.size() != after.triangle_count() + 2 * cap.inner.size()) return "the number of triangles";

    std::int64_t area = 0;
    for (const triangle t : cap.triangles) {
        if (t.a >= points.size() || t.b >= points.size() || t.c >= points.size()) return "a corner is no point";
        const std::int64_t doubled = orientation(points[t.a], points[t.b], points[t.c]);
        if (doubled <= 0) return "a triangle is not counter-clockwise";
        area += doubled;
    }
    std::int64_t around = 0;
    for (const auto& loop : inspect::loops_of(after)) around += inspect::doubled_area(loop);
    if (area != around) return "the area is not the boundary's";

    const cap_edges edges = edges_of(cap);
    if (edges.size() != 3 * cap.triangles.size()) return "a directed edge occurs twice";
    std::size_t open = 0;
    for (const auto& [edge, apex] : edges) open += edges.count({edge.second, edge.first}) == 0;
    if (open != after.points().size()) return "an inner edge is open";
    for (std::uint32_t loop = 0; loop < after.loop_count(); ++loop)
        for (std::uint32_t i = after.starts()[loop], end = after.starts()[loop + 1]; i < end; ++i)
            if (edges.count({i, i + 1 < end ? i + 1 : after.starts()[loop]}) == 0) return "a boundary edge is lost";
    return {};
}

/// Whether every inner edge is Delaunay: the corner beyond it does not lie in the circle around its triangle.
inline bool is_delaunay(const refined_result& cap)
{
    const std::vector<typemesh::grid_point> p = cap.points();
    const cap_edges edges = edges_of(cap);
    for (const auto& [edge, apex] : edges) {
        const auto other = edges.find({edge.second, edge.first});
        if (other != edges.end() &&
            typemesh::inspect::circle_side(p[edge.first], p[edge.second], p[apex], p[other->second]) > 0)
            return false;
    }
    return true;
}

/// Whether every inner edge is Delaunay for ellipses that are stretched without limit, as far as double precision tells:
/// the square of one coordinate alone lifts the points.
inline bool is_delaunay(const refined_result& cap, typemesh::detail::extents compared)
{
    using typemesh::detail::extents;
    if (compared == extents::both) return is_delaunay(cap);
    const std::vector<typemesh::grid_point> p = cap.points();
    const cap_edges edges = edges_of(cap);
    for (const auto& [edge, apex] : edges) {
        const auto other = edges.find({edge.second, edge.first});
        if (other == edges.end()) continue;
        const typemesh::grid_point at = p[other->second];
        double x[3], y[3], lifted[3], sum = 0.0, size = 0.0;
        int k = 0;
        for (const std::uint32_t i : {edge.first, edge.second, apex}) {
            x[k] = double(p[i].x) - at.x;
            y[k] = double(p[i].y) - at.y;
            lifted[k] = compared == extents::widths ? x[k] * x[k] : y[k] * y[k];
            ++k;
        }
        for (k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            sum += lifted[k] * (x[l] * y[m] - x[m] * y[l]);
            size += lifted[k] * (std::fabs(x[l] * y[m]) + std::fabs(x[m] * y[l]));
        }
        if (sum > 1e-14 * size) return false;
    }
    return true;
}

/// The number of corners with an angle below `degrees`.
inline std::size_t corners_below(const refined_result& cap, double degrees)
{
    const std::vector<typemesh::grid_point> p = cap.points();
    std::size_t count = 0;
    for (const auto& [edge, apex] : edges_of(cap)) {
        const typemesh::grid_point at = p[apex], a = p[edge.first], b = p[edge.second];
        const double ax = double(a.x) - at.x, ay = double(a.y) - at.y, bx = double(b.x) - at.x, by = double(b.y) - at.y;
        count += std::atan2(ax * by - ay * bx, ax * bx + ay * by) < (degrees - 1e-9) * (turn_once / 360.0);
    }
    return count;
}

/// What is the largest angle of a cap.
struct wide_corners {
    std::size_t above = 0;    ///< corners above 90 degrees by more than moving each coordinate of both edges by 3/2
    std::size_t crowded = 0;  ///< of these, corners of triangles that are lower than 8 cells
    std::vector<std::pair<typemesh::grid_point, cap_edges::ends>> others;  ///< the rest of these, and the edge opposite
    std::size_t rounded = 0;                                               ///< the other corners above 90 degrees
    double greatest = 0.0;                                                 ///< in degrees
};
inline wide_corners wide_corners_of(const refined_result& cap)
{
    const std::vector<typemesh::grid_point> points = cap.points();
    wide_corners all;
    for (const auto& [edge, apex] : edges_of(cap)) {
        const typemesh::grid_point at = points[apex], a = points[edge.first], b = points[edge.second];
        const std::int64_t px = std::int64_t{a.x} - at.x, py = std::int64_t{a.y} - at.y, qx = std::int64_t{b.x} - at.x,
                           qy = std::int64_t{b.y} - at.y, product = px * qx + py * qy;
        const std::int64_t around = std::abs(px) + std::abs(py) + std::abs(qx) + std::abs(qy);
        const bool is_above = 2 * product < -3 * around - 9;
        (is_above ? all.above : all.rounded) += product < 0;
        const bool is_low = double(px * qy - py * qx) < 8.0 * std::sqrt(double(squared_distance(a, b)));
        if (is_above && is_low) ++all.crowded;
        if (is_above && !is_low) all.others.emplace_back(at, edge);
        all.greatest = (std::max)(all.greatest, std::atan2(double(px * qy - py * qx), double(product)));
    }
    all.greatest *= 360.0 / turn_once;
    return all;
}

}  // namespace test
