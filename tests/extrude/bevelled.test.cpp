// SPDX-License-Identifier: MIT

#include <typemesh/extrude/bevelled.hpp>

#include <typemesh/extrude/extruded.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "capped.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;
using Catch::Approx;

namespace {

static_assert(extruder<bevelled>);
static_assert(capping_extruder<bevelled>);
static_assert(part_count_of<bevelled> == 5);
static_assert(has_heights<bevelled> && has_front_triangles<bevelled> && has_outline<bevelled>);
static_assert(refitting_extruder<bevelled>);
static_assert(!has_heights<extruded<>> && !has_front_triangles<extruded<>> && !has_outline<extruded<>>);
static_assert(!refitting_extruder<extruded<>>);

using bevelled_mesh = capped_mesh<bevelled>;

constexpr double cells = 512000.0;  // in an em

shapes::shape regular(int corners, double r)
{
    std::vector<point> p;
    for (int i = 0; i < corners; ++i) {
        const double a = 6.283185307179586 * i / corners;
        p.push_back({500.0 + r * std::cos(a), 500.0 + r * std::sin(a)});
    }
    return {std::to_string(corners) + " corners", {shapes::polygon(p)}};
}

/// Shapes that a bevel of 20 units can be carved into before two edges meet.
std::vector<shapes::shape> wide_shapes()
{
    return shapes::several(regular(4, 300), regular(6, 300), regular(64, 300), shapes::rectangle(), shapes::letter_e(),
                           shapes::ring(8), shapes::letter_d(8));
}

/// Area of a shape moved inwards by a distance, by Steiner's formula for polygons: exact as long as nothing meets.
double area_at(const shapes::shape& s, double distance)
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        const grid_point a = s.loops.points[s.previous(i)], b = s.loops.points[i], c = s.loops.points[s.next(i)];
        const point in{double(b.x) - a.x, double(b.y) - a.y}, out{double(c.x) - b.x, double(c.y) - b.y};
        const double turn = std::atan2(cross(in, out), typemesh::dot(in, out));
        area += 0.5 * (double(b.x) * c.y - double(c.x) * b.y) / cells / cells -
                distance * std::hypot(out.x, out.y) / cells + distance * distance * std::tan(turn / 2.0);
    }
    return area;
}

/// The volume within one bevel above the wall's end, and the area of its cap, from the profile only: strips are
/// prismoids, for which Simpson's rule is exact.
struct expected_bevel {
    double volume, cap;
};
expected_bevel expected(const shapes::shape& s, const profile_points& p, double width, double depth, bool outward)
{
    double sum = 0.0;
    const auto points = p.view();
    const double shift = outward ? width : 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double a = points[i - 1].t * width - shift, b = points[i].t * width - shift;
        const double rise = (double(points[i].h) - points[i - 1].h) * depth;
        sum += rise * (area_at(s, a) + 4.0 * area_at(s, (a + b) / 2.0) + area_at(s, b)) / 6.0;
    }
    return {sum, area_at(s, width - shift)};
}

/// The area of the cap in front, or at the back.
double cap_area(const bevelled_mesh& m, part p)
{
    double area = 0.0;
    for (const auto& c : triangles_of(m, p)) {
        const vec3 a = m.vertices[c[0]].position, b = m.vertices[c[1]].position, d = m.vertices[c[2]].position;
        area += 0.5 * std::abs((double(b.x) - a.x) * (double(d.y) - a.y) - (double(d.x) - a.x) * (double(b.y) - a.y));
    }
    return area;
}

void check_profile(const bevel_profile& profile, float width = 0.02f, float bevel_depth = 0.05f)
{
    for (const auto& s : wide_shapes())
        for (const bool outward : {false, true})
            for (const bevel_sides sides : {bevel_sides::both, bevel_sides::front, bevel_sides::back}) {
                INFO(s.name << (outward ? ", outward" : "") << ", sides " << int(sides));
                const bevelled how{.width = width,
                                   .bevel_depth = bevel_depth,
                                   .sides = sides,
                                   .outward = outward,
                                   .mitre_limit = 0.0f,
                                   .profile = profile};
                const auto m = capped(s, how);
                check_laws(m);

                const profile_points points = profile.at({width * cells, bevel_depth * cells, 0.0});
                const expected_bevel e = expected(s, points, double(width), double(bevel_depth), outward);
                const int bevels = sides == bevel_sides::both ? 2 : 1;
                const double foot = area_at(s, outward ? -double(width) : 0.0);
                const double walls = foot * (double(how.depth) - bevels * double(bevel_depth));
                CHECK(volume_of(m) == Approx(walls + bevels * e.volume).epsilon(2e-5));
                const bool in_front = sides != bevel_sides::back, in_back = sides != bevel_sides::front;
                CHECK(cap_area(m, part::front) == Approx(in_front ? e.cap : foot).epsilon(1e-5));
                CHECK(cap_area(m, part::back) == Approx(in_back ? e.cap : foot).epsilon(1e-5));
                CHECK((m.sizes().triangles[part::front_bevel] != 0) == in_front);
                CHECK((m.sizes().triangles[part::back_bevel] != 0) == in_back);
            }
}

}  // namespace

