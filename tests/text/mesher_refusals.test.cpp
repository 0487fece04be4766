// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <vector>

using namespace typemesh;

namespace {

using toy_mesher = text_mesher<>;

template <class Mesher, class Text>
concept plans = requires(Mesher&& m, Text&& text) { static_cast<Mesher&&>(m).plan(static_cast<Text&&>(text)); };

}  // namespace

// What is refused with a sentence is in tests/compile: the compiler must say it.
TEST_CASE("a plan is refused where its mesher or its run would be gone, and no other", "[text][refusals]")
{
    STATIC_REQUIRE(plans<toy_mesher&, const char(&)[3]>);
    STATIC_REQUIRE(plans<toy_mesher&, text_view>);
    STATIC_REQUIRE(plans<toy_mesher&, glyph_run&>);
    STATIC_REQUIRE(plans<toy_mesher&, const glyph_run&>);
    STATIC_REQUIRE(!plans<toy_mesher&, glyph_run>);
    STATIC_REQUIRE(!plans<toy_mesher, const char(&)[3]>);
    STATIC_REQUIRE(!plans<toy_mesher, glyph_run&>);
}

TEST_CASE("empty options are text_options, for every kind of text", "[text][refusals]")
{
    test::toy_font font;
    text_mesher mesher{font};
    std::vector<vec3> points;
    std::vector<std::uint32_t> indices;
    const text_view text = "oE";
    glyph_run run;
    REQUIRE(layout(font, text, {}, {}, run));
    const std::uint64_t triangles = mesher.plan(text)->size().triangles;
    CHECK(mesher.plan("oE", {})->size().triangles == triangles);
    CHECK(mesher.plan(text, {})->size().triangles == triangles);
    CHECK(mesher.plan(run, {})->size().triangles == triangles);
    CHECK(mesher.build("oE", into(points, indices), {}));
    CHECK(mesher.build(text, into(points, indices), {}));
    CHECK(mesher.build(run, into(points, indices), {}));
    CHECK(indices.size() == 3 * triangles);
}

TEST_CASE("what refuses takes no room in a mesher", "[text][refusals]")
{
    STATIC_REQUIRE(std::is_empty_v<detail::mesher_refusals<toy_mesher, toy_mesher::plan_type>>);
    struct members {
        text_planner planner;
        stored_policy<discretiser_ref> discretiser;
        stored_policy<triangulator_ref> triangulator;
        stored_policy<region_step_ref> step;
        stored_policy<outline_step_ref> warp;
        stored_policy<observer_ref> observer;
        extruded<> solid;
    };
    STATIC_REQUIRE(sizeof(toy_mesher) == sizeof(members));
}
