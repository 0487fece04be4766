// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/delaunay.hpp"
#include "support/delaunay_shapes.hpp"
#include "support/proving_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

using test::mesh_of;
using test::meshed;

TEST_CASE("constrained_delaunay makes every edge Delaunay", "[triangulate][delaunay]")
{
    for (const test::shape& s : test::delaunay_shapes()) {
        for (const double degrees : {0.0, 0.001, 33.0, 90.0, 180.0, 230.0}) {
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
        const test::shape s{"random polygon", {test::random_polygon(n, width, d)}};
        INFO(s);
        CHECK(mesh_of(s).mistake == "");
    }
}

TEST_CASE("the Delaunay triangles do not depend on the start or order of contours", "[triangulate][delaunay]")
{
    for (const test::shape& s : test::delaunay_shapes()) {
        const auto triangles = mesh_of(s, {}, false).triangles;
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            INFO(s.name << ", shuffle " << seed);
            CHECK((mesh_of(test::shuffled(s, seed), {}, false).triangles == triangles));
        }
    }
}

TEST_CASE("integer shifts and powers of two keep the Delaunay triangles", "[triangulate][delaunay]")
{
    for (const test::shape& s : test::delaunay_shapes()) {
        std::int32_t reach = 1;
        for (const test::polyline& l : s.loops)
            for (const grid_point p : l) reach = (std::max)({reach, std::abs(p.x), std::abs(p.y)});
        const auto triangles = mesh_of(s, {}, false).triangles;
        const auto moved = [&](std::int32_t scale, std::int32_t dx, std::int32_t dy) {
            const auto place = [&](grid_point p) { return grid_point{p.x * scale + dx, p.y * scale + dy}; };
            test::shape t = s;
            for (test::polyline& l : t.loops) std::transform(l.begin(), l.end(), l.begin(), place);
            auto expected = triangles;
            for (auto& corners : expected) std::transform(corners.begin(), corners.end(), corners.begin(), place);
            INFO(s.name << " times " << scale << " plus " << dx << ", " << dy);
            CHECK((mesh_of(t, {}, false).triangles == expected));
        };
        const std::int32_t room = (1 << 28) - reach;
        moved(1, room, -room);
        moved(1, (std::min)(room, 17), 0);
        std::int32_t largest = 1;
        while (std::int64_t{largest} * 2 * reach <= 1 << 28) largest *= 2;
        moved(largest, 0, 0);
        moved((std::max)(1, largest / 8), 0, 0);
    }
}

namespace {

/// The cells of points on one circle, most of them single triangles: the points of each cell.
std::vector<test::polyline> cells_of(const test::shape& s)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = fill(loops, fill_rule::non_zero, space);
    triangle_list out;
    if (!filled || constrained_delaunay{}(*filled, space, out)) return {};
    const auto points = filled->points();
    std::unordered_map<std::uint64_t, std::size_t> seen;  // the triangle at a directed edge
    std::vector<std::size_t> cell(out.size());
    const auto root = [&](std::size_t t) {
        while (cell[t] != t) t = cell[t];
        return t;
    };
    for (std::size_t t = 0; t < out.size(); ++t) {
        cell[t] = t;
        const std::uint32_t c[3] = {out[t].a, out[t].b, out[t].c};
        for (std::size_t i = 0; i < 3; ++i) {
            seen[std::uint64_t{c[i]} << 32 | c[(i + 1) % 3]] = t;
            const auto other = seen.find(std::uint64_t{c[(i + 1) % 3]} << 32 | c[i]);
            if (other == seen.end()) continue;
            const triangle u = out[other->second];
            if (test::oracle::circle_side(points[u.a], points[u.b], points[u.c], points[c[(i + 2) % 3]]) == 0)
                cell[root(t)] = root(other->second);
        }
    }
    std::vector<test::polyline> cells(out.size());
    for (std::size_t t = 0; t < out.size(); ++t)
        for (const std::uint32_t v : {out[t].a, out[t].b, out[t].c}) cells[root(t)].push_back(points[v]);
    return cells;
}

/// The cells in ascending order, whatever order they were made in.
std::vector<test::polyline> sorted(std::vector<test::polyline> cells)
{
    for (test::polyline& c : cells) {
        std::sort(c.begin(), c.end(), test::oracle::comes_first);
        c.erase(std::unique(c.begin(), c.end()), c.end());
    }
    cells.erase(std::remove(cells.begin(), cells.end(), test::polyline{}), cells.end());
    std::sort(cells.begin(), cells.end(), [](const test::polyline& a, const test::polyline& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), test::oracle::comes_first);
    });
    return cells;
}

}  // namespace

