// SPDX-License-Identifier: MIT

#include <typemesh/extrude/inflated.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <algorithm>
#include <limits>
#include <vector>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;
using namespace meshes;

static_assert(extruder<inflated> && cacheable_policy<inflated> && has_heights<inflated>);
static_assert(has_front_triangles<inflated> && has_hard_edges<inflated> && part_count_of<inflated> == 3);

namespace {

/// A mesh of an inflated shape, and its plan.
struct inflated_mesh : built {
    solid_plan plan;
    height_range heights;
};

result<inflated_mesh> inflate(const shapes::shape& s, const inflated& how, inflated_data& data,
                              const placement& to = in_em())
{
    static const monotone cut;
    cap_builder caps, further;
    region_caps maker{caps, further, cut, array_view<const triangle>{s.cap}};
    data.clear();
    const region r = s.made();
    const auto plan = plan_solid(how, r, data, maker);
    if (!plan) return plan.error();
    inflated_mesh out;
    out.plan = *plan;
    out.sizes = plan->sizes;
    const solid_of<inflated> form{{r.points(), r.starts(), s.cap}, data.read()};
    out.heights = how.heights(form);
    if (const auto done = write_solid<inflated>({form, *plan}, how, to, static_cast<mesh<everything>&>(out)); !done)
        return done.error();
    return out;
}

double volume_inside(const inflated_mesh& m) { return measure(inspect::mesh_view{m.vertices, indices_of(m)}).volume; }

/// No corner's normal points to the back of its triangle.
bool normals_are_right(const inflated_mesh& m)
{
    const auto indices = indices_of(m);
    return inspect::check_normals(inspect::mesh_view{m.vertices, indices}, [](const auto& v) { return v.normal; })
        .is_right();
}

/// The number of triangles whose corners lie on a line.
std::size_t without_area(const inflated_mesh& m)
{
    std::size_t found = 0;
    for (const auto& t : m.triangles) {
        const wide_vec a = wide(m.vertices[t[0]].position),
                       n = cross(minus(wide(m.vertices[t[1]].position), a), minus(wide(m.vertices[t[2]].position), a));
        found += !(dot(n, n) > 0.0);
    }
    return found;
}

const inflated forms[] = {{},
                          {.height = 0.4f},
                          {.height = 4.0f},
                          {.limit = 0.03f},
                          {.form = inflated_form::dome},
                          {.edge = 0.1f, .limit = 0.05f, .form = inflated_form::dome, .depth = 0.3f}};

}  // namespace

TEST_CASE("an inflated solid is closed, within its heights and box, and its normals lean out of its faces", "[extrude]")
{
    for (const auto& s : shapes::all()) {
        for (const inflated& how : forms) {
            CAPTURE(s.name, how.height, how.limit, how.depth, how.form == inflated_form::dome);
            inflated_data data;
            const auto m = inflate(s, how, data);
            REQUIRE(m);
            CHECK(m->vertices.size() == m->announced.vertices);
            CHECK(m->triangles.size() == m->announced.triangles);
            CHECK(open_edges(*m) == 0);
            CHECK(volume_inside(*m) > 0.0);
            CHECK((m->sizes.triangles[part::side] != 0) == (how.form == inflated_form::dome));
            std::size_t outside = 0, odd = 0;
            float top = -1.0f, bottom = 1.0f;
            for (const auto& v : m->vertices) {
                const double x = 512000.0 * double{v.position.x}, y = 512000.0 * double{v.position.y};
                const box& around = m->plan.around;
                outside += x < around.low.x - 0.5 || x > around.high.x + 0.5 || y < around.low.y - 0.5 ||
                           y > around.high.y + 0.5;
                top = (std::max)(top, v.position.z);
                bottom = (std::min)(bottom, v.position.z);
                odd += std::abs(length(v.normal) - 1.0) > 1e-6 || std::abs(dot(wide(v.tangent), wide(v.normal))) > 1e-5;
            }
            CHECK(top == static_cast<float>(m->heights.high));
            CHECK(bottom == static_cast<float>(m->heights.low));
            if (how.limit > 0.0f) CHECK(top < how.limit);
            CHECK(outside == 0);
            CHECK(odd == 0);
            CHECK(normals_are_right(*m));
        }
    }
}

