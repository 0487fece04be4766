// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/double3.hpp>
#include <typemesh/bend/impl/uniform_spline.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>

#include <cmath>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A smooth curve in space with a frame that moves along it: the way of text that follows a curve (along_curve.hpp).
///
///         up                   tangent   the direction of the curve
///         ^   .--> tangent     up        perpendicular to it; the frame turns about the tangent as little as possible
///         | .'                           (a rotation-minimising frame)
///     ----+'                   toward    perpendicular to both, towards the reader
///
///     text_path path;
///     if (error e = path.through(points)) ...        at least two different points, in em
///     path.length()                                  in em
///
/// The curve is the natural cubic spline through the points, with chord lengths as parameters. It is then replaced by
/// one whose parameter is the arc length, up to a relative error that falls with the fourth power of the distance of
/// its 64 knots between two of the points. That curve has continuous second derivatives, and so has no jump in its
/// curvature.
///
/// From  W. Wang, B. Juettler, D. Zheng & Y. Liu, Computation of rotation minimizing frames (2008), section 3: double
///       reflection
class text_path {
public:
    /// A frame, with its derivatives along the curve.
    struct frame {
        double3 at, tangent, up, toward;
        double3 speed;       ///< the derivative of `at`; its length is nearly 1
        double3 tangent_by;  ///< the derivative of the tangent
        double3 up_by;       ///< the derivative of `up`
        double3 toward_by;   ///< the derivative of `toward`
    };

    /// Bounds over a part of the curve.
    struct bounds {
        double bend = 0.0;    ///< of the length of the second derivative of `at`
        double turn = 0.0;    ///< of the lengths of the first derivatives of `up` and `toward`
        double turn_2 = 0.0;  ///< of their second derivatives
    };

    explicit text_path(memory source = heap()) noexcept
        : given_{source}, place_{source}, upward_{source}, bounds_{source}
    {
    }

    /// Makes the curve through these points. `up` is the direction of the text's height at the first point; the part of
    /// it that is perpendicular to the curve counts.
    ///
    /// Fails  error::bad_option: fewer than two points or more than 2^20, equal consecutive points, numbers that are
    ///        not finite or above 2^20, or a turn so sharp that its curvature is not bounded ("points"); `up` is
    ///        parallel to the curve ("up")
    ///        error::out_of_memory. The path is then empty
    /// Cost   O(points)
    [[nodiscard]] error through(array_view<const double3> points, const double3& up = {0.0, 1.0, 0.0}) noexcept
    {
        length_ = 0.0;
        if (error e = read(points, up)) {
            bounds_.clear();
            length_ = 0.0;
            return e;
        }
        return {};
    }

    /// In em; 0 if the path is empty.
    [[nodiscard]] double length() const noexcept { return length_; }
    [[nodiscard]] bool empty() const noexcept { return bounds_.empty(); }

    /// How far the text may reach beyond the ends, where the curve goes on straight: an em.
    static constexpr double beyond = 1.0;

    /// The frame at a distance along the curve, from -beyond to length() + beyond. Precondition: not empty.
    [[nodiscard]] frame at(double distance) const noexcept
    {
        TYPEMESH_ASSERT(!empty(), "a text_path has no curve: call through() first");
        const detail::spline_value c = place_.at(distance), v = upward_.at(distance);
        frame f;
        f.at = c.at;
        f.speed = c.first;
        const double size = typemesh::length(c.first);
        f.tangent = (1.0 / size) * c.first;
        f.tangent_by = (1.0 / size) * (c.second - dot(c.second, f.tangent) * f.tangent);
        const double along = dot(v.at, f.tangent);
        const double3 across = v.at - along * f.tangent,
                      across_by = v.first - (dot(v.first, f.tangent) + dot(v.at, f.tangent_by)) * f.tangent -
                                  along * f.tangent_by;
        const double across_size = typemesh::length(across);
        f.up = (1.0 / across_size) * across;
        f.up_by = (1.0 / across_size) * (across_by - dot(across_by, f.up) * f.up);
        f.toward = cross(f.tangent, f.up);
        f.toward_by = cross(f.tangent_by, f.up) + cross(f.tangent, f.up_by);
        return f;
    }

