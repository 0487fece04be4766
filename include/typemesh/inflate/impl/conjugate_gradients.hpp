// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/inflate/impl/envelope_factors.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Solves the system of a membrane_matrix step by step, by conjugate gradients with incomplete Cholesky factors: for
/// meshes that are too wide for envelope_factors.
///
/// The sums have one order. It keeps its memory for the next matrix.
///
/// From  J. Meijerink & H. van der Vorst, Mathematics of Computation 31 (1977), for the factors
class conjugate_gradients {
public:
    explicit conjugate_gradients(memory source = heap()) noexcept
        : starts_{source},
          columns_{source},
          weights_{source},
          diagonal_{source},
          factors_{source},
          pivots_{source},
          vectors_{source}
    {
    }

    /// Reads a matrix. False if out of memory
    ///
    /// Cost   O(entries)
    [[nodiscard]] bool open(const membrane_matrix& a) noexcept
    {
        const std::size_t n = a.size(), entries = a.columns.size() / 2;
        starts_.clear();
        columns_.clear();
        weights_.clear();
        diagonal_.clear();
        factors_.clear();
        pivots_.clear();
        vectors_.clear();
        std::uint32_t *const starts = starts_.append(n + 1), *const columns = columns_.append(entries + 1);
        double* const weights = weights_.append(entries + 1);
        if (starts == nullptr || columns == nullptr || weights == nullptr || !diagonal_.append(a.diagonal) ||
            factors_.append(entries + 1) == nullptr || pivots_.append(n) == nullptr ||
            vectors_.append(4 * n) == nullptr)
            return false;
        std::uint32_t end = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            starts[i] = end;
            for (std::uint32_t k = a.starts[i]; k < a.starts[i + 1]; ++k)
                if (a.columns[k] < i) insert(starts[i], end++, a.columns[k], a.shares[k]);
        }
        starts[n] = end;
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t k = a.starts[i]; k < a.starts[i + 1]; ++k)
                if (a.columns[k] > i) weights[place(a.columns[k], i)] += a.shares[k];
        factorise();
        return true;
    }

    /// Steps until the residual is so small in relation to the load, both measured by the norm of the preconditioner.
    /// Returns the number of steps, or max_steps + 1 if these do not suffice.
    [[nodiscard]] int solve(const double* load, double* u, double tolerance, int max_steps) noexcept
    {
        const std::size_t n = diagonal_.size();
        double *const r = vectors_.data(), *const z = r + n, *const p = z + n, *const q = p + n;
        for (std::size_t i = 0; i < n; ++i) {
            u[i] = 0.0;
            r[i] = load[i];
        }
        double goal = 0.0, before = 1.0;
        for (int steps = 0;; ++steps) {
            precondition(r, z);
            double now = 0.0;
            for (std::size_t i = 0; i < n; ++i) now += r[i] * z[i];
            if (steps == 0) goal = tolerance * tolerance * now;
            if (!is_finite(now)) return max_steps + 1;
            if (!(now > goal)) return steps;
            if (steps == max_steps) return steps + 1;
            const double along = steps == 0 ? 0.0 : now / before;
            for (std::size_t i = 0; i < n; ++i) p[i] = steps == 0 ? z[i] : z[i] + along * p[i];
            multiply(p, q);
            double bend = 0.0;
            for (std::size_t i = 0; i < n; ++i) bend += p[i] * q[i];
            const double far_enough = now / bend;
            for (std::size_t i = 0; i < n; ++i) {
                u[i] += far_enough * p[i];
                r[i] -= far_enough * q[i];
            }
            before = now;
        }
    }

private:
    /// Inserts an entry into a row, which is sorted and has about three.
    void insert(std::uint32_t first, std::uint32_t end, std::uint32_t column, double weight) noexcept
    {
        for (; end > first && columns_[end - 1] > column; --end) {
            columns_[end] = columns_[end - 1];
            weights_[end] = weights_[end - 1];
        }
        columns_[end] = column;
        weights_[end] = weight;
    }

    /// The place of an entry in its row.
    [[nodiscard]] std::uint32_t place(std::size_t row, std::size_t column) const noexcept
    {
        std::uint32_t k = starts_[row];
        while (columns_[k] != column) ++k;
        return k;
    }

    void multiply(const double* x, double* y) const noexcept
    {
        const std::size_t n = diagonal_.size();
        const std::uint32_t *const starts = starts_.data(), *const columns = columns_.data();
        const double *const weights = weights_.data(), *const diagonal = diagonal_.data();
        for (std::size_t i = 0; i < n; ++i) {
            double sum = diagonal[i] * x[i];
            const double here = x[i];
            for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) {
                sum -= weights[k] * x[columns[k]];
                y[columns[k]] -= weights[k] * here;
            }
            y[i] = sum;
        }
    }

    /// L D L^T with 1 on the diagonal of L, which has entries only where the matrix has them.
    void factorise() noexcept
    {
        const std::size_t n = diagonal_.size();
        const std::uint32_t *const starts = starts_.data(), *const columns = columns_.data();
        const double* const weights = weights_.data();
        double *const l = factors_.data(), *const pivots = pivots_.data();
        for (std::size_t i = 0; i < n; ++i) {
            double pivot = diagonal_[i];
            for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) {
                const std::uint32_t column = columns[k];
                double value = -weights[k];
                std::uint32_t a = starts[i], b = starts[column];
                while (a < k && b < starts[column + 1]) {
                    if (columns[a] == columns[b]) value -= l[a] * l[b] / pivots[columns[a]];
                    const bool move_a = columns[a] <= columns[b], move_b = columns[b] <= columns[a];
                    a += move_a;
                    b += move_b;
                }
                l[k] = value;  // times the column's pivot
                pivot -= value * value / pivots[column];
            }
            pivots[i] = pivot > 0.0 ? pivot : diagonal_[i];
        }
        for (std::size_t i = 0; i < n; ++i)
            for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) l[k] /= pivots[columns[k]];
        for (std::size_t i = 0; i < n; ++i) pivots[i] = 1.0 / pivots[i];
    }

    void precondition(const double* x, double* z) const noexcept
    {
        const std::size_t n = diagonal_.size();
        const std::uint32_t *const starts = starts_.data(), *const columns = columns_.data();
        const double *const l = factors_.data(), *const inverse = pivots_.data();
        for (std::size_t i = 0; i < n; ++i) {
            double sum = x[i];
            for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) sum -= l[k] * z[columns[k]];
            z[i] = sum;
        }
        for (std::size_t i = 0; i < n; ++i) z[i] *= inverse[i];
        for (std::size_t i = n; i-- > 0;) {
            const double here = z[i];
            for (std::uint32_t k = starts[i]; k < starts[i + 1]; ++k) z[columns[k]] -= l[k] * here;
        }
    }

    buffer<std::uint32_t> starts_, columns_;  // the rows of the lower half, without the diagonal
    buffer<double> weights_, diagonal_;
    buffer<double> factors_, pivots_, vectors_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
