// SPDX-License-Identifier: MIT

#include <typemesh/bend/plane_path.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include "support/catch.hpp"
#include "support/each_failure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

using namespace typemesh;

static_assert(outline_sink<plane_path>);  // an outline source can draw into it

namespace {

constexpr double pi = 3.141592653589793;

/// A line, an arc, a quadratic and a cubic, smoothly joined, but for the last one.
void draw(plane_path& way)
{
    way.move({0, 0});
    way.line({2, 0});
    way.arc({2, 1.5}, 120.0);
    const plane_path::place end = way.at(way.length());
    way.quadratic(end.at + end.tangent, end.at + point{-2, 1.2});
    way.cubic({-1, 3}, {-3, 3.5}, {-3, 1});
}

}  // namespace

TEST_CASE("places on a path follow each other at the speed of 1", "[bend][path]")
{
    plane_path way;
    draw(way);
    REQUIRE_FALSE(way.failure());
    constexpr double h = 1e-5;
    double slowest = 1.0, fastest = 1.0, worst = 0.0, length = 0.0;
    for (double s = 0.001; s + h < way.length(); s += 0.0137) {
        const auto point_at = [&](double d) {
            const plane_path::place p = way.at(d);
            return p.at + (d - p.from) * p.tangent;
        };
        const point step = (1.0 / h) * (point_at(s + h) - point_at(s));
        slowest = (std::min)(slowest, typemesh::length(step));
        fastest = (std::max)(fastest, typemesh::length(step));
        worst = (std::max)(worst, std::fabs(cross(step, way.at(s + 0.5 * h).tangent)));
        length += typemesh::length(point_at(s) - point_at((std::max)(0.0, s - 0.0137)));
    }
    CHECK(slowest > 1.0 - 1e-5);
    CHECK(fastest < 1.0 + 1e-5);
    CHECK(worst < 1e-5);
    CHECK(length == Catch::Approx(way.length()).epsilon(0.01));
}

TEST_CASE("a circle is round, and its middle is on top", "[bend][path]")
{
    for (const double radius : {0.25, 2.0, 1000.0}) {
        plane_path ring;
        ring.circle({1, -2}, radius);
        REQUIRE_FALSE(ring.failure());
        CHECK(ring.is_closed());
        CHECK(ring.length() == Catch::Approx(2.0 * pi * radius).epsilon(1e-15));
        for (int i = -5; i < 40; ++i) {
            const double share = i / 17.0;
            const plane_path::place p = ring.at(share * ring.length());
            const point arm = p.at - point{1, -2};
            CHECK(std::fabs(length(arm) - radius) < 1e-11 * radius);
            CHECK(std::fabs(dot(arm, p.tangent)) < 1e-11 * radius);
            CHECK(cross(arm, p.tangent) < 0.0);  // clockwise
            CHECK(p.curvature == Catch::Approx(-1.0 / radius));
            const double angle = -0.5 * pi - 2.0 * pi * share;
            CHECK(length(arm - radius * point{std::cos(angle), std::sin(angle)}) < 1e-10 * radius);
        }
        CHECK(ring.at(0.5 * ring.length()).at.y == Catch::Approx(radius - 2.0));
        CHECK(ring.between(0.0, ring.length()).sharpest() == Catch::Approx(1.0 / radius));
    }
}

TEST_CASE("an open path goes on straight beyond its ends, a closed one around", "[bend][path]")
{
    plane_path way;
    way.move({1, 1});
    way.arc({1, 0}, -90.0);
    const plane_path::place before = way.at(-3.0), behind = way.at(way.length() + 3.0);
    CHECK(length(before.at - point{1, 1}) < 1e-12);
    CHECK(before.from == Catch::Approx(0.0).margin(1e-15));
    CHECK(length(before.tangent - point{1, 0}) < 1e-11);
    CHECK(length(behind.at - point{2, 0}) < 1e-11);
    CHECK(length(behind.tangent - point{0, -1}) < 1e-11);
    CHECK(behind.curvature == 0.0);
    plane_path square;
    square.move({0, 0});
    for (const point p : {point{3, 0}, point{3, 3}, point{0, 3}}) square.line(p);
    square.close();
    CHECK(square.length() == 12.0);
    for (const double gap : {0x1p-29, 0x1p-31}) {  // a shorter gap than 2^-30 is left
        plane_path triangle;
        triangle.move({0, 0});
        for (const point p : {point{3, 0}, point{3, 4}, point{gap, 0}}) triangle.line(p);
        triangle.close();
        const plane_path::place end = triangle.at(triangle.length());
        CHECK((length(end.at + (triangle.length() - end.from) * end.tangent) < 0x1p-40) == (gap > 0x1p-30));
    }
    for (const double s : {-5.0, 7.0, 19.0}) {
        const plane_path::place p = square.at(s);
        CHECK(p.at + (s - p.from) * p.tangent == point{2, 3});
    }
}

