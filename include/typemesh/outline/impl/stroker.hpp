// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/steady.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/outline/impl/dash_pattern.hpp>
#include <typemesh/outline/impl/elliptical_arc.hpp>
#include <typemesh/outline/outline_sink.hpp>
#include <typemesh/outline/stroke_style.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Draws the stroke of a path: contours that all wind clockwise around what the stroke covers, and overlap. Filled by
/// the rule non_zero they are the stroke.
///
///      O1 ------> O2        The path is followed forwards along its left side, then backwards: the other side is then
///       |         |         the left one. At an inner corner the side goes to the path's own corner and back to the
///      --- path ---         next side, so that what lies on the wrong side of a short edge is not lost.
///       |         |
///        <--------          Where the path turns left more tightly than the stroke's half width, its left side runs
///                           backwards. There the side follows the path itself, and narrow quadrangles between the path
///                           and its true side are contours of their own.
///
/// Sides are cubics with the ends and the directions of the true side; pieces are halved until each is within half of
/// the tolerance of it, at seven places.
template <outline_sink Sink>
class stroker {
public:
    /// The em and the tolerance in font units.
    stroker(const stroke_style& style, double em, double tolerance, Sink& sink) noexcept
        : style_{style}, em_{em}, radius_{0.5 * style.width * em}, tolerance_{tolerance}, to_{sink}
    {
    }

    /// Strokes a path of consecutive curves. No curve may be a point.
    ///
    /// Fails  error::bad_option: "dashes": more than 10,000 for one path
    ///        error::outline_beyond_grid: numbers so large that rounding alone exceeds the tolerance
    error stroke(array_view<const curve> path, bool closed) noexcept
    {
        if (path.empty()) return {};
        const double most = 0x1p40 * tolerance_;
        for (const curve& c : path)
            for (std::uint32_t i = 0; i <= c.degree; ++i)
                if (!(std::fabs(c.p[i].x) < most) || !(std::fabs(c.p[i].y) < most)) return error::outline_beyond_grid;
        dash_pattern pattern{style_.dashes, style_.dash_offset, em_};
        if (!pattern.has_gaps()) return stroke_whole({path}, closed), error{};
        if (!pattern.is_possible(path)) return error::bad("dashes");
        pattern.each_dash(path, [this](const stretch& dash) noexcept {
            if (!dash.is_point()) return stroke_whole(dash, false);
            const station s = look(dash.curves[0], dash.t0);
            dot_at(s.at, s.along);
        });
        return {};
    }

    /// Strokes a path that is only a point: SVG gives it a disc or an upright square, or nothing.
    void dot_at(point p, point along = {1.0, 0.0}) noexcept
    {
        if (style_.cap == stroke_cap::butt) return;
        to_.move(p + radius_ * left_of(along));
        cap(p, along);
        cap(p, -1.0 * along);
        to_.close();
    }

private:
    static constexpr int deepest = 10;

    /// A place on a curve: the direction of the path, its left side and how that side moves.
    struct station {
        double t = 0.0;
        point at, along, rim, rim_along;
        double growth = 1.0;  // of the side's length, per length of the path; negative: it runs backwards
        bool stops = false;   // whether the path stops there, and may turn back
    };

    [[nodiscard]] static point left_of(point along) noexcept { return {-along.y, along.x}; }
    /// Of any vector but 0, however short: its square may be 0.
    [[nodiscard]] static point unit(point p) noexcept
    {
        const double x = std::fabs(p.x), y = std::fabs(p.y), most = x > y ? x : y;
        if (most < 0x1p-500) p = 0x1p600 * p;
        return most > 0.0 ? (1.0 / length(p)) * p : point{1.0, 0.0};
    }
    /// A curve of a stretch, counted in the direction of a side.
    [[nodiscard]] static curve nth(const stretch& path, std::size_t i, bool forwards) noexcept
    {
        const curve c = path.nth(forwards ? i : path.curves.size() - 1 - i);
        if (forwards) return c;
        curve back = c;
        for (std::uint32_t k = 0; k <= c.degree; ++k) back.p[k] = c.p[c.degree - k];
        return back;
    }

    void stroke_whole(const stretch& path, bool closed) noexcept
    {
        side(path, true, closed, true);
        if (closed) to_.close();
        side(path, false, closed, closed);
        to_.close();
        for (const bool forwards : {true, false}) tight_sides(path, forwards);
    }

