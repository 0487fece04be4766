// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/resolving_sweep.hpp>
#include <typemesh/fill/impl/snap_rounding.hpp>
#include <typemesh/fill/resolve.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

struct piece {
    grid_point from, to;
    detail::arrangement::edge home;
};

/// The pieces that snap rounding makes of contours. A sweep over them must have nothing to bend.
std::vector<piece> rounded(const test::shape& s)
{
    contours loops = test::contours_of(s);
    workspace space;
    REQUIRE(sort_points(loops, space));
    workspace::scope scratch{space};
    detail::arrangement a;
    detail::snap_rounding rounding{loops, 1'000'000};
    REQUIRE_FALSE(rounding.run(fill_rule::non_zero, space, scratch, a));
    std::vector<piece> pieces;
    for (std::uint32_t i = 0; i < a.count; ++i)
        pieces.push_back({a.segments[i].from, a.segments[i].to, a.home(a.segments[i])});
    detail::resolving_sweep sweep{a, fill_rule::non_zero};
    REQUIRE(sweep.run(space));
    CHECK_FALSE(sweep.again);
    return pieces;
}

/// Whether two pieces cross: neither ends on the other.
bool cross(const piece& p, const piece& q)
{
    return test::oracle::side(p.from, p.to, q.from) * test::oracle::side(p.from, p.to, q.to) < 0 &&
           test::oracle::side(q.from, q.to, p.from) * test::oracle::side(q.from, q.to, p.to) < 0;
}

test::shape random_shape(test::dice& d)
{
    const int kind = d.roll(3), length = 20 + d.roll(2000);
    return test::random_polylines(d, 1 + d.roll(2), 3, 9, [&](const test::polyline&, int n) {
        const std::int32_t x = kind == 0   ? d.roll(20)
                               : kind == 1 ? (n % 2) * length + d.roll(4)
                                           : (n % 2) * length / 4 + d.roll(4);
        return grid_point{x, kind == 0 ? d.roll(20) : kind == 1 ? d.roll(5) : (n % 2) * length + d.roll(5)};
    });
}

}  // namespace

TEST_CASE("Snap rounding leaves no crossing, and moves no point by more than half a cell", "[fill][snap_rounding]")
{
    test::dice d{81};
    for (int i = 0; i < 1500; ++i) {
        const test::shape s = random_shape(d);
        const std::vector<piece> pieces = rounded(s);
        INFO(s);
        bool crossing = false, moved = false;
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            for (std::size_t q = p + 1; q < pieces.size(); ++q) crossing = crossing || cross(pieces[p], pieces[q]);
            for (const grid_point x : {pieces[p].from, pieces[p].to}) {
                const auto [a, b] = pieces[p].home;
                const std::int64_t cell = std::abs(std::int64_t{b.x} - a.x) + std::abs(std::int64_t{b.y} - a.y);
                moved = moved || 2 * std::abs(orientation(a, b, x)) > cell;
            }
        }
        REQUIRE_FALSE(crossing);
        REQUIRE_FALSE(moved);
    }
}

TEST_CASE("A crossing sweep finds every crossing once, and whether it is a grid point", "[fill][crossing_sweep]")
{
    test::dice d{82};
    for (int i = 0; i < 4000; ++i) {
        test::shape s = random_shape(d);
        if (i % 7 == 0) s.loops.push_back(s.loops[0]);
        contours loops = test::contours_of(s);
        const fill_rule rule = i % 2 == 0 ? fill_rule::non_zero : fill_rule::even_odd;
        workspace space;
        REQUIRE(sort_points(loops, space));
        workspace::scope scratch{space};
        auto* const made = scratch.take<detail::net_edge>(loops.points.size());
        std::uint32_t count = 0;
        REQUIRE(detail::make_net_edges(loops, rule, space, made, count));
        const std::span<const detail::net_edge> edges{made, count};
        std::vector<std::pair<std::int64_t, bool>> all, mine;
        REQUIRE(detail::crossing_sweep::run(edges, scratch, space, [&](grid_point x, bool is_exact) noexcept {
            mine.emplace_back(detail::sweep_place(x), is_exact);
            return true;
        }));
        for (std::uint32_t p = 0; p < count; ++p) {
            for (std::uint32_t q = p + 1; q < count; ++q) {
                grid_point x;
                if (!crossing_of(edges[p].from, edges[p].to, edges[q].from, edges[q].to, x)) continue;
                all.emplace_back(detail::sweep_place(x), test::oracle::side(edges[p].from, edges[p].to, x) == 0 &&
                                                             test::oracle::side(edges[q].from, edges[q].to, x) == 0);
            }
        }
        std::sort(all.begin(), all.end());
        std::sort(mine.begin(), mine.end());
        INFO(s);
        REQUIRE(all == mine);
    }
}

