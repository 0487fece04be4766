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
#include "support/executors.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

struct bold_corner {
    vec3 place, normal;
    vec4 tangent;
    vec2 uv;
    part of;

    friend bool operator==(const bold_corner&, const bold_corner&) = default;
};

struct bold_mesh {
    std::vector<bold_corner> vertices;
    std::vector<std::uint32_t> indices;

    friend bool operator==(const bold_mesh&, const bold_mesh&) = default;
    [[nodiscard]] auto view() const { return inspect::mesh_view{vertices, indices, &bold_corner::place}; }
};

}  // namespace

template <>
struct typemesh::vertex_traits<bold_corner> {
    static constexpr auto wants =
        attribute::position | attribute::normal | attribute::tangent | attribute::uv | attribute::part;
    bold_corner operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal, s.tangent, s.uv, s.part};
    }
};

namespace {

constexpr const char* bold_word = "oExi Eo";  // x has contours that cross

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

/// Closed, right side out, lit from outside, each part where the plan says, within its bounds.
template <class Plan>
bold_mesh checked_mesh(const Plan& plan, std::size_t parts)
{
    bold_mesh m;
    REQUIRE(plan.write(into(m.vertices, m.indices)));
    CHECK(mesh_size{m.vertices.size(), m.indices.size() / 3} == plan.size());
    CHECK(inspect::check_closedness(m.view()).is_closed());
    CHECK(inspect::check_normals(m.view(), &bold_corner::normal).is_right());
    for (const bold_corner& v : m.vertices) REQUIRE(plan.bounds().holds(v.place));
    REQUIRE(plan.parts().size() == parts);
    for (const part p : plan.parts()) {
        const mesh_range r = plan.range(p);
        CHECK(r.vertex_count != 0);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) REQUIRE(m.vertices[r.first_vertex + i].of == p);
    }
    return m;
}

double volume_of(const bold_mesh& m) { return inspect::measure(m.view()).volume; }

/// A text comes out of caches, teams and constrained Delaunay as it is built alone; `other` is the same extruder with
/// other options.
template <class E>
void check_everywhere(const E& how, const E& other)
{
    constexpr std::size_t parts = part_count_of<E>;
    test::toy_font font;
    auto mesher = mesher_of(font, how);
    const auto plan = test::required(mesher.plan(bold_word));
    CHECK(plan->report().complete());
    CHECK(plan->report().narrowed == 0);
    const bold_mesh expected = checked_mesh(*plan, parts);

    glyph_cache<> cache;
    auto cached = mesher_of(font, how).with(cached_in{cache, 1});
    for (int i = 0; i < 2; ++i) {
        const auto again = test::required(cached.plan(bold_word));
        CHECK(checked_mesh(*again, parts) == expected);
    }
    CHECK(cache.statistics().hits >= 5);
    auto unlike = mesher_of(font, other).with(cached_in{cache, 1});
    const auto different = test::required(unlike.plan(bold_word));
    CHECK_FALSE(checked_mesh(*different, parts) == expected);

    test::scrambled_workers pool;
    auto team = workers_of(pool, [](std::size_t) noexcept { return result<test::toy_font>{test::toy_font{}}; });
    REQUIRE(team);
    for (int i = 0; i < 2; ++i) {
        const auto shared = test::required(mesher.plan(bold_word, {}, *team));
        bold_mesh m;
        REQUIRE(shared->write(into(m.vertices, m.indices), pool));
        CHECK(m == expected);
    }

    auto delaunay = mesher_of(font, how).with(constrained_delaunay{});
    const auto cut = test::required(delaunay.plan(bold_word));
    CHECK(volume_of(checked_mesh(*cut, parts)) == Catch::Approx(volume_of(expected)).epsilon(1e-5));
}