    [[nodiscard]] station look(const curve& c, double t, bool arrives = false) const noexcept
    {
        station s;
        s.t = t;
        s.at = t > 0.0 ? t < 1.0 ? c.at(t) : c.end() : c.start();
        const hodograph slopes{c};
        const tangents both = slopes.at(t);
        s.along = unit(t < 1.0 && !arrives ? both.after : both.before);
        s.stops = both.stops;
        s.rim = s.at + radius_ * left_of(s.along);
        const point first = static_cast<double>(c.degree) * slopes.derivative(t);
        const double speed = length(first);
        if (c.degree > 1 && !both.stops)
            s.growth = 1.0 - radius_ * cross(first, second(c, t)) / (speed * speed * speed);
        s.rim_along = both.stops ? point{} : s.growth * first;
        return s;
    }
    [[nodiscard]] static point second(const curve& c, double t) noexcept
    {
        const point a = c.p[0] - 2.0 * c.p[1] + c.p[2];
        if (c.degree == 2) return 2.0 * a;
        return 6.0 * lerp(a, c.p[1] - 2.0 * c.p[2] + c.p[3], t);
    }

    /// Draws the left side of the whole path, and what ends it.
    void side(const stretch& path, bool forwards, bool closed, bool begins) noexcept
    {
        const station start = look(nth(path, 0, forwards), 0.0);
        if (begins) to_.move(start.rim);
        rim_ = start.rim;
        on_path_ = false;
        station last = start;
        for (std::size_t i = 0; i < path.curves.size(); ++i) {
            const curve c = nth(path, i, forwards);
            const station from = look(c, 0.0);
            if (i != 0) join(from.at, last.along, from.along, style_.join);
            last = look(c, 1.0);
            add(c, from, last, 0, [this](const station& a, const station& b) noexcept { follow(a, b); });
        }
        if (closed) return join(start.at, last.along, start.along, style_.join);
        line(rim_);
        cap(last.at, last.along);
    }

    /// Goes to a point of the side.
    void line(point p) noexcept
    {
        to_.line(p);
        rim_ = p;
        on_path_ = false;
    }

    /// Adds the side of a piece; tight(a, b) for parts where it runs backwards.
    template <class Tight>
    void add(const curve& c, const station& a, const station& b, int depth, const Tight& tight) noexcept
    {
        if (c.degree == 1) return line(b.rim);
        constexpr int places = 8;
        station some[places + 1];
        some[0] = a;
        some[places] = b;
        bool forwards = a.growth > least && b.growth > least, backwards = !(a.growth > least) && !(b.growth > least);
        for (int k = 1; k < places; ++k) {
            some[k] = look(c, a.t + (b.t - a.t) * k / places);
            forwards = forwards && some[k].growth > least;
            backwards = backwards && !(some[k].growth > least);
        }
        const double turn = steady_angle(cross(a.along, b.along), dot(a.along, b.along));
        if (forwards && std::fabs(turn) < 1.0) {
            const double third = (b.t - a.t) / 3.0;
            const cubic side{a.rim, a.rim + third * a.rim_along, b.rim - third * b.rim_along, b.rim};
            bool close = true;
            for (int k = 1; k < places && close; ++k)
                close = length(side.at(static_cast<double>(k) / places) - some[k].rim) <= 0.5 * tolerance_;
            if (close) {
                if (on_path_) line(a.rim);
                to_.cubic(side.p1, side.p2, side.p3);
                rim_ = b.rim;
                return;
            }
        }
        const double flat = length(some[places / 2].at - lerp(a.at, b.at, 0.5));
        const bool narrow = radius_ * turn * turn <= 4.0 * tolerance_ && flat <= 0.5 * tolerance_;
        if ((backwards && narrow) || depth == deepest) {
            if (!backwards && forwards)
                join(b.at, a.along, b.along, stroke_join::round);
            else
                tight(a, b);
            return;
        }
        const station& middle = some[places / 2];
        const station arriving = middle.stops ? look(c, middle.t, true) : middle;
        add(c, a, arriving, depth + 1, tight);
        if (middle.stops) join(middle.at, arriving.along, middle.along, stroke_join::round);
        add(c, middle, b, depth + 1, tight);
    }

