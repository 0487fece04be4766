// SPDX-License-Identifier: MIT

// Glyphs of all smoke fonts, refined.

#include "support/catch.hpp"
#include "support/refined_shape.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/extrude/refined.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_view.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace typemesh;

TEST_CASE("every smoke font's glyphs are refined lawfully, and all but their sharp corners reach the angle",
          "[workload]")
{
    const certified flatten;
    const constrained_delaunay cut;
    no_observer nobody;
    glyph_builder builder;
    delaunay_refined::scratch scratch;
    workspace space;
    test::refined_result out;
    triangle_list cap;
    std::size_t glyphs = 0, triangles = 0, below = 0, kept = 0;
    test::each_smoke_glyph(53, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        for (const float tolerance : {1.0f / 50, 1.0f / 800}) {
            const auto filled =
                builder.build_region(font, glyph, {.tolerance = double{tolerance}}, cap_policies{flatten, cut, nobody});
            if (!filled || filled->points().empty()) continue;
            cap.clear();
            INFO(name << " at " << tolerance);
            REQUIRE_FALSE(cut(*filled, space, cap));
            const delaunay_refined how{.max_edge = glyph % 2 == 0 ? 0.0f : 0.07f};
            const error e = how(*filled, cap.view(), scratch, out.out());
            INFO(e.message());
            REQUIRE_FALSE(e);
            CHECK(test::broken_refinement(*filled, out) == "");
            CHECK(test::is_delaunay(out));
            ++glyphs;
            triangles += out.triangles.size();
            below += test::corners_below(out, 24.999);
            kept += out.kept;
        }
    });
    CAPTURE(glyphs, triangles, below, kept);
    CHECK(glyphs > 1000);
    CHECK(triangles > 50 * glyphs);
    CHECK(below < triangles / 1000);
    CHECK(kept < triangles / 1000);
}

TEST_CASE("every smoke font's glyphs are refined by squares, lawfully, at three sizes", "[workload]")
{
    const certified flatten;
    const constrained_delaunay cut;
    no_observer nobody;
    glyph_builder builder;
    quadtree_refined::scratch scratch;
    workspace space;
    test::refined_result out;
    triangle_list cap;
    std::size_t glyphs = 0, triangles = 0, kept = 0, below_5 = 0, below_15 = 0, long_edges = 0;
    test::each_smoke_glyph(607, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        for (const auto& [tolerance, longest] : {std::pair{1.0 / 50, 0.3f}, {1.0 / 160, 0.07f}, {1.0 / 800, 0.03f}}) {
            const auto filled =
                builder.build_region(font, glyph, {.tolerance = tolerance}, cap_policies{flatten, cut, nobody});
            if (!filled || filled->points().empty()) continue;
            cap.clear();
            INFO(name << " at " << tolerance);
            REQUIRE_FALSE(cut(*filled, space, cap));
            const error e = quadtree_refined{longest}(*filled, cap.view(), scratch, out.out());
            INFO(e.message());
            REQUIRE_FALSE(e);
            CHECK(test::broken_refinement(*filled, out) == "");
            CHECK(test::is_delaunay(out));
            const double most = double(longest) * filled->grid().cells * filled->grid().units_per_em;
            const std::vector<grid_point> p = out.points();
            for (const auto& [edge, apex] : test::edges_of(out))
                long_edges += double(squared_distance(p[edge.first], p[edge.second])) > most * most;
            ++glyphs;
            triangles += out.triangles.size();
            kept += out.kept;
            below_5 += test::corners_below(out, 5.0);
            below_15 += test::corners_below(out, 15.0);
        }
    });
    CAPTURE(glyphs, triangles, kept, below_5, below_15, long_edges);
    CHECK(glyphs > 1000);
    CHECK(triangles > 100 * glyphs);
    CHECK(kept == 0);
    CHECK(long_edges == 0);
    CHECK(below_5 < triangles / 1000);
    CHECK(below_15 < triangles / 300);
}

TEST_CASE("no triangle of a smoke font's glyphs has an angle above 90 degrees, but for rounding", "[workload]")
{
    const certified flatten;
    const constrained_delaunay cut;
    no_observer nobody;
    glyph_builder builder;
    non_obtuse::scratch scratch;
    workspace space;
    test::refined_result out;
    triangle_list cap;
    std::size_t glyphs = 0, triangles = 0, above = 0, kept = 0, whole = 0;
    test::each_smoke_glyph(4001, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        for (const double tolerance : {1.0 / 50, 1.0 / 160, 1.0 / 800}) {
            const auto filled =
                builder.build_region(font, glyph, {.tolerance = tolerance}, cap_policies{flatten, cut, nobody});
            if (!filled || filled->points().empty()) continue;
            cap.clear();
            INFO(name << " at " << tolerance);
            REQUIRE_FALSE(cut(*filled, space, cap));
            const error e = non_obtuse{glyph % 2 == 0 ? 0.0f : 0.1f}(*filled, cap.view(), scratch, out.out());
            INFO(e.message());
            REQUIRE_FALSE(e);
            CHECK(test::broken_refinement(*filled, out) == "");
            const test::wide_corners wide = test::wide_corners_of(out);
            ++glyphs;
            triangles += out.triangles.size();
            above += wide.above;
            kept += out.kept;
            whole += wide.rounded == 0;
        }
    });
    CAPTURE(glyphs, triangles, above, kept, whole);
    CHECK(glyphs > 200);
    CHECK(triangles > 200 * glyphs);
    CHECK(above == 0);
    CHECK(kept == 0);
    CHECK(whole > 0);  // bars and dots need no division
}
