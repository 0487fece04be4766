// SPDX-License-Identifier: MIT

#include <typemesh/extrude/outlined.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/flat.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

#include "capped.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/emboldened.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

using filled_outline = outlined<extruded<>, extruded<>>;

static_assert(extruder<outlined<>> && capping_extruder<outlined<>> && has_hard_edges<outlined<>>);
static_assert(part_count_of<outlined<>> == 3 && part_count_of<filled_outline> == 6);
static_assert(part_count_of<outlined<bevelled, extruded<>>> == 8 && part_count_of<outlined<flat, flat>> == 6);
static_assert(has_hard_edges<filled_outline> && !has_hard_edges<outlined<extruded<>, flat>>);
static_assert(extruder<test::emboldened<filled_outline>>);

constexpr outline_place places[] = {outline_place::inner, outline_place::centre, outline_place::outer};

std::vector<shapes::shape> all_shapes()
{
    auto s = shapes::all();
    s.push_back(
        {"star",
         {shapes::polygon({{0, 0}, {250, 100}, {500, 0}, {400, 250}, {500, 500}, {250, 400}, {0, 500}, {100, 250}})}});
    for (auto& one : s) one.loops.tolerance = 100.0;
    return s;
}

/// Twice the area, in cells: exact.
std::int64_t area_of(const solid& s)
{
    std::int64_t twice = 0;
    for (std::size_t k = 0; k + 1 < s.starts.size(); ++k)
        for (std::uint32_t i = s.starts[k]; i < s.starts[k + 1]; ++i) {
            const grid_point a = s.points[i], b = s.points[i + 1 == s.starts[k + 1] ? s.starts[k] : i + 1];
            twice += std::int64_t{a.x} * b.y - std::int64_t{a.y} * b.x;
        }
    return twice;
}

std::multiset<std::array<std::int32_t, 4>> edges_of(const solid& s, bool reversed)
{
    std::multiset<std::array<std::int32_t, 4>> all;
    for (std::size_t k = 0; k + 1 < s.starts.size(); ++k)
        for (std::uint32_t i = s.starts[k]; i < s.starts[k + 1]; ++i) {
            const grid_point a = s.points[i], b = s.points[i + 1 == s.starts[k + 1] ? s.starts[k] : i + 1];
            if (reversed)
                all.insert({b.x, b.y, a.x, a.y});
            else
                all.insert({a.x, a.y, b.x, b.y});
        }
    return all;
}

/// The letter whose edges have moved, as emboldened has it.
std::int64_t area_moved(const shapes::shape& s, double by)
{
    const auto m = capped(s, test::emboldened<>{.by = static_cast<float>(by)});
    return area_of(m.data.read());
}

}  // namespace

TEST_CASE("hollow letters are closed and lit from outside, with and without the letter, whatever makes them",
          "[outlined]")
{
    for (const auto& s : all_shapes())
        for (const float width : {0.01f, 0.05f, 0.3f})
            for (const outline_place place : places) {
                INFO(s.name << " width " << width << " place " << int(place));
                check_laws(capped(s, outlined<>{.width = width, .place = place}));
                const auto both = capped(s, filled_outline{.width = width, .place = place});
                check_laws(both);
                CHECK(both.sizes().triangles.of[0] != 0);
                check_laws(capped<constrained_delaunay>(s, filled_outline{.width = width, .place = place}));
                check_laws(capped(
                    s, outlined<bevelled, extruded<>>{.width = width, .place = place, .ring = {.width = 0.004f}}));
                check_laws(capped(
                    s, outlined<extruded<>, bevelled>{.width = width, .place = place, .letter = {.width = 0.01f}}));
            }
}

TEST_CASE("ring and letter together are the letter as far as the ring reaches, to the cell", "[outlined]")
{
    for (const auto& s : all_shapes())
        for (const double width : {0.015625, 0.0625})  // in halves still whole cells
            for (const outline_place place : places) {
                INFO(s.name << " width " << width << " place " << int(place));
                const auto m = capped(s, filled_outline{.width = static_cast<float>(width), .place = place});
                const auto view = m.data.read();
                const double around = place == outline_place::outer ? 1.0 : place == outline_place::centre ? 0.5 : 0.0;
                CHECK(area_of(view.ring) + area_of(view.letter) == area_moved(s, around * width));
                const bool is_left = !view.letter.points.empty();
                if (is_left) CHECK(area_of(view.letter) == area_moved(s, (around - 1.0) * width));
                // The letter's edges are edges of the ring, which they bound from the other side.
                auto of_ring = edges_of(view.ring, false);
                for (const auto& e : edges_of(view.letter, true)) {
                    REQUIRE(of_ring.count(e) == 1);
                    of_ring.erase(e);
                }
                CHECK(of_ring.size() + view.letter.points.size() == view.ring.points.size());
            }
}

