// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counted_output.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/failing_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <cstring>
#include <string>
#include <vector>

using namespace typemesh;
using test::full_mesh;
using test::full_vertex;

namespace {

result<test::toy_font> another_font(std::size_t) noexcept { return test::toy_font{}; }

/// Refuses every shape, with the number of its points.
struct counting_refusal : flat {
    result<part_sizes> plan(const region& r) const noexcept { return error{error::bad_option, r.points().size()}; }
};

struct own_lock {
    int depth = 0;
    void lock() noexcept { ++depth; }
    void unlock() noexcept { --depth; }
};

}  // namespace

static_assert(source_maker<decltype(another_font)>);
static_assert(!source_maker<int (*)(std::size_t) noexcept>);

TEMPLATE_TEST_CASE("several workers make and write the same mesh as one alone", "[text][workers]", flat,
                   extruded<curve_normals>, extruded<creased_normals>, extruded<averaged_normals>,
                   extruded<shared_normals>)
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(TestType{});
    auto other_mesher = text_mesher{font}.with(TestType{});
    const char* text = GENERATE("oEi x~q\nEoo", "o", "", " ", "~");
    const text_options options{.reuse = GENERATE(true, false)};
    const std::size_t workers = GENERATE(1u, 2u, 3u, 8u);
    test::scrambled_workers several{workers};
    auto team = test::required(workers_of(several, another_font));

    auto expected = test::required(mesher.plan(text, options));
    full_mesh one, many;
    REQUIRE(expected->write(into(one.vertices, one.indices)));
    for (int round = 0; round < 3; ++round) {
        auto plan = test::required(other_mesher.plan(text, options, *team));
        CHECK(plan->size() == expected->size());
        CHECK(plan->bounds().low == expected->bounds().low);
        CHECK(plan->bounds().high == expected->bounds().high);
        CHECK(plan->report().glyphs == expected->report().glyphs);
        CHECK(plan->report().blank == expected->report().blank);
        CHECK(plan->report().refused == expected->report().refused);
        CHECK(plan->report().first_refusal.code == expected->report().first_refusal.code);
        CHECK(plan->report().first_refusal.cluster == expected->report().first_refusal.cluster);
        CHECK(plan->report().missing == expected->report().missing);
        REQUIRE(plan->write(into(many.vertices, many.indices), several));
        CHECK(test::same_bits(one, many));
    }
    full_mesh built;
    const auto made = test::required(other_mesher.build(text, into(built.vertices, built.indices), options, *team));
    CHECK(test::same_bits(one, built));
}

TEST_CASE("shares of a text cover it, each ascending and each element once", "[text][workers]")
{
    test::toy_font font;
    text_mesher mesher{font};
    std::string text;
    const std::size_t length = GENERATE(0u, 1u, 40u, 2000u);
    for (std::size_t i = 0; i < length; ++i) text += "oEi x"[(i * 7 + i / 11) % 5];
    auto plan = test::required(mesher.plan(text, {.tolerance = quality::low}));
    const full_mesh one = test::written<full_mesh>(*plan);
    for (const std::size_t workers : {1u, 2u, 3u, 8u, 100u}) {
        test::scrambled_workers several{workers};
        test::counted_output out;
        REQUIRE(plan->write(test::counted_sink{out}, several));
        CHECK(out.each_once());
        CHECK(test::same_bits(one, {out.vertices, out.indices}));
    }
}

