// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/double3.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>

#include <cmath>
#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A value of a spline, with its derivatives.
struct spline_value {
    double3 at, first, second;
};

/// The second derivatives of a natural cubic spline: fills `second` from the values at the knots, which have these
/// distances. `factors` is working memory. All have as many elements as there are knots.
///
/// From  the tridiagonal system of C. de Boor, A Practical Guide to Splines (1978), chapter 4, solved without pivots
template <class Distance>
void natural_spline(array_view<const double3> values, const Distance& distance, double3* second,
                    double* factors) noexcept
{
    const std::size_t last = values.size() - 1;
    second[0] = second[last] = {};
    factors[0] = 0.0;
    for (std::size_t i = 1; i < last; ++i) {
        const double before = distance(i - 1), after = distance(i);
        const double3 bend = (6.0 / after) * (values[i + 1] - values[i]) - (6.0 / before) * (values[i] - values[i - 1]);
        const double pivot = 2.0 * (before + after) - before * factors[i - 1];
        factors[i] = after / pivot;
        second[i] = (1.0 / pivot) * (bend - before * second[i - 1]);
    }
    for (std::size_t i = last; i-- > 1;) second[i] = second[i] - factors[i] * second[i + 1];
}

/// A piece of a cubic spline of this length between two knots, at a share of it.
[[nodiscard]] inline spline_value spline_piece(const double3& a, const double3& b, const double3& second_a,
                                               const double3& second_b, double size, double share) noexcept
{
    const double p = 1.0 - share, q = share;
    spline_value v;
    v.at = p * a + q * b + (size * size / 6.0) * ((p * p * p - p) * second_a + (q * q * q - q) * second_b);
    v.first = (1.0 / size) * (b - a) + (size / 6.0) * ((3.0 * q * q - 1.0) * second_b - (3.0 * p * p - 1.0) * second_a);
    v.second = p * second_a + q * second_b;
    return v;
}

/// A natural cubic spline with knots at equal distances, from 0.
class uniform_spline {
public:
    explicit uniform_spline(memory source = heap()) noexcept : values_{source}, second_{source}, factors_{source} {}

    /// Room for the values at the knots of so many pieces, or null.
    [[nodiscard]] double3* begin(std::size_t pieces, double length) noexcept
    {
        values_.clear();
        step_ = length / static_cast<double>(pieces);
        return values_.append(pieces + 1);
    }
    /// Computes the spline through the values. False if out of memory.
    [[nodiscard]] bool fit() noexcept
    {
        second_.clear();
        factors_.clear();
        double3* const second = second_.append(values_.size());
        double* const factors = factors_.append(values_.size());
        if (second == nullptr || factors == nullptr) return false;
        natural_spline(values_.view(), [this](std::size_t) noexcept { return step_; }, second, factors);
        return true;
    }

    [[nodiscard]] double step() const noexcept { return step_; }
    /// The piece at a place; the first or the last one beyond the ends.
    [[nodiscard]] std::size_t piece_at(double x) const noexcept
    {
        const double i = x / step_;
        const std::size_t last = values_.size() - 2;
        return !(i > 0.0) ? 0 : i >= static_cast<double>(last) ? last : static_cast<std::size_t>(i);
    }
    /// Beyond its ends the spline goes on straight, without a jump in its second derivative.
    [[nodiscard]] spline_value at(double x) const noexcept
    {
        const double end = step_ * static_cast<double>(values_.size() - 1);
        if (x < 0.0 || x > end) {
            spline_value v = at_knot(x < 0.0 ? 0 : values_.size() - 1);
            v.at = v.at + (x < 0.0 ? x : x - end) * v.first;
            v.second = {};
            return v;
        }
        const std::size_t i = piece_at(x);
        return spline_piece(values_[i], values_[i + 1], second_[i], second_[i + 1], step_,
                            x / step_ - static_cast<double>(i));
    }
    [[nodiscard]] spline_value at_knot(std::size_t i) const noexcept
    {
        const std::size_t piece = i + 1 < values_.size() ? i : i - 1;
        return spline_piece(values_[piece], values_[piece + 1], second_[piece], second_[piece + 1], step_,
                            piece == i ? 0.0 : 1.0);
    }
    /// The third derivative in a piece, where it is constant.
    [[nodiscard]] double3 third(std::size_t i) const noexcept { return (1.0 / step_) * (second_[i + 1] - second_[i]); }

private:
    buffer<double3> values_, second_;
    buffer<double> factors_;
    double step_ = 1.0;
};

