// SPDX-License-Identifier: MIT
#include "fallback_list.hpp"
#include "monospace_shaper.hpp"
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/required.hpp"
#include "svg_paths.hpp"

#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/text/shaped_by.hpp>
#include <typemesh/typemesh.hpp>

#include <string>
#include <vector>

using namespace typemesh;

namespace {

using drawn_type = shaped_by<stranger::monospace_shaper, stranger::svg_paths>;

/// Two fonts of square letters, of different units: A and B are large, a and b are half as high.
struct two_fonts {
    stranger::svg_paths large{100.0, {"M0 0 H1", "M0 0 H80 V100 H0 Z", "M0 0 H40 V100 H0 Z"}},
        small{1000.0, {"M0 0 H1", "M0 500 H400 V1000 H0 Z", "M0 500 H200 V1000 H0 Z"}};
    stranger::monospace_shaper large_cells{100.0, 90.0, std::string{"\0AB", 3}},
        small_cells{1000.0, 500.0, std::string{"\0ab", 3}};
    drawn_type first{large_cells, large}, second{small_cells, small};
    stranger::fallback_list<drawn_type> both{{&first, &second}};
};

}  // namespace

static_assert(shaper<stranger::fallback_list<drawn_type>>);
static_assert(face_source<stranger::fallback_list<drawn_type>>);

TEST_CASE("a stranger's fallback from font to font is laid out and drawn like one font", "[stranger]")
{
    two_fonts fonts;
    auto mesher = text_mesher{fonts.both}.with(flat{});
    const auto plan = test::required(mesher.plan("AaB\nbA"));
    REQUIRE(plan->glyphs().size() == 5);
    CHECK(plan->run().glyph_styles.size() == 2);
    CHECK(plan->run().glyphs[2].origin.x == Catch::Approx(90.0 + 50.0));  // after A and a, in the first font's units
    std::vector<vec3> places(plan->size().vertices);
    std::vector<std::uint32_t> indices(plan->size().indices());
    stream_sink sink{std::span{indices}, stream<attribute::position, vec3>{std::span{places}}};
    REQUIRE(plan->write(sink));
    const double area = inspect::measure(inspect::mesh_view{places, indices}).area;
    CHECK(area == Catch::Approx(2 * 0.8 + 0.4 + 0.5 * 0.4 + 0.5 * 0.2));
    CHECK(mesher.plan("AaBc").error() == error::needs_shaping);
}

TEST_CASE("workers with a fallback of their own number their glyph styles alike", "[stranger][threads]")
{
    std::string text;
    for (int i = 0; i < 600; ++i) text += i % 7 == 6 ? "\n" : i % 11 < 5 ? "A" : i % 3 == 0 ? "b" : "a";
    two_fonts fonts;
    text_mesher mesher{fonts.both};
    const auto expected = test::required(mesher.plan(text));
    std::vector<two_fonts> own(4);
    test::scrambled_workers several{4};
    auto pool = workers_of(several, [&](std::size_t w) noexcept -> result<stranger::fallback_list<drawn_type>> {
        return stranger::fallback_list<drawn_type>{{&own[w].first, &own[w].second}};
    });
    REQUIRE(pool);
    text_mesher other{fonts.both};
    for (int round = 0; round < 5; ++round) {
        const auto plan = test::required(other.plan(text, {}, *pool));
        const glyph_run &a = expected->run(), &b = plan->run();
        REQUIRE(b.glyphs.size() == a.glyphs.size());
        CHECK(b.glyph_styles.size() == a.glyph_styles.size());
        for (std::size_t i = 0; i < a.glyphs.size(); ++i)
            REQUIRE(b.glyph_styles[b.glyphs[i].glyph_style] == a.glyph_styles[a.glyphs[i].glyph_style]);
        CHECK(plan->size() == expected->size());
    }
}
