// SPDX-License-Identifier: MIT

// The work of a sweep: the number of events, and of searches for a triangle's collapse.

#include <typemesh/offset/sweep_inwards.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/filled_shape.hpp"

#include <cmath>
#include <cstdint>
#include <string>

using namespace typemesh;

namespace {

/// Spikes all around, which close at the same time.
test::polyline star(int n)
{
    test::polyline p;
    for (int i = 0; i < n; ++i) p.push_back(test::on_circle(0, 0, i % 2 == 0 ? 1e8 : 5e7, test::turn_once * i / n));
    return p;
}
/// Teeth on a back that is wider than a tooth.
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
    const auto add = [&](double start, int i) {
        const double turn = turns * 2 * i / n;
        p.push_back(test::on_circle(0, 0, step * (start + turn), test::turn_once * turn));
    };
    for (int i = 0; i <= n / 2; ++i) add(0.8, i);
    for (int i = n / 2; i >= 0; --i) add(0.5, i);
    return p;
}
/// Its triangles are a fan: one corner belongs to all of them and runs into the bow. In a rough parabola every other
/// point is moved inwards.
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
    double events = 0, schedules = 0;  ///< for each point
    std::string refused;
};

/// The work of a sweep by a width, in cells.
work work_of(const test::polyline& p, double width)
{
    test::filled_shape f{{"", {p}}};
    triangle_list triangles;
    REQUIRE(!monotone{}(f.filled, f.space, triangles));
    const double levels[] = {0.0, std::floor(width)};
    workspace::scope scratch{f.space};
    swept_region swept{scratch.source()};
    const error e = sweep_inwards(f.filled, triangles.view(), {.levels = levels}, scratch, swept);
    const auto n = static_cast<double>(f.filled.points().size());
    return {static_cast<double>(swept.events) / n, static_cast<double>(swept.schedules) / n, e ? e.message() : ""};
}

}  // namespace

TEST_CASE("the work of a sweep grows no faster than n log n", "[offset]")
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
