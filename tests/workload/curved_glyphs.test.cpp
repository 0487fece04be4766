// SPDX-License-Identifier: MIT

// Glyphs of all smoke fonts as curved triangles.

#include "support/catch.hpp"
#include "support/curved_shape.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/outline/outline_source.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>

using namespace typemesh;

TEST_CASE("every smoke font's curved triangles do not overlap, and the shader fills what the curves fill", "[workload]")
{
    test::curved_shape made;
    outline curves;
    std::size_t glyphs = 0, places = 0, at_coarse = 0, at_high = 0, at_finest = 0, arcs = 0;
    std::size_t nth = 0;
    test::each_smoke_glyph(211, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        INFO(name);
        if (!record(font, glyph, curves) || curves.curves.empty()) return;
        for (const double tolerance : {1.0 / 100, 1.0 / 800, 0.0}) {
            INFO("tolerance " << tolerance);
            REQUIRE_FALSE(made.make(curves, font.units_per_em(), tolerance));
            CHECK(test::broken_curved(made) == "");
            CHECK_FALSE(made.gave_up());
            (tolerance > 0.005 ? at_coarse : tolerance > 0.0 ? at_high : at_finest) += made.mesh.triangles.size();
        }
        ++glyphs;
        arcs += made.curve_triangles();
        const auto wrong = test::sample(made, curves, 20, 3.0, ++nth);
        CAPTURE(wrong.farthest);
        CHECK(wrong.far_away == 0);
        places += wrong.places;
    });
    CAPTURE(glyphs, places, at_coarse, at_high, at_finest, arcs);
    CHECK(glyphs > 300);
    CHECK(places == 20 * glyphs);
    CHECK(arcs > 10 * glyphs);
    // The number of triangles does not depend on the tolerance.
    CHECK(at_finest < at_high + at_high / 20);
    CHECK(at_finest + at_finest / 10 > at_coarse);
    CHECK(at_coarse + at_coarse / 10 > at_finest);
}
