// SPDX-License-Identifier: MIT
#pragma once

// Shapes that are inflated, in em, and a slow solution on a square grid beside it.

#include "support/refined_shape.hpp"

#include <typemesh/inflate/membrane.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace inflating {

using namespace typemesh;
using loop_list = std::vector<test::polyline>;

inline constexpr double em = 512000.0;  ///< cells

inline grid_point at(double x, double y)
{
    return {static_cast<std::int32_t>(std::lround(em * x)), static_cast<std::int32_t>(std::lround(em * y))};
}

/// A shape, filled and inflated.
struct inflated_shape {
    test::filled_shape filled;
    triangle_list given;
    test::refined_result cap;
    membrane sheet;

    explicit inflated_shape(const loop_list& loops, float edge = 0.03f)
        : filled{{"", loops}, fill_rule::non_zero, {512.0, 1000.0}}
    {
        workspace space;
        REQUIRE_FALSE(constrained_delaunay{}(filled.filled, space, given));
        REQUIRE(inflate(edge) == error::none);
    }

    error inflate(float edge) { return sheet.inflate(filled.filled, given.view(), {.edge = edge}, cap.out()); }

    /// f(place in em, membrane_point) for each inner point.
    template <class F>
    void each_inner(const F& f) const
    {
        for (std::size_t i = 0; i < cap.inner.size(); ++i)
            f(point{cap.inner[i].x / em, cap.inner[i].y / em}, sheet.points()[i]);
    }

    /// The volume under the triangles, in cubic em.
    [[nodiscard]] double volume() const
    {
        const std::vector<grid_point> points = cap.points();
        const auto height = [&](std::uint32_t i) {
            return i < cap.loops.points.size() ? 0.0 : double{sheet.points()[i - cap.loops.points.size()].height};
        };
        double sum = 0.0;
        for (const triangle t : cap.triangles)
            sum += static_cast<double>(orientation(points[t.a], points[t.b], points[t.c])) / 6.0 *
                   (height(t.a) + height(t.b) + height(t.c));
        return sum / (em * em);
    }
};

/// The membrane's system on a refined cap.
inline detail::membrane_mesh mesh_of(const test::refined_result& cap)
{
    return {cap.loops.points.view(), cap.inner.view(), cap.triangles.view()};
}

/// How far u at the inner points is from a solution: the load that it does not hold up, in relation to the load, both
/// as the root of the sum of squares. Summed here without the library.
inline double residual_of(const detail::membrane_mesh& m, array_view<const double> u)
{
    const std::size_t rim = m.rim.size();
    std::vector<double> rest(m.inner.size(), 0.0), load(m.inner.size(), 0.0);
    const auto value = [&](std::uint32_t i) { return i < rim ? 0.0 : u[i - rim]; };
    for (const triangle t : m.triangles) {
        const std::uint32_t corner[] = {t.a, t.b, t.c};
        const double area = 0.5 * double(orientation(m.at(t.a), m.at(t.b), m.at(t.c)));
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t i = corner[k], j = corner[(k + 1) % 3], apex = corner[(k + 2) % 3];
            const grid_point o = m.at(apex), p = m.at(i), q = m.at(j);
            const double cosine = (double(p.x) - o.x) * (double(q.x) - o.x) + (double(p.y) - o.y) * (double(q.y) - o.y),
                         flow = 0.25 * cosine / area * (value(j) - value(i));
            if (i >= rim) rest[i - rim] += area / 3.0 + flow, load[i - rim] += area / 3.0;
            if (j >= rim) rest[j - rim] -= flow;
        }
    }
    double square = 0.0, whole = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i) square += rest[i] * rest[i], whole += load[i] * load[i];
    return rest.empty() ? 0.0 : std::sqrt(square / whole);
}

/// Letters and other shapes by name, with outer loops counter-clockwise.
inline std::vector<std::pair<std::string, loop_list>> inflatable_shapes()
{
    const auto circle = [](double x, double y, double r, int points, bool clockwise) {
        test::polyline loop;
        for (int i = 0; i < points; ++i) {
            const double turn = (clockwise ? -2.0 : 2.0) * 3.14159265358979 * i / points;
            loop.push_back(at(x + r * std::cos(turn), y + r * std::sin(turn)));
        }
        return loop;
    };
    return {{"E",
             {{at(0, 0), at(0.5, 0), at(0.5, 0.1), at(0.12, 0.1), at(0.12, 0.3), at(0.4, 0.3), at(0.4, 0.4),
               at(0.12, 0.4), at(0.12, 0.6), at(0.5, 0.6), at(0.5, 0.7), at(0, 0.7)}}},
            {"O", {circle(0.36, 0.36, 0.35, 80, false), circle(0.36, 0.36, 0.2, 60, true)}},
            {"hairline with serifs",
             {{at(0, 0), at(0.3, 0), at(0.3, 0.02), at(0.17, 0.03), at(0.165, 0.64), at(0.3, 0.65), at(0.3, 0.67),
               at(0, 0.67), at(0, 0.65), at(0.135, 0.64), at(0.13, 0.03), at(0, 0.02)}}},
            {"needle", {{at(0, 0), at(0.9, 0.02), at(0, 0.12)}}},
            {"star",
             {{at(0.3, 0), at(0.36, 0.2), at(0.6, 0.25), at(0.4, 0.36), at(0.45, 0.6), at(0.3, 0.43), at(0.1, 0.6),
               at(0.2, 0.36), at(0, 0.25), at(0.24, 0.2)}}}};
}

