// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/intersection.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The work of a crossing_refinement for one glyph.
struct refinement_effort {
    std::uint32_t rounds = 0;     ///< how often curves were discretised more finely
    std::uint32_t curves = 0;     ///< the number of these curves
    std::uint32_t unsettled = 0;  ///< intersections accepted only because their curves cannot be made finer
    std::uint64_t pieces = 0;     ///< into which the contours were cut, all rounds together: see cap_builder
};

/// Distinguishes intersections of chords that their curves share from intersections that only discretising created, and
/// finds the curves to discretise more finely because of the latter.
///
///     curves      ``---..__        ``---..__       Two curves that pass each other, or cross at a small angle: their
///                 ___...---```     ___......___    chords may cross where the curves do not, or far from there.
///
///     chords      \__    __/       \___   ____
///                    \/\/              \_/     x   intersection
///
/// An intersection x is accepted if
///
///   1. both edges are lines, or the curves have the same control points (in either direction); or x is a point of one
///      curve and the other is a line: the drawing already has this intersection
///   2. the chords cross at so large an angle, so far from their ends, that the curves must cross nearby. A curve stays
///      in a strip around its chord, of half its width d <= tolerance. Two strips that cross at the angle w share
///      a parallelogram, whose corners are within (da + db) / sin w of x:
///
///              '.  '.   |        If (da + db) / sin w + d fits between x and the ends of both chords, each curve
///         ------'.--'.-----      enters through one side of the parallelogram and leaves through the opposite one: so
///          curve  '. x'.         they cross in it. With da = db = tolerance and sin w >= 1/2 that is within 4
///         ---------'.--'.--      tolerances.
///                    '.  '.
///   3. Newton's iteration from x, along the contours, reaches a common point of the curves within 4 tolerances; or
///      the curves come within half a cell of each other beside x (they touch, or run together)
///   4. both curves have been made finer six times, or the grid allows no more
///
/// Otherwise both curves are made finer at least once: until their strips fit into the gap between them, or the
/// crossing is near enough.
///
/// Cost  a square root per steep intersection; up to a microsecond for any other. Decided in double precision from grid
///       points and control points: results can differ between compilers only where a distance equals its bound to 15
///       digits.
class crossing_refinement {
public:
    static constexpr std::uint8_t max_halvings = 6;
    static constexpr double farthest = 4.0;  ///< the largest distance of an intersection from the curves' own, in
                                             ///< tolerances

    /// False if out of memory. `curves` must outlive this.
    ///
    ///     tolerance   that `curves` are discretised with, in font units
    [[nodiscard]] bool open(workspace::scope& scratch, const outline& curves, double tolerance, const grid& g) noexcept
    {
        const std::size_t n = curves.curves.size();
        outline_ = &curves;
        cells_ = g.cells;
        tolerance_ = tolerance * g.cells;
        if (tolerance_ < 2.0 * snap) tolerance_ = 2.0 * snap;
        halvings_ = scratch.take<std::uint8_t>(2 * n);
        if (halvings_ == nullptr) return false;
        wanted_ = halvings_ + n;
        for (std::size_t i = 0; i < 2 * n; ++i) halvings_[i] = 0;
        doubts_ = 0;
        effort_ = {};
        return true;
    }

    /// For discretise(): how often each curve's tolerance is halved.
    [[nodiscard]] array_view<const std::uint8_t> halvings() const noexcept
    {
        return {halvings_, outline_->curves.size()};
    }
    [[nodiscard]] const refinement_effort& effort() const noexcept { return effort_; }

    /// True if no intersection since the last call was rejected; otherwise refines the curves of rejected ones.
    [[nodiscard]] bool is_content() noexcept
    {
        if (doubts_ == 0) return true;
        doubts_ = 0;
        ++effort_.rounds;
        for (std::size_t i = 0; i < outline_->curves.size(); ++i) {
            effort_.curves += halvings_[i] == 0 && wanted_[i] != 0;
            halvings_[i] = wanted_[i];
        }
        return false;
    }

