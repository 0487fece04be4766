// SPDX-License-Identifier: MIT

// Carved solids of shapes built by hand: closed, as high as they are far from the outline, and turned right.

#include <typemesh/extrude/carved.hpp>

#include "capped.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/ridge_laws.hpp"

#include <typemesh/discretise/certified.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/svg_path.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace typemesh;
using namespace meshes;

static_assert(extruder<carved> && capping_extruder<carved> && cacheable_policy<carved>);
static_assert(has_heights<carved> && has_front_triangles<carved> && has_hard_edges<carved>);
static_assert(part_count_of<carved> == 5 && !refitting_extruder<carved>);

namespace {

constexpr double cells_per_em = 512000.0;

/// Sets the tolerance of the round joins: 1/800 em, as for a text.
shapes::shape with_tolerance(shapes::shape&& s)
{
    s.loops.tolerance = cells_per_em / 800.0;
    return std::move(s);
}

/// A square of 600 units around (300, 300).
shapes::shape carved_square() { return {"square", {shapes::polygon({{0, 0}, {600, 0}, {600, 600}, {0, 600}})}}; }
/// A cross of strokes 200 wide, with four reflex corners.
shapes::shape carved_cross()
{
    return {"cross",
            {shapes::polygon({{200, 0},
                              {400, 0},
                              {400, 200},
                              {600, 200},
                              {600, 400},
                              {400, 400},
                              {400, 600},
                              {200, 600},
                              {200, 400},
                              {0, 400},
                              {0, 200},
                              {200, 200}})}};
}
std::vector<shapes::shape> carved_shapes()
{
    auto all = shapes::several(carved_square(), carved_cross(), shapes::rectangle(), shapes::letter_e(),
                               shapes::ring(8), shapes::letter_d(8));
    for (auto& s : all) s.loops.tolerance = cells_per_em / 800.0;
    return all;
}

double slope_of(const carved& how) { return 1.0 / std::tan(double(how.tool_angle) * 3.14159265358979323846 / 360.0); }

}  // namespace

TEST_CASE("carved solids are closed and as large as their slopes make them", "[extrude][carved]")
{
    for (const carving as : {carving::relief, carving::cutter})
        for (const auto& s : carved_shapes())
            for (const float angle : {30.0f, 60.0f, 90.0f, 150.0f})
                for (const float depth : {0.0f, 0.03f}) {
                    INFO(s.name << ", " << angle << " degrees, " << depth << " em deep, as " << int(as));
                    check_laws(capped(s, carved{.tool_angle = angle, .max_depth = depth, .as = as}));
                }
    // A pyramid over a square of 0.6 em: its height is 0.3 em times the slope.
    for (const float angle : {45.0f, 90.0f, 120.0f}) {
        const carved how{.tool_angle = angle};
        const double height = 0.3 * slope_of(how);
        CHECK(volume_of(capped(carved_square(), how)) == Catch::Approx(0.36 * height / 3.0).epsilon(1e-4));
        // A frustum where the floor ends it: all but the top third.
        const carved flat_top{.tool_angle = angle, .max_depth = static_cast<float>(2.0 / 3.0 * height)};
        CHECK(volume_of(capped(carved_square(), flat_top)) ==
              Catch::Approx(0.36 * height / 3.0 * (1.0 - 1.0 / 27.0)).epsilon(1e-4));
    }
}

TEST_CASE("a carved surface is as deep as it is far from the outline", "[extrude][carved]")
{
    double above = 0.0, below = 0.0;
    std::size_t floors = 0;
    for (const carving as : {carving::relief, carving::groove, carving::cutter})
        for (const auto& s : carved_shapes())
            for (const float angle : {30.0f, 90.0f, 150.0f})
                for (const float depth : {0.0f, 0.02f}) {
                    const carved how{.tool_angle = angle, .max_depth = depth, .as = as};
                    const auto m = capped(s, how);
                    const region r = s.made();
                    const test::plain_outline outline{r};
                    const double slope = slope_of(how), tolerance = s.loops.tolerance;
                    const part slopes = as == carving::cutter ? part::back_bevel : part::front_bevel;
                    REQUIRE(m.sizes().triangles[slopes] != 0);
                    for (const auto& t : triangles_of(m, slopes)) {
                        double x = 0.0, y = 0.0, z = 0.0;
                        for (const std::uint32_t i : t) {
                            x += double(m.vertices[i].position.x) / 3.0;
                            y += double(m.vertices[i].position.y) / 3.0;
                            z += double(m.vertices[i].position.z) / 3.0;
                        }
                        const double away = outline.distance(x * cells_per_em, y * cells_per_em);
                        const double off = std::fabs(z) / slope * cells_per_em - away;
                        above = (std::max)(above, off);
                        below = (std::max)(below, -off - tolerance);
                        CHECK((as == carving::relief) == (z > 0.0));
                    }
                    const part floor = as == carving::cutter ? part::back : part::front;
                    floors += m.sizes().triangles[floor] != 0;
                    for (const auto& v : vertices_of(m, floor)) {
                        CHECK(std::fabs(v.position.z) == depth);  // exactly
                        CHECK(v.normal.z == (as == carving::cutter ? -1.0f : 1.0f));
                    }
                }
    CAPTURE(above, below);
    CHECK(above < 1.5);
    CHECK(below <= 0.0);
    CHECK(floors > 20);
}