/// The same membrane on a square grid, by finite differences (Shortley & Weller: exact arms at the outline) and
/// successive over-relaxation.
class by_differences {
public:
    explicit by_differences(const loop_list& loops)
    {
        for (int y = 1; y + 1 < n; ++y) {
            for (int x = 1; x + 1 < n; ++x) {
                if (!is_inside(loops, place(x), place(y))) continue;
                pixel p{y * n + x, {1.0, 1.0, 1.0, 1.0}};
                for (const auto& loop : loops)
                    for (std::size_t i = 0; i < loop.size(); ++i)
                        shorten(p, loop[i], loop[(i + 1) % loop.size()], place(x), place(y));
                inside_[std::size_t(p.index)] = true;
                pixels_.push_back(p);
            }
        }
        for (int step = 0; step < 700; ++step) {
            for (const pixel& p : pixels_) {
                double weights = 0.0, sum = 0.5 * side * side;
                for (int arm = 0; arm < 4; ++arm) {
                    constexpr int to[] = {1, -1, n, -n};
                    const double whole = p.arms[arm] + p.arms[arm ^ 1], weight = 1.0 / (p.arms[arm] * whole);
                    weights += weight;
                    if (p.arms[arm] >= 1.0) sum += weight * u_[std::size_t(p.index + to[arm])];
                }
                double& u = u_[std::size_t(p.index)];
                u += 1.85 * (sum / weights - u);
            }
        }
    }

    /// The volume under the heights, in cubic em.
    [[nodiscard]] double volume() const
    {
        double sum = 0.0;
        for (const double u : u_) sum += std::sqrt(2.0 * u);
        return sum * side * side;
    }

    /// The height at a place in em; negative if it is within a pixel of the outline.
    [[nodiscard]] double height(point p) const
    {
        const double x = p.x / side + 9.5, y = p.y / side + 9.5;
        const auto left = std::size_t(x), low = std::size_t(y), i = low * n + left;
        for (const std::size_t corner : {i, i + 1, i + n, i + n + 1})
            if (!inside_[corner]) return -1.0;
        const double s = x - double(left), t = y - double(low);
        return std::sqrt(
            2.0 * ((1.0 - t) * ((1.0 - s) * u_[i] + s * u_[i + 1]) + t * ((1.0 - s) * u_[i + n] + s * u_[i + n + 1])));
    }

private:
    static constexpr int n = 380;  // pixels
    static constexpr double side = 1.0 / 360.0;

    struct pixel {
        int index;
        double arms[4];  // right, left, up, down, in pixels
    };

    [[nodiscard]] static double place(int i) { return em * side * (i - 9.5); }

    [[nodiscard]] static bool is_inside(const loop_list& loops, double x, double y)
    {
        int winding = 0;
        for (const auto& loop : loops) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const grid_point a = loop[i], b = loop[(i + 1) % loop.size()];
                const double turn = (double(b.x) - a.x) * (y - a.y) - (x - a.x) * (double(b.y) - a.y);
                if (a.y <= y && b.y > y && turn > 0.0) ++winding;
                if (a.y > y && b.y <= y && turn < 0.0) --winding;
            }
        }
        return winding != 0;
    }

    /// Ends a pixel's arms where an edge crosses them.
    static void shorten(pixel& p, grid_point a, grid_point b, double x, double y)
    {
        const auto cut = [&](int arm, double length) {
            if (length < 0.0) ++arm;
            p.arms[arm] = (std::min)(p.arms[arm], (std::max)(1e-3, std::abs(length) / (em * side)));
        };
        if ((a.y <= y) != (b.y <= y)) cut(0, a.x + (y - a.y) / (double(b.y) - a.y) * (double(b.x) - a.x) - x);
        if ((a.x <= x) != (b.x <= x)) cut(2, a.y + (x - a.x) / (double(b.x) - a.x) * (double(b.y) - a.y) - y);
    }

    std::vector<pixel> pixels_;
    std::vector<double> u_ = std::vector<double>(n * n, 0.0);
    std::vector<bool> inside_ = std::vector<bool>(n * n, false);
};

}  // namespace inflating
