// SPDX-License-Identifier: MIT

#include <typemesh/extrude/embolden.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/inspect/euler_count.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "capped.hpp"
#include "support/catch.hpp"
#include "support/emboldened.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

static_assert(extruder<test::emboldened<>> && capping_extruder<test::emboldened<>> &&
              has_hard_edges<test::emboldened<>>);
static_assert(extruder<test::emboldened<flat>> && !has_hard_edges<test::emboldened<flat>>);
static_assert(part_count_of<test::emboldened<>> == 3 && part_count_of<test::emboldened<bevelled>> == 5);

constexpr double cells_per_em = 512000.0;  // in an em

std::vector<shapes::shape> all_shapes()
{
    auto s = shapes::all();
    s.push_back(shapes::star());
    s.push_back(shapes::ring(16));
    s.push_back(shapes::letter_d(16));
    for (auto& one : s) one.loops.tolerance = 100.0;
    return s;
}

/// How far a point is from the nearest edge, in em; negative inside.
double distance_to(const std::vector<std::vector<point>>& loops, point p)
{
    double nearest = 1e9;
    bool inside = false;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const point a = loop[i], b = loop[(i + 1) % loop.size()], d = b - a;
            const double s = std::clamp(typemesh::dot(p - a, d) / typemesh::dot(d, d), 0.0, 1.0);
            nearest = std::min(nearest, typemesh::length(p - (a + s * d)));
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / d.y * d.x) inside = !inside;
        }
    return inside ? -nearest : nearest;
}

std::vector<std::vector<point>> loops_of(std::span<const grid_point> points, std::span<const std::uint32_t> starts)
{
    std::vector<std::vector<point>> all;
    for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
        all.emplace_back();
        for (std::uint32_t i = starts[k]; i < starts[k + 1]; ++i)
            all.back().push_back({points[i].x / cells_per_em, points[i].y / cells_per_em});
    }
    return all;
}

double area_of(const std::vector<std::vector<point>>& loops)
{
    double area = 0.0;
    for (const auto& loop : loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            area += 0.5 * typemesh::cross(loop[i], loop[(i + 1) % loop.size()]);
    return area;
}

/// The letter's own loops, and the bolder one's.
struct bolder {
    std::vector<std::vector<point>> before, after;
};

template <class E>
bolder bolder_of(const shapes::shape& s, const E& how)
{
    const auto m = capped(s, how);
    const auto view = m.data.read();
    return {loops_of(s.loops.points.view(), s.loops.starts.view()), loops_of(view.points, view.starts)};
}

}  // namespace

TEST_CASE("emboldened solids of every extruder are closed and lit from outside, both bolder and thinner",
          "[emboldened]")
{
    for (const auto& s : all_shapes())
        for (const float by : {0.003f, 0.02f, 0.05f, 0.4f, -0.003f, -0.01f}) {
            INFO(s.name << " by " << by);
            const auto plain = capped(s, test::emboldened<>{.by = by});
            check_laws(plain);
            CHECK(volume_of(plain) ==
                  Approx(0.2 * area_of(loops_of(plain.data.loops.points.view(), plain.data.loops.starts.view())))
                      .epsilon(1e-5));
            check_laws(capped<constrained_delaunay>(s, test::emboldened<>{.by = by}));
            check_laws(capped(s, test::emboldened<extruded<creased_normals>>{.by = by}));
            for (const bool outward : {false, true})
                check_laws(capped(
                    s, test::emboldened<bevelled>{
                           .by = by, .solid = {.width = 0.01f, .outward = outward, .profile = round_profile(3)}}));
        }
}

TEST_CASE("a bolder letter contains all within the distance, and nothing beyond the mitre limit", "[emboldened]")
{
    for (const auto& s : all_shapes())
        for (const float limit : {1.0f, 2.0f, 4.0f})
            for (const float by : {0.02f, 0.05f, -0.01f}) {
                INFO(s.name << " by " << by << ", limit " << limit);
                const bolder loops = bolder_of(s, test::emboldened<>{.by = by, .mitre_limit = limit});
                const double wide = std::abs(double(by)), slack = (100.0 + 3.0) / cells_per_em;
                std::size_t sampled = 0;
                for (double x = -0.2; x < 1.3; x += 0.0342)
                    for (double y = -0.6; y < 1.3; y += 0.0346) {
                        double d = distance_to(loops.before, {x, y});
                        if (by < 0.0f) d = -d;
                        const bool within = (by < 0.0f ? -1.0 : 1.0) * distance_to(loops.after, {x, y}) < 0.0;
                        if (d < wide - slack) REQUIRE(within);
                        if (d > wide * double(limit) + slack) REQUIRE_FALSE(within);
                        ++sampled;
                    }
                CHECK(sampled > 2000);
                for (const auto& loop : loops.after)
                    for (const point p : loop) {
                        const double d = (by < 0.0f ? -1.0 : 1.0) * distance_to(loops.before, p);
                        CHECK(d > wide - slack);
                        CHECK(d < wide * double(limit) * 1.05 + slack);
                    }
            }
}

