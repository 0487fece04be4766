// SPDX-License-Identifier: MIT

// Triangles too low for 32-bit floats: exchanged wherever there is another way to cut.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/impl/low_triangles.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

using namespace typemesh;

namespace {

/// A grid on which triangles are low that are lower than so many cells.
grid grid_of(double low_cells) { return {.cells = 1.0, .units_per_em = low_cells * 0x1p20}; }

/// Small whole numbers only, which doubles square exactly.
bool is_low(grid_point a, grid_point b, grid_point c, double cells)
{
    const auto squared = [](grid_point p, grid_point q) {
        return std::pow(double(p.x) - q.x, 2) + std::pow(double(p.y) - q.y, 2);
    };
    const double longest = (std::max)({squared(a, b), squared(b, c), squared(c, a)});
    const auto doubled_area = static_cast<double>(orientation(a, b, c));
    return doubled_area * doubled_area < cells * cells * longest;
}

std::size_t low_of(std::span<const grid_point> points, std::span<const triangle> triangles, double cells)
{
    std::size_t low = 0;
    for (const triangle t : triangles) low += is_low(points[t.a], points[t.b], points[t.c], cells);
    return low;
}

/// The fewest low triangles that a polygon can be cut into, by looking through all its triangulations.
std::size_t fewest_low(const test::polyline& p, double cells)
{
    constexpr std::size_t none = 1'000'000;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> known;
    const auto over = [&](const auto& self, std::size_t i, std::size_t j) -> std::size_t {
        if (j == i + 1) return 0;
        const auto [at, is_new] = known.try_emplace({i, j}, none);
        if (!is_new) return at->second;
        std::size_t best = none;
        for (std::size_t k = i + 1; k < j; ++k)
            if (orientation(p[i], p[k], p[j]) > 0)
                best = (std::min)(best, self(self, i, k) + self(self, k, j) + is_low(p[i], p[k], p[j], cells));
        return known[{i, j}] = best;
    };
    return over(over, 0, p.size() - 1);
}

/// What is wrong with monotone's triangles of a shape where triangles below so many cells are low; `low` is told how
/// many there are.
template <class Triangulator = monotone>
std::string broken_law(const test::shape& s, double cells, std::size_t& low, Triangulator how = {})
{
    contours loops = test::contours_of(s);
    loops.grid = grid_of(cells);
    workspace space;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    if (!filled) return filled.error().message();
    triangle_list out, again;
    if (!out.push_back({7, 8, 9})) return "no memory";
    if (const error e = how(*filled, space, out)) return e.message();
    if (!(out[0] == triangle{7, 8, 9})) return "what was there before is overwritten";
    if (how(*filled, space, again) || !std::equal(again.begin(), again.end(), out.begin() + 1))
        return "the second time other triangles";
    low = low_of(filled->points(), again.view(), cells);
    return test::oracle::broken_law(*filled, again.view());
}

/// One fan from the last point, however low its triangles: for convex shapes.
struct fan {
    error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(r.points().size());
        triangle_list made;
        for (std::uint32_t i = 0; i + 2 < n; ++i)
            if (!made.push_back({n - 1, i, i + 1})) return error::out_of_memory;
        if (error e = raise_low_triangles(r, made.view(), space)) return e;
        return out.append(made.view()) ? error{} : error{error::out_of_memory};
    }
};

}  // namespace

TEST_CASE("no triangle of a polygon is low when all its triangulations hold one without", "[triangulate][low]")
{
    test::dice d{5};
    std::size_t raised = 0, unavoidable = 0;
    for (int i = 0; i < 500; ++i) {
        const int width = 6 + d.roll(30), n = 4 + d.roll((std::min)(width * width / 4, 26));
        const test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(n, width, d)}};
        for (const double cells : {0.25, 0.75, 1.5}) {  // whole numbers of cells an em
            for (const test::shape& t : {s, test::mirrored(s), test::turned(s, 90.0)}) {
                std::size_t before = 0, low = 0;
                contours loops = test::contours_of(t);
                workspace space;
                const auto filled = fill(loops, fill_rule::non_zero, space);
                REQUIRE(filled);
                triangle_list plain;
                REQUIRE_FALSE(monotone{}(*filled, space, plain));
                before = low_of(filled->points(), plain.view(), cells);
                INFO(t << "below " << cells);
                REQUIRE(broken_law(t, cells, low) == "");
                const auto points = filled->points();
                const std::size_t fewest = fewest_low({points.begin(), points.end()}, cells);
                CHECK((low == 0) == (fewest == 0));
                raised += before != 0 && low == 0;
                unavoidable += fewest != 0;
            }
        }
    }
    CHECK(raised > 150);
    CHECK(unavoidable > 30);
}