    /// The bounds between two distances.
    [[nodiscard]] bounds between(double low, double high) const noexcept
    {
        bounds most;
        const auto raise = [](double& to, double v) noexcept { to = v > to ? v : to; };
        const auto include = [&](const bounds& b) noexcept {
            raise(most.bend, b.bend);
            raise(most.turn, b.turn);
            raise(most.turn_2, b.turn_2);
        };
        for (std::size_t i = place_.piece_at(low), last = place_.piece_at(high); i <= last; ++i) include(bounds_[i]);
        if (low < 0.0) include(before_);
        if (high > length_) include(after_);
        return most;
    }

private:
    static constexpr std::size_t pieces_per_point = 64;

    [[nodiscard]] error read(array_view<const double3> points, const double3& up) noexcept
    {
        if (points.size() < 2 || points.size() > 0x10'0000u) return error::bad("points");
        for (const double3& p : points)
            for (const double v : {p.x, p.y, p.z})
                if (!is_finite(v) || std::fabs(v) > 0x1p20) return error::bad("points");
        if (!is_finite(up.x) || !is_finite(up.y) || !is_finite(up.z)) return error::bad("up");
        const std::size_t n = points.size() - 1, pieces = pieces_per_point * n;
        buffer<double>& knots = given_.knots();
        knots.clear();
        double* const at = knots.append(n + 1);
        if (at == nullptr) return error::out_of_memory;
        at[0] = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
            const double chord = typemesh::length(points[i + 1] - points[i]);
            if (!(chord > 0x1p-30)) return error::bad("points");
            at[i + 1] = at[i] + chord;
        }
        if (!given_.fit(points)) return error::out_of_memory;
        length_ = given_.arc_length();

        double3* const place = place_.begin(pieces, length_);
        if (place == nullptr) return error::out_of_memory;
        given_.walk(pieces, place);
        if (!place_.fit()) return error::out_of_memory;

        double3* const upward = upward_.begin(pieces, length_);
        if (upward == nullptr) return error::out_of_memory;
        if (!carry(up, pieces, upward)) return error::bad("up");
        if (!upward_.fit()) return error::out_of_memory;
        bounds_.clear();
        bounds* const all = bounds_.append(pieces);
        if (all == nullptr) return error::out_of_memory;
        for (std::size_t i = 0; i < pieces; ++i)
            if (!bound(i, all[i])) return error::bad("points");
        return bound_straight(0, before_) && bound_straight(pieces, after_) ? error{} : error::bad("points");
    }

    /// The frame's `up` at each knot, by double reflection. False if it is parallel to the curve.
    [[nodiscard]] bool carry(const double3& up, std::size_t pieces, double3* out) const noexcept
    {
        const auto tangent_at = [&](std::size_t i) noexcept {
            const double3 first = place_.at_knot(i).first;
            return (1.0 / typemesh::length(first)) * first;
        };
        double3 tangent = tangent_at(0), across = up - dot(up, tangent) * tangent;
        const double size = typemesh::length(across);
        if (!(size > 0x1p-10 * typemesh::length(up))) return false;
        across = (1.0 / size) * across;
        out[0] = across;
        for (std::size_t i = 0; i < pieces; ++i) {
            const double3 step = place_.at_knot(i + 1).at - place_.at_knot(i).at;
            const auto reflected = [](double3 v, double3 normal) noexcept {
                const double square = dot(normal, normal);
                return square > 0.0 ? v - (2.0 * dot(v, normal) / square) * normal : v;
            };
            const double3 next = tangent_at(i + 1);
            across = reflected(reflected(across, step), next - reflected(tangent, step));
            tangent = next;
            across = across - dot(across, tangent) * tangent;
            across = (1.0 / typemesh::length(across)) * across;
            out[i + 1] = across;
        }
        return true;
    }

