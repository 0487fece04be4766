// SPDX-License-Identifier: MIT

// Tests of this room's oracle itself, on shapes with known offsets.

#include "support/slow_wavefront.hpp"

#include "support/catch.hpp"
#include "support/letters.hpp"
#include "support/regions.hpp"

#include <cmath>
#include <vector>

using Catch::Approx;
using test::slow_wavefront;

namespace {

double area_within(const std::vector<test::polyline>& loops, double distance, const test::slow_joins& joins = {})
{
    slow_wavefront front{loops, joins};
    front.advance(distance);
    CHECK_FALSE(front.is_doubtful());
    return static_cast<double>(front.area());
}

double perimeter(const slow_wavefront& front)
{
    long double sum = 0;
    for (const auto& l : front.loops())
        for (std::size_t i = 0; i < l.size(); ++i) sum += test::length(l[(i + 1) % l.size()] - l[i]);
    return static_cast<double>(sum);
}

const std::vector<test::polyline> tee{test::letter_tee(100)}, aitch{test::letter_aitch(100)};

}  // namespace

TEST_CASE("the slow wavefront closes rectangles, rings and letters at the right distance", "[offset][oracle]")
{
    const auto square = std::vector<test::polyline>{test::square(0, 0, 100)};
    CHECK(area_within(square, 10) == Approx(80 * 80));
    CHECK(area_within(square, 49) == Approx(4));
    CHECK(area_within(square, 51) == Approx(0));
    CHECK(area_within({{{0, 0}, {300, 0}, {300, 100}, {0, 100}}}, 20) == Approx(260 * 60));

    const auto ring = std::vector<test::polyline>{test::square(0, 0, 100), test::reversed(test::square(40, 40, 20))};
    CHECK(area_within(ring, 10) == Approx(80 * 80 - 40 * 40));
    CHECK(area_within(ring, 19) == Approx(62 * 62 - 58 * 58));
    CHECK(area_within(ring, 20) == Approx(0));
    CHECK(area_within(ring, 30) == Approx(0));

    CHECK(area_within(tee, 10) == Approx(38400));
    CHECK(area_within(tee, 50) == Approx(0));
    CHECK(area_within(aitch, 29) == Approx(2 * 42 * 242 + 158 * 2));  // the bar is 2 thick
    CHECK(area_within(aitch, 31) == Approx(2 * 38 * 238));            // the bar is gone
}

TEST_CASE("the slow wavefront sums its swept area exactly through all events", "[offset][oracle]")
{
    const auto swept_to = [](const std::vector<test::polyline>& loops, double distance) {
        slow_wavefront front{loops};
        front.advance(distance / 3);
        front.advance(distance);
        return static_cast<double>(front.swept_volume());
    };
    const auto square = std::vector<test::polyline>{test::square(0, 0, 100)};
    CHECK(swept_to(square, 20) == Approx((1e6 - 60.0 * 60 * 60) / 6));
    CHECK(swept_to(square, 80) == Approx(1e6 / 6));  // a pyramid
    CHECK(swept_to({{{0, 0}, {300, 0}, {300, 100}, {0, 100}}}, 60) ==
          Approx(1e6 / 6 + 200.0 * 100 * 50 / 2));  // a roof
    CHECK(swept_to(aitch, 0) == Approx(0));
    double steps = 0;  // the aitch falls apart on the way
    for (int i = 0; i < 500; ++i) steps += 0.1 * area_within(aitch, 0.1 * (i + 0.5));
    CHECK(swept_to(aitch, 50) == Approx(steps).epsilon(1e-4));
}

TEST_CASE("the slow wavefront of a regular polygon shrinks to its centre", "[offset][oracle]")
{
    for (const int corners : {3, 4, 5, 6, 7, 12, 100}) {
        const auto loops = std::vector<test::polyline>{test::circle(corners, 1e6)};
        const double in_radius = 1e6 * std::cos(test::turn_once / 2 / corners);
        const double whole = area_within(loops, 0.0);
        for (const double share : {0.1, 0.5, 0.9})
            CHECK(area_within(loops, share * in_radius) == Approx(whole * (1 - share) * (1 - share)).epsilon(1e-4));
        CHECK(area_within(loops, in_radius + 1.0) == Approx(0));
    }
}

TEST_CASE("the slow wavefront moves at one speed: its area falls by its length", "[offset][oracle]")
{
    std::vector<std::vector<test::polyline>> shapes{tee, aitch, {test::comb(5)}, test::square_with_holes(3, 7).loops};
    for (std::uint64_t seed = 0; seed < 10; ++seed) shapes.push_back({test::star(25, 1e5, seed)});
    for (const auto& loops : shapes) {
        const std::vector<test::oracle::loop> given{loops.begin(), loops.end()};
        const double most = std::sqrt(area_within(loops, 0.0)) / 5;
        slow_wavefront front{loops};
        for (int step = 0; step < 40; ++step) {
            const double before = static_cast<double>(front.area()), falls = perimeter(front), at = most * step / 40;
            front.advance(at + 1e-6 * most);
            CHECK(before - static_cast<double>(front.area()) <= 1e-6 * most * falls * 1.01);
            front.advance(at + most / 40);
            CHECK(static_cast<double>(front.area()) <= before);
            for (const auto& l : front.loops()) {
                for (const auto p : l) {
                    const typemesh::grid_point q{static_cast<std::int32_t>(std::lround(p.x)),
                                                 static_cast<std::int32_t>(std::lround(p.y))};
                    CHECK(test::oracle::distance(given, q) >= at + most / 40 - 1.0);
                }
            }
        }
        CHECK_FALSE(front.is_doubtful());
    }
}

TEST_CASE("the slow wavefront joins sharp corners, and rounder joins are nearer to a disc", "[offset][oracle]")
{
    // A slit from above: its tip is a reflex corner of nearly a half turn.
    const std::vector<test::polyline> slit{
        {{0, 0}, {1000, 0}, {1000, 1000}, {501, 1000}, {500, 500}, {499, 1000}, {0, 1000}}};
    const double mitred = area_within(slit, 100), bevelled = area_within(slit, 100, {2, 0, 100}),
                 round = area_within(slit, 100, {2, 0.1, 100});
    CHECK(mitred < bevelled);
    CHECK(bevelled < round);
    // Within the walls' offsets, below the tip, half a disc is missing.
    const double walls = 800.0 * 800.0, above_tip = 201.0 * 400.0;
    CHECK(walls - round == Approx(above_tip + test::turn_once / 4 * 100 * 100).epsilon(0.01));

    CHECK(test::slow_joins{2, 0, 100}.turns(3.0L) == 2);
    CHECK(test::slow_joins{1.2L, 0, 100}.turns(3.0L) == 4);
    CHECK(test::slow_joins{2, 0, 100}.turns(1.0L) == 1);
    CHECK(test::slow_joins{0, 0, 100}.turns(3.0L) == 1);
}