TEST_CASE("front and back of a balloon share no edge, and every vertex belongs to a triangle, however thin the letter",
          "[extrude]")
{
    std::vector<shapes::shape> thin = shapes::all();
    // Triangles and a star with tips of a few degrees, and a bar that is a cell or two high, on the grid of 1/512 unit.
    for (const double high : {1.0 / 512, 5.0 / 512, 20.0}) {
        thin.push_back({"bar", {shapes::polygon({{0, 0}, {150, 0}, {150, high}, {0, high}})}, {}, 1});
        // an arc of a cell or two, whose cap fans out from a point
        thin.push_back(
            {"fan", {shapes::polygon({{0, 0}, {150, 0}, {100, high}, {75, 1.1 * high}, {50, high}})}, {}, 1});
        thin.push_back({"needle", {shapes::polygon({{0, 0}, {150, 25}, {0, high}})}, {}, 1});
        thin.push_back(
            {"hourglass",
             {shapes::polygon({{0, 0}, {75, 25}, {150, 0}, {150, 50 + high}, {75, 25 + high}, {0, 50 + high}})},
             {},
             1});
    }
    for (const auto& s : thin) {
        CAPTURE(s.name);
        inflated_data data;
        const auto m = inflate(s, {.edge = 0.08f}, data);
        REQUIRE(m);
        const auto indices = indices_of(*m);
        const auto found = inspect::check_manifoldness(inspect::mesh_view{m->vertices, indices});
        CHECK(found.open_edges == 0);
        CHECK(found.crowded_edges == 0);
        CHECK(found.bad_triangles == 0);
        CHECK(without_area(*m) == 0);
        CHECK(normals_are_right(*m));
        const auto on_walls = inflate(s, {.edge = 0.08f, .form = inflated_form::dome}, data);
        REQUIRE(on_walls);
        const auto walled = indices_of(*on_walls);
        CHECK(inspect::check_manifoldness(inspect::mesh_view{on_walls->vertices, walled}).is_manifold());
        CHECK(without_area(*on_walls) == 0);
        CHECK(normals_are_right(*on_walls));
        std::vector<bool> is_used(m->vertices.size());
        for (const std::uint32_t i : indices) is_used[i] = true;
        CHECK(std::count(is_used.begin(), is_used.end(), false) == 0);
    }
}

TEST_CASE("a speck of three points has a height and a volume, unless no grid point lies inside", "[extrude]")
{
    for (const double cells : {3.0, 4.0, 40.0, 256.0, 700.0}) {
        CAPTURE(cells);
        const double side = cells / 512;
        const shapes::shape speck{"speck", {shapes::polygon({{0, 0}, {side, 0}, {0.5 * side, 0.9 * side}})}, {}, 1};
        inflated_data data;
        const auto m = inflate(speck, {}, data);
        REQUIRE(m);
        CHECK(open_edges(*m) == 0);
        CHECK(volume_inside(*m) > 0.0);
        CHECK(m->heights.high > 0.0);
    }
}

TEST_CASE("an inflated disc has an ellipsoid's normals, which lie in the plane at the outline", "[extrude]")
{
    const shapes::shape disc{"disc", {shapes::cubic_circle({0, 0}, 300)}, {}, 16};
    for (const float height : {1.0f, 0.5f, 2.0f}) {
        CAPTURE(height);
        inflated_data data;
        const auto m = inflate(disc, {.height = height}, data);
        REQUIRE(m);
        double worst = 0.0, farthest = 0.0;
        std::size_t on_outline = 0;
        for (const auto& v : m->vertices) {
            const double x{v.position.x}, y{v.position.y}, z{v.position.z}, h{height}, r = 0.3;
            // x^2 + y^2 + 2 (z / h)^2 = r^2
            const wide_vec out = unit(wide_vec{x, y, 2.0 * z / (h * h)});
            worst = (std::max)(worst, std::acos((std::min)(1.0, dot(out, wide(v.normal)))));
            farthest = (std::max)(farthest, std::abs(std::sqrt(x * x + y * y + 2.0 * z * z / (h * h)) - r));
            if (std::abs(z) > 0.0) continue;
            ++on_outline;
            CHECK(std::abs(v.normal.z) <= 0.0f);
        }
        CHECK(on_outline > 80);
        CHECK(worst < 0.04);
        CHECK(farthest < 0.003);
        CHECK(volume_inside(*m) ==
              Catch::Approx(4.0 / 3.0 * 3.14159265 * 0.027 * 0.70710678 * double{height}).epsilon(0.03));
    }
}

TEST_CASE("an inflated solid's hard corners are doubled on its caps, and smooth outlines are not", "[extrude]")
{
    inflated_data data;
    const auto square = inflate(shapes::rectangle(), {}, data);
    REQUIRE(square);
    const std::size_t outline = data.data.of<side_point>().size();
    CHECK(square->sizes.vertices[part::front] == outline + data.inner.size() + 4);
    CHECK(square->sizes.vertices[part::front] == square->sizes.vertices[part::back]);
    // Every vertex at the outline has the normal of its own side.
    std::size_t leaning = 0;
    for (const auto& v : square->vertices)
        leaning +=
            !(std::abs(v.position.z) > 0.0f) && std::abs(std::abs(v.normal.x) + std::abs(v.normal.y) - 1.0f) > 1e-6f;
    CHECK(leaning == 0);
    const shapes::shape disc{"disc", {shapes::cubic_circle({0, 0}, 300)}, {}, 16};
    REQUIRE(inflate(disc, {}, data));
    CHECK(data.loops.points.size() == data.data.of<side_point>().size() + data.inner.size());
}

