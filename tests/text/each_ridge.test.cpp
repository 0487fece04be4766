// SPDX-License-Identifier: MIT

// Carved texts, and their ridges: on the surface of the mesh, wherever it goes.

#include <typemesh/extrude/one_of.hpp>
#include <typemesh/text/each_ridge.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/text_laws.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// Polylines as a sink gets them.
struct ridge_lines {
    std::vector<std::vector<vec3>> all;

    void move(const vec3& at) noexcept { all.push_back({at}); }
    void line(const vec3& at) noexcept { all.back().push_back(at); }
};
static_assert(ridge_sink<ridge_lines>);

struct counted_ridges {
    std::size_t lines = 0, points = 0;

    void move(const vec3&) noexcept { ++lines, ++points; }
    void line(const vec3&) noexcept { ++points; }
};

/// The number of points of ridges that are no vertices of the mesh.
template <class Plan>
std::size_t off_surface(const Plan& plan, const test::lit_mesh& m)
{
    ridge_lines lines;
    each_ridge(plan, lines);
    CHECK_FALSE(lines.all.empty());
    std::size_t off = 0;
    for (const auto& line : lines.all)
        for (const vec3 p : line) {
            bool found = false;
            for (const auto& v : m.vertices)
                found = found || (std::fabs(v.place.x - p.x) < 1e-6f && std::fabs(v.place.y - p.y) < 1e-6f &&
                                  std::fabs(v.place.z - p.z) < 1e-6f);
            off += !found;
        }
    return off;
}

}  // namespace

TEST_CASE("carved letters refuse depths in output units", "[text][carved]")
{
    test::toy_font font;
    text_mesher mesher{font, carved{}};
    const auto refused = mesher.plan("o", {.depth_in = depth_unit::output});
    REQUIRE_FALSE(refused);
    CHECK(refused.error() == error::bad_option);
    CHECK(std::string{refused.error().option} == "depth_in");
    text_mesher<one_of<extruded<>, carved>> either{font};
    CHECK(either.plan("o", {.depth_in = depth_unit::output}));
    either.solid() = carved{};
    CHECK(either.plan("o", {.depth_in = depth_unit::output}).error() == error::bad_option);
}

TEST_CASE("carved letters and their ridges come out of caches and teams as they are built alone", "[text][ridges]")
{
    test::toy_font font;
    for (const carved& how :
         {carved{.ridges = true}, carved{.max_depth = 0.02f, .as = carving::cutter, .ridges = true}}) {
        auto mesher = text_mesher{font, how};
        const auto plan = test::required(mesher.plan(test::crossed_word));
        CHECK(plan->report().complete());
        CHECK(plan->report().narrowed == 0);
        const test::lit_mesh expected = test::lawful(*plan);
        ridge_lines lines;
        each_ridge(*plan, lines);
        const auto same_ridges = [&](const auto& other) {
            ridge_lines found;
            each_ridge(other, found);
            REQUIRE(found.all.size() == lines.all.size());
            std::size_t differ = 0;
            for (std::size_t k = 0; k < found.all.size(); ++k)
                differ +=
                    found.all[k].size() != lines.all[k].size() ||
                    std::memcmp(found.all[k].data(), lines.all[k].data(), found.all[k].size() * sizeof(vec3)) != 0;
            return differ == 0;
        };
        glyph_cache cache;
        auto cached = text_mesher{font, how, cached_in{cache, 1}};
        for (int i = 0; i < 2; ++i) {
            const auto again = test::required(cached.plan(test::crossed_word));
            CHECK(test::lawful(*again) == expected);
            CHECK(same_ridges(*again));
        }
        CHECK(cache.statistics().hits >= 5);
        auto unlike = text_mesher{font, carved{.tool_angle = 80.0f, .ridges = true}, cached_in{cache, 1}};
        CHECK_FALSE(test::lawful(*test::required(unlike.plan(test::crossed_word))) == expected);
        test::scrambled_workers pool;
        auto team = test::toy_team(pool);
        const auto shared = test::required(mesher.plan(test::crossed_word, {}, *team));
        CHECK(test::lawful(*shared) == expected);
        CHECK(same_ridges(*shared));
        auto delaunay = text_mesher{font, how, constrained_delaunay{}};
        const auto cut = test::required(delaunay.plan(test::crossed_word));
        CHECK(test::volume_of(test::lawful(*cut)) == Catch::Approx(test::volume_of(expected)).epsilon(1e-5));
    }
}

TEST_CASE("carved letters are merged, cut into chunks, instanced and written in part", "[text][ridges]")
{
    test::toy_font font;
    for (const carving as : {carving::relief, carving::cutter}) {
        auto mesher = text_mesher{font}.with(carved{.tool_angle = 60.0f, .as = as, .ridges = true});
        const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});  // two rings that meet
        const auto joined = test::required(mesher.plan(run, {.merge = true}));
        CHECK(joined->glyphs().size() == 2);
        (void)test::lawful(*joined);
        const auto plan = test::required(mesher.plan(test::crossed_word));
        (void)test::lawful(*plan);
        test::check_pieces(*plan, {65'535, 600, 60});  // all glyphs, one, pieces
    }
}

