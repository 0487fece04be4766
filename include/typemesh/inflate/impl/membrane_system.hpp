// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A triangulated region whose first points lie on its boundary.
struct membrane_mesh {
    array_view<const grid_point> rim;    ///< the points on the boundary
    array_view<const grid_point> inner;  ///< the points inside, whose numbers follow
    array_view<const triangle> triangles;

    [[nodiscard]] grid_point at(std::uint32_t i) const noexcept
    {
        return i < rim.size() ? rim[i] : inner[i - rim.size()];
    }
};

/// The linear system of -Laplace(u) = 1 with u = 0 on the boundary, for functions that are linear on each triangle.
///
///     sum of w (u_i - u_j) over the neighbours j of i  =  a third of the area of the triangles around i
///
///           j                w = (cot p + cot q) / 2, where p and q are the angles opposite the edge i j.
///         / | \              .
///       p   |   q            In a Delaunay mesh p + q is at most 180 degrees, so no w is negative. The matrix is then
///         \ | /              an M-matrix: every solution u is positive, and the incomplete Cholesky factors exist.
///           i
///
/// The sums are of quotients of exact integers, in the order of the triangles. It keeps its memory for the next system.
///
/// From  J. Xu & L. Zikatanov, A monotone finite element scheme for convection-diffusion equations (1999), for the
///       signs; J. Meijerink & H. van der Vorst, Mathematics of Computation 31 (1977), for the factors
class membrane_system {
public:
    explicit membrane_system(memory source = heap()) noexcept
        : starts_{source},
          columns_{source},
          weights_{source},
          diagonal_{source},
          load_{source},
          rim_load_{source},
          u_{source},
          factors_{source},
          pivots_{source},
          vectors_{source}
    {
    }

    /// Makes the system of a mesh. u begins as it was where there was one, and as the caller sets the rest.
    ///
    /// False if out of memory
    /// Cost   O(n)
    [[nodiscard]] bool open(const membrane_mesh& m) noexcept
    {
        mesh_ = m;
        const std::size_t rim = m.rim.size(), n = m.inner.size();
        starts_.clear();
        columns_.clear();
        weights_.clear();
        diagonal_.clear();
        load_.clear();
        rim_load_.clear();
        std::uint32_t* const starts = starts_.append(n + 2);
        double *const diagonal = diagonal_.append(n + 1), *const load = load_.append(n + 1),
                      *const rim_load = rim_load_.append(rim + 1);
        if (starts == nullptr || diagonal == nullptr || load == nullptr || rim_load == nullptr) return false;
        for (std::size_t i = 0; i < n + 2; ++i) starts[i] = 0;
        for (std::size_t i = 0; i < n + 1; ++i) diagonal[i] = load[i] = 0.0;
        for (std::size_t i = 0; i < rim + 1; ++i) rim_load[i] = 0.0;
        // Each edge between two inner points belongs to the row of the one with the greater number.
        const auto each_edge = [&](auto&& f) noexcept {
            for (const triangle& t : m.triangles) {
                f(t.a, t.b, t.c);
                f(t.b, t.c, t.a);
                f(t.c, t.a, t.b);
            }
        };
        each_edge([&](std::uint32_t i, std::uint32_t j, std::uint32_t) noexcept {
            if (i > j && j >= rim) ++starts[i - rim + 2];
        });
        for (std::size_t i = 2; i < n + 2; ++i) starts[i] += starts[i - 1];
        const std::size_t entries = starts[n + 1];
        std::uint32_t* const columns = columns_.append(entries + 1);
        double* const weights = weights_.append(entries + 1);
        if (columns == nullptr || weights == nullptr) return false;
        each_edge([&](std::uint32_t i, std::uint32_t j, std::uint32_t) noexcept {
            if (!(i > j && j >= rim)) return;
            columns[starts[i - rim + 1]++] = static_cast<std::uint32_t>(j - rim);
        });
        for (std::size_t i = 0; i < n; ++i) sort(columns + starts[i], columns + starts[i + 1]);
        for (std::size_t k = 0; k < entries; ++k) weights[k] = 0.0;
        each_edge([&](std::uint32_t i, std::uint32_t j, std::uint32_t k) noexcept {
            const double w = half_cotangent(m.at(k), m.at(i), m.at(j));
            if (i >= rim) diagonal[i - rim] += w;
            if (j >= rim) diagonal[j - rim] += w;
            if (i >= rim && j >= rim) weights[place(i > j ? i - rim : j - rim, i > j ? j - rim : i - rim)] += w;
        });
        for (const triangle& t : m.triangles) {
            const double third = static_cast<double>(orientation(m.at(t.a), m.at(t.b), m.at(t.c))) / 6.0;
            for (const std::uint32_t i : {t.a, t.b, t.c}) (i < rim ? rim_load[i] : load[i - rim]) += third;
        }
        return true;
    }

    [[nodiscard]] std::size_t size() const noexcept { return mesh_.inner.size(); }

    /// u at the inner points: the first guess before solve(), the solution after it. In square cells.
    [[nodiscard]] buffer<double>& u() noexcept { return u_; }
    [[nodiscard]] const buffer<double>& u() const noexcept { return u_; }

