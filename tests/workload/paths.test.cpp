// SPDX-License-Identifier: MIT

// Scripts of real fonts on a path: joins hold, marks stay on their letters, meshes are closed.

#include "opened_font.hpp"
#include "support/catch.hpp"
#include "support/font_path.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"

#include <typemesh/text/on_path.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

TEST_CASE("words of joined scripts stay one solid on an arc, and are closed", "[workload][path]")
{
    const struct {
        const char* font;
        const char* text;
    } words[] = {{"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "\u0633\u0644\u0633\u0644\u0629 \u0643\u0644\u0645"},
                 {"truetype/lohit-devanagari/Lohit-Devanagari.ttf", "\u0928\u092e\u0938\u094d\u0924\u0947"}};
    plane_path arc;
    arc.move({0, 0});
    arc.arc({0, -2}, -120.0);
    for (const auto& [name, text] : words) {
        const auto path = font_path(name);
        if (!std::filesystem::exists(path)) continue;
        INFO(name);
        harfbuzz_font font = test::opened(path.string());
        text_mesher flat_text{font}, on_arc{font, on_path{&arc}},
            turned{font, on_path{&arc, {.warp = path_warp::never}}};
        const auto flat_plan = test::required(flat_text.plan(text, {.merge = true}));
        const auto plan = test::required(on_arc.plan(text, {.merge = true}));
        const std::size_t solids = flat_plan->glyphs().size();
        CHECK(solids < flat_plan->run().glyphs.size());
        // A sign that abuts its letter's headline, without overlapping it, meets it within the tolerance only.
        std::size_t joined = 0;
        for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
            const auto members = plan->members(g);
            const glyph_run& run = plan->run();
            bool has_letter = false;
            for (const std::uint32_t i : members)
                has_letter = has_letter || i == 0 || run.glyphs[i].cluster != run.glyphs[i - 1].cluster;
            joined += has_letter ? 1u : 0u;
        }
        CHECK(joined == solids);
        const test::lit_mesh m = test::written(*plan);
        CHECK(inspect::check_closedness(m.view(), 2).is_closed());
        CHECK(inspect::check_normals(m.view(), &test::lit_vertex::normal).is_right());
        CHECK(plan->report().complete());
        for (const placed_glyph& g : plan->run().glyphs) CHECK(g.joined);
        // Letters that are turned one by one are cached, as those of other scripts.
        CHECK(test::required(turned.plan(text))->meshes().size() <=
              test::required(flat_text.plan(text))->glyphs().size());
    }
}

TEST_CASE("marks of Latin turn with their base letter", "[workload][path]")
{
    const auto path = font_path("truetype/dejavu/DejaVuSans.ttf");
    if (!std::filesystem::exists(path)) return;
    harfbuzz_font font = test::opened(path.string());
    plane_path wave;
    wave.move({0, 0});
    wave.cubic({1, 1.5}, {2, 1.5}, {3, 0});
    wave.cubic({4, -1.5}, {5, -1.5}, {6, 0});
    text_mesher mesher{font, on_path{&wave}};
    const auto plan = test::required(mesher.plan("q\u0302x\u0323\u0301fi Wo\u0330"));
    const glyph_run& run = plan->run();
    const auto drawn = plan->glyphs();
    std::size_t marks = 0;
    for (std::size_t i = 1; i < drawn.size(); ++i) {
        const drawn_glyph &base = drawn[i - 1], &mark = drawn[i];
        if (base.cluster != mark.cluster) {
            CHECK_FALSE(base.right == mark.right);
            continue;
        }
        ++marks;
        CHECK(base.right == mark.right);
        const point arm = mark.origin - base.origin,
                    flat = run.glyphs[mark.glyph].origin - run.glyphs[base.glyph].origin;
        CHECK(dot(arm, base.right) == Catch::Approx(flat.x).margin(1e-3));
        CHECK(cross(base.right, arm) == Catch::Approx(flat.y).margin(1e-3));
    }
    CHECK(marks == 4);
    const test::lit_mesh m = test::written(*plan);
    CHECK(inspect::check_closedness(m.view(), 2).is_closed());
}