TEST_CASE("quarter turns and mirrors keep the cells of points on one circle", "[triangulate][delaunay]")
{
    for (const test::shape& s : test::delaunay_shapes()) {
        const auto cells = cells_of(s);
        const auto placed = [&](auto&& place) {
            auto moved = cells;
            for (test::polyline& c : moved) std::transform(c.begin(), c.end(), c.begin(), place);
            return sorted(moved);
        };
        INFO(s.name);
        CHECK_FALSE(cells.empty());
        CHECK((sorted(cells_of(test::turned(s, 90))) == placed([](grid_point p) { return grid_point{-p.y, p.x}; })));
        CHECK((sorted(cells_of(test::turned(s, 180))) == placed([](grid_point p) { return grid_point{-p.x, -p.y}; })));
        CHECK((sorted(cells_of(test::mirrored(s))) == placed([](grid_point p) { return grid_point{p.y, p.x}; })));
    }
}

TEST_CASE("all free diagonals among points on one circle start at the smallest", "[triangulate][delaunay]")
{
    for (const std::int32_t squared_radius : {25, 65, 325, 1105, 5525}) {
        const test::polyline circle = test::on_one_circle(squared_radius, 37);
        const auto triangles = mesh_of({"circle", {circle}}).triangles;
        const grid_point smallest = *std::min_element(circle.begin(), circle.end(), test::oracle::comes_first);
        CHECK(triangles.size() == circle.size() - 2);
        for (const auto& corners : triangles) CHECK(corners[0] == smallest);
    }
}

TEST_CASE("constrained_delaunay proves what monotone proves", "[triangulate][delaunay]")
{
    test::dice d{5};
    int accepted = 0;
    const auto compare = [&](const test::shape& s) {
        const contours loops = test::contours_of(s);
        workspace space;
        triangle_list by_sweep, out;
        const result<region> expected = monotone{}.prove(loops, space, by_sweep),
                             proven = constrained_delaunay{}.prove(loops, space, out);
        INFO(s);
        CHECK(bool(expected) == bool(proven));
        if (!proven) {
            CHECK(proven.error() == expected.error().code);
            CHECK(out.empty());
            return;
        }
        ++accepted;
        CHECK(test::oracle::broken_law(*proven, out.view()) == "");
        CHECK(test::oracle::broken_delaunay(*proven, out.view()) == "");
    };
    for (const test::corpus_shape& c : test::corpus("regions.txt")) compare(c.shape);
    for (int i = 0; i < 3000; ++i) {
        const int width = 3 + d.roll(7), count = 1 + d.roll(2);
        const test::shape s = test::random_polylines(d, count, 3, 4, width);
        compare(s);
    }
    CHECK(accepted > 200);
}

TEST_CASE("a Delaunay proof reports that memory ran out, and needs none once warm", "[triangulate][delaunay]")
{
    test::check_proving_memory(constrained_delaunay{}, test::square_with_holes(12, 24));
}

TEST_CASE("constrained_delaunay takes at most 220 bytes of scratch memory a point and 128 a loop",
          "[triangulate][delaunay]")
{
    for (const test::shape& s :
         {test::shape{"circle", {test::circle(50'000, 1e8)}}, test::shape{"star", {test::star(50'000, 1e8, 3)}},
          test::shape{"small star", {test::star(399, 1e8, 3)}}, test::shape{"rough", {test::rough_parabola(999, true)}},
          test::square_with_holes(60, 8), test::square_with_holes(60, 16), test::circle_with_holes(20'000, 2000)}) {
        const contours loops = test::contours_of(s);
        INFO(s.name);
        test::check_scratch_memory(constrained_delaunay{}, loops,
                                   220 * loops.points.size() + 128 * loops.contour_count());
    }
}

TEST_CASE("constrained_delaunay takes 100,000 points and thousands of holes", "[triangulate][delaunay]")
{
    for (const test::shape& s :
         {test::shape{"fine circle", {test::circle(100'000, 0x1p28)}},
          test::shape{"parabola", {test::parabola(100'000, true)}},
          test::shape{"parabola on its side", {test::parabola(100'000, false)}},
          test::shape{"star", {test::star(50'000, 2e8, 9)}},
          test::shape{"rough parabola", {test::rough_parabola(100'000, true)}}, test::square_with_holes(60, 16),
          test::circle_with_holes(20'000, 2000), test::shape{"spiral", {test::spiral(50'000, 60, 1'000'000)}}}) {
        INFO(s.name);
        const meshed m = mesh_of(s);
        CHECK(m.mistake == "");
        CHECK(m.triangles.size() > 39'000);
    }
}