TEST_CASE("every sink over memory is written in subranges as it is in one piece", "[text][workers]")
{
    test::toy_font font;
    text_mesher mesher{font};
    std::string text;
    for (int i = 0; i < 60; ++i) text += "oEi x\nEoo";
    auto plan = test::required(mesher.plan(text));
    const auto size = plan->size();
    const full_mesh one = test::written<full_mesh>(*plan);
    test::scrambled_workers several{7};

    full_mesh array{std::vector<full_vertex>(size.vertices + 2), std::vector<std::uint32_t>(size.indices() + 2, 77u)};
    REQUIRE(plan->write(into(std::span{array.vertices}.subspan(1, size.vertices),
                             std::span{array.indices}.subspan(1, size.indices()), 5u),
                        several));
    CHECK(array.indices.front() == 77u);
    CHECK(array.indices.back() == 77u);
    CHECK(array.vertices.front().position == vec3{});
    CHECK(array.vertices.back().position == vec3{});
    CHECK(std::memcmp(array.vertices.data() + 1, one.vertices.data(), size.vertices * sizeof(full_vertex)) == 0);
    for (std::size_t i = 0; i < size.indices(); ++i) REQUIRE(array.indices[i + 1] == one.indices[i] + 5);

    std::vector<vec3> positions(size.vertices), normals(size.vertices);
    std::vector<std::uint32_t> indices(size.indices());
    REQUIRE(plan->write(stream_sink{std::span{indices}, stream<attribute::position, vec3>{positions},
                                    stream<attribute::normal, vec3>{normals}},
                        several));
    CHECK(indices == one.indices);
    for (std::size_t i = 0; i < size.vertices; ++i) {
        REQUIRE(positions[i] == one.vertices[i].position);
        REQUIRE(normals[i] == one.vertices[i].normal);
    }

    std::vector<full_vertex> none;
    std::vector<std::uint32_t> untouched(size.indices(), 77u);
    const error e = plan->write(into(std::span{none}, std::span{untouched}), several).error();
    CHECK(e == error::buffer_too_small);
    CHECK(untouched == std::vector<std::uint32_t>(size.indices(), 77u));
}

TEST_CASE("several workers return the error of the lowest glyph", "[text][workers]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(counting_refusal{});
    const char* text = GENERATE("Eio", "iEo", "oiE", " oE", "~iE");
    const auto expected = mesher.plan(text);
    REQUIRE(expected.error() == error::bad_option);
    for (std::uint32_t seed = 1; seed < 20; ++seed) {
        test::scrambled_workers several{3, seed};
        auto team = test::required(workers_of(several, another_font));
        const auto plan = mesher.plan(text, {}, *team);
        CHECK(plan.error() == error::bad_option);
        CHECK(plan.error().count == expected.error().count);
    }
}

TEST_CASE("a source that cannot be made makes no workers, and the others end", "[text][workers]")
{
    test::counting_memory counted;
    test::scrambled_workers several{4};
    const auto third_fails = [](std::size_t worker) noexcept -> result<test::toy_font> {
        if (worker == 2) return error{error::unreadable_file, worker};
        return another_font(worker);
    };
    CHECK(workers_of(several, third_fails, counted.source()).error() == error::unreadable_file);
    CHECK(counted.bytes_held == 0);

    counted.fail_at = counted.requests + 1;
    CHECK(workers_of(several, another_font, counted.source()).error() == error::out_of_memory);
}

TEST_CASE("workers' memory that fails at any request gives a clear error and leaves both usable", "[text][workers]")
{
    test::toy_font font;
    text_mesher mesher{font};
    full_mesh expected;
    REQUIRE(mesher.build("oEix", into(expected.vertices, expected.indices)));
    test::scrambled_workers several{3};
    const auto make = [&](memory source) {
        several = test::scrambled_workers{3};  // the same order each time
        return [&, team = test::required(workers_of(several, another_font, source))](full_mesh& m) mutable {
            return mesher.build("oEix", into(m.vertices, m.indices), {}, *team);
        };
    };
    const std::size_t first_of_builders = 2;  // the first request is for the workers themselves
    CHECK(test::failures_of(make, expected, GENERATE(true, false), first_of_builders) > 5);
}

TEST_CASE("the same text built by the same workers again allocates nothing", "[text][workers]")
{
    test::counting_memory counted, own;
    {
        test::toy_font font;
        text_mesher mesher{font, own.source()};
        test::scrambled_workers several{3};
        auto team = test::required(workers_of(several, another_font, counted.source()));
        full_mesh m;
        // Who gets which glyph changes with the seed: all have had all before counting.
        for (int i = 0; i < 60; ++i) REQUIRE(mesher.build("oEi o\nxoo", into(m.vertices, m.indices), {}, *team));
        const std::size_t before = counted.requests, own_before = own.requests;
        for (int i = 0; i < 20; ++i) REQUIRE(mesher.build("oEi o\nxoo", into(m.vertices, m.indices), {}, *team));
        CHECK(counted.requests == before);
        CHECK(own.requests == own_before);
    }
    CHECK(counted.bytes_held == 0);
    CHECK(own.bytes_held == 0);
}

