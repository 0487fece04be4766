// SPDX-License-Identifier: MIT

// Bevelled letters go wherever all others do: into caches, merged letters, chunks, instances, teams and partial writes.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

constexpr const char* bevelled_word = "oExi Eo";  // x has contours that cross

const bevelled<round_profile> rounding{.width = 0.02f, .bevel_depth = 0.03f, .profile = {4}};

/// A lawful mesh with five parts.
template <class Plan>
test::lit_mesh checked_mesh(const Plan& plan, const frame& f = right_handed_y_up)
{
    REQUIRE(plan.parts().size() == 5);
    for (const part p : plan.parts()) CHECK(plan.range(p).vertex_count != 0);
    return test::lawful(plan, f);
}

}  // namespace

TEST_CASE("bevelled letters come out of caches, teams and constrained Delaunay as they are built alone", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    const auto plan = mesher.plan(bevelled_word);
    REQUIRE(plan);
    CHECK(plan->report().refused == 0);
    const test::lit_mesh expected = checked_mesh(*plan);

    glyph_cache<> cache;
    auto cached = text_mesher{font}.with(rounding).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) {
        const auto again = cached.plan(bevelled_word);
        REQUIRE(again);
        CHECK(checked_mesh(*again) == expected);
    }
    CHECK(cache.statistics().hits >= 5);
    bevelled<round_profile> wider = rounding;
    wider.width = 0.03f;
    auto other = text_mesher{font}.with(wider).with(cached_in{cache, 1});
    const auto wide = other.plan(bevelled_word);
    REQUIRE(wide);
    CHECK_FALSE(checked_mesh(*wide) == expected);

    test::scrambled_workers pool;
    auto team = workers_of(pool, [](std::size_t) noexcept { return result<test::toy_font>{test::toy_font{}}; });
    REQUIRE(team);
    const text_options options;
    for (int i = 0; i < 2; ++i) {
        const auto shared = mesher.plan(bevelled_word, options, *team);
        REQUIRE(shared);
        test::lit_mesh m;
        REQUIRE_FALSE(shared->write(into(m.vertices, m.indices), pool));
        CHECK(m == expected);
    }

    auto delaunay = text_mesher{font}.with(rounding).with(constrained_delaunay{});
    const auto cut = delaunay.plan(bevelled_word);
    REQUIRE(cut);
    const test::lit_mesh finer = checked_mesh(*cut);
    CHECK(inspect::measure(finer.view()).volume ==
          Catch::Approx(inspect::measure(expected.view()).volume).epsilon(1e-5));
}

TEST_CASE("bevelled letters are merged, cut into chunks, instanced and written in part", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    glyph_run run;
    for (const double x : {0.0, 300.0, 1500.0}) REQUIRE(run.glyphs.push_back({1, 0, {x, 0.0}}));  // two rings that meet
    run.units_per_em = 1000.0;
    const text_options merging{.merge = true};
    const auto joined = mesher.plan(run, merging);
    REQUIRE(joined);
    CHECK(joined->glyphs().size() == 2);
    (void)checked_mesh(*joined);

    const auto plan = mesher.plan(bevelled_word);
    REQUIRE(plan);
    const test::lit_mesh whole = checked_mesh(*plan);
    text_chunks chunks;
    for (const std::uint32_t most : {65'535u, 600u, 60u}) {  // of all glyphs, of one, of pieces
        REQUIRE_FALSE(chunks.cut(*plan, most));
        std::vector<test::lit_vertex> vertices;
        std::vector<std::uint16_t> indices;
        REQUIRE_FALSE(chunks.write(*plan, into(vertices, indices)));
        test::lit_mesh all{vertices, {}};
        for (const text_chunk& c : chunks.view()) {
            CHECK(c.size().vertices <= most);
            const mesh_range r = c.range();
            for (std::uint32_t i = 0; i < r.index_count; ++i)
                all.indices.push_back(r.first_vertex + indices[r.first_index + i]);
        }
        CHECK(all.indices.size() == whole.indices.size());
        CHECK(inspect::check_closedness(all.view()).is_closed());
    }

    test::lit_mesh once;
    REQUIRE_FALSE(plan->write_meshes(into(once.vertices, once.indices)));
    CHECK(once.vertices.size() == plan->meshes_size().vertices);
    CHECK(inspect::check_closedness(once.view()).is_closed());

    test::lit_mesh some = whole;
    for (const part p : plan->parts()) {
        const mesh_range r = plan->range(1, p);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) some.vertices[r.first_vertex + i] = {};
    }
    CHECK_FALSE(some == whole);
    REQUIRE_FALSE(plan->write(glyph_span{1, 2}, into(std::span{some.vertices}, std::span{some.indices})));
    CHECK(some == whole);
}

