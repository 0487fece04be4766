// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/curve.hpp>
#include <typemesh/core/impl/same.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// z^(-1/4) within 0.11 % for normal z > 0, without a root or a division: an initial guess from the exponent's bits,
/// and one Newton step whose two constants were fitted together with the guess. For z = 0 the result is some large
/// number.
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

// The types below hold curves in a form that quickly answers two questions about a piece [u, v]:
//
//     fits(u, v)      Is the piece within the tolerance of its chord? May be false for a piece that barely fits.
//     excess(u, v)    1 if the piece fits; otherwise (error / tolerance)^2, or an upper bound on it
//
// and one about the whole curve: sample() computes the point density of a fine polyline with equal errors,
// sqrt(|B' x B''| / (8 tolerance |B'|)), times the step, at equal steps of t. Densities are estimates in float; fits
// and excess are proofs.
//
// If the derivative of a piece never turns by more than 90 degrees ("tame"), the piece stays in the strip over its
// chord, and its distance from the chord is its offset from the chord's line. Let w be the middle of the piece,
// h = v - u and t = w + xh/2. Then:
//
//     chord / h = B'(w) + B'''h^2/24         offset = (1 - x^2) h^2/4 |M + xD| / |chord / h|
//     M = B' x B''/2 - h^2/4 (B''/2 x B'''/6)        D = h/2 (B' x B'''/6)            (all at w; D = 0 for a quadratic)

/// B(t) = p0 + 2bt + at^2, tame.
struct quadratic_chords {
    point p0, b, a;
    double kk;  ///< (b x a)^2
    double tt;  ///< tolerance^2

    [[nodiscard]] point at(double t) const noexcept { return p0 + t * (2.0 * b + t * a); }

    [[nodiscard]] bool fits(double u, double v) const noexcept
    {
        const double h = v - u, hh = h * h;
        const point c = b + (0.5 * (u + v)) * a;
        return hh * hh * kk <= 16.0 * tt * dot(c, c);
    }

    [[nodiscard]] double excess(double u, double v) const noexcept
    {
        const double h = v - u, hh = h * h;
        const point c = b + (0.5 * (u + v)) * a;
        const double error = hh * hh * kk, room = 16.0 * tt * dot(c, c);
        return error <= room ? 1.0 : error / room;
    }

    // Cubics need more work for these three; see there.
    [[nodiscard]] bool fits_exactly(double u, double v) const noexcept { return fits(u, v); }
    [[nodiscard]] static constexpr bool turns_over() noexcept { return false; }
    [[nodiscard]] static constexpr double inflection(double u, double) noexcept { return u; }

    /// The reciprocal of the number of pieces that [u, v] needs, approximately.
    [[nodiscard]] float inverse_share(double u, double v) const noexcept
    {
        const double h = v - u, hh = h * h;
        const point c = b + (0.5 * (u + v)) * a;
        return inverse_fourth_root(static_cast<float>(hh * hh * kk / (16.0 * tt * dot(c, c) + 1e-300)) + 1e-30f);
    }

    template <int samples>
    void sample(float* density, double from, double step, double tolerance) const noexcept
    {
        const double size = std::abs(b.x) + std::abs(b.y) + std::abs(a.x) + std::abs(a.y);
        const double one = 1.0 / (size * size);
        const float n0 = static_cast<float>(dot(b, b) * one), n1 = static_cast<float>(2.0 * dot(a, b) * one),
                    n2 = static_cast<float>(dot(a, a) * one);
        const float scale = static_cast<float>(step * std::sqrt(std::sqrt(kk) / (4.0 * tolerance * size)));
        const float t0 = static_cast<float>(from), dt = static_cast<float>(step);
        for (int j = 0; j < samples; ++j) {
            const float t = t0 + static_cast<float>(j) * dt;
            density[j] = scale * inverse_fourth_root(n0 + t * (n1 + t * n2) + 1e-12f);
        }
    }
};

/// B(t) = p0 + c1 t + c2 t^2 + c3 t^3. If not `tame`, pieces may also extend past the ends of their chords.
template <bool tame>
struct cubic_chords {
    point p0, c1, c2, c3;
    double tt;  ///< tolerance^2
    double k12 = cross(c1, c2), k13 = cross(c1, c3), k23 = cross(c2, c3);

    [[nodiscard]] point at(double t) const noexcept { return p0 + t * (c1 + t * (c2 + t * c3)); }

    [[nodiscard]] bool fits(double u, double v) const noexcept
    {
        if constexpr (tame) {
            const piece p{*this, u, v};
            return p.surely_fits();
        } else {
            return excess(u, v) <= 1.0;
        }
    }

    /// Like fits, but it accepts every good piece of a tame curve.
    [[nodiscard]] bool fits_exactly(double u, double v) const noexcept
    {
        if constexpr (!tame) return fits(u, v);
        const piece p{*this, u, v};
        if (p.mm > p.room) return false;
        if (p.surely_fits()) return true;
        return p.offset() <= p.room;
    }

