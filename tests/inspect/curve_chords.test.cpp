// SPDX-License-Identifier: MIT

#include <typemesh/inspect/impl/curve_chords.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <cmath>

using namespace typemesh;
using inspect::curve_chords;

namespace {

outline closed(std::initializer_list<curve> curves)
{
    outline o;
    REQUIRE(o.starts.push_back(0));
    for (const curve& c : curves) {
        REQUIRE(o.curves.push_back(c));
        for (std::uint32_t i = 0; i <= c.degree; ++i) o.bounds.add(c.p[i]);
    }
    REQUIRE(o.starts.push_back(static_cast<std::uint32_t>(curves.size())));
    return o;
}

}  // namespace

TEST_CASE("chords follow each other and stay within the error of their curve", "[inspect][curve_chords]")
{
    test::dice d{27};
    const auto any = [&] { return point{1000.0 * d.fraction(), 1000.0 * d.fraction()}; };
    for (int round = 0; round < 200; ++round) {
        const point a = any(), b = any();
        const outline o = closed({curve::from(quadratic{a, any(), b}), curve::from(cubic{b, any(), any(), a})});
        const double cells = 512.0, error = 1.0 + 50.0 * d.fraction();
        const curve_chords chords{o, cells, error};
        for (std::uint32_t k = 0; k < 2; ++k) {
            const auto of = chords.of_curve(k);
            REQUIRE_FALSE(of.empty());
            CHECK(of.front().start == cells * o.curves[k].start());
            CHECK(of.back().end == cells * o.curves[k].end());
            for (std::size_t i = 1; i < of.size(); ++i) REQUIRE(of[i].start == of[i - 1].end);
            for (int i = 0; i <= 1000; ++i) {
                const point on = cells * o.curves[k].at(i / 1000.0);
                REQUIRE(curve_chords::squared_distance(on, of) <= error * error * 1.0001);
            }
        }
        CHECK(chords.all().size() == chords.of_curve(0).size() + chords.of_curve(1).size());
        CHECK(chords.bounds().low == cells * o.bounds.low);
        CHECK(chords.bounds().high == cells * o.bounds.high);
    }
}

TEST_CASE("a line is one chord, and take() replaces the chords from before", "[inspect][curve_chords]")
{
    const outline o = closed({curve::from({0, 0}, {10, 0}), curve::from({10, 0}, {0, 5}), curve::from({0, 5}, {0, 0})});
    curve_chords chords{closed({curve::from(quadratic{{0, 0}, {5, 9}, {0, 0}})}), 1.0, 0.01};
    chords.take(o, 2.0, 0.001);
    REQUIRE(chords.all().size() == 3);
    CHECK(chords.of_curve(1)[0].end == point{0, 10});
    CHECK(curve_chords::squared_distance({5, 3}, {0, 0}, {10, 0}) == 9.0);
    CHECK(curve_chords::squared_distance({14, 3}, {0, 0}, {10, 0}) == 25.0);
    CHECK(curve_chords::squared_distance({3, 4}, {0, 0}, {0, 0}) == 25.0);
    CHECK(curve_chords::squared_distance({3, 4}, {}) == 1e300);
}

TEST_CASE("the winding number of curves is the angle that they sweep, in turns", "[inspect][curve_chords]")
{
    test::dice d{28};
    const auto any = [&] { return point{100.0 * d.fraction(), 100.0 * d.fraction()}; };
    for (int round = 0; round < 500; ++round) {
        const point a = any(), b = any(), c = any();
        const outline o =
            closed({curve::from(cubic{a, any(), any(), b}), curve::from(quadratic{b, any(), c}), curve::from(c, a)});
        const curve_chords chords{o, 1.0, 0.01};
        const point p = any();
        if (curve_chords::squared_distance(p, chords.all()) < 1e-6) continue;
        double angle = 0.0;
        for (const auto& e : chords.all()) {
            const point u = e.start - p, v = e.end - p;
            angle += std::atan2(cross(u, v), dot(u, v));
        }
        REQUIRE(chords.winding(p) == std::lround(angle / 6.283185307179586));
    }
}
