// SPDX-License-Identifier: MIT
#include <typemesh/core/grid.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/quality.hpp>

#include "support/catch.hpp"

#include "discretise/curves.hpp"

using namespace typemesh;
using namespace test;

namespace {

constexpr double qualities[] = {quality::low, quality::normal, quality::high, quality::best};

/// Names the law that a curve breaks, or nothing.
std::string broken_law(const curve& c, double tolerance)
{
    const auto points = points_of(certified{}, c, tolerance);
    if (points.empty()) return "no point";
    if (points.back().t != 1.0 || !(points.back().p == c.end())) return "the last point is not the curve's end";
    const double size = 1.0 + std::abs(c.p[0].x) + std::abs(c.p[0].y) + length(c.p[1] - c.p[0]) +
                        length(c.p[2] - c.p[0]) + length(c.end() - c.p[0]);
    double t = 0.0;
    for (const emitted& e : points) {
        if (!(e.t > t)) return "t does not ascend";
        if (length(e.p - c.at(e.t)) > 1e-13 * size) return "a point is off the curve";
        if (chord_error(c, t, e.t) > tolerance)
            return "a chord is off by " + std::to_string(chord_error(c, t, e.t) / tolerance) + " tolerances";
        t = e.t;
    }
    return "";
}

/// The stored t of the points where the curve stops and turns.
std::vector<double> corners(const curve& c, double tolerance)
{
    std::vector<double> ts;
    for (const emitted& e : points_of(certified{}, c, tolerance)) {
        const double stored = static_cast<double>(static_cast<float>(e.t));
        const point before = tangent(c, stored, side_of::before), after = tangent(c, stored, side_of::after);
        if (e.t < 1.0 && dot(before, after) < 0.0) ts.push_back(e.t);
    }
    return ts;
}

}  // namespace

TEST_CASE("certified keeps the tolerance on curves of real fonts", "[certified]")
{
    const std::uint32_t degree = GENERATE(2u, 3u);
    for (const font_curve& f : font_curves(degree))
        for (const double q : qualities) {
            INFO(f.c << " at " << q << " em");
            REQUIRE(broken_law(f.c, q * f.units_per_em) == "");
        }
}

TEST_CASE("certified keeps the tolerance on random, degenerate, closed and collinear curves", "[certified]")
{
    const std::uint32_t degree = GENERATE(2u, 3u);
    std::mt19937 dice{2020 + degree};
    for (int i = 0; i < 6000; ++i) {
        const curve c = random_curve(dice, degree);
        for (const double tolerance : {100.0, 5.0, 0.5, 0.02}) {
            INFO(c << " with " << tolerance);
            REQUIRE(broken_law(c, tolerance) == "");
        }
    }
}

TEST_CASE("certified keeps the tolerance on curves of any scale", "[certified]")
{
    std::mt19937 dice{7};
    const double scale = GENERATE(0x1p-40, 0x1p-12, 0x1p40);
    for (int i = 0; i < 300; ++i)
        for (const std::uint32_t degree : {2u, 3u}) {
            curve c = random_curve(dice, degree);
            for (point& p : c.p) p = scale * p;
            INFO(c);
            REQUIRE(broken_law(c, 0.3 * scale) == "");
        }
}

TEST_CASE("certified needs at most 1 % more chords than the least possible for real fonts", "[certified]")
{
    const std::uint32_t degree = GENERATE(2u, 3u);
    for (const double q : qualities) {
        double count = 0.0, least = 0.0;
        for (const font_curve& f : font_curves(degree)) {
            const double tolerance = q * f.units_per_em - grid{}.snap_error();
            count += static_cast<double>(points_of(certified{}, f.c, tolerance).size());
            least += least_count(f.c, tolerance);
        }
        INFO("degree " << degree << " at " << q << " em: " << count << " chords instead of " << least);
        CHECK(count <= 1.01 * least);
    }
}

TEST_CASE("certified never needs more chords than Wang's bound", "[certified]")
{
    const std::uint32_t degree = GENERATE(2u, 3u);
    std::mt19937 dice{11};
    for (int i = 0; i < 3000; ++i) {
        const curve c = random_curve(dice, degree);
        const double tolerance = 0.5;
        double bend = length(c.p[0] - 2.0 * c.p[1] + c.p[2]);
        if (degree == 3) bend = (std::max)(bend, length(c.p[1] - 2.0 * c.p[2] + c.p[3]));
        std::size_t stops = 0;  // points that are there for another reason
        for (const double t : ts_of(certified{}, c, tolerance))
            stops += t < 1.0 && tangents_at(c, static_cast<double>(static_cast<float>(t))).stops ? 1u : 0u;
        const double wang = std::ceil(std::sqrt((degree == 2 ? 0.25 : 0.75) * bend / tolerance * 1.00001));
        INFO(c);
        REQUIRE(static_cast<double>(points_of(certified{}, c, tolerance).size()) <=
                (std::max)(wang, 1.0) + static_cast<double>(stops));
    }
}

