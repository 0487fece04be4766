// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

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

/// Fills and triangulates a shape: the triangles as a set, and the first law that they break. Without laws only shapes whose
/// loops do not meet: crossings are rounded to the grid, which turning and scaling change.
meshed mesh_of(const test::shape& s, bool lawful = true)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = lawful ? fill(loops, fill_rule::non_zero, space) : nest(loops, fill_rule::non_zero, space);
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
    std::sort(l.begin(), l.end(),
              [](grid_point a, grid_point b) { return std::atan2(a.y, a.x) < std::atan2(b.y, b.x); });
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
        l.push_back({static_cast<std::int32_t>(std::lround(0x1p27 * x)),
                     static_cast<std::int32_t>(std::lround(0x1p27 * x * x))});
    }
    if (!upwards)
        for (grid_point& p : l) p = {-p.y, p.x};
    return l;
}

/// The same with every other point moved, so that nothing is smooth.
test::polyline rough_parabola(int n, bool upwards)
{
    test::polyline l = parabola(n, upwards);
    const std::int32_t step = (1 << 28) / n;
    for (std::size_t i = 2; i + 2 < l.size(); i += 2) (upwards ? l[i].y : l[i].x) += (upwards ? 1 : -1) * step;
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
    all.push_back({"rough parabola", {rough_parabola(1500, true)}});
    all.push_back({"rough parabola on its side", {rough_parabola(1500, false)}});
    all.push_back({"fine ring", {test::circle(2000, 1e8), test::reversed(test::circle(1500, 9e7))}});
    all.push_back({"thin fine ring", {test::circle(2000, 1e8), test::reversed(test::circle(1500, 9.99e7))}});
    return all;
}

}  // namespace

TEST_CASE("constrained_delaunay makes every edge Delaunay", "[triangulate][delaunay]")
{
    for (const test::shape& s : delaunay_shapes()) {
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
        const test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(n, width, d)}};
        const std::string mistake = mesh_of(s).mistake;
        if (!mistake.empty()) {
            INFO(s);
            CHECK(mistake == "");
        }
    }
}

TEST_CASE("the Delaunay triangles do not depend on where contours begin or how they are ordered",
          "[triangulate][delaunay]")
{
    for (const test::shape& s : delaunay_shapes()) {
        const auto triangles = mesh_of(s, false).triangles;
        for (std::uint64_t seed = 0; seed < 4; ++seed) {
            INFO(s.name << ", shuffle " << seed);
            CHECK((mesh_of(test::shuffled(s, seed), false).triangles == triangles));
        }
    }
}

