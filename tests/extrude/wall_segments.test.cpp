// SPDX-License-Identifier: MIT
//
// Walls in segments along the depth, in every extruder that has them: each mesh is compared with the mesh of one segment.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/cap_normals.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>

#include <cmath>
#include <limits>

#include "capped.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

using row_vertex = surface_point<everything>;

constexpr std::uint32_t numbers_of_segments[] = {1, 2, 5};

/// Whether a vertex lies at a share of the way down from one vertex to another, with their v there; to three units in the
/// last place of the numbers that are interpolated.
bool lies_between(const row_vertex& v, const row_vertex& upper, const row_vertex& lower, double share)
{
    const auto is_between = [share](float at, float from, float to) {
        const double expected = (1.0 - share) * double(from) + share * double(to);
        const double step = 0x1p-23 * (std::max)(std::abs(double(from)), std::abs(double(to)));
        return std::abs(double(at) - expected) <= 3.0 * step + 1e-12;
    };
    return is_between(v.position.x, upper.position.x, lower.position.x) &&
           is_between(v.position.y, upper.position.y, lower.position.y) &&
           is_between(v.position.z, upper.position.z, lower.position.z) &&
           v.uv.x == upper.uv.x &&  // NOLINT: to the bit
           is_between(v.uv.y, upper.uv.y, lower.uv.y);
}

bool are_same(const row_vertex& a, const row_vertex& b)
{
    return a.position == b.position && a.normal == b.normal && a.uv == b.uv && a.tangent == b.tangent;
}

/// The walls' vertices in columns are the pairs of one segment, with vertices between them at equal distances.
template <class Vertices>
void check_columns(const Vertices& columns, const Vertices& pairs, std::uint32_t segments)
{
    const std::size_t rows = segments + 1;
    REQUIRE(columns.size() == pairs.size() / 2 * rows);
    std::size_t other_ends = 0, other_light = 0, astray = 0;
    for (std::size_t i = 0; i < pairs.size() / 2; ++i) {
        const row_vertex &upper = pairs[2 * i], &lower = pairs[2 * i + 1];
        other_ends += !are_same(columns[i * rows], upper) || !are_same(columns[i * rows + segments], lower);
        for (std::uint32_t k = 0; k <= segments; ++k) {
            const row_vertex& v = columns[i * rows + k];
            other_light += !(v.normal == upper.normal) || !(v.tangent == upper.tangent);
            astray += !lies_between(v, upper, lower, double(k) / segments);
        }
    }
    CHECK(other_ends == 0);
    CHECK(other_light == 0);
    CHECK(astray == 0);
}

/// The sum of the areas of some triangles.
template <class Mesh, class Triangles>
double area_of_triangles(const Mesh& m, const Triangles& some)
{
    double area = 0.0;
    for (const auto& [a, b, c] : some) {
        const wide_vec at = wide(m.vertices[a].position);
        const wide_vec twice = cross(minus(wide(m.vertices[b].position), at), minus(wide(m.vertices[c].position), at));
        area += 0.5 * std::sqrt(dot(twice, twice));
    }
    return area;
}

std::span<const row_vertex> side_vertices(const built& b)
{
    return std::span<const row_vertex>{b.vertices}.subspan(b.first_vertex(part::side), b.sizes.vertices[part::side]);
}
auto side_triangles(const built& b)
{
    return std::span{b.triangles}.subspan(b.first_triangle(part::side), b.sizes.triangles[part::side]);
}

/// Whether a triangle lies on the wall over an edge.
bool is_on_edge(const built& b, const std::array<std::uint32_t, 3>& t, vec3 from, vec3 to)
{
    for (const std::uint32_t v : t) {
        const vec3 p = b.vertices[v].position;
        if (!(p.x == from.x && p.y == from.y) && !(p.x == to.x && p.y == to.y)) return false;  // NOLINT: to the bit
    }
    return true;
}

}  // namespace