TEST_CASE("inflated heights scale with the letter, and an output unit of depths replaces the em", "[extrude]")
{
    const auto letter = shapes::letter_e();
    inflated_data data;
    const auto plain = inflate(letter, {}, data);
    placement large = in_em();
    large.unit_per_cell *= 40.0;
    large.unit_per_depth = 40.0;
    const auto scaled_up = inflate(letter, {}, data, large);
    large.unit_per_depth = 1.0;
    large.em_per_depth = 1.0 / 40.0;
    const auto in_output = inflate(letter, {.height = 40.0f}, data, large);
    REQUIRE(plain);
    REQUIRE(scaled_up);
    REQUIRE(in_output);
    for (std::size_t i = 0; i < plain->vertices.size(); ++i) {
        const auto &a = plain->vertices[i], &b = scaled_up->vertices[i], &c = in_output->vertices[i];
        REQUIRE(b.position.z == Catch::Approx(40.0f * a.position.z));
        REQUIRE(c.position.z == Catch::Approx(b.position.z));
        REQUIRE(dot(wide(a.normal), wide(b.normal)) > 1.0 - 1e-6);
        REQUIRE(dot(wide(a.normal), wide(c.normal)) > 1.0 - 1e-6);
    }
}

TEST_CASE("parts of an inflated solid that are switched off are empty", "[extrude]")
{
    for (unsigned bits = 0; bits < 8; ++bits) {
        CAPTURE(bits);
        const inflated how{
            .form = inflated_form::dome, .front = (bits & 1u) != 0, .back = (bits & 2u) != 0, .side = (bits & 4u) != 0};
        inflated_data data;
        const auto m = inflate(shapes::letter_e(), how, data);
        REQUIRE(m);
        CHECK((m->sizes.triangles[part::front] != 0) == how.front);
        CHECK((m->sizes.triangles[part::back] != 0) == how.back);
        CHECK((m->sizes.triangles[part::side] != 0) == how.side);
        CHECK(m->vertices.size() == m->announced.vertices);
        CHECK(m->triangles.size() == m->announced.triangles);
    }
}

TEST_CASE("inflated options have keys where the plan needs them, and are refused by name", "[extrude]")
{
    check_different_keys(inflated{}, {{.edge = 0.05f},
                                      {.form = inflated_form::dome},
                                      {.crease_degrees = 30.0f},
                                      {.max_points = 5000},
                                      {.limit = 0.1f},
                                      {.front = false},
                                      {.back = false},
                                      {.side = false},
                                      {.texture = texture_mapping::box},
                                      {.height = -1.0f}});
    CHECK(inflated{}.cache_key() == inflated{.height = 0.5f, .depth = 0.2f}.cache_key());
    CHECK(inflated{.limit = 0.1f}.cache_key() == inflated{.height = 0.5f, .limit = 0.05f}.cache_key());
    const float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const auto option_of = [](const inflated& how) {
        const error e = refused_options(how);
        return std::string{e == error::bad_option ? e.option : ""};
    };
    CHECK(option_of({}) == "");
    for (const float bad : {0.0f, -1.0f, infinite, nan}) {
        CAPTURE(bad);
        CHECK(option_of({.height = bad}) == "height");
        CHECK(option_of({.edge = bad}) == "edge");
        CHECK(option_of({.depth = bad}) == "depth");
        if (!(std::abs(bad) <= 0.0f)) CHECK(option_of({.limit = bad}) == "limit");
    }
    CHECK(option_of({.crease_degrees = 181.0f}) == "crease_degrees");
    CHECK(option_of({.max_points = 0x2000'0000u}) == "max_points");
    inflated_data data;
    CHECK(inflate(shapes::letter_e(), {.max_points = 100}, data).error() == error::too_many_points);
}

TEST_CASE("an inflated solid without memory says so, and asks for none once it is warm", "[extrude]")
{
    const auto letter = shapes::letter_d();
    const inflated how{.edge = 0.08f};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        inflated_data data{memory.source()};
        const auto m = inflate(letter, how, data);
        was_asked = memory.requests >= nth;
        CHECK(bool(m) != was_asked);
        if (!m) CHECK(m.error() == error::out_of_memory);
        memory.fail_at = 0;
        REQUIRE(inflate(letter, how, data));
        const std::size_t warm = memory.requests;
        REQUIRE(inflate(letter, how, data));
        CHECK(memory.requests == warm);
    }
}
