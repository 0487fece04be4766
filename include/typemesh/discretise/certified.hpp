// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/tangent.hpp>
#include <typemesh/discretise/discretiser.hpp>

#include <cmath>
#include <cstdint>

namespace typemesh {

namespace detail {

/// What certify() says of one piece: the chord is good enough, or how much of the piece to try instead.
struct verdict {
    bool good;
    double shrink;  ///< below 1; meaningless when good
};

[[nodiscard]] inline verdict refused(double squared_ratio) noexcept
{
    return {false, 1.0 / std::sqrt(std::sqrt(squared_ratio))};
}

/// A quadratic as p0 + 2bt + at^2.
struct quadratic_walk {
    point p0, b, a;
    double turn;  ///< |b x a|; zero for a straight curve
    double tt;    ///< tolerance squared
    bool tame;    ///< no piece leaves the stripe over its chord

    [[nodiscard]] point at(double t) const noexcept { return p0 + t * (2.0 * b + t * a); }

    /// Offset from the chord is -a h^2 s(1-s): greatest in the middle.
    [[nodiscard]] verdict certify(double u, double v) const noexcept
    {
        const double h = v - u;
        const point c = 2.0 * b + (u + v) * a;
        const double error = h * h * turn;
        const double room = 4.0 * tt * dot(c, c);
        if (tame) {
            if (error * error <= room) return {true, 1.0};
            return refused(error * error / room);
        }
        const double first = dot(b + u * a, c), last = dot(b + v * a, c);
        const double aa = dot(a, a) * h * h * h * h;  // |a|h^2/4 is the greatest distance to the point of equal s
        if (aa <= 16.0 * tt) return {true, 1.0};
        if (first >= 0.0 && last >= 0.0) {
            if (error * error <= room) return {true, 1.0};
            return refused(error * error / room);
        }
        // The piece leaves the stripe by  x = -first^2 h / (first - last) |c|  at the start, likewise at the end.
        const double cc = dot(c, c);
        const double worse = first < last ? first : last;
        const double beyond = worse * worse / (first < last ? last - first : first - last);  // times h / |c|
        const double squared = cc > 0.0 ? (error * error * 0.25 + beyond * beyond * h * h) / cc : aa / 16.0;
        const double bound = squared < aa / 16.0 ? squared : aa / 16.0;
        if (bound <= tt) return {true, 1.0};
        return refused(bound / tt);
    }
};

/// Where equal shares of the integral of sqrt(|B' x B''| / (8 tolerance |B'|)) lie on a quadratic: on the parabola it is
/// a scaled integral of (1 + x^2)^(-1/4), x being the tangent's slope against the axis.
///
/// The approximations of that integral and of its inverse are from  R. Levien, "Flattening quadratic Béziers", 2019.
struct parabola_shares {
    double slope0, slope_rate, scale;
    double u0, first, whole, ratio;  // of the approximate inverse

    [[nodiscard]] static double integral(double x) noexcept
    {
        constexpr double d = 0.67;
        return x / ((1.0 - d) + std::sqrt(std::sqrt(d * d * d * d + 0.25 * x * x)));
    }
    [[nodiscard]] static double inverse(double y) noexcept
    {
        constexpr double b = 0.39;
        return y * ((1.0 - b) + std::sqrt(b * b + 0.25 * y * y));
    }
    parabola_shares(const quadratic_walk& q, double ta, double tb, double tolerance) noexcept
    {
        const double aa = dot(q.a, q.a), length_a = std::sqrt(aa);
        slope0 = dot(q.a, q.b) / q.turn;
        slope_rate = aa / q.turn;
        const double x0 = slope0 + slope_rate * ta, x1 = slope0 + slope_rate * tb;
        first = integral(x0);
        const double last = integral(x1);
        whole = q.turn / (2.0 * length_a * std::sqrt(length_a * tolerance)) * (last - first);
        scale = (last - first) / whole;
        u0 = inverse(first);
        ratio = (tb - ta) / (inverse(last) - u0);
        start = ta;
    }
    double start;
    [[nodiscard]] double t_of(double share) noexcept { return start + ratio * (inverse(first + scale * share) - u0); }
    [[nodiscard]] double share_of(double t) const noexcept
    {
        return (integral(slope0 + slope_rate * t) - first) / scale;
    }
};

struct cubic_walk {
    point p0, c1, c2, c3;
    double tt;
    bool tame;

    [[nodiscard]] point at(double t) const noexcept { return p0 + t * (c1 + t * (c2 + t * c3)); }