TEST_CASE("a plan outlives a move of its workers, and a cache holds what they have built", "[text][workers]")
{
    test::toy_font font;
    text_mesher mesher{font};
    full_mesh expected, m;
    REQUIRE(mesher.build("oEi", into(expected.vertices, expected.indices)));

    test::scrambled_workers several{3};
    auto team = test::required(workers_of(several, another_font));
    {
        auto plan = test::required(mesher.plan("oEi", {}, *team));
        auto moved = std::move(*team);
        REQUIRE(plan->write(into(m.vertices, m.indices), moved.pool()));
        CHECK(test::same_bits(m, expected));
        *team = std::move(moved);
    }

    glyph_cache<own_lock> cache;
    auto cached = text_mesher{font}.with(cached_in{cache, 1});
    for (int round = 0; round < 3; ++round) {
        auto plan = test::required(cached.plan("oEi", {}, *team));
        CHECK(cache.statistics().misses == 3);
        CHECK(cache.statistics().pinned == 3);
        CHECK(cache.statistics().hits == 3u * static_cast<unsigned>(round));
        cache.set_bound(0);  // pins hold
        cache.clear();
        auto elsewhere = mesher.plan("ooEEx", {}, *team);  // another text by the same workers does not disturb it
        REQUIRE(elsewhere);
        REQUIRE(plan->write(into(m.vertices, m.indices), several));
        CHECK(test::same_bits(m, expected));
        cache.set_bound(1 << 20);
    }
    CHECK(cache.statistics().pinned == 0);
}

TEST_CASE("one set of drawings serves all workers where reading changes nothing", "[text][workers]")
{
    recorded_outlines shapes{1000.0};
    REQUIRE(shapes.add([](auto& pen) { pen.move({0, 0}), pen.line({10, 0}), pen.line({0, 10}), pen.close(); }));
    REQUIRE(shapes.add([](auto& pen) { pen.move({0, 0}), pen.line({10, 0}), pen.line({10, 10}), pen.close(); }));
    glyph_run run;
    for (cluster_id i = 0; i < 50; ++i) REQUIRE(run.glyphs.push_back({i % 2, i, {20.0 * i, 0}}));
    test::scrambled_workers several{2};
    using shared = transformed_outlines<const recorded_outlines>;
    auto team = workers_of(several, [&](std::size_t) noexcept { return result<shared>{shared{shapes, affine{}}}; });
    REQUIRE(team);
    text_mesher mesher{shapes};
    full_mesh expected, m;
    REQUIRE(mesher.build(run, into(expected.vertices, expected.indices)));
    REQUIRE(mesher.build(run, into(m.vertices, m.indices), {}, *team));
    CHECK(test::same_bits(m, expected));
}

TEST_CASE("trim() gives back the workers' scratch memory, plans stay, and the next text is the same", "[text][workers]")
{
    test::counting_memory memory;
    {
        const auto font_of = [](std::size_t) noexcept -> result<test::toy_font> { return test::toy_font{}; };
        test::scrambled_workers several{3};
        auto team = test::required(workers_of(several, font_of, memory.source()));
        test::toy_font font;
        text_mesher mesher{font};
        full_mesh first, kept, again;
        auto plan = test::required(mesher.plan("Eo xi", {}, *team));
        REQUIRE(plan->write(into(first.vertices, first.indices)));
        const std::size_t held = memory.bytes_held;
        team->trim();
        const std::size_t trimmed = memory.bytes_held;
        CHECK(trimmed + 16 * 1024 <= held);  // a block of each builder's scratch memory, at least
        team->trim();
        CHECK(memory.bytes_held == trimmed);
        REQUIRE(plan->write(into(kept.vertices, kept.indices)));
        CHECK(test::same_bits(kept, first));
        REQUIRE(test::required(mesher.plan("Eo xi", {}, *team))->write(into(again.vertices, again.indices)));
        CHECK(test::same_bits(again, first));
    }
    CHECK(memory.bytes_held == 0);
}
