// SPDX-License-Identifier: MIT
//
// Teams on real threads and real fonts; the thread sanitizer's tier runs this room.
#include "support/catch.hpp"
#include "support/counted_output.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"
#include "support/workload.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/adapt/threads.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <atomic>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

using namespace typemesh;
using test::full_mesh;
using test::full_vertex;

namespace {

bool same(const full_mesh& a, const full_mesh& b)
{
    if (a.indices != b.indices || a.vertices.size() != b.vertices.size()) return false;
    return a.vertices.empty() ||
           std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(full_vertex)) == 0;
}

/// The phrases of a script, a line each.
std::string phrases(const char* file)
{
    std::string all;
    for (const std::string& line : test::workload_lines(file)) all += (all.empty() ? "" : "\n") + line;
    return all;
}

harfbuzz_font open(const std::string& file)
{
    auto font = harfbuzz_font::open(font_file(file).c_str());
    REQUIRE(font);
    return std::move(*font);
}

/// The same text by one worker and by teams of several, planned, written and cut.
template <class Mesher, class Clone>
void check_teams(Mesher& mesher, const std::string& text, const Clone& clone, const text_options& options = {})
{
    full_mesh one;
    REQUIRE(mesher.build(text, into(one.vertices, one.indices), options));
    REQUIRE(one.vertices.size() > 1000);
    test::counted_output cut_by_one;
    for (const std::size_t workers : {1u, 2u, 3u, 8u}) {
        INFO(workers << " workers");
        thread_pool pool{workers};
        auto team = workers_of(pool, clone);
        REQUIRE(team);
        for (int round = 0; round < 2; ++round) {
            auto plan = mesher.plan(text, options, *team);
            REQUIRE(plan);
            REQUIRE(plan->report().complete());
            test::counted_output out;
            REQUIRE(plan->write(test::counted_sink{out}, pool));
            CHECK(out.each_once());
            CHECK(same(one, {out.vertices, out.indices}));

            text_chunks chunks;
            REQUIRE(chunks.cut(*plan, 500));
            test::counted_output cut;
            REQUIRE(chunks.write(*plan, test::counted_sink{cut}, pool));
            CHECK(cut.each_once());
            if (workers == 1) cut_by_one = cut;
            CHECK(same({cut_by_one.vertices, cut_by_one.indices}, {cut.vertices, cut.indices}));
        }
        full_mesh built;
        REQUIRE(mesher.build(text, into(built.vertices, built.indices), options, *team));
        CHECK(same(one, built));
    }
}

/// The heap for several threads, counted, and told when to fail.
struct shared_memory {
    std::atomic<std::size_t> requests{0};
    std::atomic<std::size_t> fail_at{0};
    std::atomic<std::size_t> bytes_held{0};

    [[nodiscard]] memory source() noexcept
    {
        return {this,
                [](void* user, std::size_t bytes, std::size_t alignment) noexcept -> void* {
                    auto& self = *static_cast<shared_memory*>(user);
                    if (++self.requests == self.fail_at) return nullptr;
                    self.bytes_held += bytes;
                    return heap().allocate(nullptr, bytes, alignment);
                },
                [](void* user, void* block, std::size_t bytes, std::size_t alignment) noexcept {
                    static_cast<shared_memory*>(user)->bytes_held -= bytes;
                    heap().deallocate(nullptr, block, bytes, alignment);
                }};
    }
};

}  // namespace

TEMPLATE_TEST_CASE("any number of HarfBuzz workers makes the same mesh", "[threads][harfbuzz]", flat,
                   extruded<curve_normals>, extruded<creased_normals>, extruded<averaged_normals>,
                   extruded<shared_normals>, extruded<cap_normals>, bevelled)
{
    auto font = open("truetype/dejavu/DejaVuSans.ttf");
    auto mesher = text_mesher{font}.with(TestType{});
    check_teams(mesher, phrases("phrases-latin.txt"),
                [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); });
}

/// One that can be made without arguments.
struct best_of_thesis : thesis_quality {
    best_of_thesis() noexcept : thesis_quality{best, 1000.0} {}
};

TEMPLATE_TEST_CASE("HarfBuzz workers make the same mesh with every triangulator and discretiser", "[threads][harfbuzz]",
                   monotone, constrained_delaunay, certified, two_lines, best_of_thesis)
{
    auto font = open("opentype/comic-neue/ComicNeue-Regular.otf");
    auto mesher = text_mesher{font}.with(TestType{});
    check_teams(mesher, phrases("phrases-latin.txt"),
                [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); });
}

TEST_CASE("HarfBuzz workers make the same mesh in other scripts, even of overlapping glyphs", "[threads][harfbuzz]")
{
    const auto [file, text] = GENERATE(std::pair{"truetype/wqy/wqy-microhei.ttc", "phrases-chinese.txt"},
                                       std::pair{"opentype/fonts-hosny-amiri/Amiri-Regular.ttf", "phrases-arabic.txt"},
                                       std::pair{"truetype/inter-vf/Inter.var.ttf", "phrases-latin.txt"});
    auto font = open(file);
    text_mesher mesher{font};
    const bool merge = GENERATE(false, true);
    check_teams(mesher, phrases(text), [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); },
                {.merge = merge});
}