    [[nodiscard]] verdict certify(double u, double v) const noexcept
    {
        const double h = v - u;
        const point d1 = c1 + u * (2.0 * c2 + (3.0 * u) * c3);
        const point d2 = h * (c2 + (3.0 * u) * c3);
        const point d3 = (h * h) * c3;
        const point c = d1 + d2 + d3;  // all over h
        const double p = cross(c, d1), q = p - cross(c, d3);
        const double m = (p + q) * 0.5 * h, d = (q - p) * 0.5 * h;
        const double mm = m * m, dd = d * d, cc = dot(c, c);
        const double room = 16.0 * tt * cc;
        if (!tame) return certify_wild(d1, d2, d3, c, h, m, d);
        // (1 - x^2)(|m| + |d|x)/4 <= (|m| + d^2/4|m|)/4
        const double quick = mm + 0.25 * dd;
        if (quick * quick <= mm * room) return {true, 1.0};
        const double am = std::abs(m), ad = std::abs(d);
        const double x = ad / (am + std::sqrt(mm + 3.0 * dd) + 1e-300);
        const double top = (1.0 - x * x) * (am + ad * x);
        if (top * top <= room) return {true, 1.0};
        return refused(top * top / room);
    }

    [[nodiscard]] verdict certify_wild(point d1, point d2, point d3, point c, double h, double m, double d) const noexcept
    {
        const double cc = dot(c, c);
        const double am = std::abs(m), ad = std::abs(d);
        const double x = ad / (am + std::sqrt(m * m + 3.0 * d * d) + 1e-300);
        const double top = (1.0 - x * x) * (am + ad * x) * 0.25;
        const point v1 = d1 - c, v2 = v1 - d3;
        const double n1 = dot(v1, v1), n2 = dot(v2, v2);
        const double loose = (n1 > n2 ? n1 : n2) * h * h / 16.0;
        if (loose <= tt) return {true, 1.0};
        double bound = loose;
        if (cc > 0.0) {
            const double first = dot(d1, c) / 3.0, second = (2.0 * dot(d1, c) + dot(d2, c)) / 3.0;
            double beyond = 0.0;
            if (first < 0.0 || second < 0.0 || first > cc || second > cc) {
                const double low = (first < 0.0 ? first : 0.0) + (second < 0.0 ? second : 0.0);
                const double high = (first > cc ? first - cc : 0.0) + (second > cc ? second - cc : 0.0);
                beyond = (-low > high ? -low : high) * (4.0 / 9.0) * h;
            }
            const double squared = (top * top + beyond * beyond) / cc;
            bound = squared < loose ? squared : loose;
        }
        if (bound <= tt) return {true, 1.0};
        return refused(bound / tt);
    }
};

template <int intervals>
struct sampled_shares {
    double sum[intervals + 1];
    double density[intervals + 1];
    double start, cell, whole;
    int i = 0;

