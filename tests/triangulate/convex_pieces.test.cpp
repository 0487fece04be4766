// SPDX-License-Identifier: MIT

#include <typemesh/triangulate/convex_pieces.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/filled_shape.hpp"
#include "support/regions.hpp"

#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

using namespace typemesh;

namespace {

/// Twice the area of a polygon.
std::int64_t doubled_polygon(array_view<const grid_point> points, array_view<const std::uint32_t> corners)
{
    std::int64_t sum = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += orientation(points[corners[0]], points[corners[i]], points[corners[i + 1]]);
    return sum;
}

/// The first law that pieces break, or none.
std::string broken_law_of_pieces(array_view<const grid_point> points, array_view<const triangle> triangles,
                                 const convex_pieces& pieces)
{
    std::int64_t area = 0, whole = 0;
    std::size_t corners = 0;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> piece_of;  // each directed edge's
    for (std::size_t k = 0; k < pieces.count(); ++k) {
        const auto p = pieces[k];
        if (p.size() < 3) return "a piece has fewer than three corners";
        int turns = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const std::uint32_t a = p[i], b = p[(i + 1) % p.size()], c = p[(i + 2) % p.size()];
            const std::int64_t turn = orientation(points[a], points[b], points[c]);
            if (turn < 0) return "a piece is not convex";
            turns += turn > 0;
            if (!piece_of.insert({{a, b}, k}).second) return "two pieces are on one side of an edge";
        }
        if (turns < 3) return "a piece has no area";
        area += doubled_polygon(points, p);
        corners += p.size();
    }
    for (const triangle& t : triangles) whole += orientation(points[t.a], points[t.b], points[t.c]);
    if (area != whole) return "the areas do not add up";
    if (corners - 2 * pieces.count() != triangles.size()) return "corners and triangles do not agree";
    // No two pieces could still be joined.
    for (const auto& [edge, k] : piece_of) {
        const auto other = piece_of.find({edge.second, edge.first});
        if (other == piece_of.end()) continue;
        const auto beside = [&](std::size_t piece, std::uint32_t corner, bool before) {
            const auto p = pieces[piece];
            std::size_t i = 0;
            while (p[i] != corner) ++i;
            return p[before ? (i + p.size() - 1) % p.size() : (i + 1) % p.size()];
        };
        const auto bend = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            return orientation(points[a], points[b], points[c]);
        };
        const std::uint32_t a = edge.first, b = edge.second;
        if (bend(beside(k, a, true), a, beside(other->second, a, false)) >= 0 &&
            bend(beside(other->second, b, true), b, beside(k, b, false)) >= 0)
            return "two pieces could be one";
    }
    return {};
}

}  // namespace

TEST_CASE("convex pieces are convex, cover the region once, and cannot be joined further", "[triangulate]")
{
    for (const test::shape& s : test::generated_regions()) {
        if (s.name == "largest star" || s.name == "large star" || s.name == "long spiral")
            continue;  // areas beyond 2^63, or slow
        INFO(s.name);
        test::filled_shape shape{s};
        for (const bool delaunay : {true, false}) {
            triangle_list cap;
            const error e = delaunay ? constrained_delaunay{}(shape.filled, shape.space, cap)
                                     : monotone{}(shape.filled, shape.space, cap);
            REQUIRE_FALSE(e);
            convex_pieces pieces;
            REQUIRE(pieces.find(shape.filled.points(), cap.view()));
            CHECK(broken_law_of_pieces(shape.filled.points(), cap.view(), pieces) == "");
            CHECK(pieces.count() <= cap.size());
            CHECK(pieces.starts().size() == pieces.count() + 1);
            CHECK(pieces.corners().size() == pieces.starts()[pieces.count()]);
        }
    }
}

TEST_CASE("convex pieces of some shapes are as few as possible", "[triangulate]")
{
    const auto count = [](const test::shape& s) {
        test::filled_shape shape{s};
        triangle_list cap;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, shape.space, cap));
        convex_pieces pieces;
        REQUIRE(pieces.find(shape.filled.points(), cap.view()));
        return pieces.count();
    };
    CHECK(count({"circle", {test::circle(100, 1'000'000)}}) == 1);
    CHECK(count({"two apart", {test::square(0, 0, 5), test::square(7, 1, 5)}}) == 2);
    CHECK(count({"L", {{{0, 0}, {9, 0}, {9, 2}, {2, 2}, {2, 9}, {0, 9}}}}) == 2);
    CHECK(count({"frame", {test::square(0, 0, 90), test::reversed(test::square(30, 30, 30))}}) == 4);
    CHECK(count({"a straight corner", {{{0, 0}, {5, 0}, {9, 0}, {9, 9}, {0, 9}}}}) == 1);
}

TEST_CASE("convex pieces refuse corners that are no points, and take nothing for an answer", "[triangulate]")
{
    const grid_point points[] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}};
    const triangle wrong[] = {{0, 1, 2}, {0, 2, 4}};
    convex_pieces pieces;
    CHECK(pieces.find(points, wrong).error() == error::bad_option);
    CHECK(pieces.count() == 0);
    REQUIRE(pieces.find(points, {}));
    CHECK(pieces.count() == 0);
    // Triangles with a point inside: a fan around it is one piece for each half turn at least.
    const grid_point fan[] = {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {4, 5}};
    const triangle around[] = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    REQUIRE(pieces.find(fan, around));
    CHECK(pieces.count() >= 2);
    std::int64_t area = 0;
    for (std::size_t k = 0; k < pieces.count(); ++k) area += doubled_polygon(fan, pieces[k]);
    CHECK(area == 2 * 81);
}

TEST_CASE("convex pieces allocate nothing the second time, and say when memory runs out", "[triangulate]")
{
    test::filled_shape shape{test::circle_with_holes(60, 3)};
    triangle_list cap;
    REQUIRE_FALSE(constrained_delaunay{}(shape.filled, shape.space, cap));
    test::counting_memory counted;
    convex_pieces pieces{counted.source()};
    REQUIRE(pieces.find(shape.filled.points(), cap.view()));
    const std::size_t warm = counted.requests, found = pieces.count();
    REQUIRE(pieces.find(shape.filled.points(), cap.view()));
    CHECK(counted.requests == warm);
    for (std::size_t n = 1; n <= warm; ++n) {
        test::counting_memory failing{.fail_at = n};
        convex_pieces poor{failing.source()};
        CHECK(poor.find(shape.filled.points(), cap.view()).error() == error::out_of_memory);
        CHECK(poor.count() == 0);
        failing.fail_at = 0;
        REQUIRE(poor.find(shape.filled.points(), cap.view()));
        CHECK(poor.count() == found);
    }
}
