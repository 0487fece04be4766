// SPDX-License-Identifier: MIT

// Bold and hollow letters go wherever all others do: into caches, merged letters, chunks, instances and teams; what
// thinning leaves nothing of is reported.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/emboldened.hpp"
#include "support/text_laws.hpp"

using namespace typemesh;

namespace {

/// A step and a solid.
struct bold_letters {
    embolden step;
    bevelled solid;

    static constexpr std::size_t part_count = part_count_of<bevelled>;
};

template <class Font>
auto mesher_of(Font& font, const bold_letters& how)
{
    return text_mesher{font, how.solid, how.step};
}
template <class Font, extruder E>
auto mesher_of(Font& font, const E& how)
{
    return text_mesher{font, how};
}

const bold_letters bold{{.by = 0.02f}, {.width = 0.01f}};
const outlined<extruded<>, extruded<>> hollow{.width = 0.02f, .place = outline_place::outer, .letter = {.depth = 0.1f}};

/// A text's mesh by these letters obeys the laws in caches, teams, chunks, instances and partial writes.
void check_everywhere(const auto& how, const auto& other)
{
    test::check_everywhere([](auto& font, const auto& letters) { return mesher_of(font, letters); }, how, other);
}
void check_pieces(const auto& how)
{
    test::toy_font font;
    auto mesher = mesher_of(font, how);
    test::check_pieces(*test::required(mesher.plan(test::crossed_word)), {65'535, 900, 60});  // all glyphs, one, pieces
}

}  // namespace

TEST_CASE("bold letters come out of caches, teams and constrained Delaunay as they are built alone", "[text]")
{
    auto bolder = bold;
    bolder.step.by = 0.03f;
    check_everywhere(bold, bolder);
    auto other_bevel = bold;
    other_bevel.solid.width = 0.015f;
    check_everywhere(bold, other_bevel);
    check_pieces(bold);
}

TEST_CASE("hollow letters come out of caches, teams and constrained Delaunay as they are built alone", "[text]")
{
    auto inside = hollow;
    inside.place = outline_place::inner;
    check_everywhere(hollow, inside);
    check_everywhere(inside, hollow);
    check_pieces(hollow);
}

TEST_CASE("bold and hollow letters that meet as they are drawn are merged first", "[text]")
{
    test::toy_font font;
    const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});  // two rings that meet
    const text_options merging{.merge = true};
    auto bolder = mesher_of(font, bold);
    const auto joined = test::required(bolder.plan(run, merging));
    CHECK(joined->glyphs().size() == 2);
    const test::lit_mesh m = test::lawful_parts(*joined, 5);
    const auto apart = test::required(bolder.plan(run));
    CHECK(test::volume_of(m) < test::volume_of(test::lawful_parts(*apart, 5)));

    auto hollower = text_mesher{font}.with(hollow);
    const auto rings = test::required(hollower.plan(run, merging));
    CHECK(rings->glyphs().size() == 2);
    (void)test::lawful_parts(*rings, 6);
}

TEST_CASE("rings that meet when they have grown are one ring round both letters", "[text]")
{
    test::toy_font font;
    const auto plan_of = [&](auto how, double second) {
        const glyph_run run = test::row_of(5, {0.0, second});  // bars, 100 wide
        auto mesher = mesher_of(font, how);
        auto plan = test::required(mesher.plan(run, {.merge = true}));
        (void)test::lawful_parts(*plan, part_count_of<decltype(how)>);
        return std::pair{plan->glyphs().size(), flipped_triangles(*plan)};
    };
    using ring = outlined<extruded<>, extruded<>>;
    for (const auto place : {outline_place::outer, outline_place::centre}) {
        const float width = place == outline_place::outer ? 0.03f : 0.06f;
        CHECK(plan_of(ring{.width = width, .place = place}, 140.0).first == 1);
        CHECK(plan_of(ring{.width = width, .place = place}, 170.0).first == 2);
        CHECK(plan_of(ring{.width = width, .place = place}, 140.0).second == 0);
    }
    CHECK(plan_of(ring{.width = 0.03f}, 140.0).first == 2);  // within the letters
    const outlined<bevelled> grown{.width = 0.02f, .ring = {.width = 0.03f, .outward = true}};
    CHECK(plan_of(grown, 140.0).first == 1);
    CHECK(plan_of(grown, 170.0).first == 2);
}

TEST_CASE("a ring that would grow into the letter within it is refused", "[text]")
{
    test::toy_font font;
    using ring = outlined<bevelled, extruded<>>;
    auto mesher = text_mesher{font}.with(ring{.width = 0.02f, .ring = {.width = 0.01f, .outward = true}});
    const auto plan = mesher.plan("o");
    REQUIRE_FALSE(plan);
    CHECK(plan.error() == error::bad_option);
    CHECK(std::string{plan.error().option} == "ring");
    auto inwards = text_mesher{font}.with(ring{.width = 0.02f, .ring = {.width = 0.01f}});
    CHECK(inwards.plan("o"));
}

