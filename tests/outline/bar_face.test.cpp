// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/outline/bar_face.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/recorded_outlines.hpp>

#include <algorithm>
#include <cmath>

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
    REQUIRE(record(bars, blank_bar, drawn));
    CHECK(drawn.curves.empty());
}

TEST_CASE("a bar has round corners of the given radii, and its outline is closed and tangent to the square",
          "[outline]")
{
    recorded_outlines none{1.0, fill_rule::even_odd};
    const affine same{};
    mapped_face<recorded_outlines> bars{none, bar_face, &same, 1.0};
    outline drawn;
    for (const double x : {0.0, 0.1, 0.25, 0.5, 0.7})
        for (const double y : {0.0, 0.125, 0.5, 2.0}) {
            const glyph_id id = rounded_bar(x, y);
            CHECK_FALSE(is_blank_bar(id));
            REQUIRE(record(bars, id, drawn));
            CHECK(drawn.contour_count() == 1);
            CHECK(drawn.bounds.low == point{0.0, 0.0});
            CHECK(drawn.bounds.high == point{1.0, 1.0});
            const double rx = x < 0.5 ? x : 0.5, ry = y < 0.5 ? y : 0.5;
            const bool sharp = x <= 0.0 || y <= 0.0;
            CHECK(drawn.curves.size() == (sharp ? 4u : 4u + (rx < 0.5 ? 2u : 0u) + (ry < 0.5 ? 2u : 0u)));
            double farthest = 0.0, nearest = 2.0;  // from the corner's centre, in radii
            for (std::size_t i = 0; i < drawn.curves.size(); ++i) {
                const curve& c = drawn.curves[i];
                CHECK(c.p[c.degree] == drawn.curves[(i + 1) % drawn.curves.size()].p[0]);
                if (c.degree != 3 || c.p[0].x > 0.5 || c.p[3].x > 0.5 || c.p[0].y > 0.5) continue;
                const double qx = std::floor(rx * 0x1p15) * 0x1p-15, qy = std::floor(ry * 0x1p15) * 0x1p-15;
                for (double t = 0.0; t <= 1.0; t += 0.0625) {
                    const double s = 1.0 - t, a = s * s * s, b = 3 * s * s * t, d = 3 * s * t * t, e = t * t * t;
                    const point p = a * c.p[0] + b * c.p[1] + d * c.p[2] + e * c.p[3];
                    const double r = std::hypot((p.x - qx) / qx, (p.y - qy) / qy);
                    farthest = std::max(farthest, r);
                    nearest = std::min(nearest, r);
                }
            }
            if (sharp) continue;
            CHECK(farthest < 1.0003);
            CHECK(nearest > 0.9999);
        }
}
