// SPDX-License-Identifier: MIT

#include <typemesh/bend/bend_error.hpp>

#include "deformations.hpp"

using namespace typemesh;

namespace {

/// A random smooth map: in each direction a sum of a quadratic form and a sine.
struct smooth_map {
    double square[3][3][3] = {};  // by output, then a symmetric matrix
    double wave_size[3] = {};
    double3 wave_way[3] = {};

    explicit smooth_map(test::dice& d)
    {
        for (int out = 0; out < 3; ++out) {
            for (int i = 0; i < 3; ++i)
                for (int j = i; j < 3; ++j)
                    square[out][i][j] = square[out][j][i] = d.roll(3) == 0 ? 0.0 : bending::within(d, -1.0, 1.0);
            wave_size[out] = bending::within(d, 0.0, 0.3);
            wave_way[out] = bending::within(d, {{-3.0, -3.0, -3.0}, {3.0, 3.0, 3.0}});
        }
    }
    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const double v[] = {p.x, p.y, p.z};
        double at[3] = {};
        for (int out = 0; out < 3; ++out) {
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j) at[out] += 0.5 * square[out][i][j] * v[i] * v[j];
            at[out] += wave_size[out] * std::sin(dot(wave_way[out], p));
        }
        return {{at[0], at[1], at[2]}, {}, {}, {}};  // derivatives play no part here
    }
    [[nodiscard]] bend_bounds bend(const box3&) const noexcept
    {
        double most[3][3] = {};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                double sum = 0.0;
                for (int out = 0; out < 3; ++out) {
                    const double w[] = {wave_way[out].x, wave_way[out].y, wave_way[out].z};
                    const double one = std::fabs(square[out][i][j]) + wave_size[out] * std::fabs(w[i] * w[j]);
                    sum += one * one;
                }
                most[i][j] = std::sqrt(sum);
            }
        return {most[0][0], most[1][1], most[2][2], most[0][1], most[0][2], most[1][2]};
    }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

box3 box_around(const double3 (&v)[3])
{
    box3 b{v[0], v[0]};
    for (const double3& p : v) {
        b.low = {(std::min)(b.low.x, p.x), (std::min)(b.low.y, p.y), (std::min)(b.low.z, p.z)};
        b.high = {(std::max)(b.high.x, p.x), (std::max)(b.high.y, p.y), (std::max)(b.high.z, p.z)};
    }
    return b;
}

/// Compares flat triangles with bent ones at random points. Returns the greatest ratio of deviation and bound.
template <deformation D>
double greatest_ratio(const D& d, const box3& all, test::dice& dice, int triangles, int samples, std::size_t& total)
{
    double greatest = 0.0;
    for (int round = 0; round < triangles; ++round) {
        const box3 place = bending::box_within(dice, all, 1e-3, round % 3 == 0 ? 1.0 : 0.1);
        double3 v[] = {bending::within(dice, place), bending::within(dice, place), bending::within(dice, place)};
        if (round % 4 == 0) v[2] = v[1];                            // an edge
        if (round % 4 == 1) v[1].z = v[2].z = v[0].z;               // a cap's
        if (round % 4 == 2) v[1] = {v[0].x, v[0].y, place.high.z};  // a wall's
        const box3 b = box_around(v);
        const double bound = bend_error(d.bend(b), b.high - b.low);
        const double3 image[] = {d(v[0]).at, d(v[1]).at, d(v[2]).at};
        for (int k = 0; k < samples; ++k) {
            double s = dice.fraction(), t = dice.fraction();
            if (k == 0) s = 0.5, t = 0.0;
            if (s + t > 1.0) {
                s = 1.0 - s;
                t = 1.0 - t;
            }
            const double3 p = v[0] + s * (v[1] - v[0]) + t * (v[2] - v[0]),
                          flat = image[0] + s * (image[1] - image[0]) + t * (image[2] - image[0]);
            const double off = length(d(p).at - flat);
            greatest = (std::max)(greatest, (off - 1e-13) / (bound + 1e-300));
            ++total;
        }
    }
    return greatest;
}

}  // namespace

TEST_CASE("no point of a bent triangle is farther from the flat one than the bound", "[bend]")
{
    test::dice dice{31};
    std::size_t samples = 0;
    bending::each_ready(
        [&](const auto& d, const box3& all) { CHECK(greatest_ratio(d, all, dice, 120, 60, samples) <= 1.0); });
    for (int map = 0; map < 200; ++map) {
        const smooth_map d{dice};
        CHECK_QUICKLY(greatest_ratio(d, {{-1.0, -1.0, -0.5}, {1.0, 1.0, 0.5}}, dice, 60, 40, samples) <= 1.0);
    }
    CHECK(samples > 1'000'000);
}

TEST_CASE("the bound is reached by the middle of an edge", "[bend]")
{
    test::dice dice{32};
    for (int round = 0; round < 200; ++round) {
        // z = 1/2 sum of B_ij x_i x_j with B_ij >= 0: on an edge that rises in all directions, all terms add up.
        bend_bounds by;
        for (double* b : {&by.xx, &by.yy, &by.zz, &by.xy, &by.xz, &by.yz})
            *b = dice.roll(3) == 0 ? 0.0 : bending::within(dice, 0.0, 4.0);
        const auto height = [&](double3 p) {
            return 0.5 * (by.xx * p.x * p.x + by.yy * p.y * p.y + by.zz * p.z * p.z) + by.xy * p.x * p.y +
                   by.xz * p.x * p.z + by.yz * p.y * p.z;
        };
        const box3 b = bending::box_within(dice, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}}, 1e-3, 1.0);
        const double off = 0.5 * (height(b.low) + height(b.high)) - height(0.5 * (b.low + b.high));
        CHECK(bend_error(by, b.high - b.low) == Approx(off).epsilon(1e-9).margin(1e-14));
        CHECK(bend_error(by, b.high - b.low) >= off - 1e-15);
    }
    // A circle of radius 1: the bound is the sagitta of a short edge, and not below that of a long one.
    const on_cylinder ring{.radius = 1.0};
    for (const double w : {2.0, 0.5, 0.01}) {
        const double sagitta = 1.0 - std::cos(0.5 * w);
        const double bound = bend_error(ring.bend({{0.0, 0.0, 0.0}, {w, 0.0, 0.0}}), {w, 0.0, 0.0});
        CHECK(bound >= sagitta);
        CHECK(bound < 1.1 * sagitta);
    }
}

TEST_CASE("the bound sees in which directions a deformation bends, and of what does not bend it is 0", "[bend]")
{
    constexpr bend_bounds along_x{.xx = 2.0};
    static_assert(bend_error(along_x, {0.0, 5.0, 7.0}) == 0.0);
    static_assert(bend_error({}, {3.0, 5.0, 7.0}) == 0.0);
    CHECK(bend_error(along_x, {2.0, 0.0, 0.0}) == bend_error(along_x, {2.0, 9.0, 9.0}));
    CHECK(bend_error({.xy = 1.0}, {1.0, 1.0, 0.0}) == Approx(0.25));
    CHECK(bend_error({.xz = 1.0}, {1.0, 0.0, 1.0}) == Approx(0.25));
    CHECK(bend_error({.yz = 1.0}, {0.0, 1.0, 1.0}) == Approx(0.25));
    CHECK(bend_error({.xx = HUGE_VAL}, {1.0, 1.0, 1.0}) == HUGE_VAL);
}
