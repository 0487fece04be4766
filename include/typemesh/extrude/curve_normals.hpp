// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>
#include <typemesh/extrude/side_normals.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The exact normals of the curves that the walls approximate, however coarse the polygon. 4N + 2H vertices, and 2 for
/// the seam of each contour without a hard point (extruded.hpp).
///
///     inside a curve     soft: one normal, the curve's own; a cusp or a reversal of the curve is treated as a joint
///     at a joint         hard if the angle between the two curves' tangents exceeds the crease angle: the point is
///                        doubled, and each wall has its own curve's normal. Otherwise soft, with the normalised sum of
///                        the two normals
///     along a line       the line's normal: a wall between two corners is shaded evenly
///
/// A tangent is replaced by the edge's direction if it points against its own edge (the polygon is so coarse that it
/// omits a whole hook there), or if it does not exist (the curve is a point). A soft normal that would point into one
/// of its two walls is replaced by the normalised sum of the walls' own normals. Normals therefore always point out of
/// their walls.
///
/// Normals on a long wall, longer than 16 tolerances, stay close to the wall's own normal. Where a normal would deviate
/// from it by more than 45 degrees, the wall uses its own normal, and its point is hard:
///
///                    ^ the wall's own             The tip of a hairpin inside a curve, narrower than the tolerance.
///     n <---- o======|=====================       At the point o the curve runs straight down, so its normal n is at
///             |      long wall                    right angles to the normal of the long wall. For the short wall
///             '--._                               below, which continues around the tip, n is right. Joints, soft and
///                  '---.._____________            hard, have this problem where a curve bends at its very end.
///
/// The tolerance is the region's; if it is unknown, no wall counts as long. Soft joints deviate by up to half the
/// crease angle, so for crease angles of 90 degrees and more these corrections are omitted.
///
/// Measured on fonts, all but 0.74 % of the angles at joints are below 8 or above 30 degrees.
struct curve_normals {
    static constexpr bool shares_caps = false;

    float crease_degrees = 15.0f;  ///< the crease angle, 0 to 180

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {crease_degrees}; }

    error operator()(const region& filled, array_view<side_point> sides) const noexcept
    {
        if (!is_crease_angle(crease_degrees)) return error::bad("crease_degrees");
        const wall_light light{filled, crease_cosine(crease_degrees)};
        const grid_point* points = filled.points().data();
        const contour_edge* edges = filled.edges().data();
        for (std::uint32_t loop = 0; loop < filled.loop_count(); ++loop) {
            const std::uint32_t first = filled.starts()[loop], size = filled.starts()[loop + 1] - first;
            const contour c{points + first, edges + first, size - 1};
            light.shine_on(c, sides.data() + first);
        }
        return {};
    }

