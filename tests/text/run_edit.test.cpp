// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_runs.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>

using namespace typemesh;
using test::full_mesh;

namespace {

/// Every glyph elsewhere, the last two gone, the second one slanted.
void scatter(glyph_run& run) noexcept
{
    if (run.glyphs.size() > 4) {
        text_line& last = run.lines[run.lines.size() - 1];
        const std::uint32_t gone = last.glyph_count < 2 ? last.glyph_count : 2;
        last.glyph_count -= gone;
        run.glyphs.truncate(run.glyphs.size() - gone);
    }
    for (placed_glyph& g : run.glyphs) g.origin.y += 90.0 * std::sin(g.origin.x / 700.0);
    if (run.glyphs.size() > 1 && run.glyph_styles.empty() && run.glyph_styles.push_back({}) &&
        run.glyph_styles.push_back({})) {
        run.glyph_styles[1].map.xy = 0.25;
        run.glyphs[1].glyph_style = 1;
    }
}

}  // namespace

TEMPLATE_TEST_CASE("a run that is changed on the way is meshed as one that was changed before", "[text][edit]", flat,
                   extruded<>, bevelled)
{
    const char* const text = GENERATE("oEi x\nEoo ixE", "oE", "", " ");
    const bool merge = GENERATE(false, true);
    const text_options how{.size = 2.0, .merge = merge};
    test::toy_font font;

    glyph_run run;
    REQUIRE(layout(font, text, how.shape, how.layout, run));
    scatter(run);
    text_mesher other{font, TestType{}};
    const auto expected = test::required(other.plan(run, how));

    text_mesher mesher{font, TestType{}};
    const auto plan = test::required(mesher.plan(text, how, scatter));
    CHECK(plan->run().glyphs.size() == run.glyphs.size());
    CHECK(test::same_bits(test::written<full_mesh>(*plan), test::written<full_mesh>(*expected)));

    test::scrambled_workers several{3};
    auto team = test::toy_team(several);
    text_mesher third{font, TestType{}};
    const auto shared = test::required(third.plan(text, how, *team, scatter));
    CHECK(test::same_bits(test::written<full_mesh>(*shared), test::written<full_mesh>(*expected)));
}

TEST_CASE("a run that is broken on the way is refused, and the next text is as if nothing had been", "[text][edit]")
{
    test::toy_font font;
    text_mesher mesher{font}, other{font};
    const auto expected = test::required(other.plan("oEi"));

    const auto none = mesher.plan("oEi", {}, [](glyph_run& run) noexcept { run.glyphs[1].glyph_style = 7; });
    CHECK(none.error() == error::no_such_glyph_style);
    const auto nowhere = mesher.plan("oEi", {}, [](glyph_run& run) noexcept { run.glyphs[0].origin.x = std::nan(""); });
    REQUIRE(nowhere);
    CHECK(nowhere->report().refused == 1);
    CHECK(nowhere->glyphs().size() == 2);

    const auto again = test::required(mesher.plan("oEi"));
    CHECK(test::same_bits(test::written<full_mesh>(*again), test::written<full_mesh>(*expected)));
}

TEST_CASE("what layout reports of a text stays when its run is changed, and an edit may keep what it has seen",
          "[text][edit]")
{
    test::toy_font font;
    text_mesher mesher{font};
    std::size_t seen = 0;
    const auto plan = mesher.plan("oq", {}, [&seen](glyph_run& run) noexcept { seen = run.glyphs.size(); });
    REQUIRE(plan);
    CHECK(seen == 2);
    CHECK(plan->report().missing == 1);
}

static_assert(run_edit<decltype([](glyph_run&) noexcept {})>);
static_assert(!run_edit<decltype([](glyph_run&) {})>);
