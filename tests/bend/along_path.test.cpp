// SPDX-License-Identifier: MIT

#include <typemesh/bend/along_path.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <random>

using namespace typemesh;

namespace {

/// A smooth path: a line, an arc, and a cubic that goes on from there.
void draw_smooth(plane_path& way)
{
    way.move({0, 0});
    way.line({2, 0.5});
    const point left{-0.5 / std::sqrt(4.25), 2.0 / std::sqrt(4.25)};
    way.arc(point{2, 0.5} + 1.6 * left, 70.0);
    const plane_path::place end = way.at(way.length());
    way.cubic(end.at + 1.1 * end.tangent, end.at + point{-1, 3}, end.at + point{-3, 3});
    REQUIRE_FALSE(way.failure());
}

}  // namespace

TEST_CASE("the warp along a path has the Jacobian of its values, and its bounds hold", "[bend][path]")
{
    plane_path way;
    draw_smooth(way);
    std::mt19937 random{7};
    std::uniform_real_distribution<double> any{0.0, 1.0};
    for (const bool backwards : {false, true}) {
        const along_path w{&way, 0.3, 0.8, backwards};
        REQUIRE_FALSE(w.refused_options());
        int jumps = 0;
        for (int k = 0; k < 3000; ++k) {
            constexpr double h = 1e-3;
            const point p{(way.length() - 0.4) / 0.8 * any(random), 1.2 * any(random) - 0.4};
            const auto j = w(p);
            const box around{p - point{2 * h, 2 * h}, p + point{2 * h, 2 * h}};
            const bend_bounds by = w.bend(around);
            const auto at = [&](double x, double y) { return w(p + point{h * x, h * y}).at; };
            CHECK(length((1.0 / (h * h)) * (at(1, 0) + at(-1, 0) - 2.0 * j.at)) <= by.xx + by.x_jump / h + 1e-4);
            CHECK(length((0.25 / (h * h)) * (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1))) <= by.xy + 1e-4);
            jumps += by.x_jump > 1e-9 ? 1 : 0;
            CHECK(length((0.5 / h) * (at(1, 0) - at(-1, 0)) - j.x) <= h * by.xx + by.x_jump + 1e-7);
            CHECK(length((0.5 / h) * (at(0, 1) - at(0, -1)) - j.y) < 1e-7);
            CHECK(length(j.y) == Catch::Approx(1.0));
            if (w.is_unfolded(around)) CHECK(cross(j.x, j.y) > 0.0);
        }
        CHECK(jumps > 0);
        CHECK(jumps < 30);
    }
}

TEST_CASE("a line is kept as it is, and walked back it is turned by 180 degrees", "[bend][path]")
{
    plane_path way;
    way.move({0, 0});
    way.line({7, 0});
    const along_path there{&way}, back{&way, 0.0, 1.0, true};
    for (const point p : {point{0.1, 0.7}, point{3.3, -0.2}, point{6.9, 0.0}, point{-1.0, 2.0}}) {
        CHECK(there(p).at == p);
        CHECK(length(back(p).at - point{7.0 - p.x, -p.y}) < 1e-14);
    }
    CHECK(there.bend({{0, -1}, {7, 1}}).xx == 0.0);
    CHECK(there.is_unfolded({{0, -100}, {7, 100}}));
}

TEST_CASE("letters fold over where they reach the centre of a bend, or stand on a corner", "[bend][path]")
{
    plane_path ring;
    ring.circle({0, 0}, 1.0);
    const along_path outside{&ring}, inside{&ring, 0.0, 1.0, true};
    const auto tall = [](double low, double high) { return box{{1.0, low}, {1.5, high}}; };
    CHECK(outside.is_unfolded(tall(-0.9, 50.0)));
    CHECK_FALSE(outside.is_unfolded(tall(-1.1, 0.5)));
    CHECK(inside.is_unfolded(tall(-50.0, 0.9)));
    CHECK_FALSE(inside.is_unfolded(tall(0.0, 1.1)));
    plane_path corner;
    corner.move({0, 0});
    corner.line({2, 0});
    corner.line({2, 2});
    CHECK(along_path{&corner}.is_unfolded({{0.5, 0}, {1.9, 1}}));
    CHECK_FALSE(along_path{&corner}.is_unfolded({{1.5, 0}, {2.1, 1}}));
}

TEST_CASE("a path that is missing, empty or too short for a text around it is refused", "[bend][path]")
{
    plane_path nothing, failed, ring;
    failed.line({1, 0});
    ring.circle({0, 0}, 1.0);
    CHECK(along_path{}.refused_options() == error::bad_option);
    CHECK(along_path{&nothing}.refused_options() == error::bad_option);
    CHECK(along_path{&failed}.refused_options() == error::bad_option);
    CHECK(along_path{&ring, 0.0, 0.0}.refused_options() == error::bad_option);
    for (const double start : {0x1.0001p40, -0x1.0001p40, 1e17, std::nan("")}) {
        const error e = along_path{&ring, start}.refused_options();
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option} == "start");
    }
    CHECK_FALSE(along_path{&ring, -0x1p40}.refused_options());
    CHECK_FALSE(along_path{&ring}.refused_options());
    CHECK_FALSE(along_path{&ring}.refused_text({{-1, 0}, {5.2, 1}}));
    CHECK(along_path{&ring}.refused_text({{-1, 0}, {5.4, 1}}) == error::goes_around);
}