    [[nodiscard]] double excess(double u, double v) const noexcept
    {
        const piece p{*this, u, v};
        if constexpr (tame) {
            if (p.surely_fits()) return 1.0;
            if (p.mm > p.room) return p.mm / p.room;
            const double offset = p.offset();
            return offset <= p.room ? 1.0 : offset / p.room;
        } else {
            // There are two bounds; both hold for any curve. First: the distance between points of equal s on piece and
            // chord.
            const double h = p.h, hh = h * h;
            const point second = c2 + (3.0 * u) * c3;  // B(u + hs) - chord = s(s-1)(v1 + s (v2 - v1)),
            const point v1 = second + h * c3, v2 = second + (2.0 * h) * c3;  // both over h^2
            const double n1 = dot(v1, v1), n2 = dot(v2, v2);
            const double loose = (n1 > n2 ? n1 : n2) * hh * hh * 0.0625;
            if (loose <= tt) return 1.0;
            double bound = loose;
            // Second: the offset, and how far the piece may extend past the chord's ends, by its control points.
            const double cc = dot(p.c, p.c);
            if (cc > 0.0) {
                const point d1 = c1 + u * (2.0 * c2 + (3.0 * u) * c3), d2 = h * second;  // legs of the piece, over h
                const double first = dot(d1, p.c) / 3.0, next = (2.0 * dot(d1, p.c) + dot(d2, p.c)) / 3.0;
                const double below = (first < 0.0 ? first : 0.0) + (next < 0.0 ? next : 0.0);
                const double above = (first > cc ? first - cc : 0.0) + (next > cc ? next - cc : 0.0);
                const double out = (-below > above ? -below : above) * (4.0 / 9.0) * h;
                const double tight = (p.offset() * 0.0625 + out * out) / cc;
                bound = tight < loose ? tight : loose;
            }
            return bound <= tt ? 1.0 : bound / tt;
        }
    }

    /// Whether the curve bends in opposite directions at its start and at its end.
    [[nodiscard]] bool turns_over() const noexcept { return k12 * (k12 + 3.0 * (k13 + k23)) < 0.0; }

    /// The reciprocal of the number of pieces that [u, v] needs, approximately.
    [[nodiscard]] float inverse_share(double u, double v) const noexcept
    {
        const piece p{*this, u, v};
        return inverse_fourth_root(static_cast<float>((p.mm + 0.5 * p.dd) / (p.room + 1e-300)) + 1e-30f);
    }

    /// The inflection between the ends of [u, v]: where the curve changes from bending left to bending right, or the
    /// reverse. The result is u if there is no inflection, or if there are two.
    [[nodiscard]] double inflection(double u, double v) const noexcept
    {
        const double k0 = k12, k1 = 3.0 * k13, k2 = 3.0 * k23;  // B' x B'' / 2
        const double at_u = k0 + u * (k1 + u * k2), at_v = k0 + v * (k1 + v * k2);
        if (!((at_u < 0.0) != (at_v < 0.0))) return u;
        const double square = k1 * k1 - 4.0 * k0 * k2;
        const double root = std::sqrt(square > 0.0 ? square : 0.0), twice = -(k1 < 0.0 ? k1 - root : k1 + root);
        const double one = !is_zero(k2) ? twice / (2.0 * k2) : u, other = !is_zero(twice) ? 2.0 * k0 / twice : u;
        return u < one && one < v ? one : u < other && other < v ? other : u;
    }

    template <int samples>
    void sample(float* density, double from, double step, double tolerance) const noexcept
    {
        // In units of 8 tolerances: this needs no root, and no value of the curve that would come late.
        double one = 1.0 / (8.0 * tolerance), wide = step;
        const double size = dot(c1, c1) + dot(c2, c2) + dot(c3, c3);
        if (!(size * one * one < 0x1p36)) [[unlikely]] {  // float would overflow
            wide = step * std::sqrt(std::sqrt(size) * one);
            one = 1.0 / std::sqrt(size);
        }
        const double square = one * one;
        const float k0 = static_cast<float>(k12 * (2.0 * square)), k1 = static_cast<float>(k13 * (6.0 * square)),
                    k2 = static_cast<float>(k23 * (6.0 * square));
        const float x0 = static_cast<float>(c1.x * one), x1 = static_cast<float>(c2.x * (2.0 * one)),
                    x2 = static_cast<float>(c3.x * (3.0 * one));
        const float y0 = static_cast<float>(c1.y * one), y1 = static_cast<float>(c2.y * (2.0 * one)),
                    y2 = static_cast<float>(c3.y * (3.0 * one));
        const float scale = static_cast<float>(wide);
        const float t0 = static_cast<float>(from), dt = static_cast<float>(step);
        for (int j = 0; j < samples; ++j) {
            const float t = t0 + static_cast<float>(j) * dt, square_t = t * t;
            const float dx = (x0 + t * x1) + square_t * x2, dy = (y0 + t * y1) + square_t * y2;
            const float k = (k0 + t * k1) + square_t * k2;
            const float z = (k * k) * (dx * dx + dy * dy) + 1e-30f;
            density[j] = (scale * std::abs(k)) * inverse_fourth_root(z);  // sqrt(|k| / |B'|)
        }
    }

private:
    struct piece {
        double h, m, d, mm, dd, room;
        point c;  // chord / h

