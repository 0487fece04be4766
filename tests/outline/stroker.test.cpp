// SPDX-License-Identifier: MIT

// The contours of a stroke: few cubics along gentle curves, and all of them wind the same way.

#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/outline/impl/stroker.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <random>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("sides of gentle curves are few cubics", "[outline][stroke]")
{
    outline out;
    outline_recorder to{out};
    detail::stroker draw{stroke_style{.width = 0.02}, 1000.0, 0.25, to};
    const curve arch = curve::from(cubic{{0, 0}, {0, 552.28}, {447.72, 1000}, {1000, 1000}});
    REQUIRE_FALSE(draw.stroke({&arch, 1}, false));
    REQUIRE(to.finish() == error::none);
    CHECK(out.contour_count() == 1);
    CHECK(out.curves.size() <= 2 + 2 * 4);
    CHECK(out.curves.size() >= 4);
}

TEST_CASE("no place is wound counter-clockwise by a stroke of random curves", "[outline][stroke]")
{
    std::mt19937 d{5};
    const auto next = [&] { return static_cast<double>(d() % 1001); };
    for (int round = 0; round < 150; ++round) {
        std::vector<curve> path;
        point at{next(), next()};
        for (int n = 1 + round % 3; n > 0; --n) {
            const point a{next(), next()}, b{next(), next()}, p{next(), next()};
            path.push_back(round % 2 == 0 ? curve::from(cubic{at, a, b, p}) : curve::from(quadratic{at, a, p}));
            at = p;
        }
        outline out;
        outline_recorder to{out};
        detail::stroker draw{stroke_style{.width = 0.02 + 0.01 * (round % 30)}, 1000.0, 1.0, to};
        REQUIRE_FALSE(draw.stroke(path, false));
        REQUIRE(to.finish() == error::none);
        const inspect::curve_chords chords{out, 1.0, 0.05};
        for (int i = 0; i < 100; ++i) {
            const point p{next(), next()};
            if (inspect::curve_chords::squared_distance(p, chords.all()) < 4.0) continue;
            CHECK_QUICKLY(chords.winding(p) <= 0);
        }
    }
}

TEST_CASE("strokes of pieces whose squared length is 0 are finite", "[outline][stroke]")
{
    for (const double tiny : {1e-321, 1e-300, 1e-200, 1e-160, 1e-20})
        for (const std::uint32_t degree : {1u, 2u, 3u}) {
            const point end{tiny, 1.0 - 1.0}, bend{tiny, tiny};
            const curve piece = degree == 1   ? curve::from(point{}, end)
                                : degree == 2 ? curve::from(quadratic{{}, bend, end})
                                              : curve::from(cubic{{}, bend, bend, end});
            const curve path[] = {curve::from(point{-1.0, 0.0}, {}), piece, curve::from(end, point{1.0, 1.0})};
            outline out;
            outline_recorder to{out};
            detail::stroker draw{stroke_style{.width = 0.3, .join = stroke_join::round}, 1.0, 1e-3, to};
            REQUIRE(draw.stroke(path, false) == error::none);
            INFO(tiny << ", degree " << degree);
            CHECK(to.finish() == error::none);
        }
}