TEMPLATE_TEST_CASE("walls in segments are the same walls, closed, with exact counts", "[extrude][segments]",
                   cap_normals, shared_normals, averaged_normals, creased_normals, curve_normals)
{
    for (const auto& s : shapes::all())
        for (const auto texture : texture_mappings)
            for (const bool centred : {false, true}) {
                const extruded<TestType> whole{.depth = 0.3f, .centred = centred, .texture = texture};
                const placement at = over_box(s, right_handed_y_up);
                const built one = build(s, whole, at);
                for (const std::uint32_t segments : numbers_of_segments) {
                    INFO(s.name << ", texture " << int(texture) << ", segments " << segments);
                    extruded<TestType> how = whole;
                    how.segments = segments;
                    const built b = build(s, how, at);
                    const std::uint32_t n = s.points();
                    CHECK(open_edges(b) == 0);
                    CHECK(b.in_order);
                    CHECK(b.vertices.size() == b.announced.vertices);
                    CHECK(b.triangles.size() == b.announced.triangles);
                    CHECK(b.sizes.triangles[part::side] == 2 * segments * n);
                    for (std::uint32_t i = 0; i < one.first_vertex(part::side); ++i)
                        REQUIRE(are_same(b.vertices[i], one.vertices[i]));
                    CHECK(volume_of(b) == Approx(volume_of(one)).epsilon(1e-6));
                    CHECK(area_of_triangles(b, side_triangles(b)) ==
                          Approx(area_of_triangles(one, side_triangles(one))).epsilon(1e-6));
                    for (const auto& v : b.vertices) check_tangent(v, 2e-6);

                    std::size_t on_other_edges = 0;
                    for (std::uint32_t i = 0; i < n; ++i)
                        for (std::uint32_t t = 0; t < 2 * segments; ++t)
                            on_other_edges += !is_on_edge(b, side_triangles(b)[2 * segments * i + t],
                                                          b.vertices[i].position, b.vertices[s.next(i)].position);
                    CHECK(on_other_edges == 0);

                    if constexpr (!TestType::shares_caps) {
                        check_columns(side_vertices(b), side_vertices(one), segments);
                    } else {
                        CHECK(b.sizes.vertices[part::side] == (segments - 1) * n);
                        CHECK(b.announced.vertices == (segments + 1) * n);
                    }
                }
            }
}

TEMPLATE_TEST_CASE("between two doubled points, each wall in segments has its own normals in all rows",
                   "[extrude][segments]", averaged_normals, creased_normals, curve_normals)
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        constexpr std::uint32_t segments = 4;
        extruded<TestType> how{};
        how.segments = segments;
        const built b = build(s, how);
        CHECK(b.sizes.vertices[part::side] == (segments + 1) * (s.points() + b.doubled()));
        for (std::uint32_t i = 0; i < s.points(); ++i)
            for (std::uint32_t k = 0; k < segments; ++k) {
                const auto& left = side_triangles(b)[2 * (segments * i + k)];
                const auto& right = side_triangles(b)[2 * (segments * i + k) + 1];
                CHECK(left[0] == right[0]);  // one diagonal
                CHECK(left[2] == right[1]);
                CHECK(b.vertices[left[0]].position.z > b.vertices[left[1]].position.z);
                const vec2 after = b.sides[i].after, before = b.sides[s.next(i)].before;
                for (const std::uint32_t v : {left[0], left[1]})
                    CHECK(b.vertices[v].normal == vec3{after.x, after.y, 0.0f});
                for (const std::uint32_t v : {right[1], right[2]})
                    CHECK(b.vertices[v].normal == vec3{before.x, before.y, 0.0f});
                // u runs from the seam: it does not jump back within a wall.
                CHECK(b.vertices[right[2]].uv.x > b.vertices[left[0]].uv.x);
            }
    }
}

TEMPLATE_TEST_CASE("rows between shared caps have the normals of their walls, and the caps' texture",
                   "[extrude][segments]", cap_normals, shared_normals)
{
    for (const auto& s : shapes::all())
        for (const bool caps : {true, false}) {
            INFO(s.name);
            constexpr std::uint32_t segments = 5;
            const extruded<TestType> how{.depth = 0.5f, .front = caps, .back = caps, .segments = segments};
            const built b = build(s, how), bare = build(s, extruded<shared_normals>{.front = false, .back = false});
            const std::uint32_t n = s.points(), first = b.first_vertex(part::side);
            REQUIRE(b.vertices.size() == (segments + 1) * n);
            CHECK(b.sizes.triangles[part::front] == (caps ? s.made().triangle_count() : 0));
            std::size_t wrong = 0;
            for (std::uint32_t i = 0; i < n; ++i)
                for (std::uint32_t k = 1; k < segments; ++k) {
                    const auto& v = b.vertices[first + i * (segments - 1) + k - 1];
                    // Without caps, the normals of shared_normals are only the walls' share.
                    wrong += !(v.normal == bare.vertices[i].normal) || !(v.tangent == bare.vertices[i].tangent);
                    wrong += !lies_between(v, b.vertices[i], b.vertices[n + i], double(k) / segments);
                }
            CHECK(wrong == 0);
        }
}