TEST_CASE("a ring fills strokes that are thinner than what is taken off", "[outlined]")
{
    const auto bar = shapes::rectangle();  // 0.4 em wide
    const auto m = capped(bar, filled_outline{.width = 0.25f});
    CHECK(m.data.read().letter.points.empty());
    for (std::size_t p = 3; p < 6; ++p) CHECK(m.sizes().vertices.of[p] == 0);
    CHECK(volume_of(m) == Approx(0.2 * 0.4 * 0.7));
    const auto hollow = capped(bar, outlined<>{.width = 0.1f});
    CHECK(volume_of(hollow) == Approx(0.2 * (0.4 * 0.7 - 0.2 * 0.5)));
    CHECK(hollow.data.read().letter.points.empty());  // nothing is kept of what is not drawn
    CHECK(volume_of(capped(bar, outlined<>{.width = 0.1f, .place = outline_place::outer})) ==
          Approx(0.2 * (0.6 * 0.9 - 0.4 * 0.7)));
    CHECK(volume_of(capped(bar, outlined<>{.width = 0.1f, .place = outline_place::centre})) ==
          Approx(0.2 * (0.5 * 0.8 - 0.3 * 0.6)));
}

TEST_CASE("ring and letter have parts and heights of their own", "[outlined]")
{
    const outlined<extruded<>, extruded<>> how{
        .width = 0.02f, .ring = {.depth = 0.3f, .centred = true}, .letter = {.depth = 0.1f, .centred = true}};
    const auto m = capped(shapes::letter_d(8), how);
    const part_sizes first = m.sizes().starts();
    for (std::size_t p = 0; p < 6; ++p) {
        const part own = all_parts[p];
        REQUIRE(m.sizes().vertices[own] != 0);
        const float half = p < 3 ? 0.15f : 0.05f;
        for (std::uint32_t i = 0; i < m.sizes().vertices[own]; ++i) {
            const auto& v = m.vertices[first.vertices[own] + i];
            CHECK(v.part == own);
            CHECK(std::abs(v.position.z) == Approx(half));
        }
        for (std::uint32_t t = 0; t < m.sizes().triangles[own]; ++t)
            for (const std::uint32_t corner : m.triangles[first.triangles[own] + t]) {
                CHECK(corner >= first.vertices[own]);
                CHECK(corner < first.vertices[own] + m.sizes().vertices[own]);
            }
    }
    CHECK(how.heights().low == Approx(-0.15));
    CHECK(how.heights().high == Approx(0.15));
    CHECK(outlined<>{.ring = {.centred = true}}.heights().low == Approx(-0.1));
    CHECK((outlined<extruded<>, extruded<>>{.letter = {.depth = 0.5f}}.heights().low) == Approx(-0.5));
    CHECK(m.plan.around.low.x == Approx(0.0));
    CHECK(capped(shapes::rectangle(), outlined<>{.width = 0.03f, .place = outline_place::outer}).plan.around.high.x ==
          Approx(0.53 * 512000.0).margin(2.0));
}

TEST_CASE("hollow letters obey their laws in every frame", "[outlined]")
{
    for (const frame& f : frames())
        for (const auto texture : texture_mappings) {
            placement at = in_em(f);
            at.texture_per_cell = {1.0 / 512000.0, 1.0 / 512000.0};
            check_laws(
                capped(shapes::letter_d(8),
                       filled_outline{.width = 0.03f, .ring = {.texture = texture}, .letter = {.texture = texture}},
                       at),
                f);
        }
}

