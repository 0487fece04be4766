// SPDX-License-Identifier: MIT
//
// Some random outlines; the program every_shape takes any number of them.

#include "shape_laws.hpp"
#include "support/catch.hpp"

#include <cstdint>

TEST_CASE("random outlines that are hard for moved edges become bevelled, bolder and hollow",
          "[every_glyph][every_shape]")
{
    test::shape_findings all;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const test::shape_laws laws{seed};
        INFO("seed " << seed);
        CHECK(laws.found().wrong == "");
        all.add(laws.found());
    }
    CHECK(all.shapes > 350);
    CHECK(all.solids == 5 * all.shapes);
    CHECK(all.to_nothing == 0);
    CHECK(all.refused == 0);
    CHECK(all.narrowed <= 2);
}

TEST_CASE("the ring of two contours that nearly coincide has the right width", "[every_glyph][every_shape]")
{
    // Each contour is a square with round corners. Slivers of a cell or two lie between them.
    const auto drawn = [](typemesh::outline& out, double size, double off) {
        typemesh::outline_recorder to{out};
        for (const bool second : {false, true}) {
            const double a = second ? off : 0.0, r = second ? size - off : size;
            to.move({r, a});
            for (int i = 0; i < 4; ++i) {
                const auto turned = [&](double x, double y) {
                    for (int k = 0; k < i; ++k) {
                        const double old = x;
                        x = -y, y = old;
                    }
                    return typemesh::point{x, second && size > 650.0 ? -y : y};
                };
                to.quadratic(turned(r, r + (i % 2) * a), turned(a, r));
                to.line(turned(a, r));
            }
        }
        return to.finish();
    };
    for (const double size : {618.87143611907959, 702.06254699707029, 300.0}) {
        for (const double off : {0.001953125, 0.00390625, 0.0005}) {
            for (const typemesh::outline_place place :
                 {typemesh::outline_place::inner, typemesh::outline_place::centre, typemesh::outline_place::outer}) {
                CAPTURE(size, off);
                typemesh::outline curves;
                REQUIRE(!drawn(curves, size, off));
                fuzz::solid_laws::drawn_region from;
                from.made = test::region_of(from.caps, curves, 1000.0, 1.0 / 3000.0);
                REQUIRE_FALSE(from.made.points().empty());
                from.em = 512'000.0;
                fuzz::offset_laws::made_solid<typemesh::outlined<>> s;
                CHECK(s.make({.width = 0.02f, .place = place}, from) == "");
                CHECK(s.exists);
                CHECK_FALSE(s.plan.narrowed);
            }
        }
    }
}