TEST_CASE("a bevelled mesh is closed, lit from outside and as large as its profile makes it", "[bevelled]")
{
    SECTION("chamfer") { check_profile(chamfer_profile()); }
    SECTION("round") { check_profile(round_profile(4)); }
    SECTION("round by tolerance") { check_profile(round_profile()); }
    SECTION("concave") { check_profile(concave_profile(5)); }
    SECTION("stepped") { check_profile(stepped_profile()); }
    SECTION("engraved") { check_profile(engraved_profile()); }
    SECTION("bezier") { check_profile(bezier_profile({})); }
    SECTION("points")
    {
        check_profile({{0, 0}, {0, 0.25f}, {0.25f, 1}, {0.25f, 0.5f}, {0.75f, 0.5f}, {1, 0.25f}, {1, 1}});
    }
    SECTION("bevels that meet, without a wall between them") { check_profile(chamfer_profile(), 0.02f, 0.1f); }
}

TEST_CASE("bevelled meshes have exactly the vertices and triangles that their faces need", "[bevelled]")
{
    // A square: four hard corners, and only the corners of each chamfer: 4 vertices and 2 triangles a face.
    const bevelled_mesh square = capped(regular(4, 300), bevelled{});
    for (const part p : {part::front, part::back}) {
        CHECK(square.sizes().vertices[p] == 4);
        CHECK(square.sizes().triangles[p] == 2);
    }
    for (const part p : {part::side, part::front_bevel, part::back_bevel}) {
        CHECK(square.sizes().vertices[p] == 16);
        CHECK(square.sizes().triangles[p] == 8);
    }
    // 64 soft corners: shared, but for the seam. The wall has one more pair for it, the bevel one more at each level.
    const bevelled_mesh circle = capped(regular(64, 300), bevelled{});
    CHECK(circle.sizes().vertices[part::side] == 2 * 65);
    CHECK(circle.sizes().vertices[part::front_bevel] == 2 * 65);
    const auto bevel_vertices = [](const bevelled& how) {
        return capped(regular(64, 300), how).sizes().vertices[part::front_bevel];
    };
    CHECK(bevel_vertices({.texture = texture_mapping::box}) == 2 * 64);
    // Smooth strips share their levels, hard ones do not; risers are pairs of their own.
    CHECK(bevel_vertices({.profile = round_profile(4)}) == 5 * 65);
    CHECK(bevel_vertices({.profile_crease_degrees = 10.0f, .profile = round_profile(4)}) == 8 * 65);
    const bevelled_mesh steps = capped(regular(64, 300), bevelled{.profile = stepped_profile()});
    CHECK(steps.sizes().vertices[part::front_bevel] == 8 * 65);
    CHECK(steps.sizes().triangles[part::front_bevel] == 8 * 64);
}

TEST_CASE("a bevelled mesh obeys its laws in every frame, centred or not, in all texture mappings", "[bevelled]")
{
    for (const frame& f : frames())
        for (const auto texture : texture_mappings)
            for (const bool centred : {false, true}) {
                const bevelled how{.centred = centred,
                                   .texture = texture,
                                   .profile = {{0, 0}, {0.3f, 0.6f}, {0.3f, 1.0f}, {0.6f, 1.0f}, {1.0f, 0.5f}}};
                const shapes::shape two[] = {shapes::letter_e(), shapes::letter_d(8)};
                for (const auto& s : two) {
                    const auto m = capped(s, how, with_box_texture(in_em(f)));
                    check_laws(m, f);
                    const height_range range = how.heights();
                    for (const auto& v : m.vertices) {
                        const double z = meshes::dot(wide(v.position), wide(f.toward));
                        REQUIRE(z <= range.high + 1e-6);
                        REQUIRE(z >= range.low - 1e-6);
                    }
                }
            }
    CHECK(bevelled{.depth = 0.5f}.heights().low == -0.5);
    CHECK(bevelled{.depth = 0.5f}.heights().high == 0.0);
    CHECK(bevelled{.depth = 0.5f, .centred = true}.heights().high == 0.25);
}