TEST_CASE("a groove is the cutter's surface without its lid, seen from its other side, and the relief's mirror image",
          "[extrude][carved]")
{
    for (const auto& s : carved_shapes())
        for (const float depth : {0.0f, 0.03f}) {
            INFO(s.name << ", " << depth << " em deep");
            const auto groove = capped(s, carved{.max_depth = depth, .as = carving::groove}),
                       cutter = capped(s, carved{.max_depth = depth, .as = carving::cutter}),
                       relief = capped(s, carved{.max_depth = depth});
            CHECK(groove.sizes().triangles[part::back] == 0);
            CHECK(groove.sizes().triangles[part::side] == 0);
            CHECK(groove.sizes().triangles[part::back_bevel] == 0);
            CHECK(open_edges(groove) == s.points());  // its outline
            const auto compare = [&](part of_groove, part of_other, const auto& other, float z, bool turned) {
                const auto mine = vertices_of(groove, of_groove), theirs = vertices_of(other, of_other);
                REQUIRE(mine.size() == theirs.size());
                std::size_t differ = 0;
                for (std::size_t i = 0; i < mine.size(); ++i) {
                    const auto &a = mine[i], &b = theirs[i];
                    const float n = turned ? -1.0f : 1.0f;
                    differ += a.position.x != b.position.x || a.position.y != b.position.y ||
                              std::fabs(a.position.z - z * b.position.z) > 1e-7f;
                    differ += std::fabs(a.normal.z - n * b.normal.z) > 1e-6f ||
                              std::fabs(a.normal.x + b.normal.x) > 1e-6f || std::fabs(a.normal.y + b.normal.y) > 1e-6f;
                }
                CHECK(differ == 0);
                const auto own = triangles_of(groove, of_groove), others = triangles_of(other, of_other);
                REQUIRE(own.size() == others.size());
                const std::uint32_t base = groove.sizes().starts().vertices[of_groove],
                                    other_base = other.sizes().starts().vertices[of_other];
                std::size_t unlike = 0;
                for (std::size_t i = 0; i < own.size(); ++i) {
                    const std::uint32_t first = turned ? 2 : 1, second = turned ? 1 : 2;
                    unlike += own[i][0] - base != others[i][0] - other_base ||
                              own[i][1] - base != others[i][first] - other_base ||
                              own[i][2] - base != others[i][second] - other_base;
                }
                CHECK(unlike == 0);
            };
            compare(part::front_bevel, part::back_bevel, cutter, 1.0f, true);
            compare(part::front, part::back, cutter, 1.0f, true);
            compare(part::front_bevel, part::front_bevel, relief, -1.0f, false);
            std::size_t seen = 0;
            each_seen_from_front(carved{.max_depth = depth, .as = carving::groove}, form_of<carved>(s, groove.data),
                                 [&](grid_point, grid_point, grid_point) { ++seen; });
            CHECK(seen == groove.triangles.size());
            // All of it faces up.
            for (const part p : {part::front, part::front_bevel})
                for (const auto& v : vertices_of(groove, p)) CHECK(v.normal.z > 0.0f);
            const auto indices = indices_of(groove);
            const auto normals = check_normals(
                inspect::mesh_view{groove.vertices, indices}, [](const auto& v) { return v.normal; }, 1, 2e-6);
            CHECK(normals.is_right());
        }
}

TEST_CASE("the heights of a carved solid are what it has, and end at z = 0", "[extrude][carved]")
{
    for (const carving as : {carving::relief, carving::groove, carving::cutter})
        for (const float depth : {0.0f, 0.03f, 7.0f}) {
            const carved how{.tool_angle = 60.0f, .max_depth = depth, .as = as};
            const auto s = carved_cross();
            const auto m = capped(s, how);
            const height_range all = how.heights(), own = how.heights(form_of<carved>(s, m.data));
            CHECK(all.low <= own.low);
            CHECK(own.high <= all.high);
            double low = 1e300, high = -1e300;
            for (const auto& v : m.vertices) {
                low = (std::min)(low, double(v.position.z));
                high = (std::max)(high, double(v.position.z));
            }
            CHECK(low == Catch::Approx(own.low).margin(1e-6));
            CHECK(high == Catch::Approx(own.high).margin(1e-6));
            CHECK((as == carving::relief ? low : high) == 0.0);
        }
}

