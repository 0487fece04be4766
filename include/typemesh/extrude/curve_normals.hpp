// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/same.hpp>
#include <typemesh/core/tangent.hpp>
#include <typemesh/extrude/side_normals.hpp>
#include <typemesh/extrude/wall_normal.hpp>

namespace typemesh {

/// 4N + 2H vertices, and 2 for the seam of each contour without a hard point (extruded.hpp): normals
/// exact from the curves that the walls stand for, however coarse the polygon.
///
///     inside a curve     soft: one normal, the curve's own; at a cusp or where the curve turns back, as at a joint
///     at a joint         hard where the two curves' tangents break by more than the crease angle: doubled, each wall
///                        with its own curve's normal. Otherwise soft, with the normalised sum of the two
///     along a line       the line's normal: a wall between two corners is shaded evenly
///
/// A tangent that points against its own edge (the polygon is so coarse that it leaves out the whole hook there), or
/// that does not exist (a curve that is a point), gives way to the edge's direction; a soft normal that would point
/// into one of its two walls gives way to the normalised sum of the walls' own. So normals point out of their walls
/// always.
///
/// Measured on fonts, breaks at joints are below 8 or above 30 degrees, all but 0.74 % of them.
struct curve_normals {
    static constexpr bool shares_caps = false;

    float crease_degrees = 15.0f;  ///< 0 to 180

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {crease_degrees}; }

    error operator()(const region& shape, std::span<side_point> sides) const noexcept
    {
        if (!is_crease_angle(crease_degrees)) return error::bad("crease_degrees");
        const double crease = crease_cosine(crease_degrees);
        const auto points = shape.points();
        const auto edges = shape.edges();
        const auto curves = shape.curves();
        for (std::uint32_t loop = 0; loop < shape.loop_count(); ++loop) {
            const std::uint32_t first = shape.starts()[loop], last = shape.starts()[loop + 1] - 1;
            std::uint32_t previous = last;
            const wall closing = wall_over(curves[edges[last].curve], edges[last], way(points[last], points[first]));
            wall before = closing;
            for (std::uint32_t i = first; i <= last; ++i) {
                const contour_edge edge = edges[i];
                const bool inside =
                    edge.curve == edges[previous].curve && same(edge.t0, edges[previous].t1) && !before.stops_at_end;
                const std::uint32_t next = i == last ? first : i + 1;
                wall after = closing;
                if (i != last) {
                    const point along = way(points[i], points[next]);
                    const bool known = inside && before.exact_end && dot(before.end, outward(along)) > 0.0;
                    after = known ? wall_after(before.end, curves[edge.curve], edge, along)
                                  : wall_over(curves[edge.curve], edge, along);
                }
                if (before.end == after.start) {
                    sides[i].before = sides[i].after = rounded(after.start);
                } else if (!inside && dot(before.end, after.start) < crease) {
                    sides[i].before = rounded(before.end);
                    sides[i].after = rounded(after.start);
                    sides[i].doubled = true;
                } else {
                    sides[i].before = sides[i].after =
                        rounded(soft(points[previous], points[i], points[next], before.end, after.start));
                }
                before = after;
                previous = i;
            }
        }
        return {};
    }

private:
    /// One wall's unit normals where its edge starts and ends.
    struct wall {
        point start;
        point end;
        bool stops_at_end;  ///< the curve stops there, to turn perhaps
        bool exact_end;     ///< `end` is the curve's normal, not the edge's
    };

    static wall wall_over(const curve& c, contour_edge e, point along) noexcept
    {
        const double forth = e.t0 <= e.t1 ? 1.0 : -1.0;
        if (c.degree == 1) {
            const point line = forth * (c.p[1] - c.p[0]);
            const bool exact = dot(line, along) > 0.0;
            const point n = unit(outward(exact ? line : along));
            return {n, n, false, exact};
        }
        const tangents t = tangents_at(c, as_double(e.t0));
        const point start = forth * (forth > 0.0 ? t.after : t.before);
        return wall_after(unit(outward(dot(start, along) > 0.0 ? start : along)), c, e, along);
    }

    /// The same where the normal at the start is known, from the wall before that ends in the same place of the same
    /// curve.
    static wall wall_after(point start, const curve& c, contour_edge e, point along) noexcept
    {
        if (c.degree == 1) return {start, start, false, true};
        const double forth = e.t0 <= e.t1 ? 1.0 : -1.0;
        const tangents t = tangents_at(c, as_double(e.t1));
        const point end = forth * (forth > 0.0 ? t.before : t.after);
        const bool exact = dot(end, along) > 0.0;
        return {start, unit(outward(exact ? end : along)), t.stops, exact};
    }

    /// The one normal of a soft point with two.
    static point soft(grid_point a, grid_point b, grid_point c, point before, point after) noexcept
    {
        const point sum = before + after, wall_in = outward(way(a, b)), wall_out = outward(way(b, c));
        const bool out_of_both =
            dot(before, after) > -1.0 + 0x1p-20 && dot(sum, wall_in) > 0.0 && dot(sum, wall_out) > 0.0;
        return out_of_both ? unit(sum) : joint_normal(a, b, c, unit(wall_in), unit(wall_out));
    }
};
static_assert(side_normals<curve_normals>);

}  // namespace typemesh