    sampled_shares(const cubic_walk& q, double ta, double tb, double tolerance, double longest) noexcept
    {
        const double k0 = 2.0 * cross(q.c1, q.c2), k1 = 6.0 * cross(q.c1, q.c3), k2 = 6.0 * cross(q.c2, q.c3);
        const point d1 = 2.0 * q.c2, d2 = 3.0 * q.c3;
        const double more = longest * 0x1p-20;
        const double scale = 1.0 / (8.0 * tolerance);
        start = ta;
        cell = (tb - ta) / intervals;
        for (int j = 0; j <= intervals; ++j) {
            const double t = ta + j * cell;
            const double dx = q.c1.x + t * (d1.x + t * d2.x), dy = q.c1.y + t * (d1.y + t * d2.y);
            const double k = std::abs(k0 + t * (k1 + t * k2));
            density[j] = std::sqrt(k * scale / (std::sqrt(dx * dx + dy * dy) + more));
        }
        sum[0] = 0.0;
        for (int j = 0; j < intervals; ++j) sum[j + 1] = sum[j] + 0.5 * cell * (density[j] + density[j + 1]);
        whole = sum[intervals];
    }
    [[nodiscard]] double t_of(double share) noexcept
    {
        while (i + 1 < intervals && share > sum[i + 1]) ++i;
        const double rest = share - sum[i];
        const double root = std::sqrt(std::abs(density[i] * density[i] + 2.0 * (density[i + 1] - density[i]) * rest / cell));
        return start + cell * i + 2.0 * rest / (density[i] + root + 1e-300);
    }
    [[nodiscard]] double share_of(double t) const noexcept
    {
        const double at = (t - start) / cell;
        int j = static_cast<int>(at);
        if (j > intervals - 1) j = intervals - 1;
        const double x = at - j;
        return sum[j] + cell * x * (density[j] + 0.5 * x * (density[j + 1] - density[j]));
    }
};

#ifndef SLACK
#define SLACK 0.1
#define GROW 0.98
#define SAFE 0.998
#endif

/// Emits the points of (ta, tb), not tb itself.
template <class Walk, class Shares, class Emit>
void walk_evenly(const Walk& w, Shares& shares, double ta, double tb, double sure_step, Emit&& emit) noexcept
{
    const double most = std::ceil((tb - ta) / sure_step);
    double pieces = std::ceil(shares.whole - SLACK);
    pieces = pieces < 2.0 ? 2.0 : pieces;
    if (!(pieces < most)) {
        for (double i = 1.0; i < most; i += 1.0) {
            const double t = ta + (tb - ta) * (i / most);
            emit(w.at(t), t);
        }
        return;
    }
    double u = ta, done = 0.0, share = shares.whole / pieces;
    for (;;) {
        double aim = done + share;
        double v = pieces > 1.0 ? shares.t_of(aim) : tb;
        for (int tries = 0;; ++tries) {
            if (!(v - u > sure_step)) {  // always good, by Wang's bound
                v = u + sure_step;
                aim = shares.share_of(v);
                pieces = std::ceil(shares.whole - aim - SLACK) + 1.0;
                pieces = pieces < 2.0 ? 2.0 : pieces;
                break;
            }
            const verdict said = w.certify(u, v);
            if (said.good) break;
            if (said.shrink < GROW) {
                pieces += 1.0;
                v = u + (v - u) * (said.shrink < 0.25 ? 0.25 : said.shrink) * SAFE;
            } else {
                v = u + (v - u) * said.shrink * SAFE;
                if (pieces < 2.0) pieces = 2.0;
            }
            if (tries > 8) v = u;
            aim = shares.share_of(v);
        }
        if (!(v < tb)) return;
        emit(w.at(v), v);
        u = v;
        done = aim;
        pieces -= 1.0;
        if (pieces < 1.0) pieces = 1.0;
        share = (shares.whole - done) / pieces;
    }
}

}  // namespace detail

struct certified {
    template <class Emit>
    void operator()(const quadratic& q, double tolerance, Emit&& emit) const noexcept
    {
        const double tt = tolerance * tolerance;
        const point b = q.p1 - q.p0, e = q.p2 - q.p1, a = e - b, c = q.p2 - q.p0;
        const double k = cross(b, e), cc = dot(c, c), be = dot(b, e);
        const double bend = dot(a, a);
        if (be >= 0.0) {
            if (k * k <= 4.0 * tt * cc) return emit(q.p2, 1.0);
            if (bend <= 256.0 * tt) {
                emit(0.25 * (q.p0 + q.p2) + 0.5 * q.p1, 0.5);
                return emit(q.p2, 1.0);
            }
        }
        const detail::quadratic_walk w{q.p0, b, a, std::abs(k), tt, be >= 0.0};
        if (w.certify(0.0, 1.0).good) return emit(q.p2, 1.0);
        const double sure = std::sqrt(4.0 * tolerance / std::sqrt(bend));
        detail::parabola_shares shares{w, 0.0, 1.0, tolerance};
        detail::walk_evenly(w, shares, 0.0, 1.0, sure, emit);
        emit(q.p2, 1.0);
    }

    template <class Emit>
    void operator()(const cubic& q, double tolerance, Emit&& emit) const noexcept
    {
        const double tt = tolerance * tolerance;
        const point l0 = q.p1 - q.p0, l1 = q.p2 - q.p1, l2 = q.p3 - q.p2, c = q.p3 - q.p0;
        const point s0 = l1 - l0, s1 = l2 - l1;
        const double b0 = dot(s0, s0), b1 = dot(s1, s1), bend = b0 > b1 ? b0 : b1;
        const bool tame = dot(l0, l1) >= 0.0 && dot(l1, l2) >= 0.0 && dot(l0, l2) >= 0.0;
        const detail::cubic_walk w{q.p0, 3.0 * l0, 3.0 * s0, s1 - s0, tt, tame};
        if (w.certify(0.0, 1.0).good) return emit(q.p3, 1.0);
        if (bend * 0.5625 <= 16.0 * tt) {
            emit(0.125 * (q.p0 + q.p3) + 0.375 * (q.p1 + q.p2), 0.5);
            return emit(q.p3, 1.0);
        }
        const double sure = std::sqrt(tolerance / (0.75 * std::sqrt(bend)));
        const double longest = length(l0) + length(l1) + length(l2);
        if (sure > 0.2) {
            detail::sampled_shares<4> shares{w, 0.0, 1.0, tolerance, longest};
            detail::walk_evenly(w, shares, 0.0, 1.0, sure, emit);
        } else if (sure > 0.05) {
            detail::sampled_shares<8> shares{w, 0.0, 1.0, tolerance, longest};
            detail::walk_evenly(w, shares, 0.0, 1.0, sure, emit);
        } else {
            detail::sampled_shares<16> shares{w, 0.0, 1.0, tolerance, longest};
            detail::walk_evenly(w, shares, 0.0, 1.0, sure, emit);
        }
        emit(q.p3, 1.0);
    }
};
static_assert(discretiser<certified>);

}  // namespace typemesh
