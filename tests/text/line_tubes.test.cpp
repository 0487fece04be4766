// SPDX-License-Identifier: MIT

#include <typemesh/text/line_tubes.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/failing_memory.hpp"

#include <typemesh/inspect/euler_count.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/vertex/growing_sink.hpp>
#include <typemesh/vertex/vertex_lambda.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct tube_vertex {
    vec3 position, normal;
    vec2 uv;
    vec4 tangent;
};

struct tube_mesh {
    std::vector<tube_vertex> vertices;
    std::vector<std::uint32_t> indices;
    tube_report report;

    [[nodiscard]] auto view() const { return inspect::mesh_view{vertices, indices}; }
};

}  // namespace

template <>
struct typemesh::vertex_traits<tube_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent;
    tube_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal, s.uv, s.tangent};
    }
};

namespace {

tube_mesh tubes_along(const char* path, const tube_style& style, const frame& f = right_handed_y_up)
{
    line_tubes tubes;
    tubes.begin(100.0);
    REQUIRE(draw_svg_path(path, 1e-3, tubes));
    const auto done = tubes.plan(style);
    REQUIRE(done);
    tube_mesh made;
    made.report = *done;
    REQUIRE(tubes.write(into(made.vertices, made.indices), tubes.placed(1.0, f)));
    CHECK(tubes.size() == mesh_size{made.vertices.size(), made.indices.size() / 3});
    return made;
}

double polygon_area(unsigned sides, double radius)
{
    return 0.5 * sides * radius * radius * std::sin(2.0 * 3.14159265358979323846 / sides);
}

}  // namespace

TEST_CASE("the tube along an open line is a rod, along a closed one a ring", "[text]")
{
    for (const tube_end end : {tube_end::flat, tube_end::round})
        for (const unsigned sides : {3u, 4u, 8u, 15u}) {
            const tube_style style{.radius = 0.02f, .sides = sides, .end = end};
            const tube_mesh rod = tubes_along("M0 0 L50 0 L50 40", style);
            CHECK(inspect::check_manifoldness(rod.view()).is_manifold());
            CHECK(inspect::count_euler(rod.view()).characteristic() == 2);
            const tube_mesh ring = tubes_along("M0 0 L50 0 L50 40 Z", style);
            CHECK(inspect::check_manifoldness(ring.view()).is_manifold());
            CHECK(inspect::count_euler(ring.view()).characteristic() == 0);
            const double area = polygon_area(sides, 0.02), volume = inspect::measure(rod.view()).volume;
            if (end == tube_end::flat)
                CHECK(volume == Catch::Approx(0.9 * area).epsilon(1e-5));
            else
                CHECK((volume > 0.9 * area && volume < 0.9 * area + 4.2 * 0.02 * 0.02 * 0.02));
            CHECK(inspect::measure(ring.view()).volume ==
                  Catch::Approx((0.9 + std::sqrt(0.5 * 0.5 + 0.4 * 0.4)) * area).epsilon(1e-5));
        }
}

TEST_CASE("normals of tubes along lines point out of their triangles", "[text]")
{
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up})
        for (const char* path : {"M0 0 L50 0 L50 40", "M0 0 C30 0 40 50 60 50 Q90 50 90 20", "M0 0 L50 0 L50 40 Z"})
            for (const tube_end end : {tube_end::flat, tube_end::round}) {
                const tube_mesh made = tubes_along(path, {.radius = 0.02f, .sides = 16, .end = end}, f);
                for (std::size_t t = 0; t < made.indices.size(); t += 3) {
                    inspect::place p[3];
                    for (std::size_t k = 0; k < 3; ++k)
                        p[k] = inspect::to_place(made.vertices[made.indices[t + k]].position);
                    const inspect::place face = cross(p[1] - p[0], p[2] - p[0]);
                    const double size = std::sqrt(dot(face, face));
                    for (std::size_t k = 0; k < 3; ++k) {
                        const inspect::place n = inspect::to_place(made.vertices[made.indices[t + k]].normal);
                        CHECK(dot(n, n) == Catch::Approx(1.0).margin(1e-5));
                        CHECK(f.winding * dot(n, face) > 0.8 * size);
                    }
                }
            }
}

