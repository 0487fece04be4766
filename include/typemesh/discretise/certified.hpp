// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/tangent.hpp>
#include <typemesh/discretise/discretiser.hpp>

#include <cmath>
#include <cstdint>
#include <cstring>

namespace typemesh {

#ifndef SLACK
#define SLACK 0.1
#define GROW 0.98
#define SAFE 0.998
#endif

namespace detail {

/// z^(-1/4) within 0.11 %, without a root or a division: a first guess from the exponent bits, and one step of Newton's whose
/// two constants were fitted together with it. For z = 0 some large number.
[[nodiscard]] inline float inverse_fourth_root(float z) noexcept
{
    std::uint32_t bits = 0;
    std::memcpy(&bits, &z, sizeof bits);
    bits = 0x4F50'8000u - (bits >> 2);
    float r = 0.0f;
    std::memcpy(&r, &bits, sizeof r);
    const float rr = r * r;
    return r * (1.30089f - 0.303888f * (z * rr) * rr);
}

/// B(t) = p0 + c1 t + c2 t^2 + c3 t^3, and what a chord of it may stray.
struct cubic_form {
    point p0, c1, c2, c3;
    double tt;  ///< tolerance squared

    [[nodiscard]] point at(double t) const noexcept { return p0 + t * (c1 + t * (c2 + t * c3)); }

    template <bool tame>
    [[nodiscard]] double excess(double u, double v) const noexcept
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
        if constexpr (tame) {
            // (1 - x^2)(|m| + |d|x)/4 <= (|m| + d^2/4|m|)/4
            const double quick = mm + 0.25 * dd;
            if (quick * quick <= mm * room) return 1.0;
            const double am = std::abs(m), ad = std::abs(d);
            const double x = ad / (am + std::sqrt(mm + 3.0 * dd) + 1e-300);
            const double top = (1.0 - x * x) * (am + ad * x);
            return top * top <= room ? 1.0 : top * top / room;
        } else {
            const double am = std::abs(m), ad = std::abs(d);
            const double x = ad / (am + std::sqrt(m * m + 3.0 * d * d) + 1e-300);
            const double top = (1.0 - x * x) * (am + ad * x) * 0.25;
            const point v1 = d1 - c, v2 = v1 - d3;
            const double n1 = dot(v1, v1), n2 = dot(v2, v2);
            double bound = (n1 > n2 ? n1 : n2) * h * h / 16.0;
            if (bound <= tt) return 1.0;
            if (cc > 0.0) {
                const double first = dot(d1, c) / 3.0, second = (2.0 * dot(d1, c) + dot(d2, c)) / 3.0;
                double beyond = 0.0;
                if (first < 0.0 || second < 0.0 || first > cc || second > cc) {
                    const double low = (first < 0.0 ? first : 0.0) + (second < 0.0 ? second : 0.0);
                    const double high = (first > cc ? first - cc : 0.0) + (second > cc ? second - cc : 0.0);
                    beyond = (-low > high ? -low : high) * (4.0 / 9.0) * h;
                }
                const double squared = (top * top + beyond * beyond) / cc;
                bound = squared < bound ? squared : bound;
            }
            return bound <= tt ? 1.0 : bound / tt;
        }
    }
};

template <int samples>
struct density_table {
    float density[samples];
    float sum[samples];
    double start, cell;
    float whole;
    int i = 0;

