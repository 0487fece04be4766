// SPDX-License-Identifier: MIT
#include <typemesh/morph/impl/morph_normals.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

TEST_CASE("normals at keys are the curves', and between keys they are wrong by at most what is told", "[morph]")
{
    test::toy_axis axis;
    for (const glyph_id id : {glyph_id{'o'}, glyph_id{'q'}, glyph_id{'8'}}) {
        keyed_outlines outlines;
        REQUIRE_FALSE(outlines.record(axis, id, std::vector<axis_coordinate>{-16000, 16384}));
        const grid g = *grid::fitting(1000.0, outlines.bounds());
        morph_points points;
        REQUIRE_FALSE(points.divide(outlines, 0.5, g));
        points.reverse();
        morph_store store;
        morph_glyph glyph;
        glyph.points = points.count();
        glyph.keys = 2;
        REQUIRE_FALSE((morph_normals{outlines, points, 15.0}.append(store, glyph)));
        double most = 0.0;
        for (std::uint32_t i = 0; i < points.count(); ++i)
            for (int place = 0; place <= 64; ++place) {
                const double s = place / 64.0;
                const contour_edge& e = points.edges[i];
                const point tangent =
                    -1.0 * lerp(hodograph{outlines.curves(0)[e.curve]}.derivative(as_double(e.t0)),
                                hodograph{outlines.curves(1)[e.curve]}.derivative(as_double(e.t0)), s);
                const vec2 a = store.normals[2 * i + 1], b = store.normals[2 * (points.count() + i) + 1];
                const point mixed = lerp({as_double(a.x), as_double(a.y)}, {as_double(b.x), as_double(b.y)}, s);
                const point right{tangent.y, -tangent.x};
                const double angle = std::fabs(std::atan2(cross(mixed, right), dot(mixed, right)));
                most = std::max(most, angle);
                if (place == 0 || place == 64) CHECK(angle < 1e-4);
            }
        INFO("glyph " << id);
        CHECK(most <= glyph.normal_error + 1e-4);
        CHECK(most >= 0.9 * glyph.normal_error - 1e-4);
        CHECK(glyph.hard == (id == 'o' ? 0u : points.count()));
    }
}