TEST_CASE("FreeType workers with their own face and library make the same mesh", "[threads][freetype]")
{
    const std::string path = font_file("truetype/dejavu/DejaVuSans.ttf");
    auto font = freetype_font::open(path.c_str());
    REQUIRE(font);
    text_mesher mesher{*font};
    check_teams(mesher, phrases("phrases-latin.txt"),
                [&](std::size_t) noexcept { return freetype_font::open(path.c_str()); });
}

TEST_CASE("several teams and meshers can share a cache while another thread empties it", "[threads][cache]")
{
    auto font = open("truetype/dejavu/DejaVuSans.ttf");
    const std::string text = phrases("phrases-latin.txt");
    full_mesh expected;
    {
        text_mesher mesher{font};
        REQUIRE(mesher.build(text, into(expected.vertices, expected.indices)));
    }
    glyph_cache<mutex_lock> cache;
    std::atomic<bool> over{false};
    std::thread cleaner{[&] {
        for (std::size_t bound = 0; !over; bound = (bound + 7919) % 100'000) {
            cache.set_bound(bound);
            cache.clear();
            std::this_thread::yield();
        }
    }};
    std::atomic<int> wrong{0};
    const auto work = [&](hb_font_t* handle) {
        auto own = harfbuzz_font::wrap(handle);
        auto mesher = text_mesher{*own}.with(cached_in{cache, 1});
        thread_pool pool{2};
        auto team = workers_of(pool, [&](std::size_t) noexcept { return harfbuzz_font::wrap(handle); });
        for (int round = 0; round < 8; ++round) {
            full_mesh m;
            auto plan = mesher.plan(text, {}, *team);
            if (!plan) {
                ++wrong;
                continue;
            }
            std::this_thread::yield();
            if (!plan->write(into(m.vertices, m.indices), pool) || !same(m, expected)) ++wrong;
        }
    };
    {
        std::thread first{[&] { work(font.handle()); }}, second{[&] { work(font.handle()); }};
        first.join();
        second.join();
    }
    over = true;
    cleaner.join();
    CHECK(wrong == 0);
    CHECK(cache.statistics().pinned == 0);
}

TEST_CASE("a lack of memory in one of several workers is a clear error, and the next build succeeds",
          "[threads][memory]")
{
    auto font = open("truetype/dejavu/DejaVuSans.ttf");
    const std::string text = "The quick brown fox jumps over the lazy dog.";
    text_mesher mesher{font};
    full_mesh expected;
    REQUIRE(mesher.build(text, into(expected.vertices, expected.indices)));
    thread_pool pool{3};
    std::size_t failures = 0;
    for (std::size_t n = 2; n < 400; ++n) {
        shared_memory counted;
        auto team = workers_of(
            pool, [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); }, counted.source());
        REQUIRE(team);
        counted.fail_at = n;
        full_mesh m = {{{}, {}}, {7}};
        auto made = mesher.build(text, into(m.vertices, m.indices), {}, *team);
        if (!made) {
            ++failures;
            CHECK(made.error() == error::out_of_memory);
            CHECK(m.vertices.size() == 2);
            CHECK(m.indices.size() == 1);
        }
        const bool reached = counted.requests >= n;
        counted.fail_at = 0;
        REQUIRE(mesher.build(text, into(m.vertices, m.indices), {}, *team));
        CHECK(same(m, expected));
        if (!reached) break;
    }
    CHECK(failures > 10);
}

TEST_CASE("a lack of memory in a shared cache is a clear error, and its statistics stay right", "[threads][memory]")
{
    auto font = open("truetype/dejavu/DejaVuSans.ttf");
    const std::string text = "The quick brown fox jumps over the lazy dog.";
    thread_pool pool{3};
    auto team = workers_of(pool, [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); });
    REQUIRE(team);
    full_mesh expected;
    text_mesher plain{font};
    REQUIRE(plain.build(text, into(expected.vertices, expected.indices)));
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 100; ++n) {
        shared_memory counted;
        counted.fail_at = n;
        {
            glyph_cache<mutex_lock> cache{1 << 20, counted.source()};
            auto mesher = text_mesher{font}.with(cached_in{cache, 1});
            full_mesh m;
            auto made = mesher.build(text, into(m.vertices, m.indices), {}, *team);
            if (!made) {
                ++failures;
                CHECK(made.error() == error::out_of_memory);
                CHECK(cache.statistics().pinned == 0);
            }
            REQUIRE(mesher.build(text, into(m.vertices, m.indices), {}, *team));
            CHECK(same(m, expected));
        }
        CHECK(counted.bytes_held == 0);
        if (counted.requests < n) break;
    }
    CHECK(failures > 10);
}

TEST_CASE("Several threads write one plan at once")
{
    auto font = open("truetype/dejavu/DejaVuSans.ttf");
    const std::string text = phrases("phrases-latin.txt");
    text_mesher mesher{font, bevelled{}};
    full_mesh expected;
    REQUIRE(mesher.build(text, into(expected.vertices, expected.indices)));
    auto plan = mesher.plan(text);
    REQUIRE(plan);
    std::atomic<int> wrong{0};
    std::vector<std::thread> writers;
    for (int i = 0; i < 3; ++i)
        writers.emplace_back([&] {
            for (int round = 0; round < 4; ++round) {
                full_mesh m;
                if (!plan->write(into(m.vertices, m.indices)) || !same(m, expected)) ++wrong;
            }
        });
    for (std::thread& t : writers) t.join();
    CHECK(wrong == 0);
}
