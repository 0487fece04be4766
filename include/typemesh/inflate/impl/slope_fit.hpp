// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inflate/impl/membrane_system.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The slope of a membrane at its inner points: of the polynomial of degree 2 with -Laplace = 1 that fits the values at
/// the neighbours best,
///
///     u(x, y) - u(0) = a x + b y + c (x^2 - y^2) + d 2 x y - (x^2 + y^2) / 4
///
/// by least squares, each neighbour weighted by one over its squared distance. On a strip and on a disc, whose
/// solutions are such polynomials, it is exact. With too few neighbours, c and d tend to 0.
///
/// It keeps its memory for the next membrane.
class slope_fit {
public:
    explicit slope_fit(memory source = heap()) noexcept : sums_{source} {}

    /// The slopes (a, b) at the inner points, in cells. `unit` is the usual length of an edge. False if out of memory
    ///
    /// Cost   O(n)
    [[nodiscard]] bool operator()(const membrane_mesh& m, const membrane_system& solved, double unit,
                                  buffer<point>& out) noexcept
    {
        const std::size_t n = m.inner.size(), rim = m.rim.size();
        sums_.clear();
        out.clear();
        if (n == 0) return true;
        normal_equations* const sums = sums_.append(n);
        point* const slopes = out.append(n);
        if (sums == nullptr || slopes == nullptr) return false;
        for (std::size_t i = 0; i < n; ++i) sums[i] = {};
        const double per_cell = 1.0 / unit, per_square = per_cell * per_cell;
        for (const triangle& t : m.triangles) {
            const std::uint32_t corner[] = {t.a, t.b, t.c};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t i = corner[k], j = corner[k == 2 ? 0 : k + 1];
                if (i < rim) continue;
                const grid_point from = m.at(i), to = m.at(j);
                sums[i - rim].add(per_cell * (static_cast<double>(to.x) - from.x),
                                  per_cell * (static_cast<double>(to.y) - from.y),
                                  per_square * (solved.at(j) - solved.at(i)));
            }
        }
        for (std::size_t i = 0; i < n; ++i) slopes[i] = unit * sums[i].slope();
        return true;
    }

private:
    /// The sums over the neighbours of one point: the matrix's lower half, then the right side.
    struct normal_equations {
        double matrix[4][4] = {};
        double right[4] = {};

        void add(double x, double y, double rise) noexcept
        {
            const double square = x * x + y * y, weight = 1.0 / square;
            const double basis[] = {x, y, x * x - y * y, 2.0 * x * y}, value = weight * (rise + 0.25 * square);
            for (int i = 0; i < 4; ++i) {
                for (int j = 0; j <= i; ++j) matrix[i][j] += weight * basis[i] * basis[j];
                right[i] += basis[i] * value;
            }
        }

        /// By Cholesky's method.
        [[nodiscard]] point slope() noexcept
        {
            const double least = 0.02 * (matrix[2][2] + matrix[3][3]) + 0x1p-100;
            matrix[2][2] += least;
            matrix[3][3] += least;
            // The slope comes last: then its two numbers follow from the last two rows alone.
            constexpr int order[] = {2, 3, 0, 1};
            double l[4][4] = {}, y[4] = {};
            for (int i = 0; i < 4; ++i) {
                for (int j = 0; j <= i; ++j) {
                    const int a = order[i], b = order[j];
                    double sum = a > b ? matrix[a][b] : matrix[b][a];
                    for (int k = 0; k < j; ++k) sum -= l[i][k] * l[j][k];
                    l[i][j] = i == j ? std::sqrt(sum > 0x1p-60 ? sum : 0x1p-60) : sum / l[j][j];
                }
                double sum = right[order[i]];
                for (int k = 0; k < i; ++k) sum -= l[i][k] * y[k];
                y[i] = sum / l[i][i];
            }
            const double b = y[3] / l[3][3];
            return {(y[2] - l[3][2] * b) / l[2][2], b};
        }
    };

    buffer<normal_equations> sums_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
