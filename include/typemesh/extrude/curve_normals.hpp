// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/same.hpp>
#include <typemesh/core/tangent.hpp>
#include <typemesh/extrude/side_normals.hpp>
#include <typemesh/extrude/wall_normal.hpp>

#include <cmath>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

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
/// No wall longer than 16 tolerances is lit from the side. Where such a normal would be more than 45 degrees off the
/// wall's own, the wall takes its own, and its point is hard:
///
///                    ^ the wall's own             The tip of a hairpin inside a curve, narrower than the tolerance.
///     n <---- o======|=====================       In the point o the curve runs straight down, so its normal n would
///             |      long wall                    light the long wall from the side. For the short one below, which
///             '--._                               leads on round the tip, it is right. The same comes at joints, soft
///                  '---.._____________            and hard, where a curve bends in its last bit.
///
/// The tolerance is the region's; where it is not known no wall counts as long. From a crease angle of 90 degrees on
/// nothing of this is done: soft joints are then half as far off as that by the caller's wish.
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
        wall_light light{shape, crease_cosine(crease_degrees)};
        const auto points = shape.points();
        const auto edges = shape.edges();
        for (std::uint32_t loop = 0; loop < shape.loop_count(); ++loop) {
            const std::uint32_t first = shape.starts()[loop], last = shape.starts()[loop + 1] - 1;
            const point closing = delta(points[last], points[first]);
            const wall_end start = light.start(edges[last], closing);
            wall_end before = light.end(edges[last], closing, start);
            point arriving = closing;
            for (std::uint32_t i = first, previous = last; i <= last; previous = i++) {
                const contour_edge& edge = edges[i];
                const grid_point next = points[i == last ? first : i + 1];
                const point leaving = delta(points[i], next);
                const bool inside = goes_on(edges[previous], edge) && !before.stops;
                wall_end after = before;
                if (inside && before.leads && is_near(before.normal, outward(leaving))) {
                    sides[i].before = sides[i].after = rounded(before.normal);
                } else {
                    after = i == last ? start : light.start(edge, leaving);
                    const bool may_break = !inside;
                    if (!light.meet(before, after, {arriving, leaving}, may_break, sides[i]))
                        light.meet_askew(before, after, {points[previous], points[i], next}, may_break, sides[i]);
                }
                if (i == last) break;
                before = light.end(edge, leaving, after);
                arriving = leaving;
            }
        }
        return {};
    }