    density_table(const cubic_form& q, double ta, double tb, double size, double scale) noexcept
    {
        const double one = 1.0 / size;
        const point c1 = one * q.c1, c2 = one * q.c2, c3 = one * q.c3;
        const float k0 = static_cast<float>(2.0 * cross(c1, c2)), k1 = static_cast<float>(6.0 * cross(c1, c3)),
                    k2 = static_cast<float>(6.0 * cross(c2, c3));
        const float x0 = static_cast<float>(c1.x), x1 = static_cast<float>(2.0 * c2.x), x2 = static_cast<float>(3.0 * c3.x);
        const float y0 = static_cast<float>(c1.y), y1 = static_cast<float>(2.0 * c2.y), y2 = static_cast<float>(3.0 * c3.y);
        start = ta;
        cell = (tb - ta) / (samples - 1);
        const float fscale = static_cast<float>(scale * cell), fta = static_cast<float>(ta), fcell = static_cast<float>(cell);
        for (int j = 0; j < samples; ++j) {
            const float t = fta + static_cast<float>(j) * fcell;
            const float dx = x0 + t * (x1 + t * x2), dy = y0 + t * (y1 + t * y2), k = k0 + t * (k1 + t * k2);
            const float n = dx * dx + dy * dy + 1e-12f;
            density[j] = fscale * std::abs(k) * inverse_fourth_root(k * k * n);
        }
        float s = 0.0f;
        sum[0] = 0.0f;
        for (int j = 0; j + 1 < samples; ++j) {
            s += 0.5f * (density[j] + density[j + 1]);
            sum[j + 1] = s;
        }
        whole = s;
    }
    [[nodiscard]] double t_of(float share) noexcept
    {
        while (i + 2 < samples && share > sum[i + 1]) ++i;
        const float rest = share - sum[i], rise = density[i + 1] - density[i];
        const float root = std::sqrt(std::abs(density[i] * density[i] + 2.0f * rise * rest));
        return start + cell * (static_cast<float>(i) + 2.0f * rest / (density[i] + root + 1e-30f));
    }
    [[nodiscard]] float share_of(double t) const noexcept
    {
        const float at = static_cast<float>((t - start) / cell);
        int j = static_cast<int>(at);
        if (j > samples - 2) j = samples - 2;
        const float x = at - static_cast<float>(j);
        return sum[j] + x * (density[j] + 0.5f * x * (density[j + 1] - density[j]));
    }
};

/// Emits the points of (ta, tb), not tb itself.
template <bool tame, class Shares, class Emit>
void walk_evenly(const cubic_form& w, Shares&& shares, double ta, double tb, double sure_step, Emit&& emit) noexcept
{
    const float most = static_cast<float>(std::ceil((tb - ta) / sure_step));
    float pieces = std::ceil(shares.whole - static_cast<float>(SLACK));
    pieces = pieces < 2.0f ? 2.0f : pieces;
    if (!(pieces < most)) {
        const double step = (tb - ta) / most;
        const int n = static_cast<int>(most);
        for (int i = 1; i < n; ++i) {
            const double t = ta + step * i;
            emit(w.at(t), t);
        }
        return;
    }
    double u = ta;
    float done = 0.0, share = shares.whole / pieces;
    for (;;) {
        float aim = done + share;
        double v = pieces > 1.0f ? shares.t_of(aim) : tb;
        for (int tries = 0;; ++tries) {
            if (!(v - u > sure_step)) {  // always good, by Wang's bound
                v = u + sure_step;
                aim = shares.share_of(v);
                pieces = std::ceil(shares.whole - aim - static_cast<float>(SLACK)) + 1.0f;
                pieces = pieces < 2.0f ? 2.0f : pieces;
                share = (shares.whole - aim) / (pieces - 1.0f);
                break;
            }
            const double excess = w.template excess<tame>(u, v);
            if (excess <= 1.0) break;
            const double shrink = 1.0 / std::sqrt(std::sqrt(excess));
            if (shrink < GROW) {
                pieces += 1.0f;
                v = u + (v - u) * (shrink < 0.25 ? 0.25 : shrink) * SAFE;
            } else {
                v = u + (v - u) * shrink * SAFE;
                if (pieces < 2.0f) pieces = 2.0f;
            }
            if (tries > 8) v = u;
            aim = shares.share_of(v);
            share = (shares.whole - aim) / (pieces - 1.0f);
        }
        if (!(v < tb)) return;
        emit(w.at(v), v);
        u = v;
        done = aim;
        pieces -= 1.0f;
        if (pieces < 1.0f) pieces = 1.0f;
    }
}

}  // namespace detail