TEST_CASE("bevels of rings have one width in a text, and their bounds are exact", "[text]")
{
    test::toy_font font;
    using ring = outlined<bevelled>;
    auto mesher = text_mesher{font}.with(
        ring{.width = 0.03f, .ring = {.width = 0.1f, .bevel_depth = 0.05f, .mode = bevel_mode::fit_text}});
    const auto plan = test::required(mesher.plan("oi"));
    const test::lit_mesh m = test::lawful_parts(*plan, 5);
    bounds3 reached;
    for (const test::lit_vertex& v : m.vertices) reached.add(v.place);
    CHECK(reached.low == plan->bounds().low);
    CHECK(reached.high == plan->bounds().high);
    CHECK(plan->report().narrowed == 2);  // both rings are less than half as wide as the bevels that were to be on them
    auto narrower = text_mesher{font}.with(
        ring{.width = 0.03f, .ring = {.width = 0.025f, .bevel_depth = 0.05f, .mode = bevel_mode::fit_text}});
    CHECK(narrower.plan("oi")->report().narrowed == 0);
}

TEST_CASE("a glyph that vanishes by thinning is left out and named, from a cache as well", "[text]")
{
    test::toy_font font;
    glyph_cache<> cache;
    glyph_run run;  // strokes of E and i are 100 units wide, those of the box between them 50
    for (const glyph_id id : {2u, 0u, 5u})
        REQUIRE(run.glyphs.push_back({id, static_cast<cluster_id>(run.glyphs.size()), {0.0, 0.0}}));
    run.units_per_em = 1000.0;
    auto thinner = text_mesher{font}.with(embolden{.by = -0.03f}).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) {
        const auto plan = test::required(thinner.plan(run));
        CHECK(plan->report().refused == 1);
        CHECK(plan->report().first_refusal == error::nothing_left);
        CHECK(plan->report().first_refusal.cluster == 1);
        CHECK_FALSE(plan->report().complete());
        const test::lit_mesh m = test::written(*plan);
        CHECK(inspect::check_closedness(m.view()).is_closed());
    }
}

TEST_CASE("letter spacing of twice the distance keeps bold letters as far apart as they were", "[text]")
{
    test::toy_font font;
    auto plain = text_mesher{font}.with(extruded<>{});
    auto bolder = text_mesher{font}.with(embolden{.by = 0.03f});
    const auto thin = test::required(plain.plan("EEE"));
    const auto wide = test::required(bolder.plan("EEE", {.shape = {.letter_spacing = 2 * 0.03}}));
    const double ink = thin->bounds().high.x - thin->bounds().low.x,
                 grown = wide->bounds().high.x - wide->bounds().low.x;
    CHECK(grown == Catch::Approx(ink + 6 * 0.03).margin(1e-5));
}

TEMPLATE_TEST_CASE("a step before a solid makes what an extruder makes that moves the edges itself", "[text]", flat,
                   extruded<>, bevelled, (outlined<extruded<>, extruded<>>))
{
    test::toy_font font;
    for (const float by : {0.02f, -0.02f, 0.0f})
        for (const bool merge : {false, true}) {
            text_mesher stepped{font, embolden{.by = by}, TestType{}};
            text_mesher nested{font, test::emboldened<TestType>{.by = by}};
            const auto a = test::required(stepped.plan(test::crossed_word, {.merge = merge}));
            const auto b = test::required(nested.plan(test::crossed_word, {.merge = merge}));
            CHECK(a->glyphs().size() == b->glyphs().size());
            CHECK(test::written(*a) == test::written(*b));
        }
}

TEST_CASE("a step is exchanged while the program runs, and refuses its options by their names", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font, extruded<>{}};
    const auto written = [&] { return test::written(*test::required(mesher.plan(test::crossed_word))); };
    const test::lit_mesh plain = written();
    CHECK(mesher.policy<embolden>() == nullptr);
    mesher.use(embolden{.by = 0.02f});
    REQUIRE(mesher.policy<embolden>() != nullptr);
    const test::lit_mesh bolder = written();
    CHECK_FALSE(bolder == plain);
    mesher.policy<embolden>()->by = 0.03f;
    CHECK_FALSE(written() == bolder);
    mesher.use(embolden{.mitre_limit = 0.5f});
    CHECK(std::string{mesher.plan("").error().option} == "embolden::mitre_limit");
    mesher.use(no_step{});
    CHECK(written() == plain);
}

TEST_CASE("merged bold letters tell whose outline each wall stands on", "[text]")
{
    test::toy_font font;
    const glyph_run run = test::row_of(1, {0.0, 300.0});
    text_mesher mesher{font, embolden{.by = 0.01f}, extruded<>{}};
    const auto plan = test::required(mesher.plan(run, {.merge = true}));
    REQUIRE(plan->glyphs().size() == 1);
    const test::lit_mesh m = test::written(*plan);
    const mesh_range side = plan->range(0, part::side);
    std::size_t owned[2] = {};
    for (std::uint32_t t = 0; t < side.index_count / 3; ++t) {
        const std::uint32_t owner = plan->owner(0, part::side, t);
        if (owner == shared_glyph) continue;
        REQUIRE(owner < 2);
        ++owned[owner];
        float x = 0.0f;  // its walls stand within its own box, 0.4 em wide, and the distance
        for (std::uint32_t k = 0; k < 3; ++k) {
            x = m.vertices[m.indices[side.first_index + 3 * t + k]].place.x;
            CHECK(x > (owner == 0 ? -0.011f : 0.289f));
        }
    }
    CHECK(owned[0] > 10);
    CHECK(owned[1] > 10);
}
