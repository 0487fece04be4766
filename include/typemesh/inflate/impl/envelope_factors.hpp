// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A symmetric matrix without positive numbers beside its diagonal. Each row lists its neighbours in any order:
///
///     columns   [ neighbours of 0 | neighbours of 1 | ... ]      starts: where each row begins, and the end
///     shares    the entry of i and j is -(share of j in row i + share of i in row j)
struct membrane_matrix {
    array_view<const std::uint32_t> starts, columns;
    array_view<const double> shares, diagonal;

    [[nodiscard]] std::size_t size() const noexcept { return diagonal.size(); }
};

/// Solves the system of a membrane_matrix without iteration, by the factors L D L^T. Letters are made of strokes: if
/// the unknowns are numbered along them, each row of L begins only a few columns before its diagonal.
///
///     | d         |       the envelope: in each row, everything from the first entry on. Elimination keeps it, so its
///     | x d       |       size and the work are known beforehand.
///     | . x d     |
///     |   x x d   |
///
/// The sums have one order. It keeps its memory for the next matrix.
///
/// From  E. Cuthill & J. McKee, Reducing the bandwidth of sparse symmetric matrices (1969), and A. George's reversed
///       order, without the sorting by degrees; A. Jennings, A compact storage scheme for the solution of symmetric
///       linear simultaneous equations (1966)
class envelope_factors {
public:
    explicit envelope_factors(memory source = heap()) noexcept
        : order_{source}, rank_{source}, first_{source}, starts_{source}, rows_{source}, pivots_{source}
    {
    }

    /// Numbers the unknowns. False if out of memory
    ///
    /// Cost   O(entries)
    [[nodiscard]] bool order(const membrane_matrix& a) noexcept
    {
        const std::size_t n = a.size();
        for (auto* const list : {&order_, &rank_, &first_}) {
            list->clear();
            if (list->append(n) == nullptr) return false;
        }
        for (std::uint32_t& r : rank_) r = none;
        std::size_t known = 0;
        for (std::uint32_t i = 0; i < n; ++i) {
            if (rank_[i] != none) continue;
            // From the end of a part to its other end.
            const std::size_t end = spread(a, i, known);
            const std::uint32_t last = order_[end - 1];
            for (std::size_t k = known; k < end; ++k) rank_[order_[k]] = none;
            known = spread(a, last, known);
        }
        for (std::size_t k = 0; k < n; ++k) rank_[order_[k]] = static_cast<std::uint32_t>(n - 1 - k);
        starts_.clear();
        std::size_t* const starts = starts_.append(n + 1);
        if (starts == nullptr) return false;
        for (std::uint32_t i = 0; i < n; ++i) {
            std::uint32_t least = rank_[i];
            for (std::uint32_t k = a.starts[i]; k < a.starts[i + 1]; ++k)
                least = rank_[a.columns[k]] < least ? rank_[a.columns[k]] : least;
            first_[rank_[i]] = least;
        }
        starts[0] = 0;
        work_ = 0.0;
        for (std::size_t r = 0; r < n; ++r) {
            const std::size_t width = r - first_[r];
            starts[r + 1] = starts[r] + width;
            work_ += 0.5 * static_cast<double>(width) * static_cast<double>(width);
        }
        return true;
    }

    /// About how many multiplications solve() makes, after order().
    [[nodiscard]] double work() const noexcept { return work_; }

    /// Solves the system of the matrix that was ordered. False if out of memory
    ///
    /// Cost   work()
    [[nodiscard]] bool solve(const membrane_matrix& a, const double* load, double* u) noexcept
    {
        const std::size_t n = a.size();
        rows_.clear();
        pivots_.clear();
        double* const rows = rows_.append(starts_[n] + n);
        double* const inverse = pivots_.append(n);
        if (rows == nullptr || inverse == nullptr) return false;
        for (std::size_t k = 0; k < starts_[n]; ++k) rows[k] = 0.0;
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t r = rank_[i];
            for (std::uint32_t k = a.starts[i]; k < a.starts[i + 1]; ++k) {
                const std::uint32_t s = rank_[a.columns[k]], high = r < s ? s : r, low = r < s ? r : s;
                rows[starts_[high] + (low - first_[high])] -= a.shares[k];
            }
            inverse[r] = a.diagonal[i];
        }
        double* const x = rows + starts_[n];
        for (std::uint32_t i = 0; i < n; ++i) x[rank_[i]] = load[i];
        for (std::size_t r = 0; r < n; ++r) {
            eliminate(r);
            x[r] -= dot(rows + starts_[r], x + first_[r], r - first_[r]);
        }
        for (std::size_t r = 0; r < n; ++r) x[r] *= inverse[r];
        for (std::size_t r = n; r-- > 0;) {
            const double here = x[r];
            const double* const row = rows + starts_[r];
            double* const to = x + first_[r];
            for (std::size_t k = 0; k < r - first_[r]; ++k) to[k] -= row[k] * here;
        }
        for (std::uint32_t i = 0; i < n; ++i) u[i] = x[rank_[i]];
        return true;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// Lists what is connected to an unknown, level by level, from a place in the order on. Returns the place after.
    std::size_t spread(const membrane_matrix& a, std::uint32_t from, std::size_t at) noexcept
    {
        std::size_t end = at;
        order_[end++] = from;
        rank_[from] = 0;
        for (; at < end; ++at) {
            const std::uint32_t i = order_[at];
            for (std::uint32_t k = a.starts[i]; k < a.starts[i + 1]; ++k) {
                const std::uint32_t j = a.columns[k];
                if (rank_[j] != none) continue;
                rank_[j] = 0;
                order_[end++] = j;
            }
        }
        return end;
    }

    /// Makes a row of the matrix a row of L, and its diagonal the inverse of its pivot. A pivot is positive except for
    /// rounding; then the diagonal takes its place.
    void eliminate(std::size_t r) noexcept
    {
        double *const row = rows_.data() + starts_[r], *const inverse = pivots_.data();
        const std::size_t first = first_[r];
        for (std::size_t c = first; c < r; ++c) {
            const std::size_t from = first < first_[c] ? first_[c] : first;
            row[c - first] -= dot(row + (from - first), rows_.data() + starts_[c] + (from - first_[c]), c - from);
        }
        double pivot = inverse[r];
        for (std::size_t c = first; c < r; ++c) {
            const double value = row[c - first] * inverse[c];
            pivot -= value * row[c - first];
            row[c - first] = value;
        }
        inverse[r] = 1.0 / (pivot > 0.0 ? pivot : inverse[r]);
    }

    /// In four sums, so that each addition need not wait for the one before.
    [[nodiscard]] static double dot(const double* a, const double* b, std::size_t n) noexcept
    {
        double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0;
        std::size_t k = 0;
        for (; k + 4 <= n; k += 4) {
            s0 += a[k] * b[k];
            s1 += a[k + 1] * b[k + 1];
            s2 += a[k + 2] * b[k + 2];
            s3 += a[k + 3] * b[k + 3];
        }
        for (; k < n; ++k) s0 += a[k] * b[k];
        return (s0 + s1) + (s2 + s3);
    }

    buffer<std::uint32_t> order_, rank_;  // the unknowns in their order from the last to the first; each one's row
    buffer<std::uint32_t> first_;         // each row's first column
    buffer<std::size_t> starts_;          // where each row begins in rows_
    buffer<double> rows_;                 // rows of L without the diagonal, then the solution in the rows' order
    buffer<double> pivots_;
    double work_ = 0.0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
