// SPDX-License-Identifier: MIT

#include <typemesh/bend/text_path.hpp>

#include "paths.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace typemesh;

namespace {

std::vector<double3> helix(int points, double radius, double rise, double turns)
{
    std::vector<double3> all;
    for (int i = 0; i <= points; ++i) {
        const double t = turns * 6.283185307179586 * i / points;
        all.push_back({radius * std::cos(t), radius * std::sin(t), rise * t});
    }
    return all;
}

}  // namespace

TEST_CASE("a path's frame is orthonormal, its speed nearly 1, and its derivatives are those of its values",
          "[bend][along_curve]")
{
    for (unsigned seed = 0; seed < 8; ++seed) {
        text_path path;
        REQUIRE_FALSE(path.through(paths::random_walk(seed)));
        CHECK(path.length() > 6.0);
        for (double x = 0.01; x < path.length() - 0.01; x += 0.037) {
            const auto f = path.at(x), before = path.at(x - 1e-5), after = path.at(x + 1e-5);
            CHECK(std::abs(length(f.tangent) - 1.0) < 1e-12);
            CHECK(std::abs(length(f.up) - 1.0) < 1e-12);
            CHECK(std::abs(dot(f.tangent, f.up)) < 1e-12);
            CHECK(length(f.toward - cross(f.tangent, f.up)) < 1e-12);
            CHECK(std::abs(length(f.speed) - 1.0) < 5e-3);
            const auto slope = [](double3 a, double3 b) { return (0.5 / 1e-5) * (b - a); };
            CHECK(length(slope(before.at, after.at) - f.speed) < 1e-6);
            CHECK(length(slope(before.tangent, after.tangent) - f.tangent_by) < 1e-4);
            CHECK(length(slope(before.up, after.up) - f.up_by) < 1e-4);
            CHECK(length(slope(before.toward, after.toward) - f.toward_by) < 1e-4);
            // It turns about the tangent as little as possible: up moves nearly along the tangent alone.
            CHECK(std::abs(dot(f.up_by, f.toward)) < 0.03);
        }
    }
}

TEST_CASE("a path goes through its points and has the length of a helix", "[bend][along_curve]")
{
    const auto points = helix(60, 2.0, 0.3, 2.0);
    text_path path;
    REQUIRE_FALSE(path.through(points, {0.0, 0.0, 1.0}));
    CHECK(path.length() == Catch::Approx(2.0 * 6.283185307179586 * std::sqrt(4.0 + 0.09)).epsilon(1e-3));
    for (const double3& p : points) {
        double nearest = 1e9;
        for (double x = 0.0; x <= path.length(); x += 1e-3) nearest = (std::min)(nearest, length(path.at(x).at - p));
        CHECK(nearest < 1e-3);
    }
    for (double x = 2.0; x < path.length() - 2.0; x += 0.1) {
        const auto f = path.at(x);
        CHECK(std::abs(std::hypot(f.at.x, f.at.y) - 2.0) < 1e-3);
        CHECK(length(f.tangent_by) == Catch::Approx(2.0 / 4.09).epsilon(0.02));
    }
}

TEST_CASE("a path fails cleanly without memory and keeps its memory", "[bend][along_curve]")
{
    const auto points = paths::random_walk(1);
    for (std::size_t fails = 1;; ++fails) {
        REQUIRE(fails < 100);
        test::counting_memory scarce;
        scarce.fail_at = fails;
        text_path path{scarce.source()};
        const error e = path.through(points);
        if (!e) break;
        REQUIRE(e == error::out_of_memory);
        CHECK(path.empty());
    }
    test::counting_memory counted;
    text_path path{counted.source()};
    REQUIRE_FALSE(path.through(points));
    const std::size_t before = counted.requests;
    REQUIRE_FALSE(path.through(paths::random_walk(2)));
    CHECK(counted.requests == before);
}
