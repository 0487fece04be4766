// SPDX-License-Identifier: MIT
#include <typemesh/extrude/impl/wall_normal.hpp>
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

TEST_CASE("normals at keys point out of their walls, even where chords omit a hook of the curve", "[morph]")
{
    test::toy_axis axis;
    for (const glyph_id id : {glyph_id{'h'}, glyph_id{'o'}, glyph_id{'q'}, glyph_id{'8'}})
        for (const double crease : {0.0, 15.0, 180.0}) {
            keyed_outlines outlines;
            REQUIRE_FALSE(outlines.record(axis, id, std::vector<axis_coordinate>{-16384, 16384}));
            morph_points points;
            REQUIRE_FALSE(points.divide(outlines, 150.0, *grid::fitting(1000.0, outlines.bounds())));
            points.reverse();
            morph_store store;
            morph_glyph glyph;
            REQUIRE_FALSE((morph_normals{outlines, points, crease}.append(store, glyph)));
            INFO("glyph " << id << ", crease angle " << crease);
            const std::uint32_t n = points.count();
            for (std::uint32_t k = 0; k < 2; ++k)
                for (std::uint32_t i = 0; i < n; ++i) {
                    const std::uint32_t next = store.corners[i].next;
                    const point wall = outward(delta(points.places[k * n + i], points.places[k * n + next]));
                    for (const vec2 normal : {store.normals[2 * (k * n + i) + 1], store.normals[2 * (k * n + next)]}) {
                        const point at{as_double(normal.x), as_double(normal.y)};
                        CHECK(std::fabs(length(at) - 1.0) < 1e-6);
                        CHECK((wall == point{} || dot(at, wall) > -1e-6 * length(wall)));
                    }
                }
            if (id == 'h') {
                CHECK(n == 4);
                CHECK(glyph.hard == (crease < 90.0 ? 3u : 0u));  // the first curve begins softly
            }
        }
}