TEST_CASE(
    "the ridges of a carved shape are its own, its floor's outlines come last, and without the option none are kept",
    "[extrude][carved]")
{
    for (const auto& s : carved_shapes())
        for (const float depth : {0.0f, 0.03f}) {
            INFO(s.name << ", " << depth << " em deep");
            const auto made = plan_solid_of(s, carved{.max_depth = depth, .ridges = true});
            auto data = made.data.read();
            const auto all = data.own.of<ridge_point>();
            const double floor = depth > 0.0f ? double(data.own.of<carved_depth>()[0].reach) : 0.0;
            const test::ridge_laws laws{s.made(), all, s.loops.tolerance, floor};
            CHECK(laws.broken() == "");
            CHECK(laws.valleys == 0);
            CHECK(laws.too_deep < 1.5);
            const auto is_floor = [](const ridge_point& p) { return p.step == ridge_step::floor; };
            const auto first = std::find_if(all.begin(), all.end(), is_floor);
            CHECK((first != all.end()) == (depth > 0.0f));
            CHECK(std::none_of(first, all.end(), [](const ridge_point& p) { return p.step == ridge_step::begins; }));
            for (const ridge_point& p : all)
                if (p.distance >= data.own.of<carved_depth>()[0].reach)
                    CHECK(data.own.of<carved_depth>()[0].height_at(p.distance) == double(depth));
            CHECK(plan_solid_of(s, carved{.max_depth = depth}).data.read().own.of<ridge_point>().empty());
        }
    // Four corners; with a crease angle beyond them, nothing but the middle.
    const auto count = [](float crease) {
        const auto made = plan_solid_of(carved_square(), carved{.ridges = true, .crease_degrees = crease});
        return made.data.read().own.of<ridge_point>().size();
    };
    CHECK(count(15.0f) == 8);
    CHECK(count(89.0f) == 8);
    CHECK(count(91.0f) == 1);
}

TEST_CASE("low walls of carved slopes that end sooner are as high as those of others", "[extrude][carved]")
{
    svg_path drawing{
        "M300 400L600 400L600 100L300 100ZM500 400C500 510.45695 455.228475 600 400 600C344.771525 600 300 510.45695 "
        "300 400C300 289.54305 344.771525 200 400 200C455.228475 200 500 289.54305 500 400Z",
        1000.0};
    outline drawn;
    outline_recorder pen{drawn};
    REQUIRE_FALSE(drawing.outline(0, pen));
    REQUIRE_FALSE(pen.finish());
    const auto fitting = grid::fitting(1000.0, drawn.bounds);
    REQUIRE(fitting);
    no_observer nobody;
    const cap_settings settings{.corners = touching::part};
    const cap_policies policies{certified{}, monotone{}, nobody};
    const double em = 1000.0 * fitting->cells;
    for (const int refusals : {0, 1, 3}) {
        cap_builder caps, further;
        corner_parting parting;
        const auto built = caps.build(drawn, 1.25, *fitting, settings, policies);
        REQUIRE(built);
        const auto filled = caps.part(*built, drawn.curves, settings, policies, parting);
        REQUIRE(filled);
        region_caps maker{caps, further, monotone{}};
        refusing_caps<decltype(maker)> refusing{maker, refusals};
        const carved how{.max_depth = 0.05f};
        carved_data data;
        const auto plan = plan_solid(how, *filled, data, refusing);
        REQUIRE(plan);
        CHECK(plan->narrowed == (refusals != 0));
        const carved_depth& reached = data.own.of<carved_depth>()[0];
        CHECK(as_double(reached.depth) == Approx(std::ldexp(0.05, -refusals)));
        CHECK(as_double(data.bevel.of<bevel_rims>()[0].wall) * as_double(reached.depth) * em == Approx(4.0));
    }
}

TEST_CASE("carved options are refused by name, and have keys", "[extrude][carved]")
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    for (const float angle : {0.0f, 0.99f, 179.1f, 180.0f, -60.0f, nan, infinite})
        check_refused("tool_angle", carved{.tool_angle = angle});
    for (const float depth : {-0.01f, nan, infinite}) check_refused("max_depth", carved{.max_depth = depth});
    for (const float crease : {-1.0f, 180.5f, nan}) check_refused("crease_degrees", carved{.crease_degrees = crease});
    CHECK(std::string{heights_name_of(carved{})} == "max_depth");
    check_unknown_em<carved>();
    check_empty_region(carved{});
    const carved plain,
        others[] = {
            {.tool_angle = 60.0f}, {.max_depth = 0.1f},       {.as = carving::groove},          {.as = carving::cutter},
            {.ridges = true},      {.crease_degrees = 20.0f}, {.texture = texture_mapping::box}};
    for (const carved& other : others) CHECK_FALSE(other.cache_key() == plain.cache_key());
    CHECK(carved{}.cache_key() == plain.cache_key());
}