namespace {

/// By how much u and v grow along a triangle, as vectors in space; `known` unless they lie on a line.
struct uv_growth {
    wide_vec u, v;
    bool known;
};
uv_growth growth_on(const bevelled_mesh& m, const std::array<std::uint32_t, 3>& t)
{
    const auto &p = m.vertices[t[0]], &q = m.vertices[t[1]], &r = m.vertices[t[2]];
    const auto n = face_normal(m, t);
    const auto e = minus(wide(q.position), wide(p.position)), f = minus(wide(r.position), wide(p.position));
    const double area = meshes::dot(meshes::cross(e, f), n);
    const auto eu = double(q.uv.x) - p.uv.x, ev = double(q.uv.y) - p.uv.y, fu = double(r.uv.x) - p.uv.x,
               fv = double(r.uv.y) - p.uv.y;
    const auto across_e = meshes::cross(n, e), across_f = meshes::cross(n, f);
    uv_growth g{{}, {}, std::abs(eu * fv - ev * fu) > 1e-9};
    for (std::size_t k = 0; k < 3; ++k) {
        g.u[k] = (fu * across_e[k] - eu * across_f[k]) / area;
        g.v[k] = (fv * across_e[k] - ev * across_f[k]) / area;
    }
    return g;
}

template <class Check>
void for_bevel_triangles(const shapes::shape& s, const bevelled& how, const placement& at, Check&& check)
{
    const auto m = capped(s, how, at);
    for (const part p : {part::front_bevel, part::back_bevel})
        for (const auto& t : triangles_of(m, p)) check(m, t, p == part::front_bevel);
}

}  // namespace

TEST_CASE("v continues from the wall at one tile per em, u follows the contour, and tangents follow both", "[bevelled]")
{
    const std::pair<uv_origin, bool> ways[] = {
        {uv_origin::bottom_left, false}, {uv_origin::top_left, false}, {uv_origin::top_left, true}};
    for (const auto& [origin, outward] : ways) {
        const frame f = with_origin(right_handed_y_up, origin);
        const float turn = origin == uv_origin::top_left ? -1.0f : 1.0f;
        const shapes::shape all[] = {regular(4, 300), regular(64, 300), shapes::letter_e(), shapes::letter_d(8)};
        for (const auto& s : all) {
            INFO(s.name);
            const bevelled how{
                .bevel_depth = 0.05f, .outward = outward, .mitre_limit = 0.0f, .profile = round_profile(4)};
            for_bevel_triangles(s, how, in_em(f), [&](const bevelled_mesh& m, const auto& t, bool) {
                const uv_growth g = growth_on(m, t);
                REQUIRE(g.known);
                CHECK(std::sqrt(meshes::dot(g.v, g.v)) == Approx(1.0).epsilon(0.002));
                CHECK(turn * g.v[2] > 0.0);  // upwards on both bevels, like on the walls
                for (const std::uint32_t corner : t) {
                    const auto& v = m.vertices[corner];
                    CHECK(meshes::dot(wide(v.tangent), g.u) > 0.6 * std::sqrt(meshes::dot(g.u, g.u)));
                    CHECK(meshes::dot(bitangent(v), g.v) > 0.8);
                }
            });
        }
    }
    // Where the wall ends: the same v on both sides, and the lengths of the profile from there.
    const frame upwards = with_origin(right_handed_y_up, uv_origin::bottom_left);
    const auto m = capped(shapes::rectangle(), bevelled{.width = 0.03f, .bevel_depth = 0.04f}, in_em(upwards));
    for (const auto& v : vertices_of(m, part::front_bevel))
        CHECK(v.uv.y == Approx(v.position.z < -0.02f ? 0.96 : 1.01).margin(1e-5));
    for (const auto& v : vertices_of(m, part::back_bevel))
        CHECK(v.uv.y == Approx(v.position.z > -0.18f ? 0.84 : 0.79).margin(1e-5));
    for (const auto& v : vertices_of(m, part::side))
        CHECK(v.uv.y == Approx(v.position.z > -0.1f ? 0.96 : 0.84).margin(1e-5));
}

TEST_CASE("box mapping puts the texture straight through a bevel", "[bevelled]")
{
    const frame f = with_origin(right_handed_y_up, uv_origin::bottom_left);
    const auto m = capped(shapes::letter_d(8), bevelled{.texture = texture_mapping::box}, with_box_texture(in_em(f)));
    for (const auto& v : m.vertices) {
        CHECK(v.uv.x == Approx(v.position.x).margin(1e-6));
        CHECK(v.uv.y == Approx(v.position.y).margin(1e-6));
    }
}

