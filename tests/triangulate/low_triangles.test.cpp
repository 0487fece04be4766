// SPDX-License-Identifier: MIT

// Triangles too low for 32-bit floats are exchanged wherever there is another way to cut.

#include <typemesh/fill/fill.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/impl/low_triangles.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/filled_shape.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>

using namespace typemesh;

namespace {

/// A grid on which triangles lower than so many cells are low.
grid grid_of(double low_cells) { return {.cells = 1.0, .units_per_em = low_cells * 0x1p20}; }

/// For small whole numbers only, which doubles square exactly.
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

/// What is wrong with the triangles of a shape where triangles below so many cells are low; `low` becomes their number.
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

TEST_CASE("no triangle of a polygon is low if one of its triangulations has none", "[triangulate][low]")
{
    test::dice d{5};
    std::size_t raised = 0, unavoidable = 0;
    for (int i = 0; i < 500; ++i) {
        const int width = 6 + d.roll(30), n = 4 + d.roll((std::min)(width * width / 4, 26));
        const test::shape s{"random polygon " + std::to_string(i), {test::random_polygon(n, width, d)}};
        for (const double cells : {0.25, 0.75, 1.5}) {  // whole numbers of cells an em
            for (const test::shape& t : {s, test::mirrored(s), test::turned(s, 90.0)}) {
                std::size_t low = 0;
                test::filled_shape f{t};
                triangle_list plain;
                REQUIRE_FALSE(monotone{}(f.filled, f.space, plain));
                const auto points = f.filled.points();
                const std::size_t before = low_of(points, plain.view(), cells);
                INFO(t << "below " << cells);
                REQUIRE(broken_law(t, cells, low) == "");
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

TEST_CASE("points one cell beside a long edge are cut without low triangles", "[triangulate][low]")
{
    // A slanted stem whose sides have points that rounding puts beside them, as in italics.
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

TEST_CASE("all kinds of shapes obey the laws when most triangles are low", "[triangulate][low]")
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
        for (const double cells : {1.5, 5.0, 20.0}) {  // some are low, many, all
            std::size_t low = 0;
            INFO(s << "below " << cells);
            CHECK(broken_law(s, cells, low) == "");
        }
    }
}

TEST_CASE("a long fan of low triangles is repaired with a table of neighbours", "[triangulate][low]")
{
    for (const int n : {40, 200, 3000}) {
        const test::shape s{"circle", {test::circle(n, 5e6)}};
        std::size_t low = 1, by_sweep = 1;
        const double cells = 5e6 * 10.0 / n / n;  // ears are much lower than this, and triangles across are higher
        INFO(n << " points");
        CHECK(broken_law(s, cells, low, fan{}) == "");
        CHECK(broken_law(s, cells, by_sweep) == "");
        CHECK(low <= by_sweep + static_cast<std::size_t>(n) / 20);
    }
}

TEST_CASE("one call raises all triangles that a second pass could raise", "[triangulate][low]")
{
    // Triangles of this strip that stay low at first have neighbours that are raised after them.
    const test::polyline strip{{2, 1},   {7, 4},   {14, 0},  {22, 2},  {30, 3},  {33, 4},  {39, 4},  {44, 3},  {51, 0},
                               {58, 4},  {62, 0},  {68, 4},  {73, 1},  {80, 0},  {86, 2},  {89, 2},  {91, 3},  {90, 16},
                               {84, 18}, {82, 15}, {74, 16}, {69, 17}, {61, 16}, {55, 14}, {52, 17}, {46, 17}, {43, 15},
                               {41, 16}, {40, 17}, {36, 16}, {30, 15}, {27, 14}, {25, 17}, {18, 15}};
    test::filled_shape f{{"strip", {strip}}, fill_rule::non_zero, grid_of(3.0)};
    triangle_list out;
    REQUIRE_FALSE(monotone{}(f.filled, f.space, out));
    const std::size_t low = low_of(f.filled.points(), out.view(), 3.0);
    CHECK(low > 0);
    REQUIRE_FALSE(raise_low_triangles(f.filled, out.view(), f.space));
    CHECK(low_of(f.filled.points(), out.view(), 3.0) == low);  // nothing was left for another pass
}

TEST_CASE("low triangles are raised without memory until a table is needed, and then it is reported",
          "[triangulate][low]")
{
    const test::filled_shape f{{"circle", {test::circle(500, 5e6)}}, fill_rule::non_zero, grid_of(2000.0)};
    for (std::size_t nth = 1;; ++nth) {
        test::counting_memory memory;
        workspace space{memory.source()};
        triangle_list out{memory.source()};
        REQUIRE(out.push_back({7, 8, 9}));
        memory.requests = 0;
        memory.fail_at = nth;
        const error e = monotone{}(f.filled, space, out);
        const bool was_asked = memory.requests >= nth;
        memory.fail_at = 0;
        if (!e) {
            CHECK(test::oracle::broken_law(f.filled, out.view().subspan(1)) == "");
            if (!was_asked) break;
            continue;
        }
        CHECK(e == error::out_of_memory);
        CHECK(out.size() == 1);
        REQUIRE_FALSE(monotone{}(f.filled, space, out));
        CHECK(test::oracle::broken_law(f.filled, out.view().subspan(1)) == "");
    }
}

TEST_CASE("the constrained Delaunay triangulation keeps its low triangles", "[triangulate][low]")
{
    test::dice d{9};
    for (int i = 0; i < 300; ++i) {
        const test::shape s{"random", {test::random_polygon(12, 12, d)}};
        test::filled_shape plain{s}, with_em{s, fill_rule::non_zero, grid_of(3.0)};
        triangle_list first, second;
        REQUIRE_FALSE(constrained_delaunay{}(plain.filled, plain.space, first));
        REQUIRE_FALSE(constrained_delaunay{}(with_em.filled, with_em.space, second));
        CHECK(std::ranges::equal(first, second));
    }
    STATIC_REQUIRE(has_final_diagonals<constrained_delaunay>);
    STATIC_REQUIRE(has_final_diagonals<monotone>);
    STATIC_REQUIRE_FALSE(has_final_diagonals<fan>);
}
