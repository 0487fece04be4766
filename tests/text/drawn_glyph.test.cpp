// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/text/drawn_glyph.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

TEMPLATE_TEST_CASE("a drawn glyph names its glyph of the run, and counts what precedes it", "[text]", flat, extruded<>,
                   bevelled)
{
    test::toy_font font;
    text_mesher mesher{font, TestType{}};
    const auto plan = mesher.plan("EoEo\noE");
    REQUIRE(plan);
    REQUIRE(plan->glyphs().size() == 6);
    part_sizes before;
    const drawn_glyph* last = nullptr;
    for (const drawn_glyph& g : plan->glyphs()) {
        CHECK(g.line == (g.glyph < 4 ? 0u : 1u));
        CHECK(g.merged == drawn_glyph::none);
        CHECK(g.before == before);
        if (last != nullptr) {
            CHECK(g.glyph == last->glyph + 1);
            CHECK(g.cluster > last->cluster);
        }
        for (std::size_t p = 0; p < max_parts; ++p) {
            before.vertices.of[p] += g.built->sizes().vertices.of[p];
            before.triangles.of[p] += g.built->sizes().triangles.of[p];
        }
        last = &g;
    }
    CHECK(plan->size().vertices == before.vertices.total());
    CHECK(plan->size().triangles == before.triangles.total());

    const auto& all = plan->glyphs();
    CHECK(all[0].built == all[2].built);
    CHECK(all[0].mesh == all[5].mesh);
    CHECK(all[0].mesh != all[1].mesh);
    CHECK(all[0].next_alike == 2);
    CHECK(all[5].next_alike == drawn_glyph::none);
}
