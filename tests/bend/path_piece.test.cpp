// SPDX-License-Identifier: MIT

#include <typemesh/bend/impl/path_piece.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <random>

using namespace typemesh;

namespace {

/// The two halves of a cubic.
cubic half_of(const cubic& c, bool second)
{
    const point a = lerp(c.p0, c.p1, 0.5), b = lerp(c.p1, c.p2, 0.5), d = lerp(c.p2, c.p3, 0.5), ab = lerp(a, b, 0.5),
                bd = lerp(b, d, 0.5), middle = lerp(ab, bd, 0.5);
    return second ? cubic{middle, bd, d, c.p3} : cubic{c.p0, a, ab, middle};
}

}  // namespace

TEST_CASE("the length of an even piece is that of its halves, and of a parabola in closed form", "[bend][path]")
{
    std::mt19937 random{2};
    std::uniform_real_distribution<double> any{-1.0, 1.0};
    int even = 0;
    for (int k = 0; k < 2000; ++k) {
        const auto near_line = [&](double x) { return point{x + 0.04 * any(random), 0.04 * any(random)}; };
        const cubic c{near_line(0.0), near_line(1.0), near_line(2.0), near_line(3.0)};
        detail::path_piece whole, first, second;
        if (!detail::path_piece::read(c, whole)) continue;
        ++even;
        REQUIRE(detail::path_piece::read(half_of(c, false), first));
        REQUIRE(detail::path_piece::read(half_of(c, true), second));
        CHECK(std::fabs(whole.size - (first.size + second.size)) <= 0x1p-47 * whole.size);
        CHECK(std::fabs(detail::cubic_length(c, 0.5) - first.size) <= 0x1p-47 * whole.size);
    }
    CHECK(even > 500);

    // y = x^2 / 2 from 0 to 1
    const quadratic parabola{{0, 0}, {0.5, 0}, {1.0, 0.5}};
    double length = 0.0;
    for (const bool second : {false, true})
        for (const bool later : {false, true}) {
            detail::path_piece piece;
            REQUIRE(detail::path_piece::read(half_of(half_of(raised(parabola), second), later), piece));
            length += piece.size;
        }
    CHECK(std::fabs(length - 0.5 * (std::sqrt(2.0) + std::asinh(1.0))) < 1e-14);
}

TEST_CASE("the curvature of a piece and its derivative stay within their bounds", "[bend][path]")
{
    std::mt19937 random{3};
    std::uniform_real_distribution<double> any{-1.0, 1.0};
    double loosest = 0.0;
    int even = 0;
    for (int k = 0; k < 600; ++k) {
        const auto near_line = [&](double x) { return point{x + 0.04 * any(random), 0.04 * any(random)}; };
        detail::path_piece piece;
        if (!detail::path_piece::read({near_line(0.0), near_line(1.0), near_line(2.0), near_line(3.0)}, piece))
            continue;
        ++even;
        double turn = 0.0, by = 0.0;
        constexpr double h = 1e-3;
        for (double s = h; s < piece.size - h; s += 0.05) {
            const detail::path_place at = piece.at(s);
            REQUIRE(at.curvature >= piece.bounds.low);
            REQUIRE(at.curvature <= piece.bounds.high);
            turn = (std::max)(turn, std::fabs(at.curvature));
            by = (std::max)(by, std::fabs(piece.at(s + h).curvature - piece.at(s - h).curvature) / (2.0 * h));
        }
        CHECK(by <= piece.bounds.by * (1.0 + 1e-6));
        if (turn > 0.1) loosest = (std::max)(loosest, piece.bounds.sharpest() / turn);
    }
    CHECK(even > 100);
    CAPTURE(loosest);
    CHECK(loosest < 4.0);
}

TEST_CASE("a piece with a cusp is not even, whatever is left of it", "[bend][path]")
{
    cubic left = half_of({{0, 0}, {1, 1}, {0, 1}, {1, 0}}, true);  // begins at the cusp
    for (int i = 0; i < 20; ++i) {
        detail::path_piece piece;
        REQUIRE_FALSE(detail::path_piece::read(left, piece));
        CHECK(piece.bounds.sharpest() >= detail::path_bounds::endless);
        left = half_of(left, false);
    }
}