TEST_CASE("corners and cusps have no bounded curvature, smooth joints have", "[bend][path]")
{
    plane_path way;
    draw(way);
    const auto endless = [](const plane_path& w, double low, double high) {
        return w.between(low, high).sharpest() >= plane_path::bounds::endless;
    };
    const double arc = 1.5 * pi * 2.0 / 3.0;
    CHECK_FALSE(endless(way, 1.5, 2.0 + arc + 0.5));  // line, arc and quadratic
    CHECK(endless(way, 0.0, way.length()));           // the cubic begins with a corner
    CHECK_FALSE(way.is_straight());
    plane_path square;
    square.move({0, 0});
    for (const point p : {point{3, 0}, point{3, 3}, point{0, 3}}) square.line(p);
    square.close();
    CHECK_FALSE(endless(square, 0.1, 2.9));
    CHECK(endless(square, 2.5, 3.5));
    CHECK(endless(square, 11.5, 12.5));
    CHECK(endless(square, -0.5, 0.5));
    for (const int arcs : {2, 3, 4, 6, 7}) {  // they miss their start by roundings
        plane_path ring;
        ring.move({1.3, 0.2});
        for (int k = 0; k < arcs; ++k) ring.arc({0.1, -0.4}, -360.0 / arcs);
        ring.close();
        REQUIRE_FALSE(ring.failure());
        CHECK(ring.length() == Catch::Approx(2.0 * pi * std::hypot(1.2, 0.6)));
        CHECK_FALSE(endless(ring, -0.5, 1.5 * ring.length()));
    }
    plane_path negative;
    negative.circle({0, 0}, -1.0);
    CHECK(negative.failure());
    plane_path cusp;
    cusp.move({0, 0});
    cusp.cubic({1, 1}, {0, 1}, {1, 0});
    REQUIRE_FALSE(cusp.failure());
    CHECK(endless(cusp, 0.0, cusp.length()));
    // The two halves are mirror images; each is a semicubical parabola's.
    CHECK(length(cusp.at(0.5 * cusp.length()).at - point{0.5, 0.75}) < 1e-12);
}

TEST_CASE("where a handle has no length, a path has the direction in which it goes on", "[bend][path]")
{
    const point up{0, 1};
    const auto check = [&](point control, point control_2, point first, point last) {
        plane_path way;
        way.move({1, 1});
        way.cubic(control, control_2, {1, 4});
        REQUIRE_FALSE(way.failure());
        const double all = way.length();
        for (const double s : {-0.5, 0.0, 1e-9}) CHECK(length(way.at(s).tangent - first) < 1e-4);
        for (const double s : {all - 1e-9, all, all + 0.5}) CHECK(length(way.at(s).tangent - last) < 1e-4);
        CHECK(length(way.at(0.0).at - point{1, 1}) < 1e-11);
        CHECK(length(way.at(all).at - point{1, 4}) < 1e-11);
    };
    check({1, 1}, {1, 4}, up, up);  // as programs draw lines
    check({1, 1}, {1, 1}, up, up);  // and all three points are one
    check({1, 4}, {1, 4}, up, up);
    check({1, 1}, {4, 1}, {1, 0}, std::sqrt(0.5) * point{-1, 1});
    check({4, 4}, {1, 4}, std::sqrt(0.5) * point{1, 1}, {-1, 0});
    // Too short a piece for a direction is left out.
    plane_path way;
    way.move({0, 0});
    way.line({0, 1e-162});
    CHECK(way.empty());
    way.line({3, 0});
    CHECK(way.is_straight());
    CHECK(length(way.at(-1.0).tangent - point{1, 0}) < 1e-12);
}

TEST_CASE("a contour of an outline is a closed path", "[bend][path]")
{
    outline drawn;
    const curve curves[] = {curve::from(point{0, 0}, point{1000, 0}),
                            curve::from(cubic{{1000, 0}, {1500, 0}, {1500, 1000}, {1000, 1000}}),
                            curve::from(quadratic{{1000, 1000}, {0, 1000}, {0, 0}})};
    for (const curve& c : curves) REQUIRE(drawn.curves.push_back(c));
    for (const std::uint32_t s : {0u, 3u}) REQUIRE(drawn.starts.push_back(s));
    plane_path way, by_hand;
    way.follow(drawn, 0, 1e-3);
    by_hand.move({0, 0});
    by_hand.line({1, 0});
    by_hand.cubic({1.5, 0}, {1.5, 1}, {1, 1});
    by_hand.quadratic({0, 1}, {0, 0});
    by_hand.close();
    REQUIRE_FALSE(way.failure());
    CHECK(way.is_closed());
    CHECK(way.length() == Catch::Approx(by_hand.length()).epsilon(1e-14));
    plane_path none;
    none.follow(drawn, 1, 1e-3);
    CHECK(none.failure().option == std::string_view{"path"});
}

TEST_CASE("a path says what is wrong with it, until it is cleared", "[bend][path]")
{
    const auto refused = [](auto draw) {
        plane_path way;
        draw(way);
        CHECK(way.failure() == error::bad_option);
        way.clear();
        CHECK_FALSE(way.failure());
        way.move({0, 0});
        way.line({1, 0});
        CHECK_FALSE(way.failure());
        CHECK(way.is_straight());
        CHECK(way.length() == 1.0);
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    refused([](plane_path& w) { w.line({1, 0}); });
    refused([](plane_path& w) { w.move({0, nan}); });
    refused([](plane_path& w) { w.move({0, 0}), w.move({1, 0}); });
    refused([](plane_path& w) { w.move({0, 0}), w.line({0x1p21, 0}); });
    refused([](plane_path& w) { w.move({0, 0}), w.arc({0, 0}, 90.0); });
    refused([](plane_path& w) { w.move({0, 0}), w.arc({1, 0}, 0.0); });
    refused([](plane_path& w) { w.circle({0, 0}, 0.0); });
    refused([](plane_path& w) { w.circle({0, 0}, 1.0), w.line({1, 0}); });
    plane_path still;
    still.move({1, 1});
    still.line({1, 1});
    CHECK(still.empty());
    CHECK_FALSE(still.failure());
}

TEST_CASE("a path whose memory fails says so", "[bend][path]")
{
    CHECK(test::check_each_failure([](memory source) {
              plane_path way{source};
              way.circle({0, 0}, 1.0);
              plane_path other{source};
              for (int i = 0; i < 20; ++i) {
                  if (i == 0) other.move({0, 0});
                  other.cubic({1, 1}, {0, 1}, {1, 0.1 * i});
              }
              return way.failure() ? way.failure() : other.failure();
          }) > 2);
}