TEMPLATE_TEST_CASE("walls in segments face outward in every frame, and fewer attributes give the same positions",
                   "[extrude][segments]", shared_normals, averaged_normals, creased_normals, curve_normals)
{
    for (const frame& f : frames())
        for (const auto& s : shapes::all()) {
            INFO(s.name << " in a frame whose right is " << f.right.x << " " << f.right.y << ", winding "
                        << int(f.winding));
            extruded<TestType> how{};
            how.segments = 3;
            const built b = build(s, how, in_em(f));
            check_laws(b, f);
            plan_data_of<extruded<TestType>> data;
            mesh<attribute::position> bare;
            REQUIRE(extrude(s.made(), s.cap, how, in_em(f), data, bare));
            REQUIRE(bare.vertices.size() == b.vertices.size());
            std::size_t moved = 0;
            for (std::size_t i = 0; i < bare.vertices.size(); ++i)
                moved += !(bare.vertices[i].position == b.vertices[i].position);
            CHECK(moved == 0);
            CHECK(bare.triangles == b.triangles);
        }
}

TEST_CASE("segments that are 0 or more than 1024 are a bad option, with and without walls", "[extrude][segments]")
{
    for (const std::uint32_t segments : {0u, 1025u, 0x4000'0000u, 0xFFFF'FFFFu}) {
        check_refused("segments", extruded<>{.segments = segments});
        check_refused("segments", extruded<cap_normals>{.side = false, .segments = segments});
        check_refused("segments", extruded<shared_normals>{.segments = segments});
        check_refused("segments", bevelled{.segments = segments});
    }
    CHECK_FALSE(refused_options(extruded<>{.segments = 1024}));
    const built most = build(shapes::letter_d(), extruded<>{.segments = 1024});
    CHECK(open_edges(most) == 0);
    CHECK(most.sizes.triangles[part::side] == 2048 * shapes::letter_d().points());
}

TEST_CASE("walls of 2^30 quadrilaterals are too large, and the counts of the largest walls do not wrap around",
          "[extrude][segments]")
{
    // A comb, with as many points as are needed. Nothing but the plan is made of it.
    const auto plan_of = [](std::uint32_t n, const auto& how) {
        contours comb;
        comb.grid.units_per_em = 1000.0;
        REQUIRE(comb.starts.push_back(0));
        for (std::uint32_t i = 0; i < n; ++i)
            REQUIRE(comb.points.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(i % 2)}));
        REQUIRE(comb.starts.push_back(n));
        plan_data_of<std::remove_cvref_t<decltype(how)>> data;
        no_caps nothing;
        return plan_solid(how, region::proven(comb, 0, 1), data, nothing);
    };
    constexpr std::uint32_t limit = 1u << 20;
    CHECK(plan_of(limit, extruded<averaged_normals>{.segments = 1024}).error() == error::too_large);
    CHECK(plan_of(limit, extruded<cap_normals>{.segments = 1024}).error() == error::too_large);
    CHECK(plan_of(limit, extruded<cap_normals>{.side = false, .segments = 1024}));
    const auto largest = plan_of(limit - 1, extruded<creased_normals>{.segments = 1024});
    REQUIRE(largest);
    CHECK(largest->sizes.triangles[part::side] == std::uint64_t{2048} * (limit - 1));
    CHECK(largest->sizes.vertices[part::side] >= std::uint64_t{1025} * (limit - 1));
    const auto shared = plan_of(limit - 1, extruded<shared_normals>{.segments = 1024});
    REQUIRE(shared);
    CHECK(shared->sizes.vertices[part::side] == std::uint64_t{1023} * (limit - 1));
}