TEST_CASE("certified makes a straight curve one chord, and so a curve that is a point", "[certified]")
{
    for (const curve& c :
         {curve::from(quadratic{{0, 0}, {1, 2}, {2, 4}}), curve::from(quadratic{{0, 0}, {0, 0}, {200, 400}}),
          curve::from(cubic{{0, 0}, {100, 200}, {200, 400}, {300, 600}}),
          curve::from(cubic{{0, 0}, {0, 0}, {300, 600}, {300, 600}}), curve::from(quadratic{{5, 5}, {5, 5}, {5, 5}}),
          curve::from(cubic{{5, 5}, {5, 5}, {5, 5}, {5, 5}})})
        CHECK(ts_of(certified{}, c, 1e-3) == std::vector<double>{1.0});
}

TEST_CASE("certified emits the point where a quadratic turns back, whatever the tolerance", "[certified]")
{
    const double tolerance = GENERATE(1e-3, 1.0, 1e6);
    const double end = GENERATE(0.0, 100.0);  // x(t) = 600t + (end - 600)t² turns at t = 300/(600 - end)
    const curve c = curve::from(quadratic{{0, 0}, {300, 600}, {end, 2 * end}});
    const auto ts = ts_of(certified{}, c, tolerance);
    REQUIRE(ts.size() == 2);
    CHECK(std::abs(ts[0] - 300.0 / (600.0 - end)) < 1e-15);
    CHECK(corners(c, tolerance).size() == 1);
}

TEST_CASE("certified emits the cusp of a cubic, and both turns of one that doubles back", "[certified]")
{
    const double tolerance = GENERATE(0.01, 1.0, 1000.0);
    const curve cusp = curve::from(cubic{{0, 0}, {300, 300}, {0, 300}, {300, 0}});
    REQUIRE(corners(cusp, tolerance).size() == 1);
    CHECK(std::abs(corners(cusp, tolerance)[0] - 0.5) < 1e-15);

    const curve doubled = curve::from(cubic{{0, 0}, {300, 0}, {-200, 0}, {100, 0}});  // B' = 0 where 9 - 48t + 48t² = 0
    const auto turns = corners(doubled, tolerance);
    REQUIRE(turns.size() == 2);
    CHECK(std::abs(turns[0] - 0.25) < 1e-15);
    CHECK(std::abs(turns[1] - 0.75) < 1e-15);
}

TEST_CASE("certified makes every cusp a corner, also when t is stored as a float", "[certified]")
{
    // B' = (t - s) (u + v t): a cusp at s, turned and moved about.
    std::mt19937 dice{3};
    std::uniform_real_distribution<double> any{-1000.0, 1000.0}, inner{0.02, 0.98};
    for (int i = 0; i < 3000; ++i) {
        const double s = inner(dice);
        const point u{any(dice), any(dice)}, v{any(dice), any(dice)}, p0{any(dice), any(dice)};
        const point c1 = -s * u, c2 = 0.5 * (u - s * v), c3 = (1.0 / 3.0) * v;
        const point p1 = p0 + (1.0 / 3.0) * c1, p2 = p1 + (1.0 / 3.0) * (c1 + c2), p3 = p0 + c1 + c2 + c3;
        const curve c = curve::from(cubic{p0, p1, p2, p3});
        if (length(u + s * v) < 1.0) continue;  // nearly a stop without a turn
        INFO(c << " with its cusp at " << s);
        bool found = false;
        for (const double t : corners(c, 1.0)) found = found || std::abs(t - s) < 1e-10;
        REQUIRE(found);
        REQUIRE(broken_law(c, 1.0) == "");
    }
}

TEST_CASE("certified emits at most 65,536 points, even for an absurd curve", "[certified]")
{
    const curve q = curve::from(quadratic{{0, 0}, {1e9, 1e9}, {2e9, 0}});
    const curve c = curve::from(cubic{{0, 0}, {-1e9, 1e9}, {3e9, 1e9}, {2e9, 0}});
    for (const double tolerance : {1e-6, 1e-30, 1e-200})
        for (const curve& huge : {q, c}) {
            const auto points = points_of(certified{}, huge, tolerance);
            CHECK(points.size() <= 65536);
            CHECK(points.back().t == 1.0);
        }
}

TEST_CASE("certified's count hardly depends on the direction of an outline", "[certified]")
{
    for (const std::uint32_t degree : {2u, 3u}) {
        double there = 0.0, back = 0.0;
        for (const font_curve& f : font_curves(degree)) {
            curve turned = f.c;
            for (std::uint32_t i = 0; i <= degree; ++i) turned.p[i] = f.c.p[degree - i];
            there += static_cast<double>(points_of(certified{}, f.c, f.units_per_em * quality::high).size());
            back += static_cast<double>(points_of(certified{}, turned, f.units_per_em * quality::high).size());
        }
        CHECK(std::abs(there - back) <= 0.01 * there);
    }
}
