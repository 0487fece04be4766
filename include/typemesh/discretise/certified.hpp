// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/discretise/discretiser.hpp>
#include <typemesh/discretise/impl/chord.hpp>

#include <cmath>

namespace typemesh::inline TYPEMESH_ABI {

/// The default discretiser: (almost) as few chords as the tolerance allows, and a proof for every chord.
///
///             o---------o         Points divide the integral of sqrt(|B' x B''| / (8 tolerance |B'|)) equally: all
///         o                 o     pieces have equal error, and pieces are shorter where the curve bends more. Then
///       o                    o    every piece is measured. If one is too long, it is shortened, and the rest of the
///      o                     o    curve is divided again.
///
/// Promise  No point of the curve is farther than `tolerance` from its own chord. This holds for every curve: loops,
///          cusps, curves that double back beyond their ends, coincident control points, zero length. Chords are held
///          to (1 - 2^-20) times the tolerance. This rounding margin is sufficient if the tolerance is above 2^-28 of
///          the coordinates.
/// Count    On real fonts, the number of chords is within 1 % of the minimum (for points on the curve), and within 2 %
///          for hairpins and the S-curves of handwriting. It never exceeds Wang's bound, except for corners.
/// Corners  Where the curve stops and turns, a point is emitted even if the tolerance does not require one, because
///          walls need a hard corner there. B' vanishes at this t, rounded to a float.
/// Limit    At most 65,536 points lie between two corners. Only a tolerance below 2^-31 of the curve's size would need
///          more points. discretise() never passes so small a tolerance, because its grid is coarser. Beyond the limit,
///          points lie at equal steps of t, and the tolerance is not kept.
/// Cost     At 1/800 em, up to 1.5 times the cost of equal steps of t for quadratics, two to three times for cubics; no
///          allocation, no transcendental function.
///
/// Precondition: the curve is finite and `tolerance` is positive.
///
/// This work is based on: R. Goldman, Pyramid Algorithms (2003), 5.6.3, for Wang's bound: pieces shorter than
/// sqrt(8 tolerance / (d(d-1) max|second difference|)) need no measurement; R. Levien, "Flattening quadratic Beziers"
/// (2019), for the density.
struct certified {
    static constexpr double shortest_step = 0x1p-16;  ///< the shortest step of t

    template <class Put>
    void operator()(const quadratic& q, double tolerance, Put&& put) const noexcept
    {
        TYPEMESH_ASSERT(tolerance > 0.0, "a discretiser's tolerance must be positive");
        const point b = q.p1 - q.p0, e = q.p2 - q.p1;
        if (!(dot(b, e) >= 0.0)) [[unlikely]]
            return turning(q, tolerance, put);

        tolerance *= kept_share;
        const double tt = tolerance * tolerance;
        const point c = q.p2 - q.p0, a = e - b;
        const double k = cross(b, e), bend = quadratic_bend * dot(a, a);
        if (k * k <= 4.0 * tt * dot(c, c)) return put(q.p2, 1.0);
        if (bend <= pieces(2) * tt) {
            put(0.25 * (q.p0 + q.p2) + 0.5 * q.p1, 0.5);
            return put(q.p2, 1.0);
        }
        const detail::quadratic_chords chords{q.p0, b, a, k * k, tt};
        if (bend <= pieces(4) * tt && few(chords, bend <= pieces(3) * tt ? 3 : 4, put)) return put(q.p2, 1.0);
        point_placer{chords, tolerance, bend, put}.between(0.0, 1.0);
        put(q.p2, 1.0);
    }