    /// Bounds over one piece; false if the curve nearly stops or the frame nearly flips there.
    ///
    /// Within a piece the splines' third derivatives are constant. Let v be the spline of `up` directions, s = v .
    /// tangent, and q the length of v across the tangent. The frame turns about the tangent at the rate
    /// twist = (v' . toward - s tangent' . toward) / q. First derivatives are bounded by their value in the middle, and
    /// by how much they can change up to the ends.
    [[nodiscard]] bool bound(std::size_t i, bounds& out) const noexcept
    {
        const auto greater = [](double a, double b) noexcept { return a > b ? a : b; };
        const auto size = [](double v) noexcept { return v < 0.0 ? -v : v; };
        const double half = 0.5 * place_.step(), middle = (static_cast<double>(i) + 0.5) * place_.step();
        const double c2 = greater(typemesh::length(place_.at_knot(i).second),
                                  typemesh::length(place_.at_knot(i + 1).second)),
                     c3 = typemesh::length(place_.third(i)), c1 = typemesh::length(place_.at(middle).first) - half * c2;
        if (!(c1 > 0.25)) return false;
        const frame f = at(middle);
        const double rough = c2 / c1, t2 = c3 / c1 + 2.0 * rough * rough,
                     t1 = typemesh::length(f.tangent_by) + half * t2;
        const detail::spline_value v = upward_.at(middle);
        const double v2 = greater(typemesh::length(upward_.at_knot(i).second),
                                  typemesh::length(upward_.at_knot(i + 1).second)),
                     v1 = typemesh::length(v.first) + half * v2, v0 = typemesh::length(v.at) + half * v1;
        const double s2 = v2 + 2.0 * v1 * t1 + v0 * t2,
                     s1 = size(dot(v.first, f.tangent) + dot(v.at, f.tangent_by)) + half * s2,
                     s = size(dot(v.at, f.tangent)) + half * s1;
        const double q0 = typemesh::length(v.at - dot(v.at, f.tangent) * f.tangent) - half * (v1 + t1 * v0);
        if (!(q0 > 0.25)) return false;
        const double turning = (v1 + s * t1) / q0 + t1;  // a rough bound of the frame's turning
        const double twist = (size(dot(v.first, f.toward)) + half * (v2 + v1 * turning) + s * t1) / q0,
                     q1 = size(dot(v.first, f.up)) + half * (v2 + v1 * turning) + s * t1,
                     twist_1 = (v2 + 2.0 * s1 * t1 + s * t2 + 2.0 * q1 * twist) / q0;
        const double first = t1 + twist, second = 2.0 * t1 * first + t2 + twist_1 + twist * first;
        constexpr double outward = 1.0 + 0x1p-30;  // more than all roundings together
        out = {outward * c2, outward * first, outward * second};
        return true;
    }

    /// Bounds beyond an end, where the tangent is constant and the spline of `up` directions straight. False if the
    /// frame nearly flips there.
    [[nodiscard]] bool bound_straight(std::size_t end, bounds& out) const noexcept
    {
        const double3 first = place_.at_knot(end).first, tangent = (1.0 / typemesh::length(first)) * first;
        const detail::spline_value v = upward_.at_knot(end);
        const auto across = [&](const double3& a) noexcept { return typemesh::length(a - dot(a, tangent) * tangent); };
        const double q1 = across(v.first), q0 = across(v.at) - beyond * q1;
        if (!(q0 > 0.25)) return false;
        out = {0.0, 1.0001 * q1 / q0, 2.0002 * (q1 / q0) * (q1 / q0)};
        return true;
    }

    detail::chord_spline given_;
    detail::uniform_spline place_, upward_;
    buffer<bounds> bounds_;
    bounds before_, after_;  // beyond the ends
    double length_ = 0.0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