TEST_CASE("a bevel's normals are the curve's, tilted by the profile", "[bevelled]")
{
    // A circle of 24 chords: the curve's normal points away from its middle, at every height.
    const shapes::shape circle{"circle", {shapes::cubic_circle({500, 500}, 300)}, {}, 6};
    const auto tilt = [](const auto& v) {  // degrees above the plane
        return std::asin(double(v.normal.z)) * 57.29577951308232;
    };
    const auto check_radial = [](const bevelled_mesh& m) {
        for (const auto& v : m.vertices) {
            if (std::abs(v.normal.z) > 0.999f) continue;
            const double x = double(v.position.x) - 0.5, y = double(v.position.y) - 0.5;
            const double off = std::hypot(x, y) * std::hypot(double(v.normal.x), double(v.normal.y));
            CHECK((x * v.normal.x + y * v.normal.y) / off > std::cos(1.0 / 57.3));
        }
    };
    const bevelled chamfer{.width = 0.03f, .bevel_depth = 0.04f};
    for_bevel_triangles(circle, chamfer, in_em(), [&](const bevelled_mesh& m, const auto& t, bool in_front) {
        for (const auto c : t) CHECK(tilt(m.vertices[c]) == Approx((in_front ? 1.0 : -1.0) * 36.8699).margin(0.01));
    });
    check_radial(capped(circle, chamfer));

    // Round: smooth into the wall and into the cap, and evenly between.
    const bevelled round{.width = 0.03f, .bevel_depth = 0.03f, .profile = round_profile(6)};
    const auto m = capped(circle, round);
    check_radial(m);
    for (const auto& v : vertices_of(m, part::front_bevel)) {
        const double height = (v.position.z + 0.03) / 0.03;
        CHECK(tilt(v) == Approx(std::asin(height) * 57.29577951308232).margin(0.02));
    }

    // The chamfer that looks round, and hard strips.
    const bevelled looks_round{.shading = bevel_shading::rounded};
    for_bevel_triangles(circle, looks_round, in_em(), [&](const bevelled_mesh& b, const auto& t, bool in_front) {
        for (const auto c : t) {
            const auto& v = b.vertices[c];
            const bool outer = in_front ? !(v.position.z > -0.01f) : v.position.z > -0.19f;
            CHECK(std::abs(tilt(v)) == Approx(outer ? 0.0 : 90.0).margin(0.05));
        }
    });
    const bevelled hard{.profile_crease_degrees = 5.0f, .profile = round_profile(2)};
    for_bevel_triangles(circle, hard, in_em(), [&](const bevelled_mesh& b, const auto& t, bool) {
        CHECK(tilt(b.vertices[t[0]]) == Approx(tilt(b.vertices[t[1]])).margin(0.05));
        CHECK(tilt(b.vertices[t[0]]) == Approx(tilt(b.vertices[t[2]])).margin(0.05));
    });
}

TEST_CASE("joins shade smoothly from one edge to the next, and a single wide join keeps its own normal", "[bevelled]")
{
    // A notch whose tip points into the letter.
    for (const auto joins : {bevel_joins::round, bevel_joins::bevelled}) {
        shapes::shape s = shapes::notch();
        s.loops.tolerance = 10.0;
        const bevelled how{.joins = joins};
        const auto m = capped(s, how);
        check_laws(m);
        CHECK((joins == bevel_joins::round ? m.data.swept.joins.size() > 3 : m.data.swept.joins.size() == 1));
        // Vertices near the tip, and how far their normals are from pointing away from it.
        double worst = 1.0;
        std::size_t near = 0;
        for (const auto& v : vertices_of(m, part::front_bevel)) {
            const double x = v.position.x - 0.3, y = v.position.y - 0.2, r = std::hypot(x, y);
            if (r < 0.015 || r > 0.035 || y > 0.005) continue;
            ++near;
            worst = std::min(
                worst, -(x * v.normal.x + y * v.normal.y) / r / std::hypot(double(v.normal.x), double(v.normal.y)));
        }
        CHECK(near >= 4);
        CHECK(worst > (joins == bevel_joins::round ? 0.98 : 0.7));
    }
}

TEST_CASE("a bevel wider than its stroke closes in a ridge, at the profile's height there", "[bevelled]")
{
    const bevelled how{.width = 0.3f, .bevel_depth = 0.06f};
    const auto m = capped(shapes::rectangle(), how);
    check_laws(m);
    CHECK(m.sizes().vertices[part::front] == 0);
    CHECK(m.sizes().triangles[part::back] == 0);
    CHECK(m.sizes().triangles[part::front_bevel] == 6);
    CHECK(m.sizes().vertices[part::front_bevel] == 3 + 4 + 3 + 4);
    const double a = 0.4, b = 0.7, roof = 0.06 * 2.0 / 3.0;
    CHECK(volume_of(m) == Approx(a * b * 0.08 + 2.0 * roof * a * (3.0 * b - a) / 6.0));
    float top = -1.0f;
    for (const auto& v : m.vertices) top = std::max(top, v.position.z);
    CHECK(top == Approx(-0.02));
}

