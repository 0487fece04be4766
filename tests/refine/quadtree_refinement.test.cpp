// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/quadtree_refinement.hpp>

#include <algorithm>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::balanced_quadtree;
using detail::quadtree_limits;
using detail::quadtree_refinement;

namespace {

/// Squares of this width, and edges of five thirds of it.
quadtree_limits squares_of(std::int32_t width, std::uint32_t most = 200'000)
{
    const std::int64_t longest = std::int64_t{width} * 5 / 3;
    return {width, longest * longest, most};
}

/// Refines a shape, and checks what holds for every shape.
void square_up(quadtree_refinement& refinement, const test::filled_shape& shape, const quadtree_limits& limits,
               test::refined_result& out)
{
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits));
    REQUIRE_FALSE(refinement.write(out.out()));
    CHECK(test::broken_refinement(shape.filled, out) == "");
    CHECK(test::is_delaunay(out));
}

std::int32_t size_of(const region& r)
{
    std::int32_t size = 0;
    for (const grid_point p : r.points()) size = (std::max)({size, std::abs(p.x), std::abs(p.y)});
    return size;
}

std::int64_t longest_square(const test::refined_result& cap)
{
    const std::vector<grid_point> p = cap.points();
    std::int64_t longest = 0;
    for (const auto& [edge, apex] : test::edges_of(cap))
        longest = (std::max)(longest, squared_distance(p[edge.first], p[edge.second]));
    return longest;
}

/// The corners of all leaves that are stored, and the lattice of the roots.
class leaf_corners {
public:
    explicit leaf_corners(const balanced_quadtree& tree) : width_{tree.width(0)}
    {
        for (std::uint32_t n = 0; n < tree.square_count(); ++n) {
            if (!tree.is_leaf(n)) continue;
            const auto [x, y] = tree.corner(n);
            const std::int32_t width = tree.width(tree.at(n).level);
            for (const int k : {0, 1, 2, 3}) stored_.insert({x + (k & 1) * width, y + (k >> 1) * width});
        }
    }
    [[nodiscard]] bool has(grid_point p) const
    {
        return (p.x % width_ == 0 && p.y % width_ == 0) || stored_.count({p.x, p.y}) != 0;
    }

private:
    std::int32_t width_;
    std::set<std::pair<std::int32_t, std::int32_t>> stored_;
};

std::vector<std::pair<std::int32_t, std::int32_t>> sorted_places(const test::refined_result& cap, int x, int y)
{
    std::vector<std::pair<std::int32_t, std::int32_t>> all;
    for (const grid_point p : cap.inner) all.push_back({x * p.x, y * p.y});
    std::sort(all.begin(), all.end());
    return all;
}

using corner_places = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// Each triangle as its corners in order, each coordinate times 1 or -1.
std::vector<corner_places> sorted_triangles(const test::refined_result& cap, int x, int y)
{
    const std::vector<grid_point> p = cap.points();
    std::vector<corner_places> all;
    for (const triangle t : cap.triangles) {
        corner_places one;
        for (const std::uint32_t i : {t.a, t.b, t.c}) one.push_back({x * p[i].x, y * p[i].y});
        std::sort(one.begin(), one.end());
        all.push_back(one);
    }
    std::sort(all.begin(), all.end());
    return all;
}

}  // namespace

TEST_CASE("squares keep every law, in all positions and at all sizes of a shape", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    std::size_t inner = 0;
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s)) || s.loops[0].size() > 1000 || s.name == "comb") continue;
        for (const test::shape& position : test::in_positions(s, {0.0, 33.0})) {
            if (!inspect::is_region(test::loops_of(position))) continue;
            INFO(position.name);
            const test::filled_shape shape{position};
            for (const int share : {1, 12}) {
                const std::int32_t width = (std::max)(16, size_of(shape.filled) / share);
                CAPTURE(width);
                square_up(refinement, shape, squares_of(width), out);
                CHECK(longest_square(out) <= squares_of(width).max_square);
                CHECK(refinement.kept() == 0);
                const leaf_corners corners{refinement.tree()};
                for (const grid_point p : out.inner) {
                    CHECK(corners.has(p));
                    CHECK_FALSE(refinement.tree().is_close(p));
                }
                inner += out.inner.size();
            }
        }
    }
    CHECK(inner > 10'000);
}

