// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_covering_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/typemesh.hpp>

#include <type_traits>
#include <vector>

using namespace typemesh;
using test::full_mesh;
using test::toy_covering_font;

namespace font_cascade_test {

using cascade = font_cascade<toy_covering_font, toy_covering_font>;
static_assert(face_source<cascade> && shaper<cascade>);
static_assert(shaper<font_faces<toy_covering_font, toy_covering_font>>);

/// Draws under the same numbers, but larger.
struct large_font : toy_covering_font {
    using toy_covering_font::toy_covering_font;
    template <outline_sink Sink>
    error outline(glyph_id, Sink& sink) noexcept
    {
        sink.move({0, 0}), sink.line({400, 0}), sink.line({400, 400}), sink.line({0, 400}), sink.close();
        return {};
    }
};

}  // namespace font_cascade_test

using namespace font_cascade_test;

TEST_CASE("a cascade draws what its first font has as that font alone, and shapes it once", "[text][fallback]")
{
    toy_covering_font first{U"ab "}, second{U"abc", 2000.0}, alone{U"ab "};
    font_cascade fonts{first, second};
    text_mesher mesher{fonts};
    text_mesher plain{alone};
    const auto found = test::required(mesher.plan("ab ba\na")), expected = test::required(plain.plan("ab ba\na"));
    CHECK(test::same_bits(test::written<full_mesh>(*found), test::written<full_mesh>(*expected)));
    CHECK(found->run().glyph_styles.empty());
    CHECK(first.items == alone.items);
    CHECK(second.items == 0);

    const std::size_t before = first.items;
    paragraph words{fonts};
    REQUIRE(words.set("ab ba"));
    CHECK(first.items - before == words.shaped().items().size());
    CHECK(second.items == 0);
}

TEST_CASE("glyphs of another font are as large as the first one's em", "[text][fallback]")
{
    toy_covering_font first{U"a"}, second{U"b", 250.0};
    font_cascade fonts{first, second};
    auto mesher = text_mesher{fonts}.with(flat{});
    const auto plan = test::required(mesher.plan("ab"));
    REQUIRE(plan->run().glyphs.size() == 2);
    CHECK(plan->run().glyphs[1].origin == point{500.0, 0.0});
    CHECK(plan->run().lines[0].advance == 1000.0);
    CHECK(plan->bounds().high.y == Catch::Approx(0.1f));
    CHECK(plan->bounds().high.x == Catch::Approx(0.6f));
    CHECK(fonts.metrics(direction::automatic).ascender == 800.0);

    buffer<shaped_glyph> glyphs;
    REQUIRE_FALSE(fonts.shape("ab\xCC\x81", {.last = 4, .face = 1}, {}, glyphs));
    CHECK(glyphs[0].face == 0);
    CHECK(glyphs.back().flags != glyph_flags::none);
    CHECK(fonts.shape("ab", {.last = 2, .face = 2}, {}, glyphs) == error::no_such_face);
}

TEST_CASE("a cluster that no font has is reported once, and drawn on request as the first one's", "[text][fallback]")
{
    toy_covering_font first{U"a"}, second{U"b"};
    font_cascade fonts{first, second};
    text_mesher mesher{fonts};
    const auto plan = test::required(mesher.plan("ab!a?b"));
    CHECK(plan->report().missing == 2);
    CHECK(plan->report().first_missing == 2);
    CHECK(plan->glyphs().size() == 4);
    std::vector<cluster_id> missing;
    for (const placed_glyph& g : plan->run().glyphs)
        if (g.missing) {
            missing.push_back(g.cluster);
            CHECK(plan->run().glyph_styles[g.glyph_style].face == 0);
        }
    CHECK(missing == std::vector<cluster_id>{2, 4});
}

TEST_CASE("glyphs of one number and two fonts are not taken for each other", "[text][fallback]")
{
    toy_covering_font first{U"a"};
    large_font second{U"ab"};
    font_cascade fonts{first, second};
    glyph_cache cache;
    auto mesher = text_mesher{fonts}.with(flat{}).with(cached_in{cache, 1});
    glyph_run run;
    REQUIRE(run.number_of({}));
    REQUIRE(run.number_of({.face = 1}));
    for (const placed_glyph& g : {placed_glyph{'a', 0, {0, 0}}, placed_glyph{'a', 1, {1000, 0}, false, 1}})
        REQUIRE(run.glyphs.push_back(g));
    for (int again = 0; again < 2; ++again) {
        const auto plan = test::required(mesher.plan(run));
        CHECK(plan->meshes().size() == 2);
        CHECK(plan->bounds().high.x == Catch::Approx(1.4f));
        CHECK(plan->bounds().high.y == Catch::Approx(0.4f));
    }
    // Letters of two fonts that meet are merged.
    const auto merged = test::required(mesher.plan("ab", {.shape = {.letter_spacing = -0.45}, .merge = true}));
    CHECK(merged->glyphs().size() == 1);
}

TEST_CASE("several workers, each with a cascade of its own, make the same mesh as one alone", "[text][fallback]")
{
    toy_covering_font first{U"ab "}, second{U"\u05D0c", 250.0};
    font_cascade fonts{first, second};
    text_mesher mesher{fonts};
    text_mesher other_mesher{fonts};
    const char* text =
        "ab c\n\xD7\x90"
        "b\ncc\n!a\n\xD7\x90\nb";
    const auto expected = test::required(mesher.plan(text));

    std::vector<toy_covering_font> own(6, first);
    for (std::size_t i = 1; i < own.size(); i += 2) own[i] = second;
    test::scrambled_workers several{3};
    auto team = workers_of(several, [&own](std::size_t worker) noexcept {
        return result<cascade>{cascade{own[2 * worker], own[2 * worker + 1]}};
    });
    REQUIRE(team);
    for (int round = 0; round < 3; ++round) {
        const auto plan = test::required(other_mesher.plan(text, {}, *team));
        CHECK(test::same_bits(test::written<full_mesh>(*plan), test::written<full_mesh>(*expected)));
        CHECK(plan->report().missing == 1);
        CHECK(plan->report().first_missing == expected->report().first_missing);
    }
}
