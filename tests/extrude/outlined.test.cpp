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
    s.push_back(shapes::star());
    for (auto& one : s) one.loops.tolerance = 100.0;
    return s;
}

using edge = std::array<std::int32_t, 4>;  // from x, y to x, y

std::multiset<edge> edges_of(const solid& s)
{
    std::multiset<edge> all;
    for (std::size_t k = 0; k + 1 < s.starts.size(); ++k)
        for (std::uint32_t i = s.starts[k]; i < s.starts[k + 1]; ++i) {
            const grid_point a = s.points[i], b = s.points[i + 1 == s.starts[k + 1] ? s.starts[k] : i + 1];
            all.insert({a.x, a.y, b.x, b.y});
        }
    return all;
}

/// Twice the area, in cells: exact.
std::int64_t area_of(const solid& s)
{
    std::int64_t twice = 0;
    for (const auto& [ax, ay, bx, by] : edges_of(s)) twice += std::int64_t{ax} * by - std::int64_t{ay} * bx;
    return twice;
}

/// The letter whose edges have moved, as emboldened has it.
std::int64_t area_moved(const shapes::shape& s, double by)
{
    const auto m = capped(s, test::emboldened<>{.by = static_cast<float>(by)});
    return area_of(m.data.read());
}

}  // namespace

TEST_CASE("hollow letters of every extruder are closed and lit from outside, with and without the letter", "[outlined]")
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

TEST_CASE("ring and letter together have the area of the letter grown to the ring's edge, to the cell", "[outlined]")
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
                auto of_ring = edges_of(view.ring);
                for (const auto& [ax, ay, bx, by] : edges_of(view.letter)) {
                    const edge turned{bx, by, ax, ay};
                    REQUIRE(of_ring.count(turned) == 1);
                    of_ring.erase(turned);
                }
                CHECK(of_ring.size() + view.letter.points.size() == view.ring.points.size());
            }
}

TEST_CASE("a ring fills strokes that are thinner than the ring on both sides", "[outlined]")
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
        for (const auto& v : vertices_of(m, own)) {
            CHECK(v.part == own);
            CHECK(std::abs(v.position.z) == Approx(half));
        }
        for (const auto& t : triangles_of(m, own))
            for (const std::uint32_t corner : t) {
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
            const filled_outline how{.width = 0.03f, .ring = {.texture = texture}, .letter = {.texture = texture}};
            check_laws(capped(shapes::letter_d(8), how, with_box_texture(in_em(f))), f);
        }
}

TEST_CASE("outlined refuses options out of range by name, both its own and the other extruders'", "[outlined]")
{
    const float infinite = std::numeric_limits<float>::infinity(), nowhere = std::numeric_limits<float>::quiet_NaN();
    for (const float v : {infinite, -infinite, nowhere, -0.01f, 0.0f})
        check_refused("outlined::width", outlined<>{.width = v});
    for (const float v : {infinite, nowhere, 0.5f, -1.0f})
        check_refused("outlined::mitre_limit", outlined<>{.mitre_limit = v});
    check_refused("depth", outlined<>{.ring = {.depth = 0.0f}});
    check_refused("depth", filled_outline{.letter = {.depth = -1.0f}});
    using nested = test::emboldened<outlined<bevelled>>;
    check_refused("embolden::mitre_limit", nested{.mitre_limit = 0.5f});
    check_refused("outlined::mitre_limit", nested{.solid = {.mitre_limit = 0.5f}});
    check_refused("mitre_limit", nested{.solid = {.ring = {.mitre_limit = 0.5f}}});
    check_refused("outlined::width", nested{.solid = {.width = -1.0f}});
    check_refused("width", nested{.solid = {.ring = {.width = -1.0f}}});

    for (const float width : {5e-6f, 600.0f}) check_refused_size("outlined::width", outlined<>{.width = width});
    check_refused_size("outlined::width", outlined<>{.width = 12e-6f, .place = outline_place::centre});
    capped_mesh<outlined<>> m;
    CHECK(build_capped(shapes::rectangle(), outlined<>{.width = 500.0f, .place = outline_place::outer}, m) ==
          error::outline_beyond_grid);
    check_unknown_em<outlined<>>();
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
    check_different_keys(plain, others);
}

TEST_CASE("an empty region has an empty outline, and a lack of memory is reported", "[outlined]")
{
    check_empty_region(filled_outline{});
    for (const outline_place place : places) check_scarce_memory(filled_outline{.place = place}, 120);
}

TEST_CASE("a hollow letter can be planned in the memory of the last one", "[outlined]")
{
    check_planned_anew(filled_outline{});
}

TEST_CASE("a ring is half as wide if its new edges are refused, and the plan reports it", "[outlined]")
{
    check_refused_edges(filled_outline{.width = 0.01f}, filled_outline{.width = 0.02f});
}
