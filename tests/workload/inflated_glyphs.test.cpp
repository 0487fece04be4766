// SPDX-License-Identifier: MIT

// Glyphs of all smoke fonts, inflated.

#include "../inflate/inflated_shape.hpp"
#include "same_meshes.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/lit_mesh.hpp"
#include "support/refined_shape.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/extrude/inflated.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_view.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

TEST_CASE("every smoke font's glyphs are inflated: positive inside, without flat triangles, and solved", "[workload]")
{
    const certified flatten;
    const constrained_delaunay cut;
    no_observer nobody;
    glyph_builder builder;
    membrane sheet;
    detail::membrane_system system;
    workspace space;
    test::refined_result out;
    triangle_list cap;
    std::size_t glyphs = 0, triangles = 0, flat = 0, not_positive = 0;
    double worst = 0.0;
    test::each_smoke_glyph(499, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        const auto filled =
            builder.build_region(font, glyph, {.tolerance = quality::high}, cap_policies{flatten, cut, nobody});
        if (!filled || filled->points().empty()) return;
        cap.clear();
        INFO(name);
        REQUIRE_FALSE(cut(*filled, space, cap));
        const error e = sheet.inflate(*filled, cap.view(), {.edge = glyph % 2 == 0 ? 0.03f : 0.08f}, out.out());
        INFO(e.message());
        REQUIRE_FALSE(e);
        CHECK(test::broken_refinement(*filled, out) == "");
        CHECK(test::is_delaunay(out));
        ++glyphs;
        triangles += out.triangles.size();
        REQUIRE(system.solve(inflating::mesh_of(out)));
        worst = (std::max)(worst, inflating::residual_of(inflating::mesh_of(out), system.u()));
        const std::size_t rim = out.loops.points.size();
        for (const triangle t : out.triangles) flat += t.a < rim && t.b < rim && t.c < rim;
        for (const membrane_point& m : sheet.points()) not_positive += !(m.height > 0.0f);
    });
    CAPTURE(glyphs, triangles);
    CHECK(glyphs > 100);
    CHECK(flat == 0);
    CHECK(not_positive == 0);
    CHECK(worst < 1e-6);
}

TEST_CASE("inflated texts are closed within their bounds, merged or not, and the same from workers and a cache",
          "[workload]")
{
    const std::string fonts = font_folder().string();
    const std::pair<std::string, std::string> texts[] = {
        {fonts + "/truetype/dejavu/DejaVuSans.ttf", "Regatta & 8%"},
        {fonts + "/truetype/dejavu/DejaVuSans.ttf", "\xD8\xAC\xD9\x80"},  // touches itself when it is merged
        {fonts + "/opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "\xD8\xA8\xD8\xA7\xD9\x84\xD9\x88\xD9\x86"},
        {fonts + "/truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf", "\xE6\xB0\xB8\xE9\xA2\xA8"}};
    for (const auto& [path, text] : texts) {
        INFO(path);
        auto font = test::opened(path);
        for (const bool merge : {false, true}) {
            for (const inflated_form form : {inflated_form::balloon, inflated_form::dome}) {
                text_mesher mesher{font, inflated{.form = form}};
                const auto plan = mesher.plan(text, {.tolerance = quality::high, .merge = merge});
                REQUIRE(plan);
                CHECK(plan->report().complete());
                const auto m = test::written(*plan);
                const bounds3 bounds = plan->bounds();
                std::size_t outside = 0;
                for (const auto& v : m.vertices)
                    outside += v.place.z < bounds.low.z || v.place.z > bounds.high.z || v.place.x < bounds.low.x ||
                               v.place.x > bounds.high.x || v.place.y < bounds.low.y || v.place.y > bounds.high.y;
                CHECK(outside == 0);
                CHECK(inspect::check_normals(m.view(), &test::lit_vertex::normal).is_right());
                // Merged letters that touch: no edge has four faces.
                if (form == inflated_form::balloon) {
                    std::size_t crowded = 0;
                    for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
                        crowded +=
                            inspect::check_manifoldness(
                                inspect::mesh_view{m.vertices, test::indices_of(*plan, g, m), &test::lit_vertex::place})
                                .crowded_edges;
                    CHECK(crowded == 0);
                }
                std::size_t open = 0;
                for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
                    open += inspect::check_closedness(
                                inspect::mesh_view{m.vertices, test::indices_of(*plan, g, m), &test::lit_vertex::place})
                                .unmatched_edges;
                CHECK(open == 0);
            }
        }
        test::check_same_meshes(
            path, text, [](const auto& plan) { return test::written(plan); }, inflated{.edge = 0.06f});
    }
}

TEST_CASE("no corner's normal of an inflated letter points to the back of its triangle", "[workload]")
{
    // At these letters' outlines some triangles rise the other way, and high membranes are steep beside their tops.
    const std::string fonts = font_folder().string() + "/truetype/";
    const std::pair<std::string, std::string> letters[] = {{"liberation/LiberationSerif-Regular.ttf", "rN"},
                                                           {"dejavu/DejaVuSans-Bold.ttf", "W"},
                                                           {"GreatVibes-Regular.ttf", "E"},
                                                           {"IMFePIrm29P.ttf", "\xC2\xBD"}};  // 1/2
    for (const auto& [file, letter] : letters) {
        auto font = test::opened(fonts + file);
        for (const inflated& how :
             {inflated{}, inflated{.height = 3.0f}, inflated{.limit = 0.03f, .form = inflated_form::dome}}) {
            CAPTURE(file, how.height, how.limit);
            text_mesher mesher{font, how};
            const auto plan = mesher.plan(letter);
            REQUIRE(plan);
            CHECK(inspect::check_normals(test::written(*plan).view(), &test::lit_vertex::normal).is_right());
        }
    }
}