TEST_CASE("tangents of tubes along lines are unit vectors along the surface, in which u grows", "[text]")
{
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up})
        for (const texture_mapping texture : {texture_mapping::em, texture_mapping::cylindrical, texture_mapping::box})
            for (const char* path : {"M0 0 L50 0 L50 40", "M0 0 C30 0 40 50 60 50 Q90 50 90 20", "M0 0 L50 0 L50 40 Z"})
                for (const tube_end end : {tube_end::flat, tube_end::round}) {
                    const tube_style style{.radius = 0.02f, .sides = 16, .end = end, .texture = texture};
                    const tube_mesh made = tubes_along(path, style, f);
                    for (const tube_vertex& v : made.vertices) {
                        const inspect::place n = inspect::to_place(v.normal), t = inspect::to_place(v.tangent);
                        CHECK(dot(t, t) == Catch::Approx(1.0).margin(1e-5));
                        CHECK(std::fabs(dot(n, t)) < 1e-5);
                        if (texture == texture_mapping::cylindrical) CHECK((v.uv.x >= 0.0f && v.uv.x <= 1.0f));
                    }
                    if (texture != texture_mapping::em) continue;
                    for (std::size_t i = 0; i < made.indices.size(); ++i) {
                        const tube_vertex &a = made.vertices[made.indices[i]],
                                          &b = made.vertices[made.indices[i % 3 == 2 ? i - 2 : i + 1]];
                        if (!(b.uv.x > a.uv.x + 1e-4f) || b.uv.x - a.uv.x > 0.2f) continue;
                        const inspect::place edge = inspect::to_place(b.position) - inspect::to_place(a.position),
                                             t = inspect::to_place(a.tangent), u = inspect::to_place(b.tangent);
                        CHECK((dot(edge, t) > 0.0 || dot(edge, u) > 0.0));  // a tip has one tangent for all sides
                    }
                }
}

TEST_CASE("a line that returns on itself has no tube, also where it meets itself", "[text]")
{
    for (int x = 1; x < 40; x += 2)
        for (int y = 0; y < 40; y += 3) {
            const point to{10.0 * x, 10.0 * y}, across = 0.5 * point{-to.y, to.x};
            line_tubes tubes;
            tubes.begin(1000.0);
            tubes.move({0.0, 0.0});
            for (const point p : {to, -1.0 * to, across - to, 0.5 * to + across, 0.5 * to - across}) tubes.line(p);
            const auto done = tubes.plan({.radius = 0.02f, .sides = 8});
            REQUIRE(done);
            CHECK(done->lost == 1);
            CHECK(tubes.size() == mesh_size{});
        }
}

TEST_CASE("lines near each other get thinner tubes, lines that cross are counted", "[text]")
{
    const tube_mesh apart = tubes_along("M0 0 L50 0 M0 4 L50 4", {.radius = 0.05f, .sides = 8});
    CHECK(apart.report.narrowed == 2);
    CHECK(apart.report.meeting == 0);
    CHECK(double{apart.report.smallest_radius} == Catch::Approx(0.02 * 63.0 / 64.0).epsilon(1e-4));

    const tube_mesh facing = tubes_along("M0 0 L50 0 M54 0 L90 0", {.radius = 0.05f, .sides = 8});
    CHECK(double{facing.report.smallest_radius} == Catch::Approx(0.02 * 63.0 / 64.0).epsilon(1e-4));

    const tube_mesh end_on = tubes_along("M0 0 L50 0 M54 -20 L54 20", {.radius = 0.05f, .sides = 8});
    CHECK(double{end_on.report.smallest_radius} == Catch::Approx(0.02 * 63.0 / 64.0).epsilon(1e-4));

    const tube_mesh crossing = tubes_along("M0 0 L50 50 M0 50 L50 0 M80 0 L80 50", {.radius = 0.05f, .sides = 8});
    CHECK(crossing.report.meeting == 2);
    CHECK(crossing.report.narrowed == 0);
    CHECK(crossing.report.lines == 3);
    CHECK(inspect::count_euler(crossing.view()).solids == 3);

    const tube_mesh bent = tubes_along("M0 0 L50 0 L50 4 L0 4", {.radius = 0.05f, .sides = 8});
    CHECK(double{bent.report.smallest_radius} == Catch::Approx(0.02 * 63.0 / 64.0).epsilon(1e-4));

    const tube_mesh back = tubes_along("M0 0 L50 0 L20 0", {.radius = 0.05f, .sides = 8});
    CHECK(back.report.lost == 1);
    CHECK(back.vertices.empty());
}