    /// Whether an intersection is accepted (models intersection_filter).
    [[nodiscard]] bool operator()(const intersection& m) noexcept
    {
        const std::uint32_t i = m.a.source.curve, k = m.b.source.curve;
        const curve& a = outline_->curves[i];
        const curve& b = outline_->curves[k];
        if (a.degree == 1 && b.degree == 1) return true;
        if ((b.degree == 1 && m.a.ends_in(m.at)) || (a.degree == 1 && m.b.ends_in(m.at))) return true;
        const double da = strip(i), db = strip(k);
        if (is_sure(m, da, db)) return true;
        if (i != k && is_same(a, b)) return true;
        const std::uint32_t levels = missing_levels(m, da + db);
        if (levels == 0) return true;
        const bool finer_a = want(i, levels), finer_b = k != i && want(k, levels);
        if (finer_a || finer_b) {
            ++doubts_;
            return false;
        }
        ++effort_.unsettled;
        return true;
    }

private:
    static constexpr double snap = 0.70710678118654757;  // half a cell's diagonal
    static constexpr double slack = 2.0;                 // cells: the error of rounding and of edges that bend

    struct place {
        std::uint32_t curve;
        double t;
    };
    struct sample {
        point at, derivative;  // in cells
    };

    /// Half the width of the strip around a chord in which its curve lies, in cells.
    [[nodiscard]] double strip(std::uint32_t i) const noexcept
    {
        if (outline_->curves[i].degree == 1) return snap;
        const double finer = tolerance_ / static_cast<double>(1u << halvings_[i]);
        return finer > 2.0 * snap ? finer : 2.0 * snap;
    }

    [[nodiscard]] static double squared_distance(grid_point p, grid_point q) noexcept
    {
        const double x = static_cast<double>(p.x) - q.x, y = static_cast<double>(p.y) - q.y;
        return x * x + y * y;
    }

    [[nodiscard]] bool is_sure(const intersection& m, double da, double db) const noexcept
    {
        const point u{static_cast<double>(m.a.to.x) - m.a.from.x, static_cast<double>(m.a.to.y) - m.a.from.y};
        const point v{static_cast<double>(m.b.to.x) - m.b.from.x, static_cast<double>(m.b.to.y) - m.b.from.y};
        const double sine = std::fabs(cross(u, v)) / std::sqrt(dot(u, u) * dot(v, v));
        const double reach = (da + db) + slack * sine;  // times 1 / sine
        if (!(reach <= farthest * tolerance_ * sine)) return false;
        const double far_a = reach / sine + da, far_b = reach / sine + db;
        return squared_distance(m.at, m.a.from) >= far_a * far_a && squared_distance(m.at, m.a.to) >= far_a * far_a &&
               squared_distance(m.at, m.b.from) >= far_b * far_b && squared_distance(m.at, m.b.to) >= far_b * far_b;
    }

    [[nodiscard]] static bool is_same(const curve& a, const curve& b) noexcept
    {
        if (a.degree != b.degree) return false;
        bool along = true, against = true;
        for (std::uint32_t i = 0; i <= a.degree; ++i) {
            along &= a.p[i] == b.p[i];
            against &= a.p[i] == b.p[a.degree - i];
        }
        return along || against;
    }

    /// True if this makes the curve finer.
    [[nodiscard]] bool want(std::uint32_t i, std::uint32_t levels) noexcept
    {
        if (outline_->curves[i].degree == 1 || halvings_[i] == max_halvings) return false;
        if (strip(i) <= 2.0 * snap) return false;
        const std::uint32_t sum = halvings_[i] + levels;
        const auto capped = static_cast<std::uint8_t>(sum < max_halvings ? sum : max_halvings);
        if (wanted_[i] < capped) wanted_[i] = capped;
        return true;
    }

    [[nodiscard]] static std::uint32_t levels_for(double excess) noexcept
    {
        std::uint32_t levels = 1;
        for (; excess > 2.0 && levels < max_halvings; excess *= 0.5) ++levels;
        return levels;
    }

    /// The number of halvings that an intersection needs; 0: it is accepted.
    [[nodiscard]] std::uint32_t missing_levels(const intersection& m, double strips) const noexcept
    {
        const point x{static_cast<double>(m.at.x), static_cast<double>(m.at.y)};
        const double allowed = farthest * tolerance_ + slack;
        const place start_a = place_of(m.a, m.at), start_b = place_of(m.b, m.at);
        place p = start_a, q = start_b;
        double moved = 0.0;
        for (int step = 0; step < 16; ++step) {
            const sample a = at(p), b = at(q);
            const point gap = b.at - a.at;
            if (dot(gap, gap) <= 0.25) {
                if (is_one_place(p, q)) break;
                const point off = a.at - x;
                moved = length(off);
                if (moved <= allowed) return 0;
                break;
            }
            const double turn = cross(a.derivative, b.derivative);
            const double aa = dot(a.derivative, a.derivative), bb = dot(b.derivative, b.derivative);
            if (!(turn * turn > 1e-12 * aa * bb)) break;
            p = advance(p, cross(gap, b.derivative) / turn);
            q = advance(q, cross(gap, a.derivative) / turn);
        }
        const sample a = at(nearest(start_a, x)), b = at(nearest(start_b, x));
        const double apart = length(a.at - b.at);
        if (apart <= 0.5 && !is_one_place(nearest(start_a, x), nearest(start_b, x)) && length(a.at - x) <= allowed)
            return 0;
        if (moved > 0.0) return levels_for(moved / allowed);
        return levels_for(apart > 0.5 ? strips / apart : 2.0);
    }