TEST_CASE("a bevelled solid reports the heights that it reaches, even if it closes in a ridge", "[bevelled]")
{
    const auto check = [](const shapes::shape& s, const auto& how) {
        const auto m = capped(s, how);
        float low = 1e9f, high = -1e9f;
        for (const auto& v : m.vertices) low = std::min(low, v.position.z), high = std::max(high, v.position.z);
        const height_range reported = how.heights(form_of<bevelled>(s, m.data));
        CHECK(as_double(high) == Approx(reported.high).margin(1e-7));
        CHECK(as_double(low) == Approx(reported.low).margin(1e-7));
        return reported.high - reported.low;
    };
    const auto bar = shapes::rectangle();
    for (const bool outward : {false, true})
        for (const bevel_sides sides : {bevel_sides::both, bevel_sides::front, bevel_sides::back})
            for (const float width : {0.0f, 0.02f, 0.3f}) {
                bevelled how{.width = width, .bevel_depth = 0.06f, .sides = sides, .outward = outward};
                const bool ridge = width > 0.2f && !outward;
                const double bevels = sides == bevel_sides::both ? 2.0 : 1.0;
                CHECK(check(bar, how) == Approx(ridge ? 0.2 - bevels * 0.02 : 0.2));
                how.centred = true;
                CHECK(check(bar, how) == Approx(ridge ? 0.2 - bevels * 0.02 : 0.2));
            }
    // Engraved: the rim is the highest, if it is reached; else the ridge below it.
    CHECK(check(bar, bevelled{.width = 0.1f, .profile = engraved_profile()}) == Approx(0.2));
    CHECK(check(bar, bevelled{.width = 0.8f, .bevel_depth = 0.06f, .profile = engraved_profile()}) ==
          Approx(0.2 - 2 * 0.03));
    CHECK(check(shapes::pair(), bevelled{.width = 0.5f, .profile = round_profile(4)}) < 0.2);
}

TEST_CASE("the front triangles of a bevelled solid cover its base once", "[bevelled]")
{
    const auto s = shapes::letter_d(8);
    for (const bool outward : {false, true})
        for (const float width : {0.0f, 0.02f, 0.3f}) {
            const bevelled how{.width = width, .outward = outward};
            const auto m = capped(s, how);
            std::int64_t twice = 0;
            how.seen_from_front(form_of<bevelled>(s, m.data), [&](grid_point a, grid_point b, grid_point c) noexcept {
                CHECK(orientation(a, b, c) > 0);
                twice += orientation(a, b, c);
            });
            const double area = 0.5 * double(twice) / cells / cells;
            CHECK((outward && width > 0.0f ? area > area_at(s, 0.0) + 0.01 : area == Approx(area_at(s, 0.0))));
        }
}

TEST_CASE("a fitted bevel has 0.9 times the width at which a part would lose its cap", "[bevelled]")
{
    const auto reach = [](const shapes::shape& s, float width, bevel_mode mode) {
        const auto m = capped(s, bevelled{.width = width, .mode = mode});
        check_laws(m);
        const double reached = m.data.swept.levels.back() / cells;
        const double reported =
            as_double(bevelled{.width = width, .mode = mode}.width_of(form_of<bevelled>(s, m.data)));
        CHECK(reported == Approx(reached));
        return reached;
    };
    const auto bar = shapes::rectangle();  // 400 units wide
    CHECK(reach(bar, 0.1f, bevel_mode::fit) == Approx(0.1));
    CHECK(reach(bar, 0.19f, bevel_mode::fit) == Approx(0.19));
    CHECK(reach(bar, 0.25f, bevel_mode::fit) == Approx(0.18));
    CHECK(reach(bar, 3.0f, bevel_mode::fit) == Approx(0.18));
    CHECK(reach(bar, 0.25f, bevel_mode::clip) == Approx(0.25));
    CHECK(reach(shapes::pair(), 0.3f, bevel_mode::fit) < 0.06);  // the triangle's cap is the first to go
}