TEST_CASE("a shape on the lines of the squares becomes right isosceles triangles, two a square", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    for (const std::int32_t width : {64, 1024, 1536}) {
        //  +-----------+     twelve squares wide, with a step and a hole
        //  |   +---+   |
        //  |   +---+   +---+
        //  +---------------+
        const std::int32_t w = width;
        const test::filled_shape shape{test::shape{
            "steps",
            {{{-5 * w, -3 * w}, {7 * w, -3 * w}, {7 * w, 2 * w}, {4 * w, 2 * w}, {4 * w, 9 * w}, {-5 * w, 9 * w}},
             test::reversed(test::square(-2 * w, 3 * w, 3 * w))}}};
        square_up(refinement, shape, squares_of(width), out);
        CHECK(out.triangles.size() == 2 * (12 * 5 + 9 * 7 - 9));
        const std::vector<grid_point> p = out.points();
        std::size_t rising = 0;
        for (const triangle t : out.triangles) {
            std::int64_t sides[] = {squared_distance(p[t.a], p[t.b]), squared_distance(p[t.b], p[t.c]),
                                    squared_distance(p[t.c], p[t.a])};
            std::sort(sides, sides + 3);
            const std::int64_t side = std::int64_t{w} * w;
            CHECK((sides[0] == side && sides[1] == side && sides[2] == 2 * side));
        }
        for (const auto& [edge, apex] : test::edges_of(out)) {
            const grid_point a = p[edge.first], b = p[edge.second];
            if (a.x >= b.x || a.y == b.y) continue;
            const bool rises = a.y < b.y;
            // Like the fields of a chessboard; the square at the origin rises.
            const std::int32_t column = a.x / w, row = (rises ? a.y : b.y) / w;
            CHECK(rises == ((column + row) % 2 == 0));
            rising += rises;
        }
        CHECK(rising == (12 * 5 + 9 * 7 - 9) / 2);
    }
}

TEST_CASE("away from the outline, angles are 45 degrees, and 26.5 between squares of two widths", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    std::size_t plain = 0, between = 0;
    for (const test::shape& s : {test::circle_with_holes(60, 3), test::circle_with_holes(500, 100),
                                 test::shape{"star", {test::star(60, 1'000'000, 1)}}}) {
        const test::filled_shape shape{s};
        square_up(refinement, shape, squares_of(size_of(shape.filled) / 25), out);
        const balanced_quadtree& tree = refinement.tree();
        const std::vector<grid_point> p = out.points();
        std::set<std::pair<std::int32_t, std::int32_t>> points;
        for (const grid_point q : out.inner) points.insert({q.x, q.y});
        for (const triangle t : out.triangles) {
            const std::int64_t x = (std::int64_t{p[t.a].x} + p[t.b].x + p[t.c].x) / 3,
                               y = (std::int64_t{p[t.a].y} + p[t.b].y + p[t.c].y) / 3;
            const std::uint32_t leaf = tree.leaf_at(x, y);
            if (leaf != balanced_quadtree::none && tree.at(leaf).first_entry != balanced_quadtree::none) continue;
            const std::int64_t width = tree.width(tree.level_at(x, y)),
                               left = width * balanced_quadtree::divided(x, width),
                               low = width * balanced_quadtree::divided(y, width);
            std::size_t corners = 0;
            for (const int k : {0, 1, 2, 3})
                corners += points.count({std::int32_t(left + (k & 1) * width), std::int32_t(low + (k >> 1) * width)});
            if (corners != 4) continue;
            // The triangle lies in its square, and has one of the angles of the templates.
            bool is_plain = true;
            for (const auto& [o, a, b] : {std::tuple{t.a, t.b, t.c}, {t.b, t.c, t.a}, {t.c, t.a, t.b}}) {
                CHECK((p[o].x >= left && p[o].x <= left + width && p[o].y >= low && p[o].y <= low + width));
                const std::int64_t sine = orientation(p[o], p[a], p[b]),
                                   cosine = (std::int64_t{p[a].x} - p[o].x) * (p[b].x - p[o].x) +
                                            (std::int64_t{p[a].y} - p[o].y) * (p[b].y - p[o].y);
                CHECK(2 * sine >= cosine);
                is_plain = is_plain && sine >= cosine;
            }
            ++(is_plain ? plain : between);
        }
    }
    CHECK(plain > 2000);
    CHECK(between > 100);
}

