// SPDX-License-Identifier: MIT

// How much work a sweep is, counted: events, and how often it was looked for when a triangle collapses.

#include <typemesh/fill/fill.hpp>
#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

grid_point on_circle(double radius, double turn)
{
    const double angle = 6.283185307179586 * turn;
    return {static_cast<std::int32_t>(std::lround(radius * std::cos(angle))),
            static_cast<std::int32_t>(std::lround(radius * std::sin(angle)))};
}

/// Spikes all around, which close all at once.
test::polyline star(int n)
{
    test::polyline p;
    for (int i = 0; i < n; ++i) p.push_back(on_circle(i % 2 == 0 ? 1e8 : 5e7, double(i) / n));
    return p;
}
/// Teeth on a back that is wider than they are.
test::polyline comb(int n)
{
    const int teeth = n / 4, pitch = 200'000'000 / teeth;
    test::polyline p{{0, -2 * pitch}, {teeth * pitch, -2 * pitch}};
    for (int i = teeth; i-- != 0;) {
        const int x = i * pitch;
        p.insert(p.end(), {{x + pitch / 2, 50'000'000}, {x + pitch / 2, 0}, {x, 0}, {x, 50'000'000 - i % 7 * 1000}});
    }
    return p;
}
test::polyline spiral(int n)
{
    test::polyline p;
    const double turns = std::sqrt(n / 20.0), step = 2e8 / turns;
    for (int i = 0; i <= n / 2; ++i) p.push_back(on_circle(step * (0.8 + turns * 2 * i / n), turns * 2 * i / n));
    for (int i = n / 2; i >= 0; --i) p.push_back(on_circle(step * (0.5 + turns * 2 * i / n), turns * 2 * i / n));
    return p;
}
/// Cut into triangles it is a fan: one corner has them all, and runs into the bow. If it is rough, every other point is
/// moved inwards.
test::polyline parabola(int n, bool rough)
{
    test::polyline p;
    for (int i = 0; i <= n; ++i) {
        const double x = 2.0 * i / n - 1.0;
        p.push_back({static_cast<std::int32_t>(std::lround(2.5e8 * x)),
                     static_cast<std::int32_t>(std::lround(2.5e8 * x * x)) +
                         (rough && i % 2 == 1 && i != 1 && i + 1 != n ? 250'000'000 / n : 0)});
    }
    return p;
}

struct work {
    double events = 0, schedules = 0;  ///< a point
    std::string refused;
};

/// Swept to a width, in cells.
work work_of(const test::polyline& p, double width)
{
    contours loops = test::contours_of(std::vector<test::polyline>{p});
    workspace space;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    REQUIRE(filled);
    triangle_list triangles;
    REQUIRE(!monotone{}(*filled, space, triangles));
    const double levels[] = {0.0, std::floor(width)};
    workspace::scope scratch{space};
    swept_region swept{scratch.source()};
    const error e = sweep_inwards(*filled, triangles.view(), {.levels = levels}, scratch, swept);
    const auto n = static_cast<double>(filled->points().size());
    return {static_cast<double>(swept.events) / n, static_cast<double>(swept.schedules) / n, e ? e.message() : ""};
}

}  // namespace

TEST_CASE("work grows no faster than n log n over stars, combs, spirals and parabolas", "[offset]")
{
    for (const int n : {100, 1'000, 10'000}) {
        const struct {
            const char* name;
            test::polyline points;
            double width;
        } shapes[] = {
            {"star, before its spikes close", star(n), 2.9e8 / n},
            {"star, after", star(n), 3.3e8 / n},
            {"comb, before its teeth close", comb(n), 1.9e8 / n},
            {"comb, after", comb(n), 2.1e8 / n},
            {"spiral, before it closes", spiral(n), 2.5e7 / std::sqrt(n / 20.0)},
            {"spiral, after", spiral(n), 3.5e7 / std::sqrt(n / 20.0)},
            {"parabola", parabola(n, false), 1e8},
            {"rough parabola", parabola(n, true), 1e8},
        };
        for (const auto& s : shapes) {
            CAPTURE(s.name, n);
            const work w = work_of(s.points, s.width);
            CHECK(w.refused == "");
            CHECK(w.events <= 3.0);
            CHECK(w.schedules <= 1.4 * std::log2(n));
        }
    }
}

TEST_CASE("flips that undo each other come to an end", "[offset]")
{
    CHECK(work_of(star(4'000), 80'000).refused == "");
    CHECK(work_of(star(40'000), 8'000).refused == "");
}
