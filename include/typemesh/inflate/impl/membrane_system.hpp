// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inflate/impl/conjugate_gradients.hpp>
#include <typemesh/inflate/impl/envelope_factors.hpp>

#include <array>
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

/// What a counter-clockwise triangle contributes to the system.
struct triangle_weights {
    double half_cotangents[3];  ///< of the angles opposite the edges a b, b c and c a
    double third;               ///< of its area

    triangle_weights(grid_point a, grid_point b, grid_point c) noexcept
    {
        const auto area = static_cast<double>(orientation(a, b, c));  // twice
        const double scale = 0.5 / area;
        half_cotangents[0] = scale * cosine(c, a, b);
        half_cotangents[1] = scale * cosine(a, b, c);
        half_cotangents[2] = scale * cosine(b, c, a);
        third = area / 6.0;
    }

private:
    /// Of the angle at a point, times the lengths of both edges.
    [[nodiscard]] static double cosine(grid_point at, grid_point p, grid_point q) noexcept
    {
        return static_cast<double>((std::int64_t{p.x} - at.x) * (std::int64_t{q.x} - at.x) +
                                   (std::int64_t{p.y} - at.y) * (std::int64_t{q.y} - at.y));
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
/// The numbers are quotients of exact integers, summed in the order of the triangles. The system is solved without
/// iteration where that is less work, otherwise by conjugate gradients to a residual of 1e-8. If these should not get
/// there, which nobody has seen, it is solved without iteration all the same: no solution is left unfinished.
///
/// It keeps its memory for the next system.
///
/// From  J. Xu & L. Zikatanov, A monotone finite element scheme for convection-diffusion equations (1999), for the
///       signs
class membrane_system {
public:
    explicit membrane_system(memory source = heap()) noexcept
        : starts_{source},
          columns_{source},
          shares_{source},
          diagonal_{source},
          load_{source},
          rim_load_{source},
          u_{source},
          direct_{source},
          stepwise_{source}
    {
    }

    /// Makes the system of a mesh, and solves it. False if out of memory
    ///
    /// Cost   O(n) for the system; n^1.5 for the solution, less on thin letters
    [[nodiscard]] bool solve(const membrane_mesh& m) noexcept
    {
        mesh_ = m;
        return assemble() && find();
    }

    [[nodiscard]] std::size_t size() const noexcept { return mesh_.inner.size(); }

    /// u at the inner points, in square cells.
    ///
    /// Each u_i is at least load_i / diagonal_i, because no weight is negative; what is below is set to that. So u is
    /// positive at every inner point, whatever the rounding.
    [[nodiscard]] array_view<const double> u() const noexcept { return u_.view(); }

    /// u at any point of the mesh.
    [[nodiscard]] double at(std::uint32_t i) const noexcept
    {
        return i < mesh_.rim.size() ? 0.0 : u_[i - mesh_.rim.size()];
    }

    /// Adds to `rise`, one number for each boundary point, what leaves the membrane there: the slope of u, towards the
    /// inside, times half the length of both edges of the boundary. The sum over all points is the area: the slope is
    /// exact on average, however coarse the mesh.
    void add_outflow(double* rise) const noexcept
    {
        const std::size_t rim = mesh_.rim.size();
        for (std::size_t i = 0; i < rim; ++i) rise[i] += rim_load_[i];
        for (const triangle& t : mesh_.triangles) {
            if (t.a >= rim && t.b >= rim && t.c >= rim) continue;
            const triangle_weights w{mesh_.at(t.a), mesh_.at(t.b), mesh_.at(t.c)};
            for (std::size_t k = 0; k < 3; ++k) {
                const auto [i, j] = edges_of(t)[k];
                if ((i < rim) != (j < rim)) (i < rim ? rise[i] : rise[j]) += w.half_cotangents[k] * at(i < rim ? j : i);
            }
        }
    }

private:
    /// False if out of memory.
    [[nodiscard]] bool assemble() noexcept
    {
        const std::size_t rim = mesh_.rim.size(), n = mesh_.inner.size();
        starts_.clear();
        columns_.clear();
        shares_.clear();
        diagonal_.clear();
        load_.clear();
        rim_load_.clear();
        u_.clear();
        std::uint32_t* const starts = starts_.append(n + 2);
        double *const diagonal = diagonal_.append(n + 1), *const load = load_.append(n + 1),
                      *const rim_load = rim_load_.append(rim);
        if (starts == nullptr || diagonal == nullptr || load == nullptr || rim_load == nullptr ||
            (n != 0 && u_.append(n) == nullptr))
            return false;
        for (std::size_t i = 0; i < n + 2; ++i) starts[i] = 0;
        for (std::size_t i = 0; i < n + 1; ++i) diagonal[i] = load[i] = 0.0;
        for (std::size_t i = 0; i < rim; ++i) rim_load[i] = 0.0;
        for (const triangle& t : mesh_.triangles)
            for (const auto& [i, j] : edges_of(t))
                if (i >= rim && j >= rim) ++starts[i - rim + 2];
        for (std::size_t i = 2; i < n + 2; ++i) starts[i] += starts[i - 1];
        std::uint32_t* const columns = columns_.append(starts[n + 1] + 1);
        double* const shares = shares_.append(starts[n + 1] + 1);
        if (columns == nullptr || shares == nullptr) return false;
        for (const triangle& t : mesh_.triangles) {
            const triangle_weights weights{mesh_.at(t.a), mesh_.at(t.b), mesh_.at(t.c)};
            const double* weight = weights.half_cotangents;
            for (const auto& [i, j] : edges_of(t)) {
                const double w = *weight++;
                (i < rim ? rim_load[i] : load[i - rim]) += weights.third;
                if (i >= rim) diagonal[i - rim] += w;
                if (j >= rim) diagonal[j - rim] += w;
                if (i < rim || j < rim) continue;
                const std::uint32_t k = starts[i - rim + 1]++;
                columns[k] = static_cast<std::uint32_t>(j - rim);
                shares[k] = w;
            }
        }
        return true;
    }

    /// False if out of memory.
    [[nodiscard]] bool find() noexcept
    {
        const std::size_t n = size();
        if (n == 0) return true;
        const std::size_t entries = starts_[n];
        const membrane_matrix a{starts_.view().first(n + 1), columns_.view().first(entries),
                                shares_.view().first(entries), diagonal_.view().first(n)};
        if (!direct_.order(a)) return false;
        const auto count = static_cast<double>(n);
        bool is_found = false;
        if (direct_.work() > 32.0 * count * std::sqrt(count)) {  // about what the steps take
            constexpr int most = 1000;
            if (!stepwise_.open(a)) return false;
            is_found = stepwise_.solve(load_.data(), u_.data(), 1e-8, most) <= most;
        }
        if (!is_found && !direct_.solve(a, load_.data(), u_.data())) return false;
        for (std::size_t i = 0; i < n; ++i) {
            const double least = load_[i] / diagonal_[i];
            if (!(u_[i] > least)) u_[i] = least;
        }
        return true;
    }

    struct edge {
        std::uint32_t from, to;
    };
    [[nodiscard]] static constexpr std::array<edge, 3> edges_of(const triangle& t) noexcept
    {
        return {{{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}};
    }

    membrane_mesh mesh_;
    buffer<std::uint32_t> starts_, columns_;  // the rows of a membrane_matrix
    buffer<double> shares_, diagonal_, load_, rim_load_, u_;
    envelope_factors direct_;
    conjugate_gradients stepwise_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