TEST_CASE("slopes shallower than four cells rise as well", "[extrude][carved]")
{
    for (const float depth : {1e-6f, 7e-6f, 9e-6f}) {  // 0.5 to 4.6 cells
        CAPTURE(depth);
        const carved how{.tool_angle = 179.0f, .max_depth = depth};
        const auto m = capped(carved_square(), how);
        CHECK(open_edges(m) == 0);
        const double width = double(depth) / slope_of(how), inner = 0.6 - 2.0 * width;
        CHECK(volume_of(m) ==
              Catch::Approx(double(depth) / 3.0 * (0.36 + inner * inner + 0.6 * inner)).epsilon(0.1 * width));
        std::size_t low = 0;
        for (const auto& v : vertices_of(m, part::front_bevel)) low += !(v.position.z > 0.0f);
        CHECK(low >= 4);
    }
}

TEST_CASE("a carved solid at the limits of its options is still closed", "[extrude][carved]")
{
    for (const float angle : {1.0f, 179.0f})
        for (const float depth : {0.0f, 1e-6f, 1e-3f, 1000.0f})
            for (const carving as : {carving::relief, carving::cutter}) {
                INFO(angle << " degrees, " << depth << " em deep, as " << int(as));
                const auto m = capped(with_tolerance(carved_cross()), carved{angle, depth, as, true});
                CHECK(open_edges(m) == 0);
                CHECK(volume_of(m) > 0.0);
            }
}

TEST_CASE("a carved solid without memory says so, and asks for none once it is warm", "[extrude][carved]")
{
    const carved how{.max_depth = 0.03f, .ridges = true};
    check_scarce_memory(how, 200);
    check_planned_anew(how);
    const auto s = with_tolerance(shapes::letter_e());
    caps_by<> caps{s.made()};
    auto maker = caps.maker();
    test::counting_memory memory;
    carved_data data{memory.source()};
    std::size_t warm = 0;
    for (int i = 0; i < 4; ++i) {
        data.clear();
        REQUIRE(plan_solid(how, s.made(), data, maker));
        if (i == 1) warm = memory.requests;
    }
    CHECK(memory.requests == warm);
}

TEST_CASE("the bytes of a carved plan are read back as they were", "[extrude][carved]")
{
    const auto made = plan_solid_of(carved_cross(), carved{.max_depth = 0.03f, .ridges = true});
    std::vector<std::uint64_t> block(made.data.bytes() / 8);
    made.data.copy_to(reinterpret_cast<std::byte*>(block.data()));
    const auto there = carved_data::read_from(reinterpret_cast<const std::byte*>(block.data())),
               here = made.data.read();
    REQUIRE(there.own.of<ridge_point>().size() == here.own.of<ridge_point>().size());
    for (std::size_t i = 0; i < here.own.of<ridge_point>().size(); ++i) {
        CHECK(there.own.of<ridge_point>()[i].at == here.own.of<ridge_point>()[i].at);
        CHECK(there.own.of<ridge_point>()[i].step == here.own.of<ridge_point>()[i].step);
    }
    CHECK(there.own.of<carved_depth>()[0].depth == here.own.of<carved_depth>()[0].depth);
    CHECK(there.bevel.of<bevel_vertex>().size() == here.bevel.of<bevel_vertex>().size());
}

TEST_CASE("carved solids stay within their heights, to the last bit, at every size", "[extrude][carved]")
{
    for (const carving as : {carving::relief, carving::groove, carving::cutter})
        for (const auto& s : carved_shapes())
            for (const float depth : {0.0f, 0.031f})
                for (const double unit : {1.0, 24.0, 0.3, 1.0 / 7.0}) {
                    INFO(s.name << ", " << depth << " em deep, as " << int(as) << ", em of " << unit);
                    const carved how{.tool_angle = 77.0f, .max_depth = depth, .as = as};
                    placement at = in_em();
                    at.unit_per_cell *= unit;
                    at.unit_per_depth = unit;
                    const auto m = capped(s, how, at);
                    const height_range own = how.heights(form_of<carved>(s, m.data));
                    float low = HUGE_VALF, high = -HUGE_VALF;
                    for (const auto& v : m.vertices) {
                        low = (std::min)(low, v.position.z);
                        high = (std::max)(high, v.position.z);
                    }
                    CHECK(low == at.height(own.low));
                    CHECK(high == at.height(own.high));
                }
}