    /// The steps of the last solve().
    [[nodiscard]] int steps() const noexcept { return steps_; }

    /// u at any point of the mesh.
    [[nodiscard]] double at(std::uint32_t i) const noexcept
    {
        return i < mesh_.rim.size() ? 0.0 : u_[i - mesh_.rim.size()];
    }

    /// Solves by conjugate gradients, preconditioned by incomplete Cholesky factors, until the residual is so small in
    /// relation to the load. Both are measured by the norm of the preconditioner. u has a value for each inner point.
    ///
    /// Each u_i is at least load_i / diagonal_i, because no weight is negative; what is below is set to that. So u is
    /// positive at every inner point, whatever the rounding.
    ///
    /// False if out of memory
    [[nodiscard]] bool solve(double tolerance, int max_steps) noexcept
    {
        const std::size_t n = size();
        steps_ = 0;
        factors_.clear();
        pivots_.clear();
        vectors_.clear();
        if (n == 0) return true;
        if (factors_.append(weights_.size()) == nullptr || pivots_.append(n) == nullptr ||
            vectors_.append(4 * n) == nullptr)
            return false;
        factorise();
        double *const r = vectors_.data(), *const z = r + n, *const p = z + n, *const q = p + n, *const u = u_.data();
        const double* const load = load_.data();
        precondition(load, z);
        double goal = 0.0;
        for (std::size_t i = 0; i < n; ++i) goal += load[i] * z[i];
        goal *= tolerance * tolerance;
        multiply(u, q);
        for (std::size_t i = 0; i < n; ++i) r[i] = load[i] - q[i];
        double before = 1.0;
        for (;; ++steps_) {
            precondition(r, z);
            double now = 0.0;
            for (std::size_t i = 0; i < n; ++i) now += r[i] * z[i];
            if (!(now > goal) || steps_ == max_steps) break;
            const double along = steps_ == 0 ? 0.0 : now / before;
            for (std::size_t i = 0; i < n; ++i) p[i] = steps_ == 0 ? z[i] : z[i] + along * p[i];
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
        for (std::size_t i = 0; i < n; ++i) {
            const double least = load[i] / diagonal_[i];
            if (!(u[i] > least)) u[i] = least;
        }
        return true;
    }

    /// The residual of u in relation to the load, both as the root of the sum of squares. A test's measure.
    [[nodiscard]] double residual() noexcept
    {
        const std::size_t n = size();
        double square = 0.0, whole = 0.0;
        double* const q = vectors_.data() + 3 * n;
        multiply(u_.data(), q);
        for (std::size_t i = 0; i < n; ++i) {
            square += (load_[i] - q[i]) * (load_[i] - q[i]);
            whole += load_[i] * load_[i];
        }
        return n == 0 ? 0.0 : std::sqrt(square / whole);
    }

    /// Adds to `rise`, one number for each boundary point, what leaves the membrane there: the slope of u, towards the
    /// inside, times half the length of both edges of the boundary. The sum over all points is the area: the slope is
    /// exact on average, however coarse the mesh.
    void add_outflow(double* rise) const noexcept
    {
        const std::size_t rim = mesh_.rim.size();
        for (std::size_t i = 0; i < rim; ++i) rise[i] += rim_load_[i];
        for (const triangle& t : mesh_.triangles) {
            const std::uint32_t corner[] = {t.a, t.b, t.c};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t i = corner[k], j = corner[k == 2 ? 0 : k + 1], o = corner[k == 0 ? 2 : k - 1];
                if ((i < rim) == (j < rim)) continue;
                const double w = half_cotangent(mesh_.at(o), mesh_.at(i), mesh_.at(j));
                (i < rim ? rise[i] : rise[j]) += w * at(i < rim ? j : i);
            }
        }
    }

    /// Half the cotangent of the angle at a point, between two others that are counter-clockwise around it.
    [[nodiscard]] static double half_cotangent(grid_point at, grid_point p, grid_point q) noexcept
    {
        const std::int64_t along = (std::int64_t{p.x} - at.x) * (std::int64_t{q.x} - at.x) +
                                   (std::int64_t{p.y} - at.y) * (std::int64_t{q.y} - at.y);
        return 0.5 * (static_cast<double>(along) / static_cast<double>(orientation(at, p, q)));
    }

private:
    /// Sorts a row, which has about three entries.
    static void sort(std::uint32_t* first, std::uint32_t* last) noexcept
    {
        for (std::uint32_t* next = first; next < last; ++next) {
            const std::uint32_t value = *next;
            std::uint32_t* to = next;
            for (; to > first && to[-1] > value; --to) *to = to[-1];
            *to = value;
        }
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
        const std::size_t n = size();
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
        const std::size_t n = size();
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
        const std::size_t n = size();
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

    membrane_mesh mesh_;
    buffer<std::uint32_t> starts_, columns_;  // the rows of the lower half, without the diagonal
    buffer<double> weights_, diagonal_, load_, rim_load_, u_;
    buffer<double> factors_, pivots_, vectors_;
    int steps_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
