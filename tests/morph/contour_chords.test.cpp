// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/contour_chords.hpp>

#include <vector>

#include "support/catch.hpp"
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