TEST_CASE("lines that do not meet as drawn do not meet as tubes", "[text]")
{
    // Beside the corner in L0 0, points are left out; the chord would cross the short line.
    const std::string close = "M60 14 L0 0 Q12 -10 40 -6 L120 -6 M10 -4.7 L10 1 ";
    const tube_style style{.radius = 0.1f, .sides = 4};
    const auto drawn = [&](float cut, const std::string& path) {
        tube_style how = style;
        how.corner_cut = cut;
        return tubes_along(path.c_str(), how).report;
    };
    CHECK(drawn(0.0f, close).meeting == drawn(0.5f, close).meeting);
    // The same beside lines that do meet, also if the cut ends such a meeting.
    const std::string crossing = close + "M200 0 L250 50 M200 50 L250 0";
    CHECK(drawn(0.5f, crossing).meeting == drawn(0.0f, crossing).meeting);
}

TEST_CASE("a line is kept apart from every line that it does not meet", "[text]")
{
    const std::string x = "M0 0 L50 50 M0 50 L50 0 ";
    const tube_mesh alone = tubes_along(x.c_str(), {.radius = 0.05f, .sides = 8});
    CHECK(alone.report.narrowed == 0);
    const tube_mesh two = tubes_along((x + "M52 0 L102 50 M52 50 L102 0").c_str(), {.radius = 0.05f, .sides = 8});
    CHECK(two.report.meeting == 4);
    CHECK(two.report.narrowed == 4);
    CHECK(double{two.report.smallest_radius} <= 0.01);
    float left = 0.0f, right = 2.0f;  // the gap between both
    for (const tube_vertex& v : two.vertices) {
        if (v.position.x < 0.51f) left = (std::max)(left, v.position.x);
        if (v.position.x > 0.51f) right = (std::min)(right, v.position.x);
    }
    CHECK(right - left > 1e-5f);
    CHECK(left < 0.51f);
}

TEST_CASE("a tube that floats cannot express so far from the origin is lost, any other one has no flat triangle",
          "[text]")
{
    std::size_t lost = 0;
    for (const unsigned sides : {3u, 8u, 30u})
        for (const int em : {1, 50, 100, 200, 400, 800, 1600, 3000}) {
            const std::string x = std::to_string(em * 100 + 7);
            const std::string path = "M" + x + " 3 q30 10 40 50 l3 -20";
            const tube_mesh made = tubes_along(path.c_str(), {.radius = 1e-3f, .sides = sides});
            lost += made.report.lost;
            for (std::size_t t = 0; t < made.indices.size(); t += 3) {
                inspect::place p[3];
                for (std::size_t k = 0; k < 3; ++k)
                    p[k] = inspect::to_place(made.vertices[made.indices[t + k]].position);
                const inspect::place face = cross(p[1] - p[0], p[2] - p[0]);
                CHECK(dot(face, face) > 0.0);
            }
        }
    CHECK(lost > 3);
    CHECK(lost < 20);
    CHECK(tubes_along("M5000 0 l50 0", {.radius = 0.02f}).report.narrowed == 0);
}

