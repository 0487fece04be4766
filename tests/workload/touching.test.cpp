// SPDX-License-Identifier: MIT
//
// Glyphs whose contours only touch in points: proven as they are, and the region that resolve() makes of them.

#include "opened_font.hpp"
#include "support/cycles.hpp"
#include "support/font_file.hpp"
#include "support/oracle.hpp"

#include <typemesh/glyph/cap_builder.hpp>

using namespace typemesh;

TEST_CASE("glyphs that only touch in points are the region that resolve() makes, under both fill rules", "[workload]")
{
    std::size_t touching = 0;
    for (const char* name : {"truetype/wqy/wqy-microhei.ttc", "truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf",
                             "truetype/inter-vf/Inter.var.ttf"}) {
        auto font = test::opened(font_file(name));
        workspace space;
        outline shape;
        contours resolved;
        cap_builder caps;
        for (glyph_id id = 0; id < font.glyph_count(); ++id) {
            if (!record(font, id, shape) || shape.curves.empty()) continue;
            const double tolerance = quality::normal * font.units_per_em();
            const auto g = grid::fitting(font.units_per_em(), shape.bounds);
            if (!g || !caps.flatten(shape, certified{}, tolerance, *g)) continue;
            const result<region> proven = caps.prove(monotone{});
            if (!proven || !proven->is_touching()) continue;
            ++touching;
            INFO(name << ", glyph " << id);
            CHECK(test::oracle::broken_law(*proven, caps.triangles().view()) == "");
            for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
                REQUIRE(discretise(shape, certified{}, tolerance, *g, resolved));
                const result<region> made = resolve(resolved, rule, space);
                REQUIRE(made);
                CHECK(test::cycles_of(*proven) == test::cycles_of(*made));
                CHECK(proven->holes() == made->holes());
                CHECK(proven->outers() == made->outers());
                CHECK(made->is_touching());
            }
        }
    }
    CHECK(touching >= 5);
}