TEST_CASE("A crossing sweep over net edges stops when its callback does", "[fill][crossing_sweep]")
{
    contours loops = test::contours_of({{{0, 0}, {90, 50}, {0, 10}, {90, 40}, {0, 20}, {90, 30}}});
    workspace space;
    REQUIRE(sort_points(loops, space));
    workspace::scope scratch{space};
    detail::net_edge edges[6];
    std::uint32_t count = 0, calls = 0;
    REQUIRE(detail::make_net_edges(loops, fill_rule::non_zero, space, edges, count));
    CHECK_FALSE(detail::crossing_sweep::run({edges, count}, scratch, space,
                                            [&](grid_point, bool) noexcept { return ++calls < 3; }));
    CHECK(calls == 3);
}

TEST_CASE("A segment meets the same hot pixels as a trial of all, in order", "[fill][hot_pixels]")
{
    test::dice d{83};
    for (int i = 0; i < 600; ++i) {
        const int width = 1 << (2 + d.roll(26)), count = d.roll(80);
        std::vector<grid_point> points;
        for (int k = 0; k < count; ++k) points.push_back({d.roll(width), d.roll(width)});
        std::sort(points.begin(), points.end(), lexicographic_less);
        points.erase(std::unique(points.begin(), points.end()), points.end());
        workspace space;
        workspace::scope scratch{space};
        detail::hot_pixels cells;
        REQUIRE(cells.open(points, scratch, space));
        for (int k = 0; k < 20; ++k) {
            grid_point a{d.roll(width), d.roll(width)}, b{d.roll(width), d.roll(width)};
            const int size = static_cast<int>(points.size());
            if (k % 2 == 0 && size > 1) a = points[static_cast<std::size_t>(d.roll(size))];
            if (k % 4 == 0 && size > 1) b = points[static_cast<std::size_t>(d.roll(size))];
            if (lexicographic_less(b, a)) std::swap(a, b);
            if (a == b) continue;
            std::vector<grid_point> met, expected;
            REQUIRE(cells.along(a, b, [&](detail::hot_pixels::hit h) noexcept {
                met.push_back(points[h.number]);
                CHECK(h.is_exact == (test::oracle::side(a, b, met.back()) == 0));
                return true;
            }));
            for (const grid_point p : points) {
                if (p == a || p == b || p.x < a.x || p.x > b.x || p.y < (std::min)(a.y, b.y) ||
                    p.y > (std::max)(a.y, b.y))
                    continue;
                if (detail::hot_pixels::comes_through(a, b, p)) expected.push_back(p);
            }
            std::sort(expected.begin(), expected.end(), [&](grid_point p, grid_point q) {
                return p.x != q.x ? p.x < q.x : a.y <= b.y ? p.y < q.y : q.y < p.y;
            });
            REQUIRE(met == expected);
        }
    }
    CHECK(detail::hot_pixels::comes_through({0, 0}, {4, 2}, {1, 0}));  // the corner of a half-open cell: from one side
    CHECK_FALSE(detail::hot_pixels::comes_through({0, 0}, {2, 2}, {1, 0}));
    CHECK_FALSE(detail::hot_pixels::comes_through({0, 0}, {2, 2}, {0, 1}));
}

TEST_CASE("A limit of more than 2^30 pieces counts as 2^30", "[fill][snap_rounding]")
{
    // Numbers of pieces are doubled, and grow by half, in 32 bits: a larger limit would overflow.
    constexpr std::uint32_t limits[] = {(1u << 30) - 1, 1u << 30, (1u << 30) + 1, 0xFFFF'FFFFu};
    for (const std::uint32_t most : limits) {
        contours loops = test::contours_of(test::shape{"bow tie", {{{0, 0}, {9, 7}, {9, 0}, {0, 7}}}});
        CHECK(detail::snap_rounding(loops, most).max_pieces() == (std::min)(most, 1u << 30));
    }
    test::dice d{99};
    for (int i = 0; i < 300; ++i) {
        const test::shape s = random_shape(d);
        contours usual = test::contours_of(s);
        workspace space;
        const auto wanted = resolve(usual, fill_rule::non_zero, space);
        for (const std::uint32_t most : limits) {
            contours loops = test::contours_of(s);
            const auto made = resolve(loops, fill_rule::non_zero, space, {.max_pieces = most});
            INFO(s << "at most " << most << " pieces");
            REQUIRE(bool(made) == bool(wanted));
            if (!made) continue;
            REQUIRE(std::ranges::equal(made->points(), wanted->points()));
        }
    }
}