    /// The side follows the path itself.
    void follow(const station& a, const station& b) noexcept
    {
        if (!on_path_) to_.line(a.at);
        to_.line(b.at);
        on_path_ = true;
        rim_ = b.rim;
    }

    /// From the side along `before` to the side along `after`, around a corner of the path.
    void join(point corner, point before, point after, stroke_join how) noexcept
    {
        if (on_path_) line(rim_);
        const point n = left_of(before), m = left_of(after), rim = corner + radius_ * m;
        const double turn = cross(n, m), same_way = dot(n, m);
        if (same_way > 0.0 && radius_ * length(m - n) <= 0.125 * tolerance_) return line(rim);
        if (turn > 0.0 && (same_way > 0.0 || turn > 1e-9)) {  // the inner side
            to_.line(corner);
            return line(rim);
        }
        if (how == stroke_join::round) {
            double sweep = steady_angle(turn, same_way);
            if (sweep > 0.0) sweep -= 2.0 * half_turn;
            return arc(corner, n, sweep, rim);
        }
        if (how == stroke_join::mitre && 2.0 <= style_.mitre_limit * style_.mitre_limit * (1.0 + same_way))
            to_.line(corner + (radius_ / (1.0 + same_way)) * (n + m));
        line(rim);
    }

    /// From the left side at the path's end to its right side.
    void cap(point end, point along) noexcept
    {
        const point n = left_of(along), last = end - radius_ * n;
        if (style_.cap == stroke_cap::round) return arc(end, n, -half_turn, last);
        if (style_.cap == stroke_cap::square) {
            to_.line(end + radius_ * (n + along));
            to_.line(end + radius_ * (along - n));
        }
        line(last);
    }

    /// An arc around a point, which begins in the direction n.
    void arc(point centre, point n, double sweep, point last) noexcept
    {
        elliptical_arc own;
        own.map = {radius_ * n.x, -radius_ * n.y, centre.x, radius_ * n.y, radius_ * n.x, centre.y};
        own.sweep = sweep;
        own.radius = radius_;
        own.cubics(last, 0.5 * tolerance_, [this](point a, point b, point p) noexcept { to_.cubic(a, b, p); });
        rim_ = last;
        on_path_ = false;
    }

    // --- where sides run backwards

    void tight_sides(const stretch& path, bool forwards) noexcept
    {
        ignore_outline nowhere;
        stroker<ignore_outline> silent{style_, em_, tolerance_, nowhere};
        for (std::size_t i = 0; i < path.curves.size(); ++i) {
            const curve c = nth(path, i, forwards);
            if (c.degree > 1)
                silent.each_tight(c, [this](point a, point b, point q, point p) noexcept { quadrangle(a, b, q, p); });
        }
    }
    /// The narrow quadrangle between two places of the path and their sides; two triangles if it crosses itself.
    void quadrangle(point a, point b, point q, point p) noexcept
    {
        const point of_a = p - a, of_b = q - b, gap = b - a;
        const double turn = cross(of_a, of_b), s = cross(gap, of_b), t = cross(gap, of_a);
        const bool crosses =
            turn > 0.0 ? s > 0.0 && s < turn && t > 0.0 && t < turn : s < 0.0 && s > turn && t < 0.0 && t > turn;
        if (!crosses) {
            const point corners[] = {a, p, q, b};
            return clockwise(corners);
        }
        const point x = a + (s / turn) * of_a, within[] = {a, x, b}, beyond[] = {p, x, q};
        clockwise(within);
        clockwise(beyond);
    }
    void clockwise(array_view<const point> corners) noexcept
    {
        double area = 0.0;
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            area += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
        to_.move(corners[0]);
        for (std::size_t i = 1; i < corners.size(); ++i) to_.line(corners[area > 0.0 ? corners.size() - i : i]);
        to_.close();
    }

    template <outline_sink Other>
    friend class stroker;
    template <class Put>
    void each_tight(const curve& c, const Put& put) noexcept
    {
        add(c, look(c, 0.0), look(c, 1.0), 0,
            [&put](const station& a, const station& b) noexcept { put(a.at, b.at, b.rim, a.rim); });
    }

    static constexpr double least = 0x1p-6;  // below that growth, a side counts as running backwards

    stroke_style style_;
    double em_;
    double radius_;
    double tolerance_;
    Sink& to_;
    point rim_;             // where the side is
    bool on_path_ = false;  // the contour is on the path instead
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
