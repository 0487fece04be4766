// SPDX-License-Identifier: MIT

// An extruder of five parts, with points, records and caps of its own, works wherever the library's own do: in caches,
// merged letters, chunks, instances, teams and partial writes.

#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "flared.hpp"
#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "tapering_twist.hpp"

using namespace typemesh;
using Catch::Approx;
using test::lawful;
using test::written;
using mesh = test::lit_mesh;
using vertex = test::lit_vertex;

namespace {

struct own_lock {
    int held = 0;
    void lock() noexcept { ++held; }
    void unlock() noexcept { --held; }
};

constexpr const char* word = "oExi Eo";  // x has contours that cross

}  // namespace

TEST_CASE("a stranger's extruder of five parts makes closed solids of exact size, volume and bounds", "[stranger]")
{
    test::toy_font font;
    const stranger::flared how;
    auto mesher = text_mesher{font}.with(how);
    const auto alone = test::required(mesher.plan("i"));
    CHECK(alone->parts().size() == 5);
    const std::uint32_t vertices[] = {4, 4, 16, 16, 16}, triangles[] = {2, 2, 8, 8, 8};
    for (const part p : alone->parts()) {
        CHECK(alone->range(p).vertex_count == vertices[static_cast<std::size_t>(p)]);
        CHECK(alone->range(p).index_count == 3 * triangles[static_cast<std::size_t>(p)]);
    }
    CHECK(alone->hard_edges() == 4);

    const double area = 0.1 * 0.5, rim = double{how.rim}, between = double{how.depth} - 2.0 * rim;
    CHECK(inspect::measure(lawful(*alone).view()).volume ==
          Approx(area * (between + 2.0 * rim * 7.0 / 3.0)).epsilon(1e-5));
    CHECK(alone->bounds().low == vec3{0.05f, -0.25f, -0.3f});
    CHECK(alone->bounds().high == vec3{0.25f, 0.75f, 0.0f});

    frame turned = left_handed_y_up;
    turned.winding = -1;
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up, turned}) {
        const text_options options{.frame = f};
        const auto plan = test::required(mesher.plan(word, options));
        (void)lawful(*plan, f);
    }
    // Its own box is fitted.
    const text_options fitted{.unit = output_unit::unit_box};
    const auto fits = test::required(mesher.plan(word, fitted));
    (void)lawful(*fits);
    CHECK(fits->bounds().low.x == -1.0f);
    CHECK(fits->bounds().high.x == 1.0f);
}

TEST_CASE("a stranger's five parts are the same through caches, teams and constrained Delaunay", "[stranger]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(stranger::flared{});
    const auto plan = test::required(mesher.plan(word));
    const mesh expected = lawful(*plan);

    glyph_cache<own_lock> cache;
    auto cached = text_mesher{font}.with(stranger::flared{}).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) {
        const auto again = test::required(cached.plan(word));
        CHECK(lawful(*again) == expected);
    }
    CHECK(cache.statistics().hits >= 5);
    auto other = text_mesher{font}.with(stranger::flared{.rim = 0.1f}).with(cached_in{cache, 1});
    const auto deeper = test::required(other.plan(word));
    CHECK_FALSE(lawful(*deeper) == expected);

    test::scrambled_workers pool;
    auto team = workers_of(pool, [](std::size_t) noexcept { return result<test::toy_font>{test::toy_font{}}; });
    REQUIRE(team);
    const text_options options;
    for (int i = 0; i < 2; ++i) {
        const auto shared = test::required(mesher.plan(word, options, *team));
        mesh m;
        REQUIRE(shared->write(into(m.vertices, m.indices), pool));
        CHECK(m == expected);
    }
    auto delaunay = text_mesher{font}.with(stranger::flared{}).with(constrained_delaunay{});
    const auto cut = test::required(delaunay.plan(word));
    CHECK(lawful(*cut).vertices.size() == expected.vertices.size());
}

TEST_CASE("a stranger's five parts are merged, cut into chunks, instanced and written in part", "[stranger]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(stranger::flared{});
    glyph_run run;
    for (const double x : {0.0, 300.0, 1500.0}) REQUIRE(run.glyphs.push_back({1, 0, {x, 0.0}}));  // two rings that meet
    run.units_per_em = 1000.0;
    const text_options merging{.merge = true};
    const auto joined = test::required(mesher.plan(run, merging));
    CHECK(joined->glyphs().size() == 2);
    (void)lawful(*joined);
    CHECK(joined->owner(0, stranger::flared::front_slope, 0) == shared_glyph);

    const auto plan = test::required(mesher.plan(word));
    mesh whole = lawful(*plan);
    text_chunks chunks;
    for (const std::uint32_t most : {65'535u, 200u, 30u}) {  // all glyphs, one, pieces
        REQUIRE(chunks.cut(*plan, most));
        std::vector<vertex> vertices;
        std::vector<std::uint16_t> indices;
        REQUIRE(chunks.write(*plan, into(vertices, indices)));
        mesh all{vertices, {}};
        for (const text_chunk& c : chunks.view()) {
            CHECK(c.size().vertices <= most);
            const mesh_range r = c.range();
            for (std::uint32_t i = 0; i < r.index_count; ++i)
                all.indices.push_back(r.first_vertex + indices[r.first_index + i]);
            std::uint32_t next = r.first_vertex;
            for (const part p : plan->parts())
                for (std::uint32_t i = 0; i < c.range(p).vertex_count; ++i) REQUIRE(vertices[next++].of == p);
        }
        CHECK(all.indices.size() == whole.indices.size());
        CHECK(inspect::check_closedness(all.view()).is_closed());
        CHECK(inspect::measure(all.view()).volume == Approx(inspect::measure(whole.view()).volume));
    }

    mesh once;
    REQUIRE(plan->write_meshes(into(once.vertices, once.indices)));
    CHECK(once.vertices.size() == plan->meshes_size().vertices);
    CHECK(inspect::check_closedness(once.view()).is_closed());
    for (std::size_t m = 0; m < plan->meshes().size(); ++m)
        for (const part p : plan->parts())
            for (std::uint32_t i = 0; i < plan->mesh_part(m, p).vertex_count; ++i)
                REQUIRE(once.vertices[plan->mesh_part(m, p).first_vertex + i].of == p);

    mesh some = whole;
    for (const part p : plan->parts()) {
        const mesh_range r = plan->range(1, p);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) some.vertices[r.first_vertex + i] = {};
        for (std::uint32_t i = 0; i < r.index_count; ++i) some.indices[r.first_index + i] = 0;
    }
    CHECK_FALSE(some == whole);
    REQUIRE(plan->write(glyph_span{1, 2}, into(std::span{some.vertices}, std::span{some.indices})));
    CHECK(some == whole);
}

TEST_CASE("letters that twist and taper stay within their stated bounds", "[stranger]")
{
    test::toy_font font;
    for (const double turn : {0.0, 0.2, -1.5}) {
        for (const double taper : {0.5, 1.0, 1.3}) {
            auto mesher = text_mesher{font}.with(stranger::tapering_twist{.turn = turn, .taper = taper});
            for (const output_unit unit : {output_unit::em, output_unit::unit_box}) {
                const text_options options{.unit = unit};
                const auto plan = test::required(mesher.plan(word, options));
                const mesh m = written(*plan);
                bounds3 seen{m.vertices[0].place, m.vertices[0].place};
                for (const vertex& v : m.vertices) seen.add(v.place);
                CHECK(plan->bounds().low == seen.low);
                CHECK(plan->bounds().high == seen.high);
            }
        }
    }
}
