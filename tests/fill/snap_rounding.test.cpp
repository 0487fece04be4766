// SPDX-License-Identifier: MIT

#include <typemesh/fill/resolving_sweep.hpp>
#include <typemesh/fill/snap_rounding.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

struct piece {
    grid_point from, to;
    detail::arrangement::edge home;
};

/// What snap rounding makes of contours; a walk over that must have nothing to bend.
std::vector<piece> rounded(const test::shape& s, bool all)
{
    const contours loops = test::contours_of(s);
    workspace space;
    workspace::scope scratch{space};
    detail::arrangement a;
    REQUIRE(a.reserve(scratch, 400));
    REQUIRE(a.take_apart(loops, space));
    REQUIRE((all ? detail::snap_rounding::run_all(a, scratch, space)
                 : detail::snap_rounding::run(a, {}, scratch, space)));
    std::vector<piece> pieces;
    for (std::uint32_t i = 0; i < a.count; ++i)
        pieces.push_back({a.stretches[i].from, a.stretches[i].to, a.home(a.stretches[i])});
    if (!all) return pieces;
    REQUIRE((a.reserve(scratch, 4 * a.count + 64) && a.put_in_order(space)));
    detail::resolving_sweep sweep{a, fill_rule::non_zero};
    REQUIRE(sweep.run(space));
    CHECK_FALSE(sweep.again);
    return pieces;
}

/// Whether two pieces have more in common than ends, or than all.
bool cross(const piece& p, const piece& q)
{
    if (p.from == q.from && p.to == q.to) return false;
    if (!test::oracle::meet(p.from, p.to, q.from, q.to)) return false;
    const auto inner = [](grid_point x, const piece& e) {
        return !(x == e.from) && !(x == e.to) && test::oracle::lies_on(x, e.from, e.to);
    };
    if (inner(p.from, q) || inner(p.to, q) || inner(q.from, p) || inner(q.to, p)) return true;
    return !(p.from == q.from || p.from == q.to || p.to == q.from || p.to == q.to);
}

test::shape random_shape(test::dice& d)
{
    test::shape s{"shape", {}};
    const int kind = d.roll(3), length = 20 + d.roll(2000);
    for (int c = 1 + d.roll(2); c > 0; --c) {
        test::polyline l;
        for (int n = 3 + d.roll(9); n > 0; --n) {
            if (kind == 0)
                l.push_back({d.roll(20), d.roll(20)});
            else if (kind == 1)
                l.push_back({(n % 2) * length + d.roll(4), d.roll(5)});
            else
                l.push_back({(n % 2) * length / 4 + d.roll(4), (n % 2) * length + d.roll(5)});
        }
        s.loops.push_back(l);
    }
    return s;
}

}  // namespace

TEST_CASE("Snap rounding leaves no two pieces that cross, moves none by more than half a cell, and is believed at once",
          "[fill][snap_rounding]")
{
    test::dice d{81};
    for (int i = 0; i < 1500; ++i) {
        const test::shape s = random_shape(d);
        const std::vector<piece> pieces = rounded(s, true);
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

TEST_CASE("The sweep that swaps neighbours finds nearly all crossings, each once, and no other",
          "[fill][crossing_sweep]")
{
    test::dice d{82};
    std::size_t found = 0, there = 0;
    for (int i = 0; i < 1500; ++i) {
        const test::shape s = random_shape(d);
        const contours loops = test::contours_of(s);
        workspace space;
        workspace::scope scratch{space};
        detail::arrangement a;
        REQUIRE(a.reserve(scratch, 400));
        REQUIRE(a.take_apart(loops, space));
        detail::growing<grid_point> out{scratch};
        REQUIRE(detail::crossing_sweep::run(a, scratch, out));
        std::vector<std::int64_t> all, mine;
        for (std::uint32_t p = 0; p < a.count; ++p) {
            for (std::uint32_t q = p + 1; q < a.count; ++q) {
                grid_point x;
                const detail::stretch &e = a.stretches[p], &f = a.stretches[q];
                if (crossing_of(e.from, e.to, f.from, f.to, x)) all.push_back(detail::sweep_place(x));
            }
        }
        for (std::size_t k = 0; k < out.count; ++k) mine.push_back(detail::sweep_place(out.values[k]));
        std::sort(all.begin(), all.end());
        std::sort(mine.begin(), mine.end());
        INFO(s);
        REQUIRE(std::includes(all.begin(), all.end(), mine.begin(), mine.end()));
        found += mine.size();
        there += all.size();
    }
    CHECK(found * 20 > there * 19);
}

TEST_CASE("A segment comes through exactly the hot cells that trying all of them finds, in its own order",
          "[fill][hot_cells]")
{
    test::dice d{83};
    for (int i = 0; i < 600; ++i) {
        const int width = 1 << (2 + d.roll(26)), count = d.roll(80);
        std::vector<grid_point> points;
        for (int k = 0; k < count; ++k) points.push_back({d.roll(width), d.roll(width)});
        workspace space;
        workspace::scope scratch{space};
        detail::hot_cells cells;
        REQUIRE(cells.open(points, scratch));
        for (int k = 0; k < 20; ++k) {
            grid_point a{d.roll(width), d.roll(width)}, b{d.roll(width), d.roll(width)};
            if (k % 2 == 0 && count > 1) a = points[static_cast<std::size_t>(d.roll(count))];
            if (k % 4 == 0 && count > 1) b = points[static_cast<std::size_t>(d.roll(count))];
            if (lexicographic_less(b, a)) std::swap(a, b);
            if (a == b) continue;
            std::vector<grid_point> met, expected;
            REQUIRE(cells.along(a, b, [&](grid_point p) noexcept { return met.push_back(p), true; }));
            for (const grid_point p : points) {
                if (p.x < a.x || p.x > b.x || p.y < (std::min)(a.y, b.y) || p.y > (std::max)(a.y, b.y)) continue;
                if (detail::hot_cells::comes_through(a, b, p)) expected.push_back(p);
            }
            std::sort(expected.begin(), expected.end(), [&](grid_point p, grid_point q) {
                return p.x != q.x ? p.x < q.x : a.y <= b.y ? p.y < q.y : q.y < p.y;
            });
            expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
            REQUIRE(met == expected);
        }
    }
    CHECK(detail::hot_cells::comes_through({0, 0}, {4, 2}, {1, 0}));  // the corner of a half-open cell: from one side
    CHECK_FALSE(detail::hot_cells::comes_through({0, 0}, {2, 2}, {1, 0}));
    CHECK_FALSE(detail::hot_cells::comes_through({0, 0}, {2, 2}, {0, 1}));
}