TEST_CASE("a bolder ring has the area between two circles, and its walls are lit like a circle's", "[emboldened]")
{
    const shapes::shape ring{
        "ring", {shapes::cubic_circle({400, 300}, 300)}, {shapes::cubic_circle({400, 300}, 150)}, 16};
    const double pi = 3.14159265358979;
    for (const float by : {0.05f, 0.02f, -0.03f}) {
        INFO("by " << by);
        const auto m = capped(ring, test::emboldened<>{.by = by});
        const double outer = 0.3 + double(by), inner = 0.15 - double(by);
        CHECK(volume_of(m) == Approx(0.2 * pi * (outer * outer - inner * inner)).epsilon(0.005));
        CHECK(m.sizes().vertices[part::side] == 2 * (m.sizes().vertices[part::front] + 2));  // a seam each
        for (const auto& v : vertices_of(m, part::side)) {
            const point away{double(v.position.x) - 0.4, double(v.position.y) - 0.3};
            const double r = typemesh::length(away), turned = r > 0.225 ? 1.0 : -1.0;
            CHECK(r == Approx(turned > 0.0 ? outer : inner).epsilon(0.003));
            CHECK(turned * (away.x * v.normal.x + away.y * v.normal.y) / r > std::cos(0.4 / 57.3));
        }
    }
}

TEST_CASE("an edge that is cut short is lit like the rest of its curve", "[emboldened]")
{
    const shapes::shape drop = shapes::drop(12);  // thinner, its pointed end is cut short
    const auto m = capped(drop, test::emboldened<>{.by = -0.02f, .solid = {.texture = texture_mapping::box}});
    const curve whole = drop.curves[0];
    for (const auto& v : vertices_of(m, part::side)) {
        const point at{1000.0 * double(v.position.x), 1000.0 * double(v.position.y)};
        double best = -1.0;  // of the curve's normals where it is as near as the letter has moved
        for (int k = 0; k <= 20000; ++k) {
            const double t = k / 20000.0;
            const point along = tangent(whole, t, side_of::before), right{along.y, -along.x};
            if (typemesh::length(whole.at(t) - at) > 22.5) continue;
            best = std::max(best,
                            typemesh::dot(right, {double(v.normal.x), double(v.normal.y)}) / typemesh::length(right));
        }
        CHECK(best > std::cos(4.0 / 57.3));
    }
}

TEST_CASE("a sharp corner that grows becomes round and shades smoothly, and a blunt one stays a corner", "[emboldened]")
{
    shapes::shape spike = shapes::spike();
    spike.loops.tolerance = 20.0;
    for (const auto joins : {bevel_joins::round, bevel_joins::bevelled}) {
        const auto m =
            capped(spike, test::emboldened<>{.by = 0.05f, .joins = joins, .solid = {.texture = texture_mapping::box}});
        check_laws(m);
        std::size_t hard = 0, near = 0;
        const auto arrays = m.data.data.read();
        for (const side_point& p : arrays.of<side_point>()) hard += p.doubled;
        for (const grid_point p : m.data.loops.points)
            near += typemesh::length({p.x / cells_per_em, p.y / cells_per_em}) < 0.08;
        CHECK((joins == bevel_joins::round ? near > 6 : near == 2));
        CHECK(hard == (joins == bevel_joins::round ? 2 : 4));
    }
    CHECK(capped(spike, test::emboldened<>{.by = 0.05f, .mitre_limit = 0.0f}).data.loops.points.size() == 3);
    CHECK(capped(shapes::rectangle(), test::emboldened<>{.by = 0.05f}).data.loops.points.size() == 4);
}

