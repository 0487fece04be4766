// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_shapes.hpp"

#include "support/refined_shape.hpp"

#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/refine/quadtree_refined.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Region -> its triangles with points added, by both refiners.
namespace fuzz {

namespace refinement_laws {

using namespace typemesh;

/// Whether all corners of the refined outline are at least so wide, in degrees.
inline bool is_blunt(const region& r, double degrees)
{
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop)
        for (std::uint32_t first = r.starts()[loop], end = r.starts()[loop + 1], i = first; i < end; ++i) {
            const grid_point at = r.points()[i], p = r.points()[i + 1 < end ? i + 1 : first],
                             q = r.points()[i > first ? i - 1 : end - 1];
            const double sine = static_cast<double>(orientation(at, p, q)),
                         cosine =
                             (double(p.x) - at.x) * (double(q.x) - at.x) + (double(p.y) - at.y) * (double(q.y) - at.y);
            if (sine >= 0.0 && std::atan2(sine, cosine) < degrees * 0.017453292519943295) return false;
        }
    return true;
}

/// Valid, Delaunay, not above the limit, and no edge is too long unless it is reported.
template <class Refiner>
broken_law of_refined(const drawn_shape& from, const Refiner& how)
{
    typename Refiner::scratch space;
    test::refined_result cap;
    if (const error e = how(from.made, from.caps.triangles().view(), space, cap.out()))
        return unless_one_of(e, {error::bad_option, error::too_many_points});
    const std::vector<grid_point> points = cap.points();
    if (points.size() > (std::max)(std::size_t{how.max_points}, from.made.points().size()))
        return "more points than the limit";
    if (broken_law broken = test::broken_refinement(from.made, cap); !broken.empty()) return broken;
    if (!test::is_delaunay(cap)) return "an edge is not Delaunay";
    if (cap.kept != 0) return {};
    const double longest = double(how.max_edge) * from.em;
    for (const auto& [edge, apex] : test::edges_of(cap))
        if (how.max_edge > 0.0f &&
            std::sqrt(static_cast<double>(squared_distance(points[edge.first], points[edge.second]))) > longest)
            return "an edge is too long";
    if constexpr (requires { how.min_angle; }) {
        if (is_blunt(cap.boundary(from.made), 61.0) && test::corners_below(cap, double(how.min_angle) - 1e-4) != 0)
            return "an angle is too small";
    }
    return {};
}

}  // namespace refinement_laws

inline broken_law refinements(values in)
{
    using namespace typemesh;
    static constexpr float edges[] = {0.0f, 0.05f, 0.5f, 0.02f, 0.005f, 2.0f, 0.1f, 1e-4f},
                           angles[] = {0.0f, 20.0f, 25.0f, 30.0f, 33.0f};
    static constexpr std::uint32_t limits[] = {3000, 500, 30, 1500};
    const std::uint32_t bits = in.byte();
    const float edge = in.one_of(edges) * float(in.between(0.75, 1.5)), angle = in.one_of(angles);
    const std::uint32_t limit = in.one_of(limits);
    drawn_shape from;
    if (broken_law broken = from.read(in); !broken.empty()) return broken;
    if (from.made.points().empty()) return {};
    if ((bits & 1) != 0)
        return refinement_laws::of_refined(from, quadtree_refined{.max_edge = edge, .max_points = limit});
    return refinement_laws::of_refined(from,
                                       delaunay_refined{.min_angle = angle, .max_edge = edge, .max_points = limit});
}

}  // namespace fuzz
