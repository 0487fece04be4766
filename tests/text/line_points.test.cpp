// SPDX-License-Identifier: MIT

#include <typemesh/text/impl/line_points.hpp>

#include "support/catch.hpp"

#include <typemesh/outline/outline_sink.hpp>

#include <cmath>

using namespace typemesh;

static_assert(outline_sink<detail::line_points>);

TEST_CASE("lines are flattened with the directions of their curves", "[text]")
{
    detail::line_points lines;
    lines.tolerance = 0.01;
    lines.pen = {100, 0};
    lines.move({0, 0});
    lines.quadratic({10, 0}, {10, 10});
    lines.line({10, 20});
    lines.move({50, 0});
    lines.line({60, 0});
    lines.line({60, 10});
    lines.close();
    REQUIRE_FALSE(lines.failed);
    REQUIRE(lines.starts.size() == 2);
    CHECK(lines.closed[0] == 0);
    CHECK(lines.closed[1] == 1);
    REQUIRE(lines.points.size() - lines.starts[1] == 3);
    const auto& first = lines.points[0];
    CHECK(first.at == point{100, 0});
    CHECK(first.before == point{});
    CHECK(cross(first.after, point{1, 0}) == 0.0);  // NOLINT
    const auto& end = lines.points[lines.starts[1] - 1];
    CHECK(end.at == point{110, 20});
    CHECK(cross(end.after, point{0, 1}) == 0.0);          // NOLINT
    CHECK(cross(end.before, point{0, 1}) == 0.0);         // NOLINT
    const auto& corner = lines.points[lines.starts[1]];   // the closing line arrives from the last point
    CHECK(cross(corner.before, point{-10, -10}) == 0.0);  // NOLINT
    CHECK(dot(corner.before, point{-10, -10}) > 0.0);
    // Every point lies on the curve, and every chord within the tolerance of it.
    const quadratic q{{100, 0}, {110, 0}, {110, 10}};
    for (std::uint32_t i = 0; i + 2 < lines.starts[1]; ++i) {
        const point a = lines.points[i].at, b = lines.points[i + 1].at;
        for (int k = 0; k <= 100; ++k) {
            const point p = q.at(k / 100.0);
            const double on = dot(p - a, b - a) / dot(b - a, b - a);
            if (on > 0.0 && on < 1.0) CHECK(std::fabs(cross(p - a, b - a)) <= 0.011 * length(b - a));
        }
    }
}

TEST_CASE("lines of one point stay points, and mistakes are kept", "[text]")
{
    detail::line_points lines;
    lines.move({1, 1});
    lines.close();
    lines.move({2, 2});
    lines.move({3, 3});
    CHECK(lines.points.size() == 3);
    CHECK(lines.closed[0] == 0);
    CHECK_FALSE(lines.failed);
    lines.clear();
    lines.close();
    CHECK_FALSE(lines.failed);
    lines.line({1, 1});
    CHECK(lines.failed == error::bad_outline);
    lines.clear();
    CHECK_FALSE(lines.failed);
    lines.move({0, 0});
    lines.cubic({1, 1}, {INFINITY, 0}, {2, 0});
    CHECK(lines.failed == error::outline_not_finite);
}