TEST_CASE("tubes along lines: bad drawings and options", "[text]")
{
    line_tubes tubes;
    const auto option = [&](const tube_style& style) {
        tubes.begin(100.0);
        tubes.move({0, 0});
        tubes.line({10, 0});
        return std::string{tubes.plan(style).error().option};
    };
    CHECK(option({.radius = 0.0f}) == "radius");
    CHECK(option({.sides = 2}) == "sides");
    CHECK(option({.crease_degrees = -1.0f}) == "crease_degrees");
    tubes.begin(100.0, 0.0);
    CHECK(std::string{tubes.plan({}).error().option} == "tolerance");
    tubes.begin(0.0);
    CHECK(std::string{tubes.plan({}).error().option} == "units_per_em");
    tubes.begin(100.0);
    tubes.line({1, 1});
    CHECK(tubes.plan({}).error() == error::bad_outline);
    tubes.begin(100.0);
    tubes.move({0, 0});
    tubes.line({std::nan(""), 1});
    CHECK(tubes.plan({}).error() == error::outline_not_finite);
    tubes.begin(100.0);
    tubes.move({0, 0});
    tubes.close();
    tubes.move({5, 5});
    const auto nothing = tubes.plan({});
    REQUIRE(nothing);
    CHECK(nothing->lines == 0);
    CHECK(tubes.size() == mesh_size{});
}

TEST_CASE("tubes along lines are written in sizes that floats can express, or not at all", "[text]")
{
    line_tubes tubes;
    tubes.begin(100.0);
    REQUIRE(draw_svg_path("M0 0 L50 0 L50 40", 1e-3, tubes));
    REQUIRE(tubes.plan({}));
    const auto option = [&](const placement& at) {
        tube_mesh made;
        const auto done = tubes.write(into(made.vertices, made.indices), at);
        CHECK(made.vertices.empty() == !done);
        for (const tube_vertex& v : made.vertices) CHECK(std::isfinite(v.position.x + v.position.y + v.position.z));
        return std::string{done ? "" : done.error().option};
    };
    for (const double size : {-1.0, 0.0, std::nan(""), double(INFINITY), 1e39, 1e-31, 0x1.1p30})
        CHECK(option(tubes.placed(size)) == "size");
    for (const double size : {1e-30, 1.0, 0x1p30}) CHECK(option(tubes.placed(size)) == "");
    placement at = tubes.placed();
    at.pen = {1e60, 0.0};
    CHECK(option(at) == "size");
    at = tubes.placed();
    at.unit_per_depth = 1e-40;
    CHECK(option(at) == "radius");
    at.unit_per_depth = std::nan("");
    CHECK(option(at) == "size");
}

TEST_CASE("the box texture reaches from edge to edge of the tubes", "[text]")
{
    const auto range = [](const tube_style& style) {
        vec2 low{9.0f, 9.0f}, high{-9.0f, -9.0f};
        for (const tube_vertex& v : tubes_along("M0 0 L50 0 L50 10", style).vertices) {
            low = {(std::min)(low.x, v.uv.x), (std::min)(low.y, v.uv.y)};
            high = {(std::max)(high.x, v.uv.x), (std::max)(high.y, v.uv.y)};
        }
        for (const float v : {low.x, low.y}) CHECK(double(v) == Catch::Approx(0.0).margin(1e-5));
        for (const float v : {high.x, high.y}) CHECK(double(v) == Catch::Approx(1.0).margin(1e-5));
    };
    range({.radius = 0.04f, .texture = texture_mapping::box});
    range({.radius = 0.04f, .end = tube_end::flat, .texture = texture_mapping::box});
}

TEST_CASE("tubes along lines allocate nothing after warm-up, and say when memory runs out", "[text]")
{
    const auto draw = [](line_tubes& tubes) {
        tubes.begin(100.0);
        REQUIRE(draw_svg_path("M0 0 C30 0 40 50 60 50 Q90 50 90 20 M0 80 L50 80 L50 120 Z", 1e-3, tubes));
        return tubes.plan({.radius = 0.02f});
    };
    test::counting_memory counted;
    line_tubes tubes{counted.source()};
    REQUIRE(draw(tubes));
    const mesh_size planned = tubes.size();
    const std::size_t warm = counted.requests;
    REQUIRE(draw(tubes));
    CHECK(counted.requests == warm);
    for (std::size_t n = 1; n <= warm; ++n) {
        test::counting_memory failing{.fail_at = n};
        line_tubes poor{failing.source()};
        const auto done = draw(poor);
        CHECK(done.error() == error::out_of_memory);
        CHECK(poor.size() == mesh_size{});
        failing.fail_at = 0;
        REQUIRE(draw(poor));
        CHECK(poor.size() == planned);
    }
}
