// SPDX-License-Identifier: MIT
//
// Both triangulators on the glyphs of every font of the workload, against the laws; Delaunay edge by edge.

#include "support/catch.hpp"
#include "support/delaunay.hpp"
#include "support/workload.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

TEST_CASE(
    "both triangulators accept the same glyphs of a font and obey the laws on each, and Delaunay edges are Delaunay",
    "[workload]")
{
    for (const test::workload_font& entry : test::workload_fonts()) {
        if (!entry.available()) continue;
        auto font = harfbuzz_font::open(entry.path.c_str());
        REQUIRE(font);
        const std::uint32_t count = font->glyph_count(), step = (std::max)(1u, count / 250);
        std::size_t accepted = 0;
        workspace space;
        outline shape;
        contours loops;
        triangle_list by_sweep, delaunay;
        for (const double tolerance : {quality::low, quality::high})
            for (glyph_id id = 0; id < count; id += step) {
                if (!record(*font, id, shape) || shape.curves.empty()) continue;
                const auto g = grid::fitting(font->units_per_em(), shape.bounds);
                if (!g || !discretise(shape, certified{}, tolerance * font->units_per_em(), *g, loops)) continue;
                orient(loops);
                by_sweep.clear();
                delaunay.clear();
                const result<region> first = monotone{}.prove(loops, space, by_sweep),
                                     second = constrained_delaunay{}.prove(loops, space, delaunay);
                INFO(entry.name << ", glyph " << id << " at " << tolerance);
                REQUIRE(bool(first) == bool(second));
                if (!first) continue;
                ++accepted;
                CHECK(test::oracle::broken_law(*first, by_sweep.view()) == "");
                CHECK(test::oracle::broken_law(*second, delaunay.view()) == "");
                CHECK(test::oracle::broken_delaunay(*second, delaunay.view()) == "");
            }
        INFO(entry.name);
        CHECK(accepted > 100);
    }
}
