// SPDX-License-Identifier: MIT

#include <typemesh/bend/wave.hpp>

#include "deformations.hpp"

using namespace typemesh;

TEST_CASE("a wave's derivatives and bounds are those of its positions", "[bend]")
{
    std::size_t points = 0;
    bending::each_wave([&](const displaced<wave>& d, const box3& all) {
        CHECK(d.refused_options() == error::none);
        bending::check_jacobian(d, all);
        points += bending::check_bounds(d, all, 100, 1e18);  // the bounds are the same everywhere
    });
    CHECK(points > 100'000);
}

TEST_CASE("a wave's bounds are reached on its crests", "[bend]")
{
    test::dice dice{4};
    for (int round = 0; round < 50; ++round) {
        const wave w{.height = bending::within(dice, -1.0, 1.0),
                     .length = bending::within(dice, 0.2, 3.0),
                     .direction = bending::within(dice, -360.0, 360.0),
                     .phase = 90.0};  // a crest at the origin
        constexpr double h = 0x1p-12;
        const auto curved = [&](double x, double y) {  // the second derivative of the height in a direction
            return std::fabs(w(h * x, h * y).z - 2.0 * w(0.0, 0.0).z + w(-h * x, -h * y).z) / (h * h);
        };
        const bend_bounds by = w.bend({});
        CHECK(curved(1.0, 0.0) == Approx(by.xx).epsilon(1e-4).margin(1e-5));
        CHECK(curved(0.0, 1.0) == Approx(by.yy).epsilon(1e-4).margin(1e-5));
        // Of the two diagonals, one adds the mixed derivative twice, and the other subtracts it.
        CHECK((std::max)(curved(1.0, 1.0), curved(1.0, -1.0)) ==
              Approx(by.xx + 2.0 * by.xy + by.yy).epsilon(1e-4).margin(1e-5));
    }
}

TEST_CASE("a wave repeats along its direction, is even across it, and moves by its phase", "[bend]")
{
    test::dice dice{2};
    for (const double degrees : {0.0, 30.0, 90.0, 210.0}) {
        const double angle = degrees * test::turn_once / 360.0, c = std::cos(angle), s = std::sin(angle);
        const wave w{.height = 0.3, .length = 1.7, .direction = degrees, .phase = 20.0};
        wave later = w;
        later.phase -= 90.0;
        double highest = 0.0;
        for (int round = 0; round < 200; ++round) {
            const double x = bending::within(dice, -4.0, 4.0), y = bending::within(dice, -4.0, 4.0), z = w(x, y).z,
                         across = bending::within(dice, -3.0, 3.0);
            CHECK_QUICKLY(std::fabs(w(x + 1.7 * c, y + 1.7 * s).z - z) < 4e-12);
            CHECK_QUICKLY(std::fabs(w(x - across * s, y + across * c).z - z) < 4e-12);
            CHECK_QUICKLY(std::fabs(later(x + 0.425 * c, y + 0.425 * s).z - z) < 4e-12);
            highest = (std::max)(highest, std::fabs(z));
        }
        CHECK(highest <= 0.3);
        CHECK(highest > 0.29);
    }
    CHECK(wave{}(0.5, 3.0).z == Approx(0.1));  // a quarter of the length from a zero: a crest
}

TEST_CASE("a wave's numbers must be finite, and its length must not be 0", "[bend]")
{
    for (const double bad : bending::not_finite) {
        bending::check_refused_option("height", wave{.height = bad});
        bending::check_refused_option("length", wave{.length = bad});
        bending::check_refused_option("direction", wave{.direction = bad});
        bending::check_refused_option("phase", wave{.phase = bad});
        bending::check_refused_option("height", displaced<wave>{{.height = bad}});
    }
    for (const double bad : {0.0, -0.0, 1e-300}) bending::check_refused_option("length", wave{.length = bad});
    CHECK(wave{.height = 0.0}.refused_options() == error::none);
    CHECK(refused_text(displaced<wave>{}, {{-1e3, -1e3, 0.0}, {1e3, 1e3, 0.0}}) == error::none);
}
