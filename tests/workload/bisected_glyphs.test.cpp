// SPDX-License-Identifier: MIT

// Glyphs of all smoke fonts, with edges halved as bending needs it.

#include "support/catch.hpp"
#include "support/refined_shape.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/wave.hpp>
#include <typemesh/extrude/impl/bent_measure.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/refine/impl/edge_bisection.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>

using namespace typemesh;

TEST_CASE("every smoke font's glyphs are bisected lawfully for cups, balls and waves", "[workload]")
{
    const certified flatten;
    const constrained_delaunay cut;
    no_observer nobody;
    glyph_builder builder;
    detail::edge_bisection bisection;
    workspace space;
    test::refined_result out;
    triangle_list cap;
    std::size_t glyphs = 0, triangles = 0, given = 0, kept = 0;
    const auto check = [&](const region& filled, const auto& bends, double tolerance) {
        const double em = filled.grid().cells * filled.grid().units_per_em;
        detail::bent_measure<std::decay_t<decltype(bends)>> measure{bends, {0.4, 0.0}, 1.0 / em, -0.1,
                                                                    0.0,   0.05,       tolerance};
        measure.compared = measure.extents_in({{-9.0, -9.0, -0.1}, {9.0, 9.0, 0.0}});
        const error e = bisection.run(filled, cap.view(), measure, default_max_points);
        INFO(e.message());
        REQUIRE_FALSE(e);
        REQUIRE_FALSE(bisection.write(out.out()));
        CHECK(test::broken_refinement(filled, out) == "");
        CHECK(test::is_delaunay(out, measure.compared));
        const std::vector<grid_point> p = out.points();
        for (const triangle t : out.triangles) kept += !(measure.triangle(p[t.a], p[t.b], p[t.c]) <= 1.0);
        ++glyphs;
        given += cap.size();
        triangles += out.triangles.size();
    };
    test::each_smoke_glyph(251, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        for (const double tolerance : {1.0 / 50, 1.0 / 800}) {
            const auto filled =
                builder.build_region(font, glyph, {.tolerance = tolerance}, cap_policies{flatten, cut, nobody});
            if (!filled || filled->points().empty()) continue;
            cap.clear();
            INFO(name << " at " << tolerance);
            REQUIRE_FALSE(cut(*filled, space, cap));
            if (glyph % 3 == 0)
                check(*filled, on_cylinder{.radius = 1.0}, tolerance);
            else if (glyph % 3 == 1)
                check(*filled, on_sphere{.radius = -2.0}, tolerance);
            else
                check(*filled, displaced<wave>{{.height = 0.1, .length = 1.0, .direction = 30.0}}, tolerance);
        }
    });
    CAPTURE(glyphs, given, triangles, kept);
    CHECK(glyphs > 600);
    CHECK(triangles > 2 * given);
    CHECK(kept == 0);
}
