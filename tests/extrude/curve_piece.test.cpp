// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/curve_piece.hpp>

#include "support/catch.hpp"

#include <algorithm>
#include <random>

using namespace typemesh;

namespace {

detail::curve_piece straight_piece(grid_point a, grid_point b)
{
    detail::curve_piece p;
    p.start = a;
    p.end = b;
    return p;
}

detail::curve_piece arc_piece(grid_point a, grid_point c, grid_point b)
{
    detail::curve_piece p = straight_piece(a, b);
    p.control = c;
    p.weight = 1.0f;
    return p;
}

bool both_ways(const detail::curve_piece& p, const detail::curve_piece& q)
{
    const bool meet = pieces_meet(p, q);
    CHECK(pieces_meet(q, p) == meet);
    return meet;
}

}  // namespace

TEST_CASE("pieces may share their ends but nothing else", "[extrude][curved]")
{
    const auto arc = arc_piece({0, 0}, {10, -10}, {20, 0});
    CHECK(arc.doubled_area() > 0);
    CHECK(arc_piece({0, 0}, {10, 10}, {20, 0}).doubled_area() < 0);
    CHECK(straight_piece({0, 0}, {20, 0}).doubled_area() == 0);

    // The next piece, straight on, and back into the triangle.
    CHECK_FALSE(both_ways(arc, arc_piece({20, 0}, {30, 10}, {40, 0})));
    CHECK_FALSE(both_ways(arc, straight_piece({20, 0}, {0, 20})));
    CHECK(both_ways(arc, straight_piece({20, 0}, {10, -5})));
    CHECK(both_ways(arc, arc_piece({20, 0}, {12, -2}, {12, -4})));
    // Along an edge.
    CHECK(both_ways(arc, straight_piece({20, 0}, {15, -5})));
    CHECK(both_ways(arc, straight_piece({20, 0}, {0, -20})));
    CHECK(both_ways(arc, straight_piece({20, 0}, {0, 0})));
    CHECK_FALSE(both_ways(arc, straight_piece({20, 0}, {40, 20})));
    // The control point and the inside of an edge are no ends.
    CHECK(both_ways(arc, straight_piece({10, -10}, {10, -20})));
    CHECK(both_ways(arc, straight_piece({10, 0}, {10, 20})));
    CHECK(both_ways(arc, arc_piece({0, -20}, {10, -10}, {20, -20})));
    // One inside of the other.
    CHECK(both_ways(arc, straight_piece({9, -4}, {11, -4})));
    CHECK(both_ways(arc, arc_piece({9, -4}, {10, -5}, {11, -4})));
    // Two arcs over one chord, on both sides and on one side: the chord is common.
    CHECK(both_ways(arc, arc_piece({20, 0}, {10, 10}, {0, 0})));
    CHECK(both_ways(arc, arc_piece({20, 0}, {10, -4}, {0, 0})));
    // Apart.
    CHECK_FALSE(both_ways(arc, straight_piece({0, 1}, {20, 1})));
    CHECK_FALSE(both_ways(arc, straight_piece({0, -1}, {0, -20})));
}

TEST_CASE("pieces meet as their triangles do, by brute force", "[extrude][curved]")
{
    // Triangles with all corners on multiples of 12, compared in all places of a finer grid: two that overlap share a
    // place with both sides of each edge.
    std::mt19937 random{3};
    const auto corner = [&] {
        return grid_point{12 * static_cast<std::int32_t>(random() % 5), 12 * static_cast<std::int32_t>(random() % 5)};
    };
    std::size_t overlapping = 0, apart = 0;
    for (int tries = 0; tries < 3000; ++tries) {
        const grid_point p[] = {corner(), corner(), corner()}, q[] = {corner(), corner(), corner()};
        if (orientation(p[0], p[1], p[2]) == 0 || orientation(q[0], q[1], q[2]) == 0) continue;
        const auto inside = [](const grid_point* t, grid_point at) {
            const auto a = orientation(t[0], t[1], at), b = orientation(t[1], t[2], at),
                       c = orientation(t[2], t[0], at);
            return (a > 0 && b > 0 && c > 0) || (a < 0 && b < 0 && c < 0);
        };
        bool overlap = false;
        for (std::int32_t x = 0; x <= 48 && !overlap; ++x)
            for (std::int32_t y = 0; y <= 48 && !overlap; ++y) overlap = inside(p, {x, y}) && inside(q, {x, y});
        const bool meet = both_ways(arc_piece(p[0], p[1], p[2]), arc_piece(q[0], q[1], q[2]));
        if (overlap) CHECK(meet);
        overlapping += overlap;
        apart += !meet;
        // Boxes that are apart.
        const auto right = (std::max)({p[0].x, p[1].x, p[2].x}), left = (std::min)({q[0].x, q[1].x, q[2].x});
        if (right < left) CHECK_FALSE(meet);
    }
    CHECK(overlapping > 500);
    CHECK(apart > 200);
}

TEST_CASE("segments meet where they cross or touch", "[extrude][curved]")
{
    using detail::segments_meet;
    CHECK(segments_meet({0, 0}, {10, 10}, {0, 10}, {10, 0}));
    CHECK(segments_meet({0, 0}, {10, 0}, {5, 0}, {5, 5}));
    CHECK(segments_meet({0, 0}, {10, 0}, {10, 0}, {20, 5}));
    CHECK(segments_meet({0, 0}, {10, 0}, {5, 0}, {20, 0}));
    CHECK_FALSE(segments_meet({0, 0}, {10, 0}, {11, 0}, {20, 0}));
    CHECK_FALSE(segments_meet({0, 0}, {10, 0}, {5, 1}, {5, 5}));
    CHECK_FALSE(segments_meet({0, 0}, {10, 10}, {6, 5}, {20, 0}));
}