/// And is cut into chunks, written glyph by glyph and as instances.
template <class E>
void check_pieces(const E& how)
{
    test::toy_font font;
    auto mesher = mesher_of(font, how);
    const auto plan = test::required(mesher.plan(bold_word));
    const bold_mesh whole = checked_mesh(*plan, part_count_of<E>);
    text_chunks chunks;
    for (const std::uint32_t most : {65'535u, 900u, 60u}) {  // of all glyphs, of one, of pieces
        REQUIRE(chunks.cut(*plan, most));
        std::vector<bold_corner> vertices;
        std::vector<std::uint16_t> indices;
        REQUIRE(chunks.write(*plan, into(vertices, indices)));
        bold_mesh all{vertices, {}};
        for (const text_chunk& c : chunks.view()) {
            CHECK(c.size().vertices <= most);
            const mesh_range r = c.range();
            for (std::uint32_t i = 0; i < r.index_count; ++i)
                all.indices.push_back(r.first_vertex + indices[r.first_index + i]);
        }
        CHECK(all.indices.size() == whole.indices.size());
        CHECK(inspect::check_closedness(all.view()).is_closed());
    }

    bold_mesh once;
    REQUIRE(plan->write_meshes(into(once.vertices, once.indices)));
    CHECK(once.vertices.size() == plan->meshes_size().vertices);
    CHECK(inspect::check_closedness(once.view()).is_closed());

    bold_mesh some = whole;
    for (const part p : plan->parts()) {
        const mesh_range r = plan->range(1, p);
        for (std::uint32_t i = 0; i < r.vertex_count; ++i) some.vertices[r.first_vertex + i] = {};
    }
    CHECK_FALSE(some == whole);
    REQUIRE(plan->write(glyph_span{1, 2}, into(std::span{some.vertices}, std::span{some.indices})));
    CHECK(some == whole);
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
    glyph_run run;
    for (const double x : {0.0, 300.0, 1500.0}) REQUIRE(run.glyphs.push_back({1, 0, {x, 0.0}}));  // two rings that meet
    run.units_per_em = 1000.0;
    const text_options merging{.merge = true};
    auto bolder = mesher_of(font, bold);
    const auto joined = test::required(bolder.plan(run, merging));
    CHECK(joined->glyphs().size() == 2);
    const bold_mesh m = checked_mesh(*joined, 5);
    const auto apart = test::required(bolder.plan(run));
    CHECK(volume_of(m) < volume_of(checked_mesh(*apart, 5)));

    auto hollower = text_mesher{font}.with(hollow);
    const auto rings = test::required(hollower.plan(run, merging));
    CHECK(rings->glyphs().size() == 2);
    (void)checked_mesh(*rings, 6);
}

TEST_CASE("rings that meet when they have grown are one ring round both letters", "[text]")
{
    test::toy_font font;
    const auto plan_of = [&](auto how, double second) {
        glyph_run run;
        run.units_per_em = 1000.0;
        for (const double x : {0.0, second}) REQUIRE(run.glyphs.push_back({5, 0, {x, 0.0}}));  // bars, 100 wide
        auto mesher = mesher_of(font, how);
        auto plan = test::required(mesher.plan(run, {.merge = true}));
        (void)checked_mesh(*plan, part_count_of<decltype(how)>);
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
    const bold_mesh m = checked_mesh(*plan, 5);
    bounds3 reached;
    for (const bold_corner& v : m.vertices) reached.add(v.place);
    CHECK(reached.low == plan->bounds().low);
    CHECK(reached.high == plan->bounds().high);
    CHECK(plan->report().narrowed == 2);  // both rings are less than half as wide as the bevels that were to be on them
    auto narrower = text_mesher{font}.with(
        ring{.width = 0.03f, .ring = {.width = 0.025f, .bevel_depth = 0.05f, .mode = bevel_mode::fit_text}});
    CHECK(narrower.plan("oi")->report().narrowed == 0);
}

TEST_CASE("a glyph that thinning leaves nothing of is left out and named, from a cache as well", "[text]")
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
        bold_mesh m;
        REQUIRE(plan->write(into(m.vertices, m.indices)));
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
            const auto a = test::required(stepped.plan(bold_word, {.merge = merge}));
            const auto b = test::required(nested.plan(bold_word, {.merge = merge}));
            CHECK(a->glyphs().size() == b->glyphs().size());
            bold_mesh m, n;
            REQUIRE(a->write(into(m.vertices, m.indices)));
            REQUIRE(b->write(into(n.vertices, n.indices)));
            CHECK(m == n);
        }
}

TEST_CASE("a step is exchanged while the program runs, and refuses its options by their names", "[text]")
{
    test::toy_font font;
    text_mesher mesher{font, extruded<>{}};
    const auto written = [&] {
        const auto plan = test::required(mesher.plan(bold_word));
        bold_mesh m;
        REQUIRE(plan->write(into(m.vertices, m.indices)));
        return m;
    };
    const bold_mesh plain = written();
    CHECK(mesher.policy<embolden>() == nullptr);
    mesher.use(embolden{.by = 0.02f});
    REQUIRE(mesher.policy<embolden>() != nullptr);
    const bold_mesh bolder = written();
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
    glyph_run run;
    for (const double x : {0.0, 300.0}) REQUIRE(run.glyphs.push_back({1, 0, {x, 0.0}}));
    run.units_per_em = 1000.0;
    text_mesher mesher{font, embolden{.by = 0.01f}, extruded<>{}};
    const auto plan = test::required(mesher.plan(run, {.merge = true}));
    REQUIRE(plan->glyphs().size() == 1);
    bold_mesh m;
    REQUIRE(plan->write(into(m.vertices, m.indices)));
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