TEST_CASE("outlined refuses options out of range by their names, its own and the other extruders'", "[outlined]")
{
    const float infinite = std::numeric_limits<float>::infinity(), nowhere = std::numeric_limits<float>::quiet_NaN();
    const auto check = [](const char* name, const auto& how) {
        INFO(name);
        capped_mesh<std::remove_cvref_t<decltype(how)>> m;
        const error refusals[] = {refused_options(how), build_capped(shapes::rectangle(), how, m)};
        for (const error& e : refusals) {
            CHECK(e == error::bad_option);
            REQUIRE(e.option != nullptr);
            CHECK(std::string{e.option} == name);
        }
    };
    for (const float v : {infinite, -infinite, nowhere, -0.01f, 0.0f}) check("outlined::width", outlined<>{.width = v});
    for (const float v : {infinite, nowhere, 0.5f, -1.0f}) check("outlined::mitre_limit", outlined<>{.mitre_limit = v});
    check("depth", outlined<>{.ring = {.depth = 0.0f}});
    check("depth", filled_outline{.letter = {.depth = -1.0f}});
    using nested = test::emboldened<outlined<bevelled>>;
    check("embolden::mitre_limit", nested{.mitre_limit = 0.5f});
    check("outlined::mitre_limit", nested{.solid = {.mitre_limit = 0.5f}});
    check("mitre_limit", nested{.solid = {.ring = {.mitre_limit = 0.5f}}});
    check("outlined::width", nested{.solid = {.width = -1.0f}});
    check("width", nested{.solid = {.ring = {.width = -1.0f}}});

    capped_mesh<outlined<>> m;
    for (const float width : {5e-6f, 600.0f})
        CHECK(std::string{build_capped(shapes::rectangle(), outlined<>{.width = width}, m).option} ==
              "outlined::width");
    CHECK(std::string{build_capped(shapes::rectangle(), outlined<>{.width = 12e-6f, .place = outline_place::centre}, m)
                          .option} == "outlined::width");
    CHECK(build_capped(shapes::rectangle(), outlined<>{.width = 500.0f, .place = outline_place::outer}, m) ==
          error::outline_beyond_grid);
    shapes::shape unknown = shapes::rectangle();
    unknown.loops.grid.units_per_em = 0.0;
    CHECK(std::string{build_capped(unknown, outlined<>{}, m).option} == "units_per_em");
}

TEST_CASE("hollow letters that differ have different keys", "[outlined]")
{
    const filled_outline plain;
    std::vector<filled_outline> others(7, plain);
    others[0].width = 0.03f;
    others[1].place = outline_place::centre;
    others[2].place = outline_place::outer;
    others[3].mitre_limit = 2.0f;
    others[4].joins = bevel_joins::bevelled;
    others[5].ring.side = false;
    others[6].letter.side = false;
    for (std::size_t i = 0; i < others.size(); ++i) {
        INFO(i);
        CHECK_FALSE(others[i].cache_key() == plain.cache_key());
        for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(others[i].cache_key() == others[k].cache_key());
    }
}

TEST_CASE("an empty region is outlined to nothing, and memory that runs out is reported", "[outlined]")
{
    plan_data_of<filled_outline> data;
    no_caps nothing;
    const auto empty = plan_solid(filled_outline{}, region{}, data, nothing);
    REQUIRE(empty);
    CHECK(empty->sizes.total() == mesh_size{});

    const auto s = shapes::letter_d(8);
    for (const outline_place place : places) {
        bool done = false;
        for (std::size_t allowed = 0; !done && allowed < 200; ++allowed) {
            test::counting_memory memory;
            memory.fail_at = allowed + 1;
            plan_data_of<filled_outline> scarce{memory.source()};
            caps_by<> caps{s.made()};
            auto maker = caps.maker();
            const auto plan = plan_solid(filled_outline{.place = place}, s.made(), scarce, maker);
            done = static_cast<bool>(plan);
            if (!done) CHECK(plan.error() == error::out_of_memory);
            CHECK((done || allowed < 120));
        }
        CHECK(done);
    }
}

TEST_CASE("a hollow letter is planned anew into the memory of the last one", "[outlined]")
{
    plan_data_of<filled_outline> data;
    const filled_outline how;
    const auto large = shapes::ring(8), small = shapes::rectangle();
    caps_by<> of_large{large.made()}, of_small{small.made()};
    auto large_caps = of_large.maker();
    auto small_caps = of_small.maker();
    const auto first = plan_solid(how, small.made(), data, small_caps);
    REQUIRE(first);
    data.clear();
    REQUIRE(plan_solid(how, large.made(), data, large_caps));
    data.clear();
    const auto again = plan_solid(how, small.made(), data, small_caps);
    REQUIRE(again);
    CHECK(again->sizes == first->sizes);
}

TEST_CASE("where new edges are not proven, a ring is half as wide, and the plan says so", "[outlined]")
{
    const auto s = shapes::letter_d(8);
    caps_by<> caps{s.made()};
    auto maker = caps.maker();
    const auto narrow = plan_solid_of(s, filled_outline{.width = 0.01f}, maker);
    CHECK_FALSE(narrow.plan.narrowed);
    refusing_caps<decltype(maker)> refusing{maker, 1};
    const auto narrowed = plan_solid_of(s, filled_outline{.width = 0.02f}, refusing);
    CHECK(narrowed.plan.narrowed);
    CHECK(narrowed.plan.sizes == narrow.plan.sizes);
    CHECK(narrowed.plan.around.low == narrow.plan.around.low);
    refusing.refusals = 1000;
    plan_data_of<filled_outline> data;
    CHECK(plan_solid(filled_outline{}, s.made(), data, refusing).error() == error::edges_not_moved);
}