TEST_CASE(
    "a speck does not decide how wide a bevel fits, but its lost cap is counted, and what becomes narrow is reported",
    "[bevelled]")
{
    const auto with_triangle = [](double side, double tolerance) {
        std::vector<std::vector<curve>> outers;
        outers.push_back(shapes::polygon({{100, 0}, {500, 0}, {500, 700}, {100, 700}}));  // fits 0.18
        if (side > 0.0) outers.push_back(shapes::polygon({{700, 0}, {700 + side, 0}, {700 + side / 2, 0.866 * side}}));
        shapes::shape s{"bar and triangle", outers};
        s.loops.tolerance = tolerance * 512.0;
        return s;
    };
    const struct {
        double side;  ///< its inradius is 0.289 of that
        double tolerance;
        float width;
        double reached;
        std::uint32_t lost;
        bool narrow;
    } cases[] = {
        {0.0, 1.25, 0.03f, 0.03, 0, false},
        {0.0, 1.25, 0.3f, 0.18, 0, false},
        {0.0, 1.25, 0.4f, 0.18, 0, true},
        {3.0, 1.25, 0.03f, 0.03, 1, false},      // 0.87 units: a speck
        {3.0, 1.25, 0.0003f, 0.0003, 0, false},  // with a bevel that leaves its cap
        {3.0, 1.25, 0.3f, 0.18, 1, false},
        {30.0, 1.25, 0.03f, 0.9 * 0.00866, 0, true},
        {30.0, 1.25, 0.01f, 0.9 * 0.00866, 0, false},
        {30.0, 1000.0, 0.3f, 0.18, 1, false},  // both are specks: the larger one keeps its cap
        {3.0, 0.0, 0.03f, 0.9 * 0.000866, 0, true},
    };
    for (const auto& c : cases) {
        CAPTURE(c.side, c.tolerance, c.width);
        const auto s = with_triangle(c.side, c.tolerance);
        for (const bevel_mode mode : {bevel_mode::fit, bevel_mode::clip}) {
            const bevelled how{.width = c.width, .mode = mode};
            const auto [plan, data] = plan_solid_of(s, how);
            const bool fits = mode == bevel_mode::fit;
            CHECK(plan.narrowed == (fits && c.narrow));
            CHECK(plan.lost_caps == (fits ? c.lost : 0));
            CHECK(data.swept.levels.back() / cells == Approx(fits ? c.reached : as_double(c.width)).margin(4e-6));
            check_laws(capped(s, how));
        }
    }
}

TEST_CASE("a bevel whose cap is refused becomes narrower, stays closed, and is reported", "[bevelled]")
{
    const auto s = shapes::letter_d(8);
    for (const int refusals : {0, 1, 3})
        for (const bevel_mode mode : {bevel_mode::clip, bevel_mode::fit}) {
            const bevelled how{.width = mode == bevel_mode::clip ? 0.02f : 0.3f, .mode = mode};
            caps_by<> caps{s.made()};
            auto maker = caps.maker();
            refusing_caps<decltype(maker)> refusing{maker, refusals};
            const auto made = plan_solid_of(s, how, refusing);
            CHECK(made.plan.narrowed == (refusals != 0 || mode == bevel_mode::fit));
            const double width = capped(s, how).data.swept.levels.back();
            CHECK(made.data.swept.levels.back() == Approx(std::ldexp(width, -refusals)));
            mesh<> m;
            REQUIRE(write_solid<bevelled>({form_of<bevelled>(s, made.data), made.plan}, how, in_em(), m));
            check_laws(m);
        }
    // Of an outward bevel the first region that is filled is what lies around the letter: its refusal is the letter's.
    const bevelled outwards{.sides = bevel_sides::front, .outward = true};
    caps_by<> caps{s.made()};
    auto maker = caps.maker();
    for (const bool refused : {false, true}) {
        int asked = 0;
        struct second_refused : decltype(maker) {
            int& asked;
            bool refused;
            result<region> fill(triangle_list& out) noexcept
            {
                if (++asked == 2 && refused) return error::crossing_contours;
                return decltype(maker)::fill(out);
            }
        } refusing{maker, asked, refused};
        CHECK(plan_solid_of(s, outwards, refusing).plan.narrowed == refused);
        CHECK(asked >= 2);
    }
}

TEST_CASE("an outward bevel grows the letter, keeps its front, and meets its walls in texture and light", "[bevelled]")
{
    const auto s = shapes::letter_d(8);
    const bevelled how{.outward = true, .profile = round_profile(4)};
    const auto m = capped(s, how);
    CHECK(m.plan.around.low.x == Approx(-0.02 * cells).margin(2.0));
    CHECK(m.plan.around.high.y == Approx((0.7 + 0.02) * cells).margin(2.0));
    check_laws(m);
    CHECK(m.data.swept.joins.empty());  // its corners are of 90 degrees
    const auto plain = build(s, extruded<>{});
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        CHECK(m.vertices[i].position == plain.vertices[i].position);
        CHECK(m.vertices[i].uv == plain.vertices[i].uv);
    }
    // Each vertex at the top of a wall is met by one of the bevel, with its normal and texture coordinates.
    const auto walls = vertices_of(m, part::side);
    for (std::size_t i = 1; i < walls.size(); i += 2) {
        const auto& wall = walls[i];
        REQUIRE(wall.position.z == Approx(-0.02f));
        double best = 1.0;
        for (const auto& b : vertices_of(m, part::front_bevel)) {
            if (!(b.position == wall.position)) continue;
            const double off = std::abs(double(b.uv.x) - wall.uv.x) + std::abs(double(b.uv.y) - wall.uv.y) + 1.0 -
                               meshes::dot(wide(b.normal), wide(wall.normal));
            best = std::min(best, off);
        }
        CHECK(best < 1e-4);
    }

    // The counter is 450 units wide, and a bevel that fits stays narrower; sharp corners are joined.
    const auto fitted = capped(s, bevelled{.width = 0.4f, .mode = bevel_mode::fit, .outward = true});
    check_laws(fitted);
    CHECK(fitted.data.swept.levels.back() / cells == Approx(0.9 * 0.225).margin(0.002));
    check_laws(capped(s, bevelled{.width = 0.4f, .outward = true}));
    const auto joined = capped(shapes::star(), bevelled{.outward = true});
    check_laws(joined);
    CHECK(joined.data.swept.joins.size() >= 4);
    for (const float narrow : {0.0f, 1e-6f})
        CHECK(volume_of(capped(s, bevelled{.width = narrow, .outward = true})) == Approx(0.2 * area_at(s, 0.0)));
}