TEST_CASE("a shape that is mirrored about an axis gets the mirrored points and triangles", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out, other;
    test::dice d{8};
    std::size_t inner = 0;
    for (int round = 0; round < 60; ++round) {
        test::shape s = round == 0 ? test::circle_with_holes(60, 3)
                                   : test::shape{"random polygon", {test::random_polygon(5 + d.roll(20), 20, d)}};
        const std::int32_t factor = round == 0 ? 1 : 1000 + d.roll(50'000);
        for (test::polyline& l : s.loops)
            for (grid_point& p : l) p = {factor * p.x - 9 * factor, factor * p.y - 7 * factor};
        if (!inspect::is_region(test::loops_of(s))) continue;
        const test::filled_shape shape{s};
        const quadtree_limits limits = squares_of((std::max)(64, size_of(shape.filled) / (3 + d.roll(20))));
        square_up(refinement, shape, limits, out);
        for (const auto& [x, y] : {std::pair{-1, 1}, {1, -1}, {-1, -1}}) {
            INFO(s << " times " << x << ' ' << y << ", squares of " << limits.width);
            test::shape mirrored = s;
            for (test::polyline& l : mirrored.loops) {
                for (grid_point& p : l) p = {x * p.x, y * p.y};
                if (x != y) std::reverse(l.begin(), l.end());
            }
            square_up(refinement, test::filled_shape{mirrored}, limits, other);
            CHECK((sorted_places(other, x, y) == sorted_places(out, 1, 1)));
        }
        inner += out.inner.size();
    }
    CHECK(inner > 1000);
    // On the lines of the squares, the triangles are mirrored as well.
    const test::filled_shape whole{test::shape{"square", {test::square(-4096, -4096, 8192)}}};
    square_up(refinement, whole, squares_of(1024), out);
    for (const auto& [x, y] : {std::pair{-1, 1}, {1, -1}, {-1, -1}})
        CHECK((sorted_triangles(out, x, y) == sorted_triangles(out, 1, 1)));
}

TEST_CASE("an edge is cut on the lines of the squares, or halved", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    // A square that no line touches, and one that is turned: its sides are cut at both kinds of lines.
    for (const double degrees : {0.0, 10.0, 30.0, 60.0}) {
        const test::filled_shape shape{
            test::turned(test::shape{"square", {test::square(-33'333, -33'333, 66'666)}}, degrees)};
        square_up(refinement, shape, squares_of(4096), out);
        std::size_t on_lines = 0;
        for (std::size_t i = 0; i < out.loops.points.size(); ++i) {
            const grid_point p = out.loops.points[i];
            on_lines += p.x % 4096 == 0 || p.y % 4096 == 0;
        }
        CAPTURE(degrees, on_lines, out.loops.points.size());
        CHECK(on_lines + 8 >= out.loops.points.size());
        CHECK(on_lines > 40);
    }
}

TEST_CASE("a long gap of a few cells ends, and does not split squares without end", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    std::size_t gaps = 0;
    for (const test::shape& s : test::generated_regions()) {
        if (s.name != "largest square with a hole up to its edges") continue;
        const test::filled_shape shape{s};
        square_up(refinement, shape, squares_of((std::max)(16, size_of(shape.filled) / 20)), out);
        CHECK(out.triangles.size() < 60'000);
        ++gaps;
    }
    CHECK(gaps == 1);
}

TEST_CASE("random polygons become squares, however narrow they are", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    test::dice d{10};
    for (int round = 0; round < 200; ++round) {
        const int width = 5 + d.roll(60);
        test::shape s{"random polygon",
                      {test::random_polygon(6 + d.roll((std::min)(width * width / 4, 200)), width, d)}};
        const std::int32_t factor = 1 + d.roll(3) * d.roll(5000);
        for (grid_point& p : s.loops[0]) p = {factor * p.x, factor * p.y};
        if (!inspect::is_region(test::loops_of(s))) continue;
        INFO(s);
        const test::filled_shape shape{s};
        const quadtree_limits limits = squares_of((std::max)(16, size_of(shape.filled) / (1 + d.roll(30))));
        square_up(refinement, shape, limits, out);
        CHECK(longest_square(out) <= limits.max_square);
    }
}

TEST_CASE("corners are found around bays, also where rows of corners pass through the outline's points", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    test::dice d{51};
    std::size_t inner = 0;
    for (int round = 0; round < 150; ++round) {
        test::shape s{"random polygon", {test::random_polygon(8 + d.roll(40), 12, d)}};
        for (grid_point& p : s.loops[0]) p = {256 * p.x, 256 * p.y};
        if (!inspect::is_region(test::loops_of(s))) continue;
        INFO(s);
        square_up(refinement, test::filled_shape{s}, squares_of(round % 2 == 0 ? 64 : 48), out);
        inner += out.inner.size();
    }
    CHECK(inner > 10'000);
}

TEST_CASE("the number of squares and points grows with the outline, if its shape repeats", "[refine]")
{
    quadtree_refinement refinement;
    test::refined_result out;
    std::vector<double> points, squares;
    for (const int teeth : {10, 60, 360}) {
        test::shape s{"comb", {test::comb(teeth, 40)}};
        for (grid_point& p : s.loops[0]) p = {1000 * p.x, 1000 * p.y};
        const test::filled_shape shape{s};
        square_up(refinement, shape, squares_of(1 << 13), out);
        points.push_back(double(refinement.mesh().vertex_count()) / double(shape.filled.points().size()));
        squares.push_back(double(refinement.tree().square_count()) / double(shape.filled.points().size()));
    }
    CAPTURE(points, squares);
    CHECK(points[2] < 1.1 * points[1]);
    CHECK(squares[2] < 1.1 * squares[1]);
}

TEST_CASE("more points than are allowed are refused, on the outline and inside", "[refine]")
{
    quadtree_refinement refinement;
    workspace space;
    const test::filled_shape shape{test::shape{"square", {test::square(0, 0, 1 << 20)}}};
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    CHECK_FALSE(refinement.run(shape.filled, given.view(), squares_of(1 << 14, 65 * 65)));
    CHECK(refinement.mesh().vertex_count() == 65 * 65);
    for (const std::uint32_t most : {65u * 65 - 1, 4000u, 4u * 64 - 1, 100u, 3u}) {
        CAPTURE(most);
        CHECK(refinement.run(shape.filled, given.view(), squares_of(1 << 14, most)) == error::too_many_points);
    }
    // Squares of 16 cells on the largest shape would need 2^50 points.
    const test::filled_shape largest{test::shape{"largest square", {test::square(-(1 << 28), -(1 << 28), 1 << 29)}}};
    given.clear();
    REQUIRE_FALSE(monotone{}(largest.filled, space, given));
    CHECK(refinement.run(largest.filled, given.view(), squares_of(16)) == error::too_many_points);
}

TEST_CASE("squares without memory say so, and ask for none once they are warm", "[refine]")
{
    const test::filled_shape shape{test::circle_with_holes(60, 3)};
    const quadtree_limits limits = squares_of(size_of(shape.filled) / 8);
    workspace space;
    triangle_list given;
    REQUIRE_FALSE(monotone{}(shape.filled, space, given));
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        quadtree_refinement refinement{memory.source()};
        test::refined_result out{memory.source()};
        error e = refinement.run(shape.filled, given.view(), limits);
        if (!e) e = refinement.write(out.out());
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
        memory.fail_at = 0;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(test::broken_refinement(shape.filled, out) == "");
        const std::size_t warm = memory.requests;
        REQUIRE_FALSE(refinement.run(shape.filled, given.view(), limits));
        REQUIRE_FALSE(refinement.write(out.out()));
        CHECK(memory.requests == warm);
    }
}
