// SPDX-License-Identifier: MIT

#include <typemesh/bend/taper.hpp>

#include "deformations.hpp"

using namespace typemesh;

TEST_CASE("a taper's derivatives and bounds are those of its positions, and it can be undone", "[bend]")
{
    std::size_t points = 0;
    bending::each_taper([&](const taper& d, const box3& all) {
        CHECK(d.refused_options() == error::none);
        bending::check_jacobian(d, all);
        points += bending::check_bounds(d, all, 400, 1.001);
        box3 positive = all;  // where the factor is at least 0.2
        const bool along = d.axis == text_axis::along;
        if (d.growth < 0.0) (along ? positive.high.x : positive.high.y) = (std::min)(2.0, -0.8 / d.growth);
        if (d.growth > 0.0) (along ? positive.low.x : positive.low.y) = (std::max)(-2.0, -0.8 / d.growth);
        bending::check_inverse(d, positive, [&](double3 q) {
            const double f = 1.0 + d.growth * (along ? q.x : q.y);
            return along ? double3{q.x, q.y / f, q.z / f} : double3{q.x / f, q.y, q.z / f};
        });
        // Volumes change by the square of the factor.
        test::dice dice{8};
        for (int round = 0; round < 100; ++round) {
            const double3 p = bending::within(dice, all);
            const double f = 1.0 + d.growth * (along ? p.x : p.y);
            CHECK_QUICKLY(bending::determinant(d(p)) == Approx(f * f).margin(1e-13));
        }
    });
    CHECK(points > 100'000);
}

TEST_CASE("a taper is 1 at the origin, and changes by its growth per em", "[bend]")
{
    const taper d{.growth = 0.5};
    CHECK(length(d({0.0, 0.7, -0.2}).at - double3{0.0, 0.7, -0.2}) == 0.0);
    CHECK(length(d({2.0, 0.7, -0.2}).at - double3{2.0, 1.4, -0.4}) < 1e-15);
    const taper up{.growth = -0.25, .axis = text_axis::up};
    CHECK(length(up({0.8, 2.0, 0.4}).at - double3{0.4, 2.0, 0.2}) < 1e-15);
    CHECK(length(up({0.0, 3.0, 0.0}).at - double3{0.0, 3.0, 0.0}) == 0.0);
}

TEST_CASE("a taper's growth must be finite, and its factor positive in the whole text", "[bend]")
{
    for (const double bad : bending::not_finite) bending::check_refused_option("growth", taper{.growth = bad});
    CHECK(taper{.growth = 0.0}.refused_options() == error::none);
    const box3 text{{-1.0, -0.5, 0.0}, {4.0, 1.0, 0.0}};
    struct row {
        double growth;
        text_axis axis;
        bool folds;
    };
    for (const row& r : {row{-0.24, text_axis::along, false},
                         {-0.25, text_axis::along, true},
                         {-0.3, text_axis::along, true},
                         {0.99, text_axis::along, false},
                         {1.0, text_axis::along, true},
                         {-0.9, text_axis::up, false},
                         {-1.1, text_axis::up, true},
                         {1.9, text_axis::up, false},
                         {2.0, text_axis::up, true}}) {
        CAPTURE(r.growth, int(r.axis));
        CHECK(refused_text(taper{.growth = r.growth, .axis = r.axis}, text) ==
              (r.folds ? error::folds_over : error::none));
    }
}