TEST_CASE("a bevel keeps its slope where depths are in output units", "[text]")
{
    test::toy_font font;
    const bevelled<> how{.depth = 20.0f, .width = 0.02f, .bevel_depth = 2.0f};
    auto mesher = text_mesher{font}.with(how);
    const text_options options{.unit = output_unit::pixels, .pixels_per_em = 100.0, .depth_in = depth_unit::output};
    const auto plan = mesher.plan("i", options);
    REQUIRE(plan);
    const test::lit_mesh m = checked_mesh(*plan);
    const mesh_range r = plan->range(part::front_bevel);
    for (std::uint32_t i = 0; i < r.vertex_count; ++i)
        CHECK(m.vertices[r.first_vertex + i].normal.z == Catch::Approx(0.70710678).margin(1e-5));
    CHECK(plan->bounds().low.z == Catch::Approx(-20.0));
}

TEST_CASE("bevelled letters obey their laws in every frame, in mirrored looks as well", "[text]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(rounding);
    frame godot = right_handed_y_up;
    godot.winding = -1;
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up, godot}) {
        const auto plan = mesher.plan(bevelled_word, {.frame = f});
        REQUIRE(plan);
        (void)checked_mesh(*plan, f);
    }
    glyph_run run;
    run.units_per_em = 1000.0;
    REQUIRE(run.looks.push_back({}));
    REQUIRE(run.looks.push_back({.map = {.xx = -1.0}}));
    for (const glyph_id g : {1u, 2u, 3u})
        for (const std::uint32_t look : {0u, 1u})
            REQUIRE(run.glyphs.push_back({.id = g, .origin = {2000.0 * g, 2000.0 * look}, .look = look}));
    const auto plan = mesher.plan(run);
    REQUIRE(plan);
    CHECK(plan->report().refused == 0);
    (void)checked_mesh(*plan);
}

TEST_CASE("a bevelled text reports memory that fails at any request, and can be built afterwards", "[text][memory]")
{
    const bool once = GENERATE(true, false);
    test::toy_font font;
    auto reference = text_mesher{font}.with(rounding);
    const auto plan = reference.plan(bevelled_word);
    REQUIRE(plan);
    const test::lit_mesh expected = test::written(*plan);
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 1000; ++n) {
        test::counting_memory counted{.fail_at = n, .fail_once = once};
        auto mesher = text_mesher{font, counted.source()}.with(rounding);
        test::lit_mesh m{{{}, {}}, {7}};
        auto made = mesher.build(bevelled_word, into(m.vertices, m.indices));
        if (!made) {
            ++failures;
            CHECK(made.error() == error::out_of_memory);
            CHECK(m.vertices.size() == 2);  // nothing of the caller's was touched
            CHECK(m.indices.size() == 1);
        } else
            CHECK(made->complete());
        counted.fail_at = 0;
        made = mesher.build(bevelled_word, into(m.vertices, m.indices));
        REQUIRE(made);
        CHECK(m == expected);
        if (counted.requests < n) break;
    }
    CHECK(failures > 20);
}