TEST_CASE("outward bevels reach no farther round sharp corners than any mitre limit", "[bevelled]")
{
    for (const auto& [limit, reach] : {std::pair{2.0f, 0.1}, {8.0f, 0.4}, {0.0f, 0.81}}) {
        INFO("limit " << limit);
        const auto m = capped(shapes::spike(), bevelled{.width = 0.05f, .outward = true, .mitre_limit = limit});
        CHECK_FALSE(m.plan.narrowed);
        CHECK(-m.plan.around.low.x / cells <= reach);
        CHECK((limit > 0.0f || -m.plan.around.low.x / cells > 0.75));
        check_laws(m);
    }
}

TEST_CASE("a bevel narrower than four cells is upright, and a bevel less deep than that is level", "[bevelled]")
{
    const shapes::shape shape = shapes::letter_d(8);
    const double area = area_at(shape, 0.0);
    const auto plain = build(shape, extruded<>{});
    for (const float width : {0.0f, 1e-6f}) {
        const auto m = capped(shape, bevelled{.width = width, .profile = round_profile()});
        check_laws(m);
        CHECK(volume_of(m) == Approx(0.2 * area));
        CHECK(m.sizes().triangles[part::front_bevel] == 2 * shape.points());
        CHECK(m.sizes().triangles[part::side] == 2 * shape.points());
        CHECK(m.sizes().vertices[part::front_bevel] == plain.sizes.vertices[part::side]);
        CHECK(m.sizes().vertices[part::front] == plain.sizes.vertices[part::front]);
    }
    for (const float depth : {0.0f, 1e-6f}) {
        const auto m = capped(shape, bevelled{.bevel_depth = depth, .mitre_limit = 0.0f, .profile = round_profile()});
        check_laws(m);
        CHECK(volume_of(m) == Approx(0.2 * area));
        CHECK(m.sizes().triangles[part::front_bevel] == 2 * shape.points());
        CHECK(cap_area(m, part::front) == Approx(area_at(shape, 0.02)).epsilon(1e-5));
    }
    // Neither, or a profile that ends where it began: the mesh of extruded, to the bit.
    check_same(capped(shape, bevelled{.width = 0.0f, .bevel_depth = 0.0f}), plain);
    const profile_points back_again{{0, 0}, {0.5f, 1}, {1, 1e-7f}};
    check_laws(capped(shape, bevelled{.width = 0.0f, .profile = back_again}));
    CHECK(capped(shape, bevelled{.width = 0.0f, .profile = back_again}).triangles.size() == plain.triangles.size());
}

TEST_CASE("parts that are switched off are left out, and the others stay the same", "[bevelled]")
{
    const auto s = shapes::letter_e();
    const auto all = capped(s, bevelled{});
    for (unsigned bits = 0; bits < 8; ++bits) {
        const bevelled how{.front = (bits & 1u) != 0, .back = (bits & 2u) != 0, .side = (bits & 4u) != 0};
        const auto m = capped(s, how);
        CHECK(m.sizes().vertices[part::front] == (how.front ? all.sizes().vertices[part::front] : 0));
        CHECK(m.sizes().triangles[part::back] == (how.back ? all.sizes().triangles[part::back] : 0));
        CHECK(m.sizes().vertices[part::side] == (how.side ? all.sizes().vertices[part::side] : 0));
        CHECK(m.sizes().triangles[part::front_bevel] == all.sizes().triangles[part::front_bevel]);
    }
}