TEST_CASE("a bevelled solid's walls in segments are the same walls, closed, between the same bevels",
          "[extrude][segments]")
{
    for (const auto& s : shapes::all())
        for (const bool outward : {false, true})
            for (const bevel_sides sides : {bevel_sides::both, bevel_sides::front, bevel_sides::back}) {
                const bevelled whole{.width = 0.01f,
                                     .bevel_depth = 0.03f,
                                     .sides = sides,
                                     .outward = outward,
                                     .centred = sides == bevel_sides::front,
                                     .texture = outward ? texture_mapping::em : texture_mapping::cylindrical,
                                     .profile = round_profile(2)};
                const auto one = capped(s, whole);
                for (const std::uint32_t segments : numbers_of_segments) {
                    INFO(s.name << ", segments " << segments << (outward ? ", outward" : "") << ", sides "
                                << int(sides));
                    bevelled how = whole;
                    how.segments = segments;
                    const auto b = capped(s, how);
                    check_laws(b);
                    check_columns(vertices_of(b, part::side), vertices_of(one, part::side), segments);
                    CHECK(b.sizes().triangles[part::side] == segments * one.sizes().triangles[part::side]);
                    CHECK(volume_of(b) == Approx(volume_of(one)).epsilon(1e-6));
                    CHECK(area_of_triangles(b, triangles_of(b, part::side)) ==
                          Approx(area_of_triangles(one, triangles_of(one, part::side))).epsilon(1e-6));
                    for (const part p : {part::front, part::back, part::front_bevel, part::back_bevel}) {
                        const auto mine = vertices_of(b, p), before = vertices_of(one, p);
                        REQUIRE(mine.size() == before.size());
                        std::size_t others = 0;
                        for (std::size_t i = 0; i < mine.size(); ++i) others += !are_same(mine[i], before[i]);
                        CHECK(others == 0);
                        CHECK(b.sizes().triangles[p] == one.sizes().triangles[p]);
                    }
                }
            }
}

TEST_CASE("bevels that leave no walls, and walls that are switched off, have no segments", "[extrude][segments]")
{
    for (const bool outward : {false, true}) {
        const bevelled deep{.depth = 0.1f, .width = 0.01f, .bevel_depth = 0.05f, .outward = outward, .segments = 4};
        const auto b = capped(shapes::letter_e(), deep);
        CHECK(b.sizes().vertices[part::side] == 0);
        CHECK(b.sizes().triangles[part::side] == 0);
        check_laws(b);
        const auto none = capped(shapes::letter_e(), bevelled{.outward = outward, .side = false, .segments = 4});
        CHECK(none.sizes().vertices[part::side] == 0);
        CHECK(none.sizes().triangles[part::side] == 0);
    }
}

TEST_CASE("refined and hollow letters, and chosen extruders, have walls in segments", "[extrude][segments]")
{
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        const auto check = [&s](const auto& one, const auto& four) {
            const auto a = capped(s, one), b = capped(s, four);
            CHECK(open_edges(b) == 0);
            CHECK(a.sizes().triangles[part::side] != 0);
            CHECK(b.sizes().triangles[part::side] == 4 * a.sizes().triangles[part::side]);
            CHECK(b.sizes().triangles[part::front] == a.sizes().triangles[part::front]);
            CHECK(volume_of(b) == Approx(volume_of(a)).epsilon(1e-6));
        };
        check(refined<>{.how = {.max_edge = 0.1f}}, refined<>{.solid = {.segments = 4}, .how = {.max_edge = 0.1f}});
        check(refined<extruded<shared_normals>>{.how = {.max_edge = 0.1f}},
              refined<extruded<shared_normals>>{.solid = {.segments = 4}, .how = {.max_edge = 0.1f}});
        using framed = outlined<extruded<>, extruded<cap_normals>>;
        check(framed{.width = 0.01f}, framed{.width = 0.01f, .ring = {.segments = 4}, .letter = {.segments = 4}});
        using chosen = one_of<extruded<>, bevelled>;
        check(chosen{extruded<>{}}, chosen{extruded<>{.segments = 4}});
        check(chosen{bevelled{.width = 0.01f}}, chosen{bevelled{.width = 0.01f, .segments = 4}});
    }
}