    template <class Put>
    void operator()(const cubic& q, double tolerance, Put&& put) const noexcept
    {
        TYPEMESH_ASSERT(tolerance > 0.0, "a discretiser's tolerance must be positive");
        const point l0 = q.p1 - q.p0, l1 = q.p2 - q.p1, l2 = q.p3 - q.p2;
        if (!(dot(l0, l1) >= 0.0 && dot(l1, l2) >= 0.0 && dot(l0, l2) >= 0.0)) [[unlikely]]
            return wild(q, tolerance, put);

        tolerance *= kept_share;
        const double tt = tolerance * tolerance;
        const point s0 = l1 - l0, s1 = l2 - l1;
        const detail::cubic_chords<true> chords{q.p0, 3.0 * l0, 3.0 * s0, s1 - s0, tt};
        if (chords.fits_exactly(0.0, 1.0)) return put(q.p3, 1.0);
        const double bend = cubic_bend * greater(dot(s0, s0), dot(s1, s1));
        if (bend <= pieces(2) * tt || (bend <= halves_tried * tt && chords.fits(0.0, 0.5) && chords.fits(0.5, 1.0))) {
            put(0.125 * (q.p0 + q.p3) + 0.375 * (q.p1 + q.p2), 0.5);
            return put(q.p3, 1.0);
        }
        if (bend <= pieces(4) * tt && few(chords, bend <= pieces(3) * tt ? 3 : 4, put)) return put(q.p3, 1.0);
        point_placer{chords, tolerance, bend, put}.between(0.0, 1.0);
        put(q.p3, 1.0);
    }

private:
    static constexpr double kept_share = 1.0 - 0x1p-20;  // of the tolerance; the rest is a margin for rounding

    // By Wang's bound, n pieces suffice if bend <= pieces(n) * tolerance^2; this test needs no root. The bend is the
    // largest squared second difference of the control points, times (d(d-1)/8)^2 for degree d.
    static constexpr double quadratic_bend = 0.0625, cubic_bend = 0.5625;
    [[nodiscard]] static constexpr double pieces(int n) noexcept { return double(n) * n * n * n; }

    static constexpr double halves_tried = 40.0;  // = pieces(2.5): up to here two equal pieces often suffice
    static constexpr double four_samples_do = 1024.0, eight_samples_do = 0x1p17;  // = pieces(5.7), pieces(19)
    static constexpr double at_an_end = 0x1p-20;                                  // no stop is nearer to an end

    [[nodiscard]] static double greater(double a, double b) noexcept { return a > b ? a : b; }

    /// Emits the inner points without a table if Wang's bound is 3 or 4, which is the value of `most`. The bound is 3
    /// or 4 for the majority of the curves in a text. The errors of the two halves give the number of points. If it is
    /// below Wang's bound, the points are denser in the half with the larger error. Returns false if a chord is too
    /// long, or if a cubic changes its bending direction.
    template <class Chords, class Put>
    static bool few(const Chords& chords, int most, Put& put) noexcept
    {
        constexpr float worth_trying = 0.93f;  // pieces below Wang's bound; this and the next value are fitted to fonts
        constexpr float two_do = 2.04f;        // pieces, by the estimate
        if (chords.turns_over()) return false;
        const float left = chords.inverse_share(0.0, 0.5), right = chords.inverse_share(0.5, 1.0);
        const float sum = left + right, product = left * right;  // sum over product: approximately the number of pieces
        if (sum > (static_cast<float>(most) - worth_trying) * product) {
            const double step = most == 3 ? 1.0 / 3.0 : 0.25;
            for (int i = 1; i < most; ++i) put(chords.at(step * i), step * i);
            return true;
        }
        if (sum <= two_do * product) {
            const float half = left < right ? 0.25f + 0.25f * left / right : 0.75f - 0.25f * right / left;
            const double t = static_cast<double>(half);
            if (!(chords.fits_exactly(0.0, t) && chords.fits_exactly(t, 1.0))) return false;
            put(chords.at(t), t);
            return true;
        }
        if (most == 3) return false;
        const float lean = 2.0f * (left - right) / sum;
        float first = 1.0f / 3.0f + lean * (2.0f / 9.0f), second = 2.0f / 3.0f + lean * (2.0f / 9.0f);
        for (int i = 0; i < 2; ++i) {
            first = 1.0f / 3.0f + lean * (first - first * first);
            second = 2.0f / 3.0f + lean * (second - second * second);
        }
        const double u = static_cast<double>(first), v = static_cast<double>(second);
        bool good = (0.0 < u) & (u < v) & (v < 1.0);
        good = good & chords.fits(0.0, u);
        good = good & chords.fits(u, v);
        good = good & chords.fits(v, 1.0);
        if (!good) return false;
        put(chords.at(u), u);
        put(chords.at(v), v);
        return true;
    }

