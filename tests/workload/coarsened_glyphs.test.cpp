// SPDX-License-Identifier: MIT

// Levels of detail of glyphs of all smoke fonts: the laws of each level, and its points beside a fresh flattening.

#include "support/catch.hpp"
#include "support/level_laws.hpp"
#include "support/smoke_glyphs.hpp"

#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/inspect/curve_distance.hpp>
#include <typemesh/inspect/impl/curve_chords.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

using namespace typemesh;

TEST_CASE("every smoke font's levels keep their tolerance, loops and points of the finer level", "[workload]")
{
    const certified flatten;
    const monotone cut;
    no_observer nobody;
    const cap_policies with{flatten, cut, nobody};
    glyph_builder builder, fresh_builder;
    cap_builder own, further;
    coarsened::scratch scratch;
    outline drawn;
    inspect::curve_chords chords;
    coarsened how{.tolerances = {quality::normal, 1.0 / 60, 1.0 / 25}};
    std::size_t glyphs = 0, points[4] = {}, fresh[4] = {};
    test::each_smoke_glyph(701, [&](auto& font, std::uint32_t glyph, const std::string& name) {
        const auto filled = builder.build_region(font, glyph, {.tolerance = quality::high}, with);
        if (!filled || filled->points().empty()) return;
        INFO(name);
        REQUIRE(record(font, glyph, drawn));
        const double cells = filled->grid().cells, em = cells * font.units_per_em();
        chords.take(drawn, cells, 1e-5 * em);
        test::loop_points finer = test::loops_with(filled->points(), filled->starts());
        const test::edge_set finest = test::edges_in(finer);
        ++glyphs;
        for (how.level = 0; how.level <= 3; ++how.level) {
            INFO("level " << how.level);
            const double tolerance = how.level == 0 ? quality::high : how.tolerances[how.level - 1];
            scratch.clear();
            region_caps caps{own, further, cut, {}};
            const auto made = how(*filled, scratch, caps);
            REQUIRE(made);
            const region& r = made->filled;
            const test::loop_points level = test::loops_with(r.points(), r.starts());
            CHECK(r.holes() == filled->holes());
            CHECK(r.outers() == filled->outers());
            CHECK(test::is_nested_in(level, finer));
            if (!r.is_touching()) CHECK(test::bound_a_region(level));
            const double allowed = 1.0001 * tolerance * em + 2.0;  // 2: crossings are rounded to the grid
            CHECK(inspect::check_distance(r, chords, allowed).strays == 0);
            if (how.level != 0) {
                CHECK(made->triangles.size() == r.triangle_count());
                CHECK(test::farthest_curve_place(level, r.edges(), r.curves(), cells, finest) <= allowed);
            }
            const auto same = fresh_builder.build_region(font, glyph, {.tolerance = tolerance}, with);
            REQUIRE(same);
            points[how.level] += r.points().size();
            fresh[how.level] += same->points().size();
            finer = level;
        }
    });
    CAPTURE(glyphs, points[0], points[1], points[2], points[3], fresh[1], fresh[2], fresh[3]);
    CHECK(glyphs > 300);
    CHECK(points[0] == fresh[0]);
    for (int level = 1; level <= 3; ++level) CHECK(double(points[level]) < 1.03 * double(fresh[level]));
}