/// A natural cubic spline through points, with any knots.
class chord_spline {
public:
    explicit chord_spline(memory source = heap()) noexcept : knots_{source}, second_{source}, factors_{source} {}

    /// The knots, to be filled in before fit().
    [[nodiscard]] buffer<double>& knots() noexcept { return knots_; }

    /// Computes the spline through the points, which must outlive its use. False if out of memory.
    [[nodiscard]] bool fit(array_view<const double3> points) noexcept
    {
        points_ = points;
        second_.clear();
        factors_.clear();
        double3* const second = second_.append(points.size());
        double* const factors = factors_.append(points.size());
        if (second == nullptr || factors == nullptr) return false;
        natural_spline(points, [this](std::size_t i) noexcept { return knots_[i + 1] - knots_[i]; }, second, factors);
        return true;
    }

    [[nodiscard]] double arc_length() const noexcept
    {
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < points_.size(); ++i)
            for (int k = 0; k < parts; ++k) sum += length_of(i, k, 1.0);
        return sum;
    }

    /// Writes the points at pieces + 1 equal distances along the curve.
    void walk(std::size_t pieces, double3* out) const noexcept
    {
        const double step = arc_length() / static_cast<double>(pieces);
        std::size_t made = 0;
        double before = 0.0;  // the length of the parts so far
        out[made++] = points_.front();
        for (std::size_t i = 0; i + 1 < points_.size(); ++i)
            for (int k = 0; k < parts; ++k) {
                const double own = length_of(i, k, 1.0);
                while (made < pieces && step * static_cast<double>(made) <= before + own) {
                    // The share of this part at which the length is reached: Newton's method.
                    const double wanted = step * static_cast<double>(made) - before;
                    double share = own > 0.0 ? wanted / own : 0.0;
                    for (int turn = 0; turn < 8; ++turn) {
                        const double speed = length(at(i, k, share).first) * size_of(i) / parts;
                        if (!(speed > 0.0)) break;
                        share -= (length_of(i, k, share) - wanted) / speed;
                        share = share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share;
                    }
                    out[made++] = at(i, k, share).at;
                }
                before += own;
            }
        while (made <= pieces) out[made++] = points_.back();
    }

private:
    static constexpr int parts = 8;  // of each piece, for lengths

    [[nodiscard]] double size_of(std::size_t i) const noexcept { return knots_[i + 1] - knots_[i]; }
    [[nodiscard]] spline_value at(std::size_t i, int part, double share) const noexcept
    {
        return spline_piece(points_[i], points_[i + 1], second_[i], second_[i + 1], size_of(i),
                            (static_cast<double>(part) + share) / parts);
    }
    /// The length of a share of a part, by five points of Gauss and Legendre.
    [[nodiscard]] double length_of(std::size_t i, int part, double share) const noexcept
    {
        constexpr double places[] = {0.0, 0.5384693101056831, 0.9061798459386640};
        constexpr double weights[] = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
        double sum = weights[0] * length(at(i, part, 0.5 * share).first);
        for (int k = 1; k < 3; ++k)
            for (const double side : {-1.0, 1.0})
                sum += weights[k] * length(at(i, part, 0.5 * share * (1.0 + side * places[k])).first);
        return 0.5 * share * sum * size_of(i) / parts;
    }

    array_view<const double3> points_;
    buffer<double> knots_;
    buffer<double3> second_;
    buffer<double> factors_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