    /// Places the inner points of one curve, or of its pieces.
    template <class Chords, class Put>
    class point_placer {
    public:
        point_placer(const Chords& chords, double tolerance, double bend, Put& put) noexcept
            : chords_{chords}, tolerance_{tolerance}, bend_{bend}, put_{put}
        {
        }

        /// Emits the inner points of (from, to). Uses a finer table for curves that need more points.
        void between(double from, double to) const noexcept
        {
            const double tt = tolerance_ * tolerance_;
            if (bend_ < four_samples_do * tt)  // without a root: its result would come late
                between(detail::share_table<4>{chords_, from, to, tolerance_}, from, to);
            else if (bend_ < eight_samples_do * tt)
                between(detail::share_table<8>{chords_, from, to, tolerance_}, from, to);
            else
                between(detail::share_table<16>{chords_, from, to, tolerance_}, from, to);
        }

        template <class Shares>
        void place(const Shares& shares, double from, double to) const noexcept
        {
            constexpr int most = 65536;
            const double wang4 = bend_ / (tolerance_ * tolerance_);  // Wang's bound to the fourth power, for the curve
            const float whole = shares.whole();
            const int pieces = !(whole < static_cast<float>(most)) ? most
                               : whole > 1.0f                      ? static_cast<int>(whole) + 1
                                                                   : 2;
            const double count = static_cast<double>(pieces), length = to - from;
            const double cc = count * count, ll = length * length;  // powers, because the root of wang4 would come late
            if (!(cc * cc < wang4 * (ll * ll)))                     // at least Wang's bound: no proof needed
                return place_evenly(from, to, sure_step(wang4));
            const float share = whole / static_cast<float>(pieces);

            constexpr int chunk = 16;  // three loops (place, measure, emit) are faster than one
            double t[chunk + 1];
            t[0] = from;
            for (int done = 0;;) {
                const int left = pieces - done, now = left <= chunk ? left : chunk;
                for (int i = 1; i <= now; ++i) t[i] = shares.t_of(share * static_cast<float>(done + i));
                if (now == left) t[now] = to;
                bool good = t[now] <= to;
                for (int i = 0; i < now; ++i) good = good & (t[i] < t[i + 1]) & chords_.fits(t[i], t[i + 1]);
                if (!good) [[unlikely]]
                    return place_carefully(shares, {t[0], share * static_cast<float>(done), left}, to,
                                           sure_step(wang4));
                const int inner = now == left ? now - 1 : now;
                for (int i = 1; i <= inner; ++i) put_(chords_.at(t[i]), t[i]);
                if (now == left) return;
                t[0] = t[now];
                done += now;
            }
        }

    private:
        struct progress {
            double t;     // the last point
            float spent;  // the curve's share up to there
            int pieces;   // the rest is divided into so many pieces
        };

        template <class Shares>
        void between(const Shares& shares, double from, double to) const noexcept
        {
            const double middle = chords_.inflection(from, to);
            if (middle > from && place_across(shares, from, middle, to)) return;
            place(shares, from, to);
        }

        /// Pieces whose step of t is this or less always keep the tolerance (Wang's bound), without a measurement.
        [[nodiscard]] static double sure_step(double wang4) noexcept
        {
            return greater(1.0 / std::sqrt(std::sqrt(wang4)), shortest_step);
        }

        void place_evenly(double from, double to, double sure) const noexcept
        {
            const int most = static_cast<int>(std::ceil((to - from) / sure));
            const double step = (to - from) / most;
            for (int i = 1; i < most; ++i) {
                const double t = from + step * i;
                put_(chords_.at(t), t);
            }
        }

