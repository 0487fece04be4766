// SPDX-License-Identifier: MIT

#include <typemesh/core/curve.hpp>
#include <typemesh/outline/impl/elliptical_arc.hpp>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("the number of cubics is the least in which an arc of a circle keeps its tolerance, or nearly",
          "[outline][svg]")
{
    const auto error_of = [](double angle) {  // measured, not by the formula
        const double handle = 4.0 / 3.0 * std::tan(angle / 4.0), c = std::cos(angle), s = std::sin(angle);
        const cubic q{{1.0, 0.0}, {1.0, handle}, {c + handle * s, s - handle * c}, {c, s}};
        double worst = 0.0;
        for (int i = 0; i <= 1000; ++i) worst = std::fmax(worst, std::fabs(length(q.at(i / 1000.0)) - 1.0));
        return worst;
    };
    for (double sweep = 0.1; sweep < 6.28; sweep += 0.37)
        for (double tolerance = 1e-2; tolerance > 1e-11; tolerance *= 0.1) {
            const std::uint32_t count = detail::cubics_for(-sweep, 2.0, tolerance);
            CHECK(2.0 * error_of(sweep / count) <= tolerance * 1.001 + 1e-15);
            const auto least = static_cast<std::uint32_t>(std::ceil(sweep / (0.5 * detail::half_turn) - 1e-9));
            const std::uint32_t fewer = count * 3 / 4;
            if (fewer > least) CHECK(2.0 * error_of(sweep / fewer) > tolerance);
        }
    CHECK(detail::cubics_for(6.0, 1e300, 1e-300) == 4096);
}

TEST_CASE("an arc begins and ends where it should", "[outline][svg]")
{
    const point from{3.0, 4.0}, to{-2.0, 7.0};
    for (const bool large : {false, true})
        for (const bool positive : {false, true}) {
            const auto arc = detail::elliptical_arc::between(from, to, {6.0, 4.0}, 33.0, large, positive);
            constexpr double rounding = 0x1p-36;  // of sines and angles, for radii of about 6
            CHECK(length(arc.at(arc.start) - from) < rounding);
            CHECK(length(arc.at(arc.start + arc.sweep) - to) < rounding);
            CHECK((arc.sweep > 0.0) == positive);
            CHECK((std::fabs(arc.sweep) > detail::half_turn) == large);
            point last;
            arc.cubics(to, 1e-6, [&](point, point, point end) { last = end; });
            CHECK(last == to);
        }
}