    [[nodiscard]] static place place_of(const intersection::edge& e, grid_point at) noexcept
    {
        const double whole = std::sqrt(squared_distance(e.from, e.to));
        const double share = whole > 0.0 ? std::sqrt(squared_distance(e.from, at)) / whole : 0.0;
        const double t0 = static_cast<double>(e.source.t0), t1 = static_cast<double>(e.source.t1);
        return {e.source.curve, t0 + (t1 - t0) * (share < 1.0 ? share : 1.0)};
    }

    [[nodiscard]] sample at(place p) const noexcept
    {
        const curve& c = outline_->curves[p.curve];
        if (c.degree == 1) return {cells_ * lerp(c.p[0], c.p[1], p.t), cells_ * (c.p[1] - c.p[0])};
        point a = lerp(c.p[0], c.p[1], p.t), b = lerp(c.p[1], c.p[2], p.t);
        if (c.degree == 3) {
            const point last = lerp(c.p[2], c.p[3], p.t);
            a = lerp(a, b, p.t);
            b = lerp(b, last, p.t);
        }
        return {cells_ * lerp(a, b, p.t), static_cast<double>(c.degree) * cells_ * (b - a)};
    }

    /// Moves along the contour, by at most half a curve; the end of a curve is a stop.
    [[nodiscard]] place advance(place p, double by) const noexcept
    {
        by = by < -0.5 ? -0.5 : by > 0.5 ? 0.5 : by;
        if (p.t >= 1.0 && by > 0.0)
            p = {neighbour(p.curve, true), 0.0};
        else if (p.t <= 0.0 && by < 0.0)
            p = {neighbour(p.curve, false), 1.0};
        p.t += by;
        p.t = p.t < 0.0 ? 0.0 : p.t > 1.0 ? 1.0 : p.t;
        return p;
    }

    /// The place near p on its curve that is nearest to x, approximately.
    [[nodiscard]] place nearest(place p, point x) const noexcept
    {
        for (int step = 0; step < 4; ++step) {
            const sample s = at(p);
            const double speed = dot(s.derivative, s.derivative);
            if (!(speed > 0.0)) return p;
            p.t += dot(x - s.at, s.derivative) / speed;
            p.t = p.t < 0.0 ? 0.0 : p.t > 1.0 ? 1.0 : p.t;
        }
        return p;
    }

    /// The next or previous curve on the contour.
    [[nodiscard]] std::uint32_t neighbour(std::uint32_t i, bool behind) const noexcept
    {
        const std::size_t contour = range_of(outline_->starts.view(), i);
        const std::uint32_t first = outline_->starts[contour], last = outline_->starts[contour + 1] - 1;
        if (behind) return i == last ? first : i + 1;
        return i == first ? last : i - 1;
    }

    /// Whether two places are the same place on the contour, not two passes of the contour.
    [[nodiscard]] bool is_one_place(place p, place q) const noexcept
    {
        constexpr double little = 0x1p-10;
        if (p.curve == q.curve) return std::fabs(p.t - q.t) < little;
        if (1.0 - p.t + q.t < little) return neighbour(p.curve, true) == q.curve;
        if (1.0 - q.t + p.t < little) return neighbour(q.curve, true) == p.curve;
        return false;
    }

    const outline* outline_ = nullptr;
    std::uint8_t* halvings_ = nullptr;
    std::uint8_t* wanted_ = nullptr;
    double cells_ = 1.0;
    double tolerance_ = 0.0;  // in cells
    std::uint32_t doubts_ = 0;
    refinement_effort effort_;
};
static_assert(intersection_filter<crossing_refinement>);

}  // namespace typemesh::inline TYPEMESH_ABI
