// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/outline/bar_face.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/recorded_outlines.hpp>

using namespace typemesh;

TEST_CASE("every outline source draws a unit square as its bar face, and a bar through a map", "[outline]")
{
    recorded_outlines none{200.0, fill_rule::even_odd};
    CHECK(units_per_em_of(none, bar_face) == 200.0);
    CHECK(fill_of(none, bar_face) == fill_rule::non_zero);
    CHECK(variation_of(none, bar_face) == 0);
    const affine map{.xx = 300.0, .yy = 10.0, .dy = -40.0};
    mapped_face<recorded_outlines> bars{none, bar_face, &map, 200.0};
    outline drawn;
    for (const glyph_id id : {glyph_id{0}, glyph_id{77}}) {
        REQUIRE(record(bars, id, drawn));
        CHECK(drawn.contour_count() == 1);
        CHECK(drawn.curves.size() == 4);
        CHECK(drawn.bounds.low == point{0.0, -40.0});
        CHECK(drawn.bounds.high == point{300.0, -30.0});
    }
}