TEST_CASE("narrow counters close in a bolder letter, and thin parts vanish from a thinner one", "[emboldened]")
{
    const auto euler = [](const auto& m) {
        const auto indices = indices_of(m);
        return inspect::count_euler(inspect::mesh_view{m.vertices, indices}).characteristic();
    };
    const shapes::shape ring = shapes::ring(16);
    CHECK(euler(capped(ring, test::emboldened<>{.by = 0.14f})) == 0);
    CHECK(euler(capped(ring, test::emboldened<>{.by = 0.16f})) == 2);
    CHECK(euler(capped(shapes::pair(), test::emboldened<>{.by = -0.03f})) == 2);  // both, the second with a hole: 2 + 0
    const auto pair = capped(shapes::pair(), test::emboldened<>{.by = -0.06f});   // the triangle is gone
    for (const grid_point p : pair.data.loops.points) CHECK(p.x / cells_per_em > 0.4);
    capped_mesh<test::emboldened<>> none;
    CHECK(build_capped(ring, test::emboldened<>{.by = -0.08f}, none) == error::nothing_left);
    CHECK(build_capped(shapes::rectangle(), test::emboldened<>{.by = -0.21f}, none) == error::nothing_left);
}

TEST_CASE("a letter moved by less than four cells stays the same", "[emboldened]")
{
    const auto s = shapes::letter_d(8);
    const auto plain = build(s, extruded<>{});
    for (const float by : {0.0f, 5e-6f, -5e-6f}) check_same_vertices(capped(s, test::emboldened<>{.by = by}), plain);
}

TEST_CASE("loops that touch in a point grow together when bolder, and part when thinner", "[emboldened]")
{
    for (const float by : {0.0f, 0.02f, -0.02f}) {
        INFO("by " << by);
        cap_builder caps, further;
        const shapes::shape two{"two squares",
                                {shapes::polygon({{0, 0}, {200, 0}, {200, 200}, {0, 200}}),
                                 shapes::polygon({{200, 200}, {400, 200}, {400, 400}, {200, 400}})}};
        REQUIRE(append_loops(two.loops, caps.loops()));
        caps.loops().grid = two.loops.grid;
        caps.loops().curves = two.curves;
        const monotone cut;
        const auto touching = caps.fill({}, cut);
        REQUIRE(touching);
        REQUIRE(touching->is_touching());
        region_caps maker{caps, further, cut};
        capped_mesh<test::emboldened<>> m;
        const auto plan = plan_solid(test::emboldened<>{.by = by}, *touching, m.data, maker);
        REQUIRE(plan);
        CHECK_FALSE(plan->narrowed);
        const solid_of<test::emboldened<>> form{{touching->points(), touching->starts(), caps.triangles().view()},
                                                m.data.read()};
        REQUIRE(write_solid<test::emboldened<>>({form, *plan}, test::emboldened<>{.by = by}, in_em(),
                                                static_cast<mesh<everything>&>(m)));
        CHECK(open_edges(m) == 0);
        CHECK(m.data.loops.contour_count() == (by > 0.0f ? 1u : 2u));
        const double side = 0.2 + 2.0 * double(by), shared = by > 0.0f ? 0.04 * 0.04 : 0.0;
        CHECK(volume_of(m) == Approx(0.2 * (2.0 * side * side - shared)));
    }
}

TEST_CASE("an emboldened solid obeys its laws in every frame, and its box contains the growth", "[emboldened]")
{
    for (const frame& f : frames())
        for (const auto texture : {texture_mapping::em, texture_mapping::box}) {
            const test::emboldened<> how{.by = 0.03f, .solid = {.centred = true, .texture = texture}};
            const auto m = capped(shapes::letter_d(8), how, with_box_texture(in_em(f)));
            check_laws(m, f);
            CHECK(m.plan.around.low.x == Approx(-0.03 * cells_per_em).margin(2.0));
            CHECK(m.plan.around.high.y == Approx((0.7 + 0.03) * cells_per_em).margin(2.0));
        }
    CHECK(test::emboldened<>{.solid = {.depth = 0.5f}}.heights().low == -0.5);
}

TEST_CASE("a bolder letter can be made bolder again", "[emboldened]")
{
    const auto s = shapes::ring(16);
    const auto twice = capped(s, test::emboldened<test::emboldened<>>{.by = 0.02f, .solid = {.by = 0.03f}});
    const auto once = capped(s, test::emboldened<>{.by = 0.05f});
    check_laws(twice);
    CHECK(volume_of(twice) == Approx(volume_of(once)).epsilon(1e-4));
}

