// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/outline.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace typemesh::inline TYPEMESH_ABI::inspect {

/// An outline's curves as short chords that stand for the curves: within `error` of them.
///
///     cells    grid cells per font unit: region::grid().cells
///     error    in cells, above 0: for example, 1/100 of the tolerance under test. At most 2^20 chords per curve
///
/// The number of chords is Wang's bound. From R. Goldman, Pyramid Algorithms (2003), 5.6.3
class curve_chords {
public:
    /// Both ends in cells.
    struct chord {
        point start;
        point end;
    };

    curve_chords() = default;
    curve_chords(const outline& given, double cells, double error) { take(given, cells, error); }

    /// Replaces all chords with the chords of another outline. Storage is reused.
    void take(const outline& given, double cells, double error)
    {
        chords_.clear();
        first_.assign(1, 0);
        bounds_ = given.bounds;
        bounds_.low = cells * bounds_.low;
        bounds_.high = cells * bounds_.high;
        for (const curve& c : given.curves) {
            double bend = 0.0;
            for (std::uint32_t k = 0; k + 2 <= c.degree; ++k)
                bend = (std::max)(bend, length(c.p[k] + c.p[k + 2] - 2.0 * c.p[k + 1]));
            const double wang = std::sqrt(c.degree * (c.degree - 1) * cells * bend / (8.0 * error));
            const int n = wang < 0x1p20 ? (std::max)(1, static_cast<int>(std::ceil(wang))) : 1 << 20;
            point start = cells * c.p[0];
            for (int i = 1; i <= n; ++i) {
                const point end = cells * (i == n ? c.end() : at(c, double(i) / n));
                chords_.push_back({start, end});
                start = end;
            }
            first_.push_back(chords_.size());
        }
    }

    [[nodiscard]] array_view<const chord> all() const noexcept { return chords_; }
    [[nodiscard]] array_view<const chord> of_curve(std::uint32_t curve) const noexcept
    {
        return all().subspan(first_[curve], first_[curve + 1] - first_[curve]);
    }

    /// The bounding box of all control points, in cells.
    [[nodiscard]] const box& bounds() const noexcept { return bounds_; }

    /// The squared distance from p to the nearest of the given chords, in cells; 1e300 if there are none.
    [[nodiscard]] static double squared_distance(point p, array_view<const chord> some) noexcept
    {
        double nearest = 1e300;
        for (const chord& c : some) nearest = (std::min)(nearest, squared_distance(p, c.start, c.end));
        return nearest;
    }
    [[nodiscard]] static double squared_distance(point p, point start, point end) noexcept
    {
        const point along = end - start, to = p - start;
        const double square = dot(along, along);
        const double t = square > 0.0 ? (std::max)(0.0, (std::min)(1.0, dot(to, along) / square)) : 0.0;
        const point gap = to - t * along;
        return dot(gap, gap);
    }

    /// The winding number of the curves around p, which must not lie on them.
    [[nodiscard]] std::int32_t winding(point p) const noexcept
    {
        std::int32_t w = 0;
        for (const chord& c : chords_) {
            const point along = c.end - c.start, to = p - c.start;
            if (c.start.y <= p.y && c.end.y > p.y && cross(along, to) > 0.0) ++w;
            if (c.end.y <= p.y && c.start.y > p.y && cross(along, to) < 0.0) --w;
        }
        return w;
    }

private:
    /// De Casteljau's scheme.
    static point at(const curve& c, double t) noexcept
    {
        point p[4] = {c.p[0], c.p[1], c.p[2], c.p[3]};
        for (std::uint32_t left = c.degree; left > 0; --left)
            for (std::uint32_t i = 0; i < left; ++i) p[i] = lerp(p[i], p[i + 1], t);
        return p[0];
    }

    std::vector<chord> chords_;
    std::vector<std::size_t> first_;  // each curve's first chord
    box bounds_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::inspect