        piece(const cubic_chords& q, double u, double v) noexcept
        {
            h = v - u;
            const double w = 0.5 * (u + v), hh = h * h, quarter = 0.25 * hh;
            m = hh * (q.k12 + w * (3.0 * q.k13 + (3.0 * w) * q.k23) - quarter * q.k23);
            d = (0.5 * h * hh) * (q.k13 + (2.0 * w) * q.k23);
            c = q.c1 + (2.0 * w) * q.c2 + (3.0 * w * w + quarter) * q.c3;
            mm = m * m;
            dd = d * d;
            room = 16.0 * q.tt * dot(c, c);
        }

        /// Uses (1 - x^2)(|m| + |d|x) <= |m| + d^2/4|m|, without a root.
        [[nodiscard]] bool surely_fits() const noexcept
        {
            const double quick = mm + 0.25 * dd;
            return quick * quick <= mm * room;
        }

        /// The maximum of (1 - x^2)^2(|m| + |d|x)^2, where x solves a quadratic equation: the offset is a cubic with
        /// zeros at both ends.
        [[nodiscard]] double offset() const noexcept
        {
            const double am = std::abs(m), ad = std::abs(d);
            const double x = ad / (am + std::sqrt(mm + 3.0 * dd) + 1e-300);
            const double top = (1.0 - x * x) * (am + ad * x);
            return top * top;
        }
    };
};

/// A running integral of the density, and its inverse: the t at which a given share of the points is used up.
///
/// Samples lie in the middle of equal intervals of t. Within an interval the density is linear, with the slope between
/// the neighbouring samples. The inverse takes two steps of a fixed-point iteration, which avoids a root.
template <int samples>
class share_table {
public:
    static_assert(samples > 0 && samples % 4 == 0);

    template <class Chords>
    share_table(const Chords& chords, double from, double to, double tolerance) noexcept
        : start_{from}, step_{(to - from) / samples}
    {
        float density[count + 2];
        chords.template sample<samples>(density + 1, from + 0.5 * step_, step_, tolerance);
        density[0] = 2.0f * density[1] - density[2];
        density[samples + 1] = 2.0f * density[samples] - density[samples - 1];
        for (int j = 0; j < samples; ++j) {
            inverse_[j] = 1.0f / (density[j + 1] + 1e-30f);
            const float lean = 0.25f * (density[j + 2] - density[j]) * inverse_[j];
            lean_[j] = lean < -1.0f ? -1.0f : lean > 1.0f ? 1.0f : lean;
        }
        // Running sums, in pairs and fours: one by one they would take twice as long.
        sum_[0] = 0.0f;
        for (int j = 0; j < samples; j += 4) {
            const float* d = density + 1 + j;
            const float two = d[0] + d[1], three = two + d[2], four = two + (d[2] + d[3]);
            sum_[j + 1] = sum_[j] + d[0];
            sum_[j + 2] = sum_[j] + two;
            sum_[j + 3] = sum_[j] + three;
            sum_[j + 4] = sum_[j] + four;
        }
    }

    /// The number of pieces that the curve needs, approximately; not rounded.
    [[nodiscard]] float whole() const noexcept { return sum_[samples]; }

    /// The t of a share in 0 to whole(); it increases with the share.
    [[nodiscard]] double t_of(float share) const noexcept
    {
        int i = 0;
        for (int j = 1; j < samples; ++j) i += share > sum_[j] ? 1 : 0;  // no branch to mispredict
        const float even = (share - sum_[i]) * inverse_[i];
        float x = even + lean_[i] * (even - even * even);
        x = even + lean_[i] * (x - x * x);
        return start_ + step_ * static_cast<double>(static_cast<float>(i) + x);
    }

    [[nodiscard]] float share_of(double t) const noexcept
    {
        const float place = static_cast<float>((t - start_) / step_);
        int j = static_cast<int>(place);
        j = j > samples - 1 ? samples - 1 : j;
        const float x = place - static_cast<float>(j);
        return sum_[j] + (x - lean_[j] * (x - x * x)) / inverse_[j];
    }

private:
    static constexpr std::size_t count = samples;
    double start_, step_;
    float sum_[count + 1], inverse_[count], lean_[count];
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