TEST_CASE("bevelled refuses options out of range by their names, with and without a region", "[bevelled]")
{
    const float endless = std::numeric_limits<float>::infinity(), nowhere = std::numeric_limits<float>::quiet_NaN();
    for (const float v : {-0.1f, endless, -endless, nowhere}) {
        check_refused("depth", bevelled{.depth = v});
        check_refused("width", bevelled{.width = v});
        check_refused("bevel_depth", bevelled{.bevel_depth = v});
        check_refused("mitre_limit", bevelled{.mitre_limit = v});
        check_refused("crease_degrees", bevelled{.crease_degrees = v});
        check_refused("profile_crease_degrees", bevelled{.profile_crease_degrees = v});
    }
    check_refused("depth", bevelled{.depth = 0.0f});
    check_refused("mitre_limit", bevelled{.mitre_limit = 0.5f});
    check_refused("crease_degrees", bevelled{.crease_degrees = 180.5f});
    check_refused("bevel_depth", bevelled{.depth = 0.2f, .bevel_depth = 0.11f});
    check_refused("bevel_depth", bevelled{.depth = 0.2f, .bevel_depth = 0.21f, .sides = bevel_sides::back});
    CHECK_FALSE(refused_options(bevelled{.depth = 0.2f, .bevel_depth = 0.1f}));
    CHECK_FALSE(refused_options(bevelled{.depth = 0.2f, .bevel_depth = 0.2f, .sides = bevel_sides::front}));
    check_refused("bevel_depth", bevelled{.depth = 0.2f, .bevel_depth = 0.1f, .profile = stepped_profile()});
    check_refused(
        "bevel_depth",
        bevelled{.depth = 0.2f, .bevel_depth = 0.2f, .sides = bevel_sides::back, .profile = engraved_profile()});
    CHECK_FALSE(refused_options(bevelled{.depth = 0.2f, .bevel_depth = 0.09f, .profile = engraved_profile()}));
    check_refused("profile", bevelled{.profile = profile_points{}});
    check_refused("profile", bevelled{.profile = {{0, 0}, {0.7f, 1}, {0.5f, 1}, {1, 1}}});
    check_refused("profile", bevelled{.profile = round_profile(64)});
    check_refused("shading", bevelled{.shading = bevel_shading::rounded, .profile = engraved_profile()});

    check_refused_size("width", bevelled{.width = 525.0f});
    check_laws(capped(shapes::rectangle(), bevelled{.width = 524.0f}));  // 2^28 cells are 524.3 em
    for (const float v : {65.6f, 2000.0f})                               // 2^25 cells are 65.5 em of 512,000
        check_refused_size("width", bevelled{.width = v, .outward = true});
    check_laws(capped(shapes::rectangle(), bevelled{.width = 65.5f, .outward = true}));
    check_unknown_em<bevelled>();
}

TEST_CASE("bevels that plan differently have different keys", "[bevelled]")
{
    const bevelled plain{.profile = round_profile()};
    std::vector<bevelled> others(18, plain);
    others[0].width = 0.021f;
    others[1].bevel_depth = 0.021f;
    others[2].sides = bevel_sides::front;
    others[3].sides = bevel_sides::back;
    others[4].mode = bevel_mode::fit;
    others[5].joins = bevel_joins::bevelled;
    others[6].shading = bevel_shading::rounded;
    others[7].mitre_limit = 0.0f;
    others[8].crease_degrees = 16.0f;
    others[9].profile_crease_degrees = 31.0f;
    others[10].texture = texture_mapping::box;
    others[11].profile = round_profile(5);
    others[12].depth = 0.01f;  // refused
    others[13].side = false;
    others[14].outward = true;
    others[15].wanted = 0.1f;   // so that it is reported
    others[16].wanted = 0.03f;  // joins are counted there
    others[17].wanted = 0.11f;
    check_different_keys(plain, others);
    bevelled deeper = plain;
    deeper.depth = 0.3f;
    deeper.centred = true;
    CHECK(deeper.cache_key() == plain.cache_key());
    CHECK_FALSE(bevelled{.bevel_depth = 0.1f}.cache_key() == bevelled{.depth = 0.3f, .bevel_depth = 0.1f}.cache_key());
    // Walls lower than the bevel may be raised.
    const float a_step_deeper = std::nextafter(0.2f, 1.0f);
    for (const float depth : {0.2f, 0.299f, 1.0f})
        CHECK_FALSE(bevelled{.depth = a_step_deeper, .bevel_depth = 0.1f}.cache_key() ==
                    bevelled{.depth = depth, .bevel_depth = 0.1f}.cache_key());
    CHECK(bevelled{.depth = 0.301f, .bevel_depth = 0.1f}.cache_key() ==
          bevelled{.depth = 1.0f, .bevel_depth = 0.1f}.cache_key());
    const bevelled a{.profile = {{0, 0}, {0.5f, 0.2f}, {1, 1}}}, b{.profile = {{0, 0}, {0.5f, 0.3f}, {1, 1}}};
    CHECK_FALSE(a.cache_key() == b.cache_key());
}

TEST_CASE("an empty region has an empty bevel, and a lack of memory is reported", "[bevelled]")
{
    check_empty_region(bevelled{});
    check_scarce_memory(bevelled{.profile = round_profile()}, 60);
}

TEST_CASE("a bevel can be planned in the memory of the last one", "[bevelled]")
{
    check_planned_anew(bevelled{.profile = round_profile(4)});
}