        /// Places points so that one chord crosses the inflection. This chord can be long, because the curve lies first
        /// on one side of the chord and then on the other. With the inflection in its middle, the chord is two reaches
        /// long. Returns false if this saves no chord, or if a chord is too long.
        template <class Shares>
        bool place_across(const Shares& shares, double from, double middle, double to) const noexcept
        {
            constexpr int most = 16;
            constexpr float reach = 0.93f;  // of a chord from the inflection to either side, in shares; fitted to fonts
            constexpr float stretch = 2.0f * reach;
            const float whole = shares.whole();
            if (!(whole < static_cast<float>(most))) return false;
            const float centre = shares.share_of(middle);
            const float low = centre > reach ? centre - reach : 0.0f,
                        high = centre + reach < whole ? centre + reach : whole;
            const float spared = (high - low) * (1.0f - 1.0f / stretch), wanted = whole - spared;
            const int pieces = wanted > 1.0f ? static_cast<int>(wanted) + 1 : 2;
            if (static_cast<float>(pieces) >= whole) return false;  // no gain

            const float share = (whole - spared) / static_cast<float>(pieces);
            double t[most + 1];
            t[0] = from;
            for (int i = 1; i < pieces; ++i) {
                const float even = share * static_cast<float>(i);
                t[i] = shares.t_of(even < low             ? even
                                   : even + spared < high ? low + (even - low) * stretch
                                                          : even + spared);
            }
            t[pieces] = to;
            bool good = true;
            for (int i = 0; i < pieces; ++i) good = good & (t[i] < t[i + 1]) & chords_.fits_exactly(t[i], t[i + 1]);
            if (!good) return false;
            for (int i = 1; i < pieces; ++i) put_(chords_.at(t[i]), t[i]);
            return true;
        }

        /// Places one piece at a time: the longest good piece, but not longer than its share of the rest.
        template <class Shares>
        void place_carefully(const Shares& shares, progress at, double to, double sure) const noexcept
        {
            for (;;) {
                float aim = at.spent + (shares.whole() - at.spent) / static_cast<float>(at.pieces);
                const double aimed = at.pieces > 1 ? shares.t_of(aim) : to;
                const auto [v, as_aimed] = longest_good(at.t, aimed < to ? aimed : to, sure);
                if (!(v < to)) return;
                put_(chords_.at(v), v);
                if (as_aimed) {
                    --at.pieces;
                } else {
                    aim = shares.share_of(v);
                    const float rest = shares.whole() - aim;
                    at.pieces = rest > 1.0f ? static_cast<int>(rest) + 1 : 1;
                }
                at.t = v;
                at.spent = aim;
            }
        }

        struct piece_end {
            double t;
            bool as_aimed;
        };

        /// The end of the piece that starts at u: v or an earlier t. Errors grow with the square of a piece's length.
        [[nodiscard]] piece_end longest_good(double u, double v, double sure) const noexcept
        {
            constexpr int max_tries = 8;
            constexpr double least_shrink = 0.25, less_than_computed = 0.998;
            for (int tries = 0; v - u > sure && tries <= max_tries; ++tries) {
                const double excess = chords_.excess(u, v);
                if (excess <= 1.0) return {v, tries == 0};
                v = u + (v - u) * greater(less_than_computed / std::sqrt(std::sqrt(excess)), least_shrink);
            }
            return {u + sure, false};
        }

        const Chords& chords_;
        double tolerance_;
        double bend_;
        Put& put_;
    };

    /// For a quadratic that turns by more than 90 degrees. It can stop only where its first derivative is perpendicular
    /// to its second.
    template <class Put>
    static void turning(const quadratic& q, double tolerance, Put& put) noexcept
    {
        const point b = q.p1 - q.p0, a = (q.p2 - q.p1) - b;
        const double t = -dot(a, b) / dot(a, a);
        double stops[4] = {t, 1.0};
        const bool inside = t > at_an_end && t < 1.0 - at_an_end;
        const bool stopped = inside && tangents_at(curve::from(q), static_cast<double>(static_cast<float>(t))).stops;
        between_stops(raised(q), tolerance, stops, stopped ? 1 : 0, put);
    }

    /// For a cubic that turns by more than 90 degrees, or that may stop and turn.
    template <class Put>
    static void wild(const cubic& q, double tolerance, Put& put) noexcept
    {
        double stops[4];
        const int count = find_stops(q, stops);
        between_stops(q, tolerance, stops, count, put);
    }

