// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/inflate/impl/membrane_system.hpp>

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

    /// The slopes (a, b) at the inner points, in cells, from their values. `unit` is the usual length of an edge. False
    /// if out of memory
    ///
    /// Cost   O(n)
    [[nodiscard]] bool operator()(const membrane_mesh& m, array_view<const double> u, double unit,
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
        const auto value = [&](std::uint32_t i) noexcept { return i < rim ? 0.0 : u[i - rim]; };
        for (const triangle& t : m.triangles) {
            const std::uint32_t corner[] = {t.a, t.b, t.c};
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t i = corner[k], j = corner[k == 2 ? 0 : k + 1];
                if (i < rim || (j >= rim && j < i)) continue;  // an edge between inner points counts once, for both
                const grid_point from = m.at(i), to = m.at(j);
                const neighbour edge{per_cell * (static_cast<double>(to.x) - from.x),
                                     per_cell * (static_cast<double>(to.y) - from.y),
                                     per_square * (value(j) - value(i))};
                sums[i - rim].add(edge, 1.0);
                if (j >= rim) sums[j - rim].add(edge, -1.0);
            }
        }
        for (std::size_t i = 0; i < n; ++i) slopes[i] = unit * sums[i].slope();
        return true;
    }

private:
    /// What the edge to a neighbour contributes. The basis is x, y, p = x^2 - y^2, q = 2 x y, each weighted by
    /// 1 / (x^2 + y^2).
    struct neighbour {
        double x, y, p, q, square;
        double xx, xy, turned;  // the weighted x x, x y, and p
        double rise_by_x, rise_by_y, rise_by_p, rise_by_q;

        neighbour(double dx, double dy, double rise) noexcept : x{dx}, y{dy}
        {
            const double own = x * x;
            square = own + y * y;
            const double weight = 1.0 / square, weighted = weight * rise;
            p = own - y * y;
            q = 2.0 * x * y;
            xx = weight * own;
            xy = weight * (x * y);
            turned = weight * p;
            rise_by_x = weighted * x;
            rise_by_y = weighted * y;
            rise_by_p = weighted * p;
            rise_by_q = weighted * q;
        }
    };

    /// The sums over the neighbours of one point.
    struct normal_equations {
        double count = 0.0, xx = 0.0, xy = 0.0;  // the weighted y y are count - xx
        double xp = 0.0, xq = 0.0, yp = 0.0, yq = 0.0;
        double squares = 0.0, pp = 0.0, pq = 0.0;   // the weighted q q are squares - pp
        double x = 0.0, y = 0.0, p = 0.0, q = 0.0;  // the right side

        /// `way` is 1, or -1 for the edge's other end.
        void add(const neighbour& e, double way) noexcept
        {
            const double quarter = 0.25 * way, twice = 2.0 * way * e.xy, turned = way * e.turned;
            count += 1.0;
            xx += e.xx;
            xy += e.xy;
            xp += turned * e.x;
            xq += twice * e.x;
            yp += turned * e.y;
            yq += twice * e.y;
            squares += e.square;
            pp += e.turned * e.p;
            pq += e.turned * e.q;
            x += e.rise_by_x + quarter * e.x;
            y += e.rise_by_y + quarter * e.y;
            p += way * e.rise_by_p + 0.25 * e.p;
            q += way * e.rise_by_q + 0.25 * e.q;
        }

        /// Eliminates c and d, then solves for a and b.
        [[nodiscard]] point slope() const noexcept
        {
            const double least = 0.02 * squares + 0x1p-100, c = pp + least, d = (squares - pp) + least;
            const double inverse = 1.0 / (c * d - pq * pq);
            const double x_by_p = inverse * (xp * d - xq * pq), x_by_q = inverse * (xq * c - xp * pq),
                         y_by_p = inverse * (yp * d - yq * pq), y_by_q = inverse * (yq * c - yp * pq);
            const double s = xx - (x_by_p * xp + x_by_q * xq), t = xy - (x_by_p * yp + x_by_q * yq),
                         u = (count - xx) - (y_by_p * yp + y_by_q * yq), f = x - (x_by_p * p + x_by_q * q),
                         g = y - (y_by_p * p + y_by_q * q);
            const double determinant = s * u - t * t, scale = 1.0 / (determinant > 0x1p-60 ? determinant : 0x1p-60);
            return {scale * (u * f - t * g), scale * (s * g - t * f)};
        }
    };

    buffer<normal_equations> sums_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
