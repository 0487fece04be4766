// SPDX-License-Identifier: MIT

#include <typemesh/bend/along_curve.hpp>
#include <typemesh/bend/bend_error.hpp>
#include <typemesh/bend/unfolded.hpp>

#include "paths.hpp"
#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace typemesh;

TEST_CASE("the bounds of a curve's deformation hold, and its Jacobian is that of its values", "[bend][along_curve]")
{
    std::mt19937 random{3};
    std::uniform_real_distribution<double> any{0.0, 1.0};
    double loosest = 0.0;
    for (unsigned seed = 0; seed < 8; ++seed) {
        text_path path;
        REQUIRE_FALSE(path.through(paths::random_walk(seed)));
        const along_curve d{&path, 0.0};
        for (int k = 0; k < 4000; ++k) {
            const double x = 0.1 + any(random) * (path.length() - 0.5), w = 0.2 * any(random);
            const box3 b{{x, -0.3 + any(random), -0.2}, {x + w, 0.9, 0.0}};
            const double3 p{x + w * any(random), b.low.y + (b.high.y - b.low.y) * any(random), -0.2 * any(random)};
            const bend_bounds by = d.bend(b);
            constexpr double h = 1e-4;
            const auto second = [&](double3 u, double3 v) {
                return length((0.25 / (h * h)) * ((d(p + h * u + h * v).at - d(p + h * u - h * v).at) -
                                                  (d(p - h * u + h * v).at - d(p - h * u - h * v).at)));
            };
            const double3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};
            if (x + w * 0.0 > h && p.x - 2 * h > b.low.x && p.x + 2 * h < b.high.x) {
                CHECK(second(ex, ex) <= by.xx + 1e-4);
                CHECK(second(ex, ey) <= by.xy + 1e-4);
                CHECK(second(ex, ez) <= by.xz + 1e-4);
                if (second(ex, ex) > 0.5) loosest = (std::max)(loosest, by.xx / second(ex, ex));
            }
            const deformed_point j = d(p);
            CHECK(length((0.5 / h) * (d(p + h * ex).at - d(p - h * ex).at) - j.x) < 1e-4);
            CHECK(length((0.5 / h) * (d(p + h * ey).at - d(p - h * ey).at) - j.y) < 1e-8);
            CHECK(length((0.5 / h) * (d(p + h * ez).at - d(p - h * ez).at) - j.z) < 1e-8);
        }
    }
    CAPTURE(loosest);
    CHECK(loosest < 40.0);
}

TEST_CASE("flat triangles along a curve are never farther from the curve's own than promised", "[bend][along_curve]")
{
    std::mt19937 random{5};
    std::uniform_real_distribution<double> any{0.0, 1.0};
    text_path path;
    REQUIRE_FALSE(path.through(paths::random_walk(11)));
    const along_curve d{&path, 0.2};
    for (int k = 0; k < 3000; ++k) {
        double3 c[3], image[3];
        const double x = any(random) * (path.length() - 1.0), size = 0.3 * any(random);
        box3 b{{1e9, 1e9, 1e9}, {-1e9, -1e9, -1e9}};
        for (int i = 0; i < 3; ++i) {
            c[i] = {x + size * any(random), any(random) - 0.2, -0.2 * any(random)};
            image[i] = d(c[i]).at;
            b.low = {(std::min)(b.low.x, c[i].x), (std::min)(b.low.y, c[i].y), (std::min)(b.low.z, c[i].z)};
            b.high = {(std::max)(b.high.x, c[i].x), (std::max)(b.high.y, c[i].y), (std::max)(b.high.z, c[i].z)};
        }
        const double promised = bend_error(d.bend(b), b.high - b.low);
        for (int i = 0; i < 20; ++i) {
            double u = any(random), v = any(random);
            if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
            const double3 p = (1.0 - u - v) * c[0] + u * c[1] + v * c[2],
                          q = (1.0 - u - v) * image[0] + u * image[1] + v * image[2];
            CHECK(length(d(p).at - q) <= promised);
        }
    }
}

TEST_CASE("paths and places on them that cannot be used are refused", "[bend][along_curve]")
{
    text_path path;
    CHECK(along_curve{}.refused_options() == error::bad_option);
    CHECK(along_curve{&path, 0.0}.refused_options() == error::bad_option);
    const auto option = [&](std::vector<double3> points, double3 up = {0.0, 1.0, 0.0}) {
        const error e = path.through(points, up);
        CHECK(e == error::bad_option);
        CHECK(path.empty());
        CHECK(!(path.length() > 0.0));
        return std::string{e.option == nullptr ? "" : e.option};
    };
    CHECK(option({}) == "points");
    CHECK(option({{0, 0, 0}}) == "points");
    CHECK(option({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}) == "points");
    CHECK(option({{0, 0, 0}, {std::nan(""), 0, 0}}) == "points");
    CHECK(option({{0, 0, 0}, {0, 1, 0}}) == "up");
    CHECK(option({{0, 0, 0}, {1, 0, 0}}, {0.0, 0.0, 0.0}) == "up");
    REQUIRE_FALSE(path.through(std::vector<double3>{{0, 0, 0}, {3, 0, 0}, {6, 1, 0}}));
    const along_curve d{&path, 1.0};
    CHECK_FALSE(d.refused_options());
    CHECK_FALSE(d.refused_text({{0.0, 0.0, 0.0}, {4.0, 1.0, 0.0}}));
    CHECK(d.refused_text({{-2.1, 0.0, 0.0}, {4.0, 1.0, 0.0}}) == error::bad_option);
    CHECK(d.refused_text({{0.0, 0.0, 0.0}, {7.0, 1.0, 0.0}}) == error::goes_around);
    CHECK(along_curve{&path, std::nan("")}.refused_options() == error::bad_option);
    // A circle of radius 0.5 folds letters that reach 0.7 towards its middle, but not away from it.
    std::vector<double3> arc;
    for (int i = 0; i <= 40; ++i) arc.push_back({0.5 * std::sin(0.1 * i), 0.5 - 0.5 * std::cos(0.1 * i), 0.0});
    REQUIRE_FALSE(path.through(arc));
    CHECK_FALSE(is_unfolded(along_curve{&path, 0.0}, {{0.5, 0.0, -0.1}, {1.0, 0.7, 0.0}}));
    CHECK(is_unfolded(along_curve{&path, 0.0}, {{0.5, -0.7, -0.1}, {1.0, 0.0, 0.0}}));
}
