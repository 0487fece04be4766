// SPDX-License-Identifier: MIT

#include <typemesh/inflate/impl/membrane_system.hpp>

#include "inflated_shape.hpp"

using namespace typemesh;
using detail::membrane_mesh;
using detail::membrane_system;

namespace {

/// u at the inner points by Gauss's elimination of the whole matrix, in the plainest way.
std::vector<double> eliminated(const membrane_mesh& m)
{
    const std::size_t n = m.inner.size(), rim = m.rim.size();
    std::vector<std::vector<double>> rows(n, std::vector<double>(n + 1, 0.0));
    for (const triangle t : m.triangles) {
        const std::uint32_t corner[] = {t.a, t.b, t.c};
        const double area = 0.5 * double(orientation(m.at(t.a), m.at(t.b), m.at(t.c)));
        for (int k = 0; k < 3; ++k) {
            const grid_point o = m.at(corner[k]), p = m.at(corner[(k + 1) % 3]), q = m.at(corner[(k + 2) % 3]);
            const double cosine = (double(p.x) - o.x) * (double(q.x) - o.x) + (double(p.y) - o.y) * (double(q.y) - o.y),
                         w = 0.5 * cosine / (2.0 * area);
            const std::size_t i = corner[(k + 1) % 3], j = corner[(k + 2) % 3];
            if (corner[k] >= rim) rows[corner[k] - rim][n] += area / 3.0;
            if (i >= rim) rows[i - rim][i - rim] += w;
            if (j >= rim) rows[j - rim][j - rim] += w;
            if (i >= rim && j >= rim) {
                rows[i - rim][j - rim] -= w;
                rows[j - rim][i - rim] -= w;
            }
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) {
            const double share = rows[j][i] / rows[i][i];
            if (std::abs(share) > 0.0)
                for (std::size_t k = i; k <= n; ++k) rows[j][k] -= share * rows[i][k];
        }
    std::vector<double> u(n);
    for (std::size_t i = n; i-- > 0;) {
        u[i] = rows[i][n];
        for (std::size_t j = i + 1; j < n; ++j) u[i] -= rows[i][j] * u[j];
        u[i] /= rows[i][i];
    }
    return u;
}

}  // namespace

TEST_CASE("elimination gives the same solution, positive, and what leaves it is the area", "[inflate]")
{
    for (const auto& [name, loops] : inflating::inflatable_shapes()) {
        CAPTURE(name);
        const inflating::inflated_shape shape{loops, 0.08f};
        const membrane_mesh m = inflating::mesh_of(shape.cap);
        const std::vector<double> expected = eliminated(m);
        double highest = 0.0, area = 0.0;
        for (const double u : expected) highest = (std::max)(highest, u);
        for (const triangle t : m.triangles) area += 0.5 * double(orientation(m.at(t.a), m.at(t.b), m.at(t.c)));
        membrane_system system;
        REQUIRE(system.solve(m));
        REQUIRE(system.size() == m.inner.size());
        CHECK(inflating::residual_of(m, system.u()) < 1e-12);
        double farthest = 0.0, least = highest;
        for (std::size_t i = 0; i < expected.size(); ++i) {
            farthest = (std::max)(farthest, std::abs(system.u()[i] - expected[i]));
            least = (std::min)(least, system.u()[i]);
        }
        CHECK(farthest < 1e-10 * highest);
        CHECK(least > 0.0);
        std::vector<double> outflow(m.rim.size(), 0.0);
        system.add_outflow(outflow.data());
        double sum = 0.0;
        for (const double flow : outflow) sum += flow;
        CHECK(sum == Catch::Approx(area).epsilon(1e-7));
    }
}

TEST_CASE("a wide mesh is solved step by step, to a residual of 1e-6", "[inflate]")
{
    const double side = 0.5;
    const inflating::inflated_shape square{
        {{inflating::at(0, 0), inflating::at(side, 0), inflating::at(side, side), inflating::at(0, side)}}, 0.006f};
    const membrane_mesh m = inflating::mesh_of(square.cap);
    CHECK(m.inner.size() > 8000);
    membrane_system system;
    REQUIRE(system.solve(m));
    const double residual = inflating::residual_of(m, system.u());
    CHECK(residual < 1e-6);
    CHECK(residual > 1e-13);  // it was not eliminated
    double highest = 0.0;
    for (const double u : system.u()) highest = (std::max)(highest, u);
    const double cells = side * inflating::em;
    CHECK(highest == Catch::Approx(0.0736714 * cells * cells).epsilon(1e-3));  // the torsion of a square
}

TEST_CASE("the weights of a triangle are half the cotangents of its angles and a third of its area", "[inflate]")
{
    const auto check = [](grid_point a, grid_point b, grid_point c, double ab, double bc, double ca, double third) {
        const detail::triangle_weights w{a, b, c};
        CHECK(w.half_cotangents[0] == Catch::Approx(ab));
        CHECK(w.half_cotangents[1] == Catch::Approx(bc));
        CHECK(w.half_cotangents[2] == Catch::Approx(ca));
        CHECK(w.third == Catch::Approx(third));
    };
    check({5, 7}, {15, 7}, {5, 17}, 0.5, 0.0, 0.5, 50.0 / 3.0);
    check({5, 7}, {15, 7}, {15, 17}, 0.5, 0.5, 0.0, 50.0 / 3.0);
    check({5, 7}, {15, 7}, {-5, 17}, 1.5, -0.5, 1.0, 50.0 / 3.0);
}