TEST_CASE("integer shifts and powers of two leave the Delaunay triangles as they are", "[triangulate][delaunay]")
{
    for (const test::shape& s : delaunay_shapes()) {
        std::int32_t reach = 1;
        for (const test::polyline& l : s.loops)
            for (const grid_point p : l) reach = (std::max)({reach, std::abs(p.x), std::abs(p.y)});
        const auto triangles = mesh_of(s, false).triangles;
        const auto moved = [&](std::int32_t scale, std::int32_t dx, std::int32_t dy) {
            const auto place = [&](grid_point p) { return grid_point{p.x * scale + dx, p.y * scale + dy}; };
            test::shape t = s;
            for (test::polyline& l : t.loops) std::transform(l.begin(), l.end(), l.begin(), place);
            auto expected = triangles;
            for (auto& corners : expected) std::transform(corners.begin(), corners.end(), corners.begin(), place);
            INFO(s.name << " times " << scale << " plus " << dx << ", " << dy);
            CHECK((mesh_of(t, false).triangles == expected));
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

/// Triangles none of whose edges could as well be the other diagonal of four points on one circle.
std::vector<test::oracle::placed_triangle> outside_cells(const test::shape& s)
{
    contours loops = test::contours_of(s);
    workspace space;
    const result<region> filled = fill(loops, fill_rule::non_zero, space);
    triangle_list out;
    if (!filled || constrained_delaunay{}(*filled, space, out)) return {};
    const auto points = filled->points();
    std::unordered_map<std::uint64_t, std::uint32_t> opposite;
    for (const triangle t : out) {
        const std::uint32_t c[3] = {t.a, t.b, t.c};
        for (std::size_t i = 0; i < 3; ++i) opposite[std::uint64_t{c[i]} << 32 | c[(i + 1) % 3]] = c[(i + 2) % 3];
    }
    std::vector<triangle> alone;
    for (const triangle t : out) {
        const std::uint32_t c[3] = {t.a, t.b, t.c};
        bool is_alone = true;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto other = opposite.find(std::uint64_t{c[(i + 1) % 3]} << 32 | c[i]);
            is_alone = is_alone &&
                       (other == opposite.end() ||
                        test::oracle::circle_side(points[t.a], points[t.b], points[t.c], points[other->second]) != 0);
        }
        if (is_alone) alone.push_back(t);
    }
    return test::oracle::as_set(points, alone);
}

}  // namespace

TEST_CASE("quarter turns and mirrors leave the Delaunay triangles outside cells of co-circular points as they are",
          "[triangulate][delaunay]")
{
    for (const test::shape& s : delaunay_shapes()) {
        const auto triangles = outside_cells(s);
        const auto sorted = [](std::vector<test::oracle::placed_triangle> set, auto&& place, bool turns_round) {
            for (auto& corners : set) {
                std::transform(corners.begin(), corners.end(), corners.begin(), place);
                if (turns_round) std::reverse(corners.begin(), corners.end());
                std::rotate(corners.begin(),
                            std::min_element(corners.begin(), corners.end(), test::oracle::comes_first), corners.end());
            }
            std::sort(set.begin(), set.end(), test::oracle::operator_less);
            return set;
        };
        INFO(s.name);
        CHECK((outside_cells(test::turned(s, 90)) == sorted(
                                                         triangles,
                                                         [](grid_point p) {
                                                             return grid_point{-p.y, p.x};
                                                         },
                                                         false)));
        CHECK((outside_cells(test::turned(s, 180)) == sorted(
                                                          triangles,
                                                          [](grid_point p) {
                                                              return grid_point{-p.x, -p.y};
                                                          },
                                                          false)));
        CHECK((outside_cells(test::mirrored(s)) == sorted(
                                                       triangles,
                                                       [](grid_point p) {
                                                           return grid_point{p.y, p.x};
                                                       },
                                                       true)));
    }
}

TEST_CASE("all free diagonals among points on one circle leave the smallest", "[triangulate][delaunay]")
{
    for (const std::int32_t squared_radius : {25, 65, 325, 1105, 5525}) {
        const test::polyline circle = on_one_circle(squared_radius, 37);
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
        test::shape s{"polylines " + std::to_string(i), {}};
        for (int c = 0; c < count; ++c) {
            test::polyline l;
            for (int n = 3 + d.roll(4); n > 0; --n) l.push_back({d.roll(width), d.roll(width)});
            s.loops.push_back(l);
        }
        compare(s);
    }
    CHECK(accepted > 200);
}

TEST_CASE("proving Delaunay triangles without memory says so, and after warming up asks for none",
          "[triangulate][delaunay]")
{
    const contours loops = test::contours_of(test::square_with_holes(12, 24));
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out{memory.source()};
        memory.fail_at = nth;
        memory.fail_once = true;
        const result<region> proven = constrained_delaunay{}.prove(loops, space, out);
        const bool was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        INFO("request " << nth);
        if (!proven) {
            CHECK(proven.error() == error::out_of_memory);
            CHECK(out.empty());
        }
        out.clear();
        REQUIRE(constrained_delaunay{}.prove(loops, space, out));
        const std::size_t warm = memory.requests;
        out.clear();
        REQUIRE(constrained_delaunay{}.prove(loops, space, out));
        CHECK(memory.requests == warm);
        if (!was_asked) break;
    }
}

TEST_CASE("constrained_delaunay takes at most 230 bytes of scratch memory a point and 128 a loop",
          "[triangulate][delaunay]")
{
    for (const test::shape& s : {test::shape{"circle", {test::circle(50'000, 1e8)}},
                                 test::shape{"star", {test::star(50'000, 1e8, 3)}}, test::square_with_holes(60, 8)}) {
        const contours loops = test::contours_of(s);
        const auto wanted = static_cast<std::size_t>(230.0 * static_cast<double>(loops.points.size())) +
                            128 * loops.contour_count() + 64 * 64;
        test::counting_memory memory;
        workspace measured{memory.source()};
        {
            workspace::scope whole{measured};
            REQUIRE(whole.take<char>(wanted) != nullptr);
        }
        const std::size_t before = memory.requests;
        triangle_list out;
        INFO(s.name);
        REQUIRE(constrained_delaunay{}.prove(loops, measured, out));
        CHECK(memory.requests == before);
    }
}

TEST_CASE("constrained_delaunay takes 100,000 points and thousands of holes", "[triangulate][delaunay]")
{
    for (const test::shape& s :
         {test::shape{"fine circle", {test::circle(100'000, 0x1p28)}},
          test::shape{"parabola", {parabola(100'000, true)}},
          test::shape{"parabola on its side", {parabola(100'000, false)}},
          test::shape{"star", {test::star(50'000, 2e8, 9)}},
          test::shape{"rough parabola", {rough_parabola(100'000, true)}}, test::square_with_holes(60, 16),
          test::circle_with_holes(20'000, 2000), test::shape{"spiral", {test::spiral(50'000, 60, 1'000'000)}}}) {
        INFO(s.name);
        const meshed m = mesh_of(s);
        CHECK(m.mistake == "");
        CHECK(m.triangles.size() > 39'000);
    }
}