TEST_CASE("points that lie a cell beside a long edge are cut without low triangles", "[triangulate][low]")
{
    // A slanted stem, whose sides have points that rounding puts beside them: as in italics.
    for (const int count : {1, 2, 5, 20}) {
        test::polyline stem;
        for (int i = 0; i <= count + 1; ++i)
            stem.push_back({200'000 + 300'000 * i / (count + 1) + i % 2, 1'400'000 * i / (count + 1)});
        for (int i = count + 1; i >= 0; --i)
            stem.push_back({300'000 * i / (count + 1) - i % 2, 1'400'000 * i / (count + 1)});
        std::reverse(stem.begin(), stem.end());
        for (const double degrees : {0.0, 90.0, 180.0, 270.0}) {
            for (const bool mirror : {false, true}) {
                const test::shape turned = test::turned({"stem", {stem}}, degrees);
                std::size_t low = 1;
                INFO(count << " points a side, " << degrees << " degrees, mirrored " << mirror);
                CHECK(broken_law(mirror ? test::reversed(test::mirrored(turned)) : turned, 1.0, low) == "");
                CHECK(low == 0);
            }
        }
    }
}

TEST_CASE("shapes of all kinds obey the laws where most triangles are low", "[triangulate][low]")
{
    for (const test::shape& s : test::generated_regions()) {
        for (const double cells : {1.0, 30.0}) {
            for (const double degrees : {0.0, 33.0}) {
                const test::shape t = test::turned(s, degrees);
                std::size_t low = 0;
                INFO(t.name << ", below " << cells);
                CHECK(broken_law(t, cells, low) == "");
            }
        }
    }
}

TEST_CASE("around a hole no triangle is exchanged twice", "[triangulate][low]")
{
    test::dice d{8};
    for (int i = 0; i < 300; ++i) {
        test::polyline hole = test::random_polygon(3 + d.roll(10), 12, d);
        for (grid_point& p : hole) p = {p.x + 2, p.y + 2};
        const test::shape s{"hole " + std::to_string(i), {test::square(0, 0, 16), test::reversed(hole)}};
        for (const double cells : {1.5, 5.0, 20.0}) {  // low are some, many, all
            std::size_t low = 0;
            INFO(s << "below " << cells);
            CHECK(broken_law(s, cells, low) == "");
        }
    }
}

TEST_CASE("a long fan of low triangles is mended, with a table of neighbours", "[triangulate][low]")
{
    for (const int n : {40, 200, 3000}) {
        const test::shape s{"circle", {test::circle(n, 5e6)}};
        std::size_t low = 1, by_sweep = 1;
        const double cells = 5e6 * 10.0 / n / n;  // ears are lower by far than what is across, higher than this
        INFO(n << " points");
        CHECK(broken_law(s, cells, low, fan{}) == "");
        CHECK(broken_law(s, cells, by_sweep) == "");
        CHECK(low <= by_sweep + static_cast<std::size_t>(n) / 20);
    }
}

TEST_CASE("what one pass leaves low is raised by the next", "[triangulate][low]")
{
    // Triangles of this strip that stay low at first have neighbours that are raised after them.
    const test::polyline strip{{2, 1},   {7, 4},   {14, 0},  {22, 2},  {30, 3},  {33, 4},  {39, 4},  {44, 3},  {51, 0},
                               {58, 4},  {62, 0},  {68, 4},  {73, 1},  {80, 0},  {86, 2},  {89, 2},  {91, 3},  {90, 16},
                               {84, 18}, {82, 15}, {74, 16}, {69, 17}, {61, 16}, {55, 14}, {52, 17}, {46, 17}, {43, 15},
                               {41, 16}, {40, 17}, {36, 16}, {30, 15}, {27, 14}, {25, 17}, {18, 15}};
    contours loops = test::contours_of({"strip", {strip}});
    loops.grid = grid_of(3.0);
    workspace space;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    REQUIRE(filled);
    triangle_list out;
    REQUIRE_FALSE(monotone{}(*filled, space, out));
    const std::size_t low = low_of(filled->points(), out.view(), 3.0);
    CHECK(low > 0);
    REQUIRE_FALSE(raise_low_triangles(*filled, out.view(), space));
    CHECK(low_of(filled->points(), out.view(), 3.0) == low);  // so nothing was left to another pass
}

TEST_CASE("low triangles are mended without memory as far as a table is not needed, and say so where it is",
          "[triangulate][low]")
{
    contours loops = test::contours_of(test::shape{"circle", {test::circle(500, 5e6)}});
    loops.grid = grid_of(2000.0);
    workspace for_fill;
    const auto filled = fill(loops, fill_rule::non_zero, for_fill);
    REQUIRE(filled);
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out{memory.source()};
        REQUIRE(out.push_back({7, 8, 9}));
        memory.requests = 0;
        memory.fail_at = nth;
        const error e = monotone{}(*filled, space, out);
        const bool was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        if (!e) {
            CHECK(test::oracle::broken_law(*filled, out.view().subspan(1)) == "");
            if (!was_asked) break;
            continue;
        }
        CHECK(e == error::out_of_memory);
        CHECK(out.size() == 1);
        REQUIRE_FALSE(monotone{}(*filled, space, out));
        CHECK(test::oracle::broken_law(*filled, out.view().subspan(1)) == "");
    }
}

TEST_CASE("the constrained Delaunay triangulation keeps its low triangles", "[triangulate][low]")
{
    test::dice d{9};
    for (int i = 0; i < 300; ++i) {
        const test::shape s{"random", {test::random_polygon(12, 12, d)}};
        contours plain = test::contours_of(s), told = test::contours_of(s);
        told.grid = grid_of(3.0);
        workspace space;
        const auto a = fill(plain, fill_rule::non_zero, space), b = fill(told, fill_rule::non_zero, space);
        REQUIRE(a);
        REQUIRE(b);
        triangle_list first, second;
        REQUIRE_FALSE(constrained_delaunay{}(*a, space, first));
        REQUIRE_FALSE(constrained_delaunay{}(*b, space, second));
        CHECK(std::equal(first.begin(), first.end(), second.begin(), second.end()));
    }
    STATIC_REQUIRE(has_final_diagonals<constrained_delaunay>);
    STATIC_REQUIRE(has_final_diagonals<monotone>);
    STATIC_REQUIRE_FALSE(has_final_diagonals<fan>);
}