private:
    /// A loop: its points, and the edges that start at them.
    struct contour {
        const grid_point* points;
        const contour_edge* edges;
        std::size_t last;

        [[nodiscard]] std::size_t next(std::size_t i) const noexcept { return i == last ? 0 : i + 1; }
        [[nodiscard]] std::size_t previous(std::size_t i) const noexcept { return i == 0 ? last : i - 1; }
        [[nodiscard]] point along(std::size_t i) const noexcept { return delta(points[i], points[next(i)]); }
    };

    /// The normal of a wall at the start or end of its edge.
    struct wall_end {
        point normal;
        bool leads;  ///< whether the normal is the curve's own and less than 45 degrees from the wall's normal
    };

    /// The directions of the two edges at a point.
    struct edge_directions {
        point arriving, leaving;
    };

    /// Three consecutive points of a contour.
    struct corner {
        grid_point a, b, c;
    };

    /// Whether two directions, of any length, are less than 45 degrees apart, as nearly all are. At 45 degrees the
    /// cross product equals the dot product.
    static bool is_near(point a, point b) noexcept { return dot(a, b) > std::fabs(cross(a, b)); }

    /// Whether one edge continues where the other stopped on its curve.
    static bool goes_on(const contour_edge& stopped, const contour_edge& e) noexcept
    {
        return e.curve == stopped.curve && same(e.t0, stopped.t1);
    }

    static bool is_forth(const contour_edge& e) noexcept { return e.t0 <= e.t1; }

    class wall_light {
    public:
        wall_light(const region& filled, double crease) noexcept
            : curves_{filled.curves().data()}, crease_{crease}, slope_{clear_slope(crease)}
        {
            const double longest = 16.0 * filled.tolerance();
            if (longest > 0.0 && crease > 0.0) long_square_ = longest * longest;
            const double longest_leg = 4.0 * grid::reach / filled.grid().cells;
            moving_ = 0x1p-40 * longest_leg * longest_leg;
        }

        /// Computes the normals of all walls over a contour: at the start of a curve, inside it, then on the next
        /// curve.
        void shine_on(const contour& c, side_point* sides) const noexcept
        {
            point arriving = c.along(c.last);
            const contour_edge* stopped = &c.edges[c.last];
            for (std::size_t i = 0;; ++i) {
                const point leaving = c.along(i);
                if (!meet_at_ends(*stopped, c.edges[i], {arriving, leaving}, sides[i])) [[unlikely]]
                    meet(c, i, sides[i]);
                arriving = leaving;
                i = shine_within(c, i, arriving, sides);
                if (i == c.last) return;
                stopped = &c.edges[i];
            }
        }

    private:
        /// A direction is clear if its angle to its edge is less than 45 degrees minus half the crease angle. Then the
        /// sum of two clear directions that meet softly is near both edges. Returns the tangent of this angle, with a
        /// margin for rounding: tan(45 - crease / 2) = cos / (1 + sin). It is 0 for 90 degrees and more: no direction
        /// is clear.
        [[nodiscard]] static double clear_slope(double crease) noexcept
        {
            constexpr double kept = 1.0 - 0x1p-20;
            return crease > 0.0 ? kept * crease / (1.0 + std::sqrt(1.0 - crease * crease)) : 0.0;
        }

        /// The derivative where an edge leaves the end of its curve: a leg of the control polygon. 0 if the edge starts
        /// inside the curve.
        [[nodiscard]] point leaving_leg(const contour_edge& e) const noexcept
        {
            const curve& q = curves_[e.curve];
            if (e.t0 <= 0.0f) return q.p[1] - q.p[0];
            return e.t0 >= 1.0f ? q.p[q.degree - 1] - q.p[q.degree] : point{};
        }

        /// The derivative where the edge arrives at an end of its curve.
        [[nodiscard]] point arriving_leg(const contour_edge& e) const noexcept
        {
            const curve& q = curves_[e.curve];
            if (e.t1 <= 0.0f) return q.p[0] - q.p[1];
            return e.t1 >= 1.0f ? q.p[q.degree] - q.p[q.degree - 1] : point{};
        }

        /// Joins two walls where one curve ends and the next begins, if both directions are clear, as nearly all are.
        /// Otherwise it returns false and changes nothing.
        [[nodiscard]] bool meet_at_ends(const contour_edge& stopped, const contour_edge& edge,
                                        const edge_directions& edges, side_point& side) const noexcept
        {
            const point in = arriving_leg(stopped), out = leaving_leg(edge);
            const double out_square = dot(out, out);
            if (!(out_square > moving_) || stopped.curve == edge.curve) return false;
            if (in == out) {  // for example where TrueType implies a point between two controls
                if (!is_near(out, edges.arriving) || !is_near(out, edges.leaving)) return false;
                side.before = side.after = rounded(normal_of(out, out_square));
                return true;
            }
            const double in_square = dot(in, in);
            if (!(in_square > moving_) || !is_clear(in, edges.arriving) || !is_clear(out, edges.leaving)) return false;
            const point before = normal_of(in, in_square), after = normal_of(out, out_square);
            side.doubled = dot(before, after) < crease_;
            if (side.doubled) {
                side.before = rounded(before);
                side.after = rounded(after);
            } else {
                side.before = side.after = rounded(before == after ? after : unit(before + after));
            }
            return true;
        }

        [[nodiscard]] bool is_clear(point direction, point edge) const noexcept
        {
            return slope_ * dot(direction, edge) > std::fabs(cross(direction, edge));
        }

        /// The unit normal of a direction, given its squared length.
        [[nodiscard]] static point normal_of(point direction, double square) noexcept
        {
            return (1.0 / std::sqrt(square)) * outward(direction);
        }

        /// Computes the normals at the points inside edge i's curve as long as the curve is smooth there; nearly all
        /// points inside curves are of this kind. Returns the edge after the last of them, and its direction in
        /// `arriving`.
        std::size_t shine_within(const contour& c, std::size_t i, point& arriving, side_point* sides) const noexcept
        {
            const contour_edge& edge = c.edges[i];
            if (i == c.last || !goes_on(edge, c.edges[i + 1])) return i;
            const curve& q = curves_[edge.curve];
            if (q.degree == 2) {  // the derivative of a hodograph, in fewer instructions
                const double sign = is_forth(edge) ? 1.0 : -1.0;
                const point from = sign * (q.p[1] - q.p[0]), to = sign * (q.p[2] - q.p[1]);
                return shine_along([=](double t) noexcept { return lerp(from, to, t); }, c, i, arriving, sides);
            }
            const hodograph any = along(edge);
            return shine_along([=](double t) noexcept { return any.derivative(t); }, c, i, arriving, sides);
        }

        /// Continues with the curve's derivative along the edge.
        template <class Derivative>
        std::size_t shine_along(const Derivative& derivative, const contour& c, std::size_t i, point& arriving,
                                side_point* sides) const noexcept
        {
            do {
                const contour_edge &edge = c.edges[i], &next = c.edges[i + 1];
                if (!goes_on(edge, next)) break;
                const point direction = derivative(as_double(edge.t1)), leaving = c.along(i + 1);
                const double square = dot(direction, direction);
                if (!(square > moving_) || !is_near(direction, arriving) || !is_near(direction, leaving)) break;
                sides[i + 1].before = sides[i + 1].after = rounded(normal_of(direction, square));
                arriving = leaving;
            } while (++i != c.last);
            return i;
        }

        /// A curve's direction, along an edge of it.
        struct heading {
            point direction;
            bool stops;  ///< the curve stops there
        };
        [[nodiscard]] heading at(const contour_edge& e, float t, bool at_end) const noexcept
        {
            const hodograph derivative = along(e);
            const point d = derivative.derivative(as_double(t));
            if (!derivative.vanishes(d)) return {d, false};
            const tangents both = derivative.at(as_double(t));
            return {at_end == is_forth(e) ? both.before : both.after, true};
        }

        /// Joins the walls at point i of a contour in all cases: hairpins, spikes, hooks that the polygon omits, curves
        /// that stop or are divided.
        void meet(const contour& c, std::size_t i, side_point& side) const noexcept
        {
            const corner at_i{c.points[c.previous(i)], c.points[i], c.points[c.next(i)]};
            const edge_directions edges{delta(at_i.a, at_i.b), delta(at_i.b, at_i.c)};
            const contour_edge &last = c.edges[c.previous(i)], &edge = c.edges[i];
            const heading in = at(last, last.t1, true);
            const bool may_break = !goes_on(last, edge) || in.stops;
            const bool turns = may_break || is_forth(edge) != is_forth(last);
            const point out = turns ? at(edge, edge.t0, false).direction : in.direction;
            const wall_end before = leading(last, in.direction, edges.arriving),
                           after = leading(edge, out, edges.leaving);
            join(before, after, at_i, may_break, side);
        }

        /// The derivative of an edge's curve, along the edge.
        [[nodiscard]] hodograph along(const contour_edge& e) const noexcept
        {
            return hodograph{curves_[e.curve], is_forth(e) ? 1.0 : -1.0};
        }

        void join(const wall_end& before, const wall_end& after, const corner& at, bool may_break,
                  side_point& side) const noexcept
        {
            const point in = before.normal, out = after.normal;
            if (may_break && dot(in, out) < crease_) {
                side.before = rounded(before.leads ? in : lit(in, at.a, at.b));
                side.after = rounded(after.leads ? out : lit(out, at.b, at.c));
                side.doubled = true;
                return;
            }
            const point n = in == out ? out : soft(at, in, out);
            side.before = rounded(lit(n, at.a, at.b));
            side.after = rounded(lit(n, at.b, at.c));
            side.doubled = !(side.before == side.after);
        }

        [[nodiscard]] static wall_end leading(const contour_edge& e, point curve_direction, point along) noexcept
        {
            const bool leads = is_near(curve_direction, along);
            if (!leads) [[unlikely]]
                curve_direction = set_right(e, curve_direction, along);
            return {unit(outward(curve_direction)), leads};
        }

        /// Corrects a curve's direction that is not near its edge's direction. Reverses it if t does not show in which
        /// direction the edge runs. Uses the edge's direction if the curve leads backwards, or nowhere.
        [[nodiscard]] static point set_right(const contour_edge& e, point curve_direction, point along) noexcept
        {
            if (same(e.t0, e.t1) && dot(curve_direction, along) < 0.0) curve_direction = -1.0 * curve_direction;
            return dot(curve_direction, along) > 0.0 ? curve_direction : along;
        }

        /// The normal of the wall from a to b, given n: its own if it is long and n deviates by more than 45 degrees.
        [[nodiscard]] point lit(point n, grid_point a, grid_point b) const noexcept
        {
            const point own = outward(delta(a, b));
            const bool from_the_side = dot(n, own) < std::fabs(cross(n, own)) && dot(own, own) > long_square_;
            return from_the_side ? unit(own) : n;
        }

        /// The single normal of a soft point that has two distinct normals.
        [[nodiscard]] static point soft(const corner& at, point before, point after) noexcept
        {
            const point sum = before + after;
            const point wall_in = outward(delta(at.a, at.b)), wall_out = outward(delta(at.b, at.c));
            const bool out_of_both =
                dot(before, after) > -1.0 + 0x1p-20 && dot(sum, wall_in) > 0.0 && dot(sum, wall_out) > 0.0;
            return out_of_both ? unit(sum) : joint_normal(at.a, at.b, at.c, unit(wall_in), unit(wall_out));
        }

        const curve* curves_;
        double crease_;
        double slope_;  // see clear_slope()
        double
            moving_;  // squared length above which a derivative surely does not vanish: no leg is longer than the grid
        double long_square_ = 0x1p62;  // squared length above which a wall is long; no edge has 2^31 cells
    };
};
static_assert(side_normals<curve_normals>);

}  // namespace typemesh::inline TYPEMESH_ABI
