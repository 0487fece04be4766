// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/impl/piece_of.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Consecutive curves, from a place on the first one to a place on the last one.
struct stretch {
    array_view<const curve> curves;
    double t0 = 0.0;
    double t1 = 1.0;

    [[nodiscard]] bool is_point() const noexcept { return curves.size() == 1 && !(t0 < t1); }
    [[nodiscard]] curve nth(std::size_t i) const noexcept
    {
        const double from = i == 0 ? t0 : 0.0, to = i + 1 == curves.size() ? t1 : 1.0;
        return from > 0.0 || to < 1.0 ? piece_of(curves[i], from, to) : curves[i];
    }
};

/// The length of a curve between two parameters: Gauss's formula for five places, in eight parts.
[[nodiscard]] inline double length_between(const curve& c, double t0, double t1) noexcept
{
    if (c.degree == 1) return (t1 - t0) * length(c.p[1] - c.p[0]);
    constexpr double at[] = {0.0, 0.5384693101056831, 0.9061798459386640},
                     weight[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    constexpr int parts = 8;
    const hodograph slopes{c};
    double sum = 0.0;
    for (int i = 0; i < parts; ++i) {
        const double half = 0.5 * (t1 - t0) / parts, middle = t0 + (2.0 * i + 1.0) * half;
        double part = weight[0] * length(slopes.derivative(middle));
        for (int k = 1; k < 3; ++k)
            part += weight[k] * (length(slopes.derivative(middle - at[k] * half)) +
                                 length(slopes.derivative(middle + at[k] * half)));
        sum += half * part;
    }
    return static_cast<double>(c.degree) * sum;
}

/// Dashes and gaps along a path. All lengths are in font units.
class dash_pattern {
public:
    dash_pattern(array_view<const double> dashes, double offset, double em) noexcept
        : dashes_{dashes}, em_{em}, offset_{offset * em}
    {
        for (const double d : dashes) period_ += d * em;
        if (dashes.size() % 2 != 0) period_ *= 2.0;
    }

    [[nodiscard]] bool has_gaps() const noexcept { return period_ > 0.0; }

    /// Whether a path has no more dashes than anyone can want.
    [[nodiscard]] bool is_possible(array_view<const curve> path) const noexcept
    {
        constexpr double max_dashes = 1e4;
        double all = 0.0;
        for (const curve& c : path) all += length_between(c, 0.0, 1.0);
        return all / period_ * static_cast<double>(dashes_.size()) <= max_dashes;
    }

    /// put(stretch) for each dash.
    template <class Put>
    void each_dash(array_view<const curve> path, const Put& put) noexcept
    {
        std::size_t nth = 0;
        double left = std::fmod(offset_, period_);
        if (left < 0.0) left += period_;
        while (left >= of(nth) && left > 0.0) left -= of(nth++);
        left = of(nth) - left;
        place here, begin;
        for (;;) {
            const bool on = nth % 2 == 0;
            // At the end of a curve nothing is left of it, so the dash begins with the next one.
            if (on && here.t >= 1.0 && here.curve + 1 < path.size()) here = {here.curve + 1, 0.0};
            begin = here;
            const bool ends = !advance(path, here, left);
            if (on && (!ends || begin.curve != here.curve || begin.t < here.t))
                put({path.subspan(begin.curve, here.curve - begin.curve + 1), begin.t, here.t});
            if (ends) return;
            left = of(++nth);
        }
    }

private:
    struct place {
        std::size_t curve = 0;
        double t = 0.0;
    };

    [[nodiscard]] double of(std::size_t nth) const noexcept { return dashes_[nth % dashes_.size()] * em_; }

    /// Goes on along the path; false at its end.
    [[nodiscard]] static bool advance(array_view<const curve> path, place& here, double distance) noexcept
    {
        for (;;) {
            const curve& c = path[here.curve];
            const double rest = length_between(c, here.t, 1.0);
            if (!(distance > rest)) {
                double low = here.t, high = 1.0;
                for (int i = 0; i < 40 && distance > 0.0; ++i) {
                    const double middle = 0.5 * (low + high);
                    (length_between(c, here.t, middle) < distance ? low : high) = middle;
                }
                here.t = distance > 0.0 ? high : here.t;
                return true;
            }
            if (here.curve + 1 == path.size()) {
                here.t = 1.0;
                return false;
            }
            distance -= rest;
            ++here.curve;
            here.t = 0.0;
        }
    }

    array_view<const double> dashes_;
    double em_;
    double offset_;
    double period_ = 0.0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