TEST_CASE("emboldened refuses options out of range by name, both its own and the other extruder's", "[emboldened]")
{
    const float infinite = std::numeric_limits<float>::infinity(), nowhere = std::numeric_limits<float>::quiet_NaN();
    for (const float v : {infinite, -infinite, nowhere}) {
        check_refused("by", test::emboldened<>{.by = v});
        check_refused("embolden::mitre_limit", test::emboldened<>{.mitre_limit = v});
    }
    for (const float v : {0.5f, -1.0f}) check_refused("embolden::mitre_limit", test::emboldened<>{.mitre_limit = v});
    check_refused("depth", test::emboldened<>{.solid = {.depth = 0.0f}});
    check_refused("width", test::emboldened<bevelled>{.solid = {.width = -1.0f}});
    check_refused("mitre_limit", test::emboldened<bevelled>{.solid = {.mitre_limit = 0.5f}});
    CHECK_FALSE(refused_options(test::emboldened<>{.mitre_limit = 0.0f}));

    check_refused_size("by", test::emboldened<>{.by = 600.0f});
    capped_mesh<test::emboldened<>> far;
    CHECK(build_capped(shapes::rectangle(), test::emboldened<>{.by = 500.0f}, far) == error::outline_beyond_grid);
    check_unknown_em<test::emboldened<>>();
}

TEST_CASE("emboldened letters that differ have different keys", "[emboldened]")
{
    const test::emboldened<> plain;
    std::vector<test::emboldened<>> others(6, plain);
    others[0].by = 0.03f;
    others[1].by = -0.02f;
    others[2].mitre_limit = 2.0f;
    others[3].joins = bevel_joins::bevelled;
    others[4].solid.side = false;
    others[5].solid.normals.crease_degrees = 20.0f;
    check_different_keys(plain, others);
    test::emboldened<> deeper = plain;
    deeper.solid.depth = 0.3f;
    CHECK(deeper.cache_key() == plain.cache_key());
}

TEST_CASE("an empty region stays empty when emboldened, and a lack of memory is reported", "[emboldened]")
{
    check_empty_region(test::emboldened<>{});
    for (const float by : {0.03f, -0.03f}) check_scarce_memory(test::emboldened<>{.by = by}, 60);
}

TEST_CASE("a bolder letter can be planned in the memory of the last one", "[emboldened]")
{
    check_planned_anew(test::emboldened<bevelled>{.by = 0.01f});
}

TEST_CASE("a letter grows by half as much if its new edges are refused, and the plan reports it", "[emboldened]")
{
    check_refused_edges(test::emboldened<>{.by = 0.01f}, test::emboldened<>{.by = 0.02f});
}

TEST_CASE("nested solids with a mitre limit of 1 have less than 5 times as many triangles as with 2", "[emboldened]")
{
    std::vector<point> spikes;
    for (int i = 0; i < 40; ++i) {
        const double angle = 6.283185307179586 * i / 40, radius = i % 2 == 0 ? 450.0 + i : 150.0 + 3.0 * i;
        spikes.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    shapes::shape s{"spikes", {shapes::polygon(spikes)}};
    s.loops.tolerance = 640.0;
    using nested = test::emboldened<bevelled>;
    for (const float by : {-0.0003f, 0.02f})
        for (const bevel_joins joins : {bevel_joins::round, bevel_joins::bevelled}) {
            std::uint64_t triangles[2];
            for (const float limit : {1.0f, 2.0f}) {
                nested how{.by = by, .joins = joins, .mitre_limit = limit};
                how.solid = {.width = 0.05f,
                             .bevel_depth = 0.05f,
                             .joins = joins,
                             .mitre_limit = limit,
                             .profile = round_profile()};
                const auto m = capped(s, how);
                check_laws(m);
                CHECK_FALSE(m.plan.narrowed);
                triangles[limit > 1.0f ? 1 : 0] = m.sizes().total().triangles;
            }
            CAPTURE(by, triangles[0], triangles[1]);
            CHECK(triangles[0] < 5 * triangles[1]);
        }
}

TEST_CASE("needles are moved by the full distance, with and without a mitre limit", "[emboldened]")
{
    // The crescents between two circles that are nearly the same end in needles, and these grow spikes.
    const double c = 1.0 / 512.0;
    std::vector<std::vector<curve>> outers;
    for (int i = 0; i < 12; ++i)
        outers.push_back(
            shapes::polygon({{60.0 * i, 0}, {60.0 * i + 50.0, 3 * c}, {60.0 * i + 25.0, (2 + i % 3) * c + 0.01}}));
    shapes::shape s{"needles", outers};
    s.loops.tolerance = 640.0;
    for (const float limit : {0.0f, 1000.0f, 4.0f}) {
        CAPTURE(limit);
        const auto m = capped(s, test::emboldened<>{.by = 0.0004f, .mitre_limit = limit});
        CHECK_FALSE(m.plan.narrowed);
        check_laws(m);
    }
}