TEST_CASE("ridges lie on the mesh, in every frame, and of merged letters as well", "[text][ridges]")
{
    test::toy_font font;
    frame godot = right_handed_y_up;
    godot.winding = -1;
    for (const carving as : {carving::relief, carving::cutter})
        for (const float depth : {0.0f, 0.02f})
            for (const frame& f : {right_handed_y_up, left_handed_z_up, godot})
                for (const bool merge : {false, true}) {
                    auto mesher = text_mesher{font}.with(carved{.max_depth = depth, .as = as, .ridges = true});
                    const glyph_run run = test::row_of(1, {0.0, 300.0, 1500.0});
                    const auto plan = test::required(mesher.plan(run, {.frame = f, .merge = merge}));
                    const test::lit_mesh m = test::lawful(*plan, f);
                    CHECK(off_surface(*plan, m) == 0);
                }
}

TEST_CASE("letters of straight strokes have the ridges that they should have", "[text][ridges]")
{
    test::toy_font font;
    const auto lines_of = [&](const char* text, const carved& how) {
        auto mesher = text_mesher{font}.with(how);
        const auto plan = test::required(mesher.plan(text));
        ridge_lines lines;
        each_ridge(*plan, lines);
        return lines;
    };
    const carved groove{.as = carving::groove, .ridges = true};
    // A box of 100 x 500 units: a ridge of 400 units, 50 deep, and one to each corner.
    const ridge_lines box = lines_of("i", groove);
    REQUIRE(box.all.size() == 5);
    float longest = 0.0f;
    std::size_t corners = 0;
    for (const auto& line : box.all) {
        const float size = std::hypot(line.back().x - line[0].x, line.back().y - line[0].y);
        longest = size > longest ? size : longest;
        for (const vec3 p : line) {
            CHECK((p.z == 0.0f || std::fabs(p.z + 0.05f) < 1e-5f));
            corners += p.z == 0.0f;
        }
    }
    CHECK(corners == 4);
    CHECK(longest == Catch::Approx(0.4f).epsilon(1e-4));
    // A floor of 0.02 em: four corners up, and the outline of the floor.
    carved shallow = groove;
    shallow.max_depth = 0.02f;
    const ridge_lines flat_box = lines_of("i", shallow);
    REQUIRE(flat_box.all.size() == 5);
    CHECK(flat_box.all.back().size() == 5);
    for (const vec3 p : flat_box.all.back()) CHECK(p.z == -0.02f);
    // A relief has the same lines, upwards; two letters have them twice; a letter alone has its own.
    carved relief = groove;
    relief.as = carving::relief;
    const ridge_lines up = lines_of("i", relief);
    REQUIRE(up.all.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
        REQUIRE(up.all[k].size() == box.all[k].size());
        for (std::size_t i = 0; i < up.all[k].size(); ++i) {
            CHECK(up.all[k][i].x == box.all[k][i].x);
            CHECK(up.all[k][i].z == -box.all[k][i].z);
        }
    }
    CHECK(lines_of("ii", groove).all.size() == 10);
    CHECK(lines_of("ii", carved{}).all.empty());  // carved::ridges is off
    CHECK(lines_of("", groove).all.empty());
    // A ring has one line, which comes back.
    const ridge_lines ridge = lines_of("o", groove);
    REQUIRE(ridge.all.size() == 1);
    CHECK(ridge.all[0].front().x == ridge.all[0].back().x);
    CHECK(ridge.all[0].front().y == ridge.all[0].back().y);
}

TEST_CASE("the ridges of the letters are those of the text, in order", "[text][ridges]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(carved{.ridges = true});
    const auto plan = test::required(mesher.plan("Eiox"));
    ridge_lines all, one_by_one;
    each_ridge(*plan, all);
    for (std::size_t i = 0; i < plan->glyphs().size(); ++i) each_ridge(*plan, i, one_by_one);
    REQUIRE(all.all.size() == one_by_one.all.size());
    CHECK(all.all.size() > 20);
    std::size_t differ = 0;
    for (std::size_t k = 0; k < all.all.size(); ++k) {
        differ += all.all[k].size() != one_by_one.all[k].size();
        differ += all.all[k][0].x != one_by_one.all[k][0].x;
    }
    CHECK(differ == 0);
}

TEST_CASE("after warm-up a carved text and its ridges ask nobody for memory", "[text][ridges]")
{
    test::toy_font font;
    test::counting_memory memory;
    glyph_cache<> cache{std::size_t{1} << 20, memory.source()};
    const auto asked_by = [&](auto mesher) {
        std::size_t before = 0, found = 0;
        for (int i = 0; i < 5; ++i) {
            if (i == 3) before = memory.requests;
            auto plan = mesher.plan("oEi x\noE", {.merge = i % 2 == 0});
            REQUIRE(plan);
            counted_ridges lines;
            each_ridge(*plan, lines);
            found += lines.points;
        }
        const std::size_t asked = memory.requests - before;
        CHECK(found > 100);
        return asked;
    };
    const carved how{.max_depth = 0.03f, .ridges = true};
    CHECK(asked_by(text_mesher{font, how, memory.source()}) == 0);
    CHECK(asked_by(text_mesher{font, how, cached_in{cache, 1}, memory.source()}) == 0);
}

TEST_CASE("a carved text too large for floats is refused by the name of its depth", "[text][ridges]")
{
    test::toy_font font;
    auto mesher = text_mesher{font}.with(carved{.max_depth = 3e38f});
    const auto plan = mesher.plan("i", {.size = 100.0});
    REQUIRE_FALSE(plan);
    CHECK(plan.error() == error::bad_option);
    CHECK(std::string{plan.error().option} == "max_depth");
}