private:
    /// What a wall is lit with where its edge starts or ends.
    struct wall_end {
        point normal;
        bool leads;  ///< it is the curve's own, and less than 45 degrees off the wall's
        bool stops;  ///< the curve stops there, to turn perhaps
    };

    /// The two edges that meet in a point.
    struct edge_ways {
        point arriving, leaving;
    };

    /// Three points of a contour, one after another.
    struct corner {
        grid_point a, b, c;
    };

    /// Whether two directions, of any length, are less than 45 degrees apart, as nearly all are that are asked about:
    /// at 45 degrees the cross product is as large as the dot product.
    static bool is_near(point a, point b) noexcept { return dot(a, b) > std::fabs(cross(a, b)); }

    /// Whether one edge goes on where the other stopped on its curve.
    static bool goes_on(const contour_edge& stopped, const contour_edge& e) noexcept
    {
        return e.curve == stopped.curve && same(e.t0, stopped.t1);
    }

    class wall_light {
    public:
        wall_light(const region& shape, double crease) noexcept
            : curves_{shape.curves()}, crease_{crease}
        {
            const double longest = 16.0 * shape.tolerance();
            if (longest > 0.0 && crease > 0.0) long_square_ = longest * longest;
        }

        /// Where the wall over an edge that leads `along` starts.
        [[nodiscard]] wall_end start(const contour_edge& e, point along) noexcept
        {
            follow(e);
            const tangents t = derivative_.at(as_double(e.t0));
            return leading(e, forth_ ? t.after : t.before, along, t.stops);
        }

        /// Where it ends.
        [[nodiscard]] wall_end end(const contour_edge& e, point along, const wall_end& start) noexcept
        {
            if (curves_[e.curve].degree == 1) return start;
            follow(e);
            const tangents t = derivative_.at(as_double(e.t1));
            return leading(e, forth_ ? t.before : t.after, along, t.stops);
        }

        /// Two walls meet whose edges lead `ways`. False, and nothing done, where one is not lit by its curve alone.
        [[nodiscard]] bool meet(const wall_end& before, const wall_end& after, const edge_ways& ways, bool may_break,
                                side_point& side) const noexcept
        {
            const point in = before.normal, out = after.normal, sum = in + out;
            if (may_break && dot(in, out) < crease_) {
                if (!before.leads || !after.leads) return false;
                side.before = rounded(in);
                side.after = rounded(out);
                side.doubled = true;
                return true;
            }
            if (!is_near(sum, outward(ways.arriving)) || !is_near(sum, outward(ways.leaving))) return false;
            side.before = side.after = rounded(in == out ? out : unit(sum));
            return true;
        }

        /// The same for the rest: hairpins, spikes, hooks that the polygon leaves out.
        void meet_askew(const wall_end& before, const wall_end& after, const corner& at, bool may_break,
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

    private:
        /// Takes up the derivative of an edge's curve, along the edge: most edges go on where the one before stopped.
        void follow(const contour_edge& e) noexcept
        {
            const bool forth = e.t0 <= e.t1;
            if (&curves_[e.curve] == curve_ && forth == forth_) return;
            curve_ = &curves_[e.curve];
            forth_ = forth;
            derivative_ = hodograph{*curve_, forth ? 1.0 : -1.0};
        }

        [[nodiscard]] static wall_end leading(const contour_edge& e, point curve_way, point along, bool stops) noexcept
        {
            const bool leads = is_near(curve_way, along);
            if (!leads) [[unlikely]]
                curve_way = set_right(e, curve_way, along);
            return {unit(outward(curve_way)), leads, stops};
        }

        /// A curve's direction that is not near its edge's: turned round where t does not tell which way the edge runs,
        /// and the edge's own where the curve leads backwards, or nowhere.
        [[nodiscard]] static point set_right(const contour_edge& e, point curve_way, point along) noexcept
        {
            if (same(e.t0, e.t1) && dot(curve_way, along) < 0.0) curve_way = -1.0 * curve_way;
            return dot(curve_way, along) > 0.0 ? curve_way : along;
        }

        /// What the wall from a to b is lit with for a normal n: its own where it is long and n more than 45 degrees
        /// off.
        [[nodiscard]] point lit(point n, grid_point a, grid_point b) const noexcept
        {
            const point own = outward(delta(a, b));
            const bool from_the_side = dot(n, own) < std::fabs(cross(n, own)) && dot(own, own) > long_square_;
            return from_the_side ? unit(own) : n;
        }

        /// The one normal of a soft point with two.
        [[nodiscard]] static point soft(const corner& at, point before, point after) noexcept
        {
            const point sum = before + after, wall_in = outward(delta(at.a, at.b)), wall_out = outward(delta(at.b, at.c));
            const bool out_of_both =
                dot(before, after) > -1.0 + 0x1p-20 && dot(sum, wall_in) > 0.0 && dot(sum, wall_out) > 0.0;
            return out_of_both ? unit(sum) : joint_normal(at.a, at.b, at.c, unit(wall_in), unit(wall_out));
        }

        std::span<const curve> curves_;
        const curve* curve_ = nullptr;  // the one that is followed,
        bool forth_ = true;             // which way,
        hodograph derivative_;          // and its derivative that way
        double crease_;
        double long_square_ = 0x1p62;  // of the length from which a wall is long; no edge is as long as 2^31 cells
    };
};
static_assert(side_normals<curve_normals>);

}  // namespace typemesh::inline TYPEMESH_ABI