    /// Splits a curve where it stops and turns.
    template <class Put>
    static void between_stops(const cubic& q, double tolerance, double (&stops)[4], int count, Put& put) noexcept
    {
        tolerance *= kept_share;
        const point l0 = q.p1 - q.p0, l1 = q.p2 - q.p1, l2 = q.p3 - q.p2, s0 = l1 - l0, s1 = l2 - l1;
        const detail::cubic_chords<false> chords{q.p0, 3.0 * l0, 3.0 * s0, s1 - s0, tolerance * tolerance};
        const double bend = cubic_bend * greater(dot(s0, s0), dot(s1, s1));
        stops[count] = 1.0;
        double from = 0.0;
        for (int i = 0; i <= count; ++i) {
            const double to = stops[i];
            if (!(chords.excess(from, to) <= 1.0)) point_placer{chords, tolerance, bend, put}.between(from, to);
            if (i < count) put(q.at(to), to);
            from = to;
        }
        put(q.p3, 1.0);
    }

    /// Finds where the derivative vanishes between the ends, in ascending order; at most 3 values.
    ///
    /// |B'|^2 has its minima where B' * B'' = 0, a cubic equation. Its roots are bisected between the extremes of that
    /// cubic, with a few steps at first: hardly any root is a stop.
    [[nodiscard]] static int find_stops(const cubic& q, double (&stops)[4]) noexcept
    {
        constexpr int max_steps = 64, early = 10;
        // As a fraction of the longest leg's square: after the early steps B'/3 moves by less than 2^-8 of that leg.
        constexpr double hardly_slow = 0x1p-14;
        const point d0 = q.p1 - q.p0, l1 = q.p2 - q.p1, l2 = q.p3 - q.p2;
        const point d1 = l1 - d0, d2 = (l2 - l1) - d1;  // B'/3 = d0 + 2 d1 t + d2 t^2
        const double g0 = dot(d0, d1), g1 = 2.0 * dot(d1, d1) + dot(d0, d2), g2 = 3.0 * dot(d1, d2), g3 = dot(d2, d2);
        const auto slope = [=](double t) noexcept { return g0 + t * (g1 + t * (g2 + t * g3)); };
        const auto speed = [=](double t) noexcept {
            const point v = d0 + t * (2.0 * d1 + t * d2);
            return dot(v, v);
        };
        const double longest = greater(dot(d0, d0), greater(dot(l1, l1), dot(l2, l2)));

        double border[4] = {0.0, 1.0, 1.0, 1.0};  // 0, the extremes of the slope inside, 1
        int borders = 1;
        const double square = g2 * g2 - 3.0 * g3 * g1;
        if (square > 0.0) {
            const double root = std::sqrt(square), far_end = -(g2 < 0.0 ? g2 - root : g2 + root);
            double first = !is_zero(g3) ? far_end / (3.0 * g3) : 2.0, last = !is_zero(far_end) ? g1 / far_end : 2.0;
            if (last < first) {
                const double swapped = first;
                first = last;
                last = swapped;
            }
            if (first > 0.0 && first < 1.0) border[borders++] = first;
            if (last > 0.0 && last < 1.0 && last > first) border[borders++] = last;
        }
        border[borders] = 1.0;

        int count = 0;
        for (int i = 0; i < borders; ++i) {
            double low = border[i], high = border[i + 1];
            const bool rising = slope(low) < 0.0;
            if (rising == (slope(high) < 0.0)) continue;
            for (int step = 0; step < max_steps; ++step) {
                const double mid = 0.5 * (low + high);
                if (step == early && speed(mid) > longest * hardly_slow) break;
                if (!(mid > low && mid < high)) break;
                ((slope(mid) < 0.0) == rising ? low : high) = mid;
            }
            const double stop = speed(low) < speed(high) ? low : high;
            const double stored = static_cast<double>(static_cast<float>(stop));
            const bool inside = stop > at_an_end && stop < 1.0 - at_an_end && (count == 0 || stop > stops[count - 1]);
            if (inside && tangents_at(curve::from(q), stored).stops) stops[count++] = stop;
        }
        return count;
    }
};
static_assert(discretiser<certified>);

}  // namespace typemesh::inline TYPEMESH_ABI
