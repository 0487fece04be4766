// SPDX-License-Identifier: MIT
#include <typemesh/plate/silhouette.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

using namespace typemesh;

namespace {

double area_of(const silhouette& s)
{
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < s.starts().size(); ++k)
        for (std::uint32_t i = s.starts()[k]; i < s.starts()[k + 1]; ++i) {
            const grid_point p = s.points()[i], q = s.points()[i + 1 < s.starts()[k + 1] ? i + 1 : s.starts()[k]];
            sum += 0.5 * (static_cast<double>(p.x) * q.y - static_cast<double>(p.y) * q.x);
        }
    return sum;
}

}  // namespace

TEST_CASE("a rounded rectangle is symmetric, and its corners are arcs within the tolerance", "[silhouette]")
{
    for (const double radius : {0.0, 0.4, 1.0, 7.0, 1000.0, 20000.0, 1e9})
        for (const double tolerance : {0.5, 20.0}) {
            silhouette s;
            s.begin({});
            REQUIRE(s.add_rectangle({-30000, -20000}, {30000, 20000}, radius, tolerance));
            std::set<std::pair<std::int32_t, std::int32_t>> points;
            for (const grid_point p : s.points()) points.insert({p.x, p.y});
            CHECK(points.size() == s.points().size());
            const double r = radius < 1.0 ? 0.0 : std::min(radius, 20000.0);
            for (const auto& [x, y] : points) {
                CHECK((points.count({-x, y}) == 1 && points.count({x, -y}) == 1));
                const double dx = std::abs(x) - (30000 - r), dy = std::abs(y) - (20000 - r);
                if (r > 0.0) CHECK(std::abs(std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) - r) <= 0.75);
            }
            const double exact = 60000.0 * 40000.0 - (4.0 - 3.14159265358979) * r * r;
            CHECK(std::abs(area_of(s) - exact) <= 6.3 * r * (tolerance + 1.0) + 1.0);
            CHECK(s.low() == grid_point{-30000, -20000});
            CHECK(s.high() == grid_point{30000, 20000});
        }
}

TEST_CASE("an arc is its own mirror image, whatever the last bits of sines and cosines are", "[silhouette]")
{
    // At three chords a quarter the points lie at 30 and 60 degrees, where sines and cosines of a half differ in their
    // last bits. With an odd radius that would decide which way a half is rounded.
    for (const double radius : {1001.0, 1003.0, 4005.0, 4007.0})
        for (const double tolerance : {0.04 * radius, 0.002 * radius}) {
            silhouette s;
            s.begin({});
            REQUIRE(s.add_disc({0, 0}, radius, tolerance));
            std::set<std::pair<std::int32_t, std::int32_t>> points;
            for (const grid_point p : s.points()) points.insert({p.x, p.y});
            for (const auto& [x, y] : points) CHECK(points.count({y, x}) == 1);
        }
}

TEST_CASE("a union has no overlap, and its holes can be filled", "[silhouette]")
{
    silhouette s;
    workspace space;
    s.begin({});
    // A frame of four bars, with a block in its hole.
    REQUIRE(s.add_rectangle({0, 0}, {100, 10}, 0.0, 1.0));
    REQUIRE(s.add_rectangle({0, 90}, {100, 100}, 0.0, 1.0));
    REQUIRE(s.add_rectangle({0, 0}, {10, 100}, 0.0, 1.0));
    REQUIRE(s.add_rectangle({90, 0}, {100, 100}, 0.0, 1.0));
    REQUIRE(s.add_rectangle({40, 40}, {60, 60}, 0.0, 1.0));
    REQUIRE(s.fill(space));
    CHECK(area_of(s) == Catch::Approx(10000.0 - 6400.0 + 400.0));
    CHECK(s.starts().size() == 4);
    silhouette limited;
    limited.begin({});
    for (std::int32_t i = 0; i < 9; ++i) REQUIRE(limited.add_rectangle({9 * i, 0}, {9 * i + 5, 5}, 0.0, 1.0));
    REQUIRE(limited.fill(space));
    CHECK(limited.fill_holes(space, 30).error() == error::too_many_pieces);
    REQUIRE(s.fill_holes(space));
    CHECK(area_of(s) == Catch::Approx(10000.0));
    CHECK(s.starts().size() == 2);
    s.begin({});
    CHECK(s.empty());
    CHECK((s.low() == grid_point{} && s.high() == grid_point{}));
    REQUIRE(s.fill(space));
    REQUIRE(s.fill_holes(space));
    REQUIRE(s.add_diamond({5, 5}, 3));
    CHECK(area_of(s) == Catch::Approx(18.0));
    s.begin({});
    REQUIRE(s.add_rectangle({5, 5}, {5, 9}, 0.0, 1.0));  // without width
    CHECK(s.empty());
}

TEST_CASE("a loop keeps its first point, wherever the one before it has ended", "[silhouette]")
{
    silhouette alone, after;
    for (silhouette* s : {&alone, &after}) s->begin({});
    REQUIRE(after.add_rectangle({0, 0}, {1000, 1000}, 100.0, 1.0));  // it ends at (1000, 100), where the next begins
    for (silhouette* s : {&alone, &after}) REQUIRE(s->add_rectangle({0, -800}, {1000, 200}, 100.0, 1.0));
    const array_view<const grid_point> wanted = alone.points(), found = after.points().subspan(after.starts()[1]);
    CHECK(std::equal(found.begin(), found.end(), wanted.begin(), wanted.end()));
}
