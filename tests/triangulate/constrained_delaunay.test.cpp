// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/delaunay.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

struct meshed {
    std::string mistake;
    std::vector<test::oracle::placed_triangle> triangles;
};

/// Fills and triangulates a shape: the triangles as a set, and the first law that they break.
meshed mesh_of(const test::shape& s, bool lawful = true)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = fill(loops, fill_rule::non_zero, space);
    if (!filled) return {filled.error() == error::crossing_contours ? "" : filled.error().message(), {}};
    triangle_list out;
    if (const error e = constrained_delaunay{}(*filled, space, out)) return {e.message(), {}};
    meshed m{"", test::oracle::as_set(filled->points(), out.view())};
    if (lawful) m.mistake = test::oracle::broken_law(*filled, out.view());
    if (m.mistake.empty()) m.mistake = test::oracle::broken_delaunay(*filled, out.view());
    return m;
}

/// Points of the grid that lie exactly on one circle, counter-clockwise.
test::polyline on_one_circle(std::int32_t squared_radius, std::int32_t scale)
{
    test::polyline l;
    const auto reach = static_cast<std::int32_t>(std::sqrt(squared_radius)) + 1;
    for (std::int32_t x = -reach; x <= reach; ++x)
        for (std::int32_t y = -reach; y <= reach; ++y)
            if (x * x + y * y == squared_radius) l.push_back({x * scale, y * scale});
    std::sort(l.begin(), l.end(), [](grid_point a, grid_point b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
    return l;
}

test::shape lattice(int rows)
{
    test::shape s{"square lattice of square holes", {}};
    test::polyline outer;
    const int width = 20 * rows;
    for (int i = 0; i < width; i += 10) outer.push_back({i, 0});
    for (int i = 0; i < width; i += 10) outer.push_back({width, i});
    for (int i = width; i > 0; i -= 10) outer.push_back({i, width});
    for (int i = width; i > 0; i -= 10) outer.push_back({0, i});
    s.loops.push_back(outer);
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < rows; ++x) s.loops.push_back(test::reversed(test::square(20 * x + 5, 20 * y + 5, 10)));
    return s;
}

test::polyline parabola(int n, bool upwards)
{
    test::polyline l;
    for (int i = 0; i < n; ++i) {
        const double x = 2.0 * i / (n - 1) - 1.0;
        l.push_back({static_cast<std::int32_t>(std::lround(0x1p27 * x)), static_cast<std::int32_t>(std::lround(0x1p27 * x * x))});
    }
    if (!upwards)
        for (grid_point& p : l) p = {-p.y, p.x};
    return l;
}

std::vector<test::shape> delaunay_shapes()
{
    std::vector<test::shape> all = test::generated_regions();
    all.push_back(lattice(1));
    all.push_back(lattice(6));
    all.push_back({"12 points on a circle", {on_one_circle(25, 1000)}});
    all.push_back({"36 points on a circle", {on_one_circle(5525, 100)}});
    all.push_back({"ring of points on two circles", {on_one_circle(5525, 8), test::reversed(on_one_circle(325, 16))}});
    all.push_back({"parabola", {parabola(500, true)}});
    all.push_back({"parabola on its side", {parabola(500, false)}});
    all.push_back({"fine ring", {test::circle(2000, 1e8), test::reversed(test::circle(1500, 9e7))}});
    all.push_back({"thin fine ring", {test::circle(2000, 1e8), test::reversed(test::circle(1500, 9.99e7))}});
    return all;
}

}  // namespace

TEST_CASE("constrained_delaunay makes every edge Delaunay", "[triangulate][delaunay]")
{
    for (const test::shape& s : delaunay_shapes()) {
        for (const double degrees : {0.0, 0.001, 33.0, 90.0, 180.0, 270.0}) {
            const test::shape t = test::turned(s, degrees);
            INFO(t.name);
            CHECK(mesh_of(t).mistake == "");
            CHECK(mesh_of(test::mirrored(t)).mistake == "");
        }
    }
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        CHECK(mesh_of(c.shape).mistake == "");
    }
}

TEST_CASE("constrained_delaunay makes every edge of random polygons on tiny grids Delaunay", "[triangulate][delaunay]")
{
    test::dice d{4};
    for (int i = 0; i < 6000; ++i) {
        const int width = 4 + d.roll(14), n = 3 + d.roll((std::min)(width * width / 3, 50));
        const test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(n, width, d)}};
        const std::string mistake = mesh_of(s).mistake;
        if (!mistake.empty()) {
            INFO(s);
            CHECK(mistake == "");
        }
    }
}

TEST_CASE("the Delaunay triangles do not depend on where contours begin or how they are ordered", "[triangulate][delaunay]")
{
    for (const test::shape& s : delaunay_shapes()) {
        const auto triangles = mesh_of(s, false).triangles;
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            INFO(s.name << ", shuffle " << seed);
            CHECK((mesh_of(test::shuffled(s, seed), false).triangles == triangles));
        }
    }
}