struct certified {
    template <class Emit>
    void operator()(const quadratic& q, double tolerance, Emit&& emit) const noexcept
    {
        tolerance *= 1.0 - 0x1p-20;
        const double tt = tolerance * tolerance;
        const point b = q.p1 - q.p0, e = q.p2 - q.p1, a = e - b, c = q.p2 - q.p0;
        const double k = cross(b, e), cc = dot(c, c), be = dot(b, e);
        const double aa = dot(a, a), kk = k * k;
        if (!(be >= 0.0)) return wild(raised(q), tolerance, emit);
        if (kk <= 4.0 * tt * cc) return emit(q.p2, 1.0);
        if (aa <= 256.0 * tt) {
            emit(0.25 * (q.p0 + q.p2) + 0.5 * q.p1, 0.5);
            return emit(q.p2, 1.0);
        }
        // Three nodes of Gauss's: within ...
        const double one = 1.0 / aa;
        const double ba = dot(b, a);
        float integral = 0.0f;
        {
            const float n0 = static_cast<float>(dot(b, b) * one), n1 = static_cast<float>(2.0 * ba * one);
            constexpr float t0 = 0.1127017f, t2 = 0.8872983f;
            integral = (5.0f / 18.0f) * (detail::inverse_fourth_root(n0 + t0 * (n1 + t0)) + detail::inverse_fourth_root(n0 + t2 * (n1 + t2))) +
                       (8.0f / 18.0f) * detail::inverse_fourth_root(n0 + 0.5f * (n1 + 0.5f));
        }
        // rho = sqrt(K/(4 tol |b + at|)) = sqrt(K/(4 tol |a|)) n^(-1/4)
        const double full = 16.0 * tt * aa * (aa * aa) / (kk * kk);  // lambda^2
        const double shares = integral / std::sqrt(std::sqrt(full)) * aa / std::abs(k);
        double pieces = std::ceil(shares - 0.02);
        pieces = pieces < 2.0 ? 2.0 : pieces;
        double ratio = shares / pieces;
        ratio *= ratio;
        ratio *= ratio;
        double aim = full * (ratio < 1.0 ? ratio : 1.0);
        // x = (ba + aa t)/K
        const double rate = aa / std::abs(k), inverse_rate = std::abs(k) * one, x0 = ba / std::abs(k), x1 = x0 + rate;
        double x = x0;
        double d = std::sqrt(std::sqrt(aim * (1.0 + x * x)));
        {
            const double m = x + 0.5 * d, dd = d * d;
            d -= (dd * dd - aim * (1.0 + m * m)) / (4.0 * dd * d - aim * m);
        }
        double last = d;
        for (;;) {
            const double m = x + 0.5 * d, dd = d * d;
            double next = d - (dd * dd - aim * (1.0 + m * m)) / (4.0 * dd * d - aim * m);
            pieces -= 1.0;
            if (!(pieces > 0.0)) {
                const double rest = x1 - x, mid = 0.5 * (x1 + x);
                if (rest * rest * (rest * rest) <= full * (1.0 + mid * mid)) break;
                aim = full;
            }
            for (;;) {
                const double mid = x + 0.5 * next;
                if (next * next * (next * next) <= full * (1.0 + mid * mid)) break;
                next *= 0.99;
            }
            x += next;
            if (!(x < x1)) break;
            const double t = (x - x0) * inverse_rate;
            emit(q.p0 + t * (2.0 * b + t * a), t);
            d = 2.0 * next - last;
            last = next;
        }
        emit(q.p2, 1.0);
    }

    template <class Emit>
    void operator()(const cubic& q, double tolerance, Emit&& emit) const noexcept
    {
        tolerance *= 1.0 - 0x1p-20;
        const double tt = tolerance * tolerance;
        const point l0 = q.p1 - q.p0, l1 = q.p2 - q.p1, l2 = q.p3 - q.p2, c = q.p3 - q.p0;
        if (!(dot(l0, l1) >= 0.0 && dot(l1, l2) >= 0.0 && dot(l0, l2) >= 0.0)) return wild(q, tolerance, emit);
        const double d1 = cross(c, l0), d2 = cross(l2, c);
        const double m = 1.5 * (d2 - d1), d = 0;
        (void)m; (void)d;
        const point s0 = l1 - l0, s1 = l2 - l1;
        const double b0 = dot(s0, s0), b1 = dot(s1, s1), bend = b0 > b1 ? b0 : b1;
        const detail::cubic_form w{q.p0, 3.0 * l0, 3.0 * s0, s1 - s0, tt};
        if (w.excess<true>(0.0, 1.0) <= 1.0) return emit(q.p3, 1.0);
        if (bend * 0.5625 <= 16.0 * tt) {
            emit(0.125 * (q.p0 + q.p3) + 0.375 * (q.p1 + q.p2), 0.5);
            return emit(q.p3, 1.0);
        }
        walk<true>(w, 0.0, 1.0, tolerance, std::sqrt(bend), emit);
        emit(q.p3, 1.0);
    }

private:
    template <bool tame, class Emit>
    static void walk(const detail::cubic_form& w, double ta, double tb, double tolerance, double bend, Emit&& emit) noexcept
    {
        const double sure = std::sqrt(tolerance / (0.75 * bend));
        const double size = bend;
        const double scale = std::sqrt(size / (8.0 * tolerance));
        if (sure > 0.05)
            detail::walk_evenly<tame>(w, detail::density_table<8>{w, ta, tb, size, scale}, ta, tb, sure, emit);
        else
            detail::walk_evenly<tame>(w, detail::density_table<16>{w, ta, tb, size, scale}, ta, tb, sure, emit);
    }
    template <class Emit>
    static void wild(const cubic& q, double tolerance, Emit&& emit) noexcept
    {
        const double tt = tolerance * tolerance;
        const point l0 = q.p1 - q.p0, l1 = q.p2 - q.p1, l2 = q.p3 - q.p2;
        const point s0 = l1 - l0, s1 = l2 - l1;
        const double b0 = dot(s0, s0), b1 = dot(s1, s1), bend = b0 > b1 ? b0 : b1;
        const detail::cubic_form w{q.p0, 3.0 * l0, 3.0 * s0, s1 - s0, tt};
        if (w.excess<false>(0.0, 1.0) <= 1.0) return emit(q.p3, 1.0);
        walk<false>(w, 0.0, 1.0, tolerance, std::sqrt(bend), emit);
        emit(q.p3, 1.0);
    }
};
static_assert(discretiser<certified>);

}  // namespace typemesh
