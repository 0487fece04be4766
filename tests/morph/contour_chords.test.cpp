// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/contour_chords.hpp>

#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

TEST_CASE("a stroke that overlaps itself is divided into pieces that do not cross themselves", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    REQUIRE_FALSE(outlines.record(axis, '8', std::vector<axis_coordinate>{-16384, 16384}));
    const grid g = *grid::fitting(1000.0, outlines.bounds());
    morph_points points;
    REQUIRE_FALSE(points.divide(outlines, 1.0, g));
    const std::uint32_t before = points.count();
    contour_chords chords;
    bool changed = false;
    REQUIRE_FALSE(chords.divide(points, outlines, g, changed));
    CHECK(changed);
    CHECK(points.contours() == 2);
    CHECK(points.count() == before + 2);
    REQUIRE_FALSE(chords.divide(points, outlines, g, changed));
    CHECK_FALSE(changed);  // nothing crosses itself any more

    REQUIRE_FALSE(outlines.record(axis, 'o', std::vector<axis_coordinate>{-16384, 16384}));
    REQUIRE_FALSE(points.divide(outlines, 1.0, g));
    REQUIRE_FALSE(chords.divide(points, outlines, g, changed));
    CHECK_FALSE(changed);
    CHECK(points.contours() == 2);
}

TEST_CASE("a contour with too many crossings, or that takes too many steps, stays whole", "[morph]")
{
    test::toy_axis axis;
    keyed_outlines outlines;
    morph_points points;
    bool changed = true;
    REQUIRE_FALSE(outlines.record(axis, '*', std::vector<axis_coordinate>{-16384, 16384}));
    grid g = *grid::fitting(1000.0, outlines.bounds());
    REQUIRE_FALSE(points.divide(outlines, 1.0, g));
    REQUIRE(points.count() > 800);
    test::counting_memory counted;
    contour_chords chords{counted.source()};
    REQUIRE_FALSE(chords.divide(points, outlines, g, changed));
    CHECK_FALSE(changed);
    CHECK(points.contours() == 1);
    CHECK(counted.peak < 200'000);

    REQUIRE_FALSE(outlines.record(axis, '8', std::vector<axis_coordinate>{-16384, 16384}));
    g = *grid::fitting(1000.0, outlines.bounds());
    REQUIRE_FALSE(points.divide(outlines, 1.0, g));
    contour_chords hurried{heap(), 100};
    REQUIRE_FALSE(hurried.divide(points, outlines, g, changed));
    CHECK_FALSE(changed);
}
