// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/delaunay_check.hpp>
#include <typemesh/offset/impl/int128.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <string>
#include <vector>

using namespace typemesh;

namespace {

std::string broken(const test::polyline& l, const std::vector<triangle>& cut)
{
    contours loops = test::contours_of({l});
    workspace space;
    const auto r = fill(loops, fill_rule::non_zero, space);
    REQUIRE(r);
    return inspect::check_delaunay(*r, cut).broken();
}

}  // namespace

TEST_CASE("a diagonal that is not Delaunay is found, and so is the wrong one of a tie", "[inspect]")
{
    const test::polyline kite{{0, 0}, {10, -3}, {20, 0}, {10, 3}};
    CHECK(broken(kite, {{0, 1, 3}, {1, 2, 3}}) == "");
    CHECK(broken(kite, {{0, 1, 2}, {0, 2, 3}}) == "an edge is not Delaunay");
    const test::polyline square = test::square(0, 0, 10);
    CHECK(broken(square, {{0, 1, 2}, {0, 2, 3}}) == "");
    CHECK(broken(square, {{0, 1, 3}, {1, 2, 3}}) == "a diagonal of cocircular points does not end at the smallest");
}

TEST_CASE("every exchanged diagonal of a Delaunay triangulation is found", "[inspect]")
{
    contours loops = test::contours_of(test::square_with_holes(2, 7));
    workspace space;
    const auto r = fill(loops, fill_rule::non_zero, space);
    REQUIRE(r);
    triangle_list out;
    REQUIRE_FALSE(constrained_delaunay{}(*r, space, out));
    const std::vector<triangle> right{out.begin(), out.end()};
    CHECK(std::string{inspect::check_delaunay(*r, right).broken()} == "");
    CHECK(inspect::check_delaunay(*r, right).inner_edges == (3 * right.size() - r->points().size()) / 2);
    std::size_t exchanged = 0;
    const auto rotated = [](triangle t, std::size_t k) {
        return k == 0 ? t : k == 1 ? triangle{t.b, t.c, t.a} : triangle{t.c, t.a, t.b};
    };
    for (std::size_t i = 0; i < 9 * right.size() * right.size(); ++i) {
        const std::size_t s = i / 9 / right.size(), t = i / 9 % right.size();
        const triangle p = rotated(right[s], i % 3), q = rotated(right[t], i / 3 % 3);  // a -> b is b -> a of the other
        if (s >= t || p.a != q.b || p.b != q.a) continue;
        const auto at = r->points();
        if (inspect::side(at[p.c], at[p.a], at[q.c]) <= 0 || inspect::side(at[q.c], at[p.b], at[p.c]) <= 0) continue;
        std::vector<triangle> other = right;
        other[s] = {p.c, p.a, q.c};
        other[t] = {q.c, p.b, p.c};
        const inspect::delaunay_check found = inspect::check_delaunay(*r, other);
        CHECK(found.not_delaunay + found.wrong_ties > 0);
        ++exchanged;
    }
    CHECK(exchanged > 10);
}

#if defined(__SIZEOF_INT128__)
TEST_CASE("the side of a circle agrees with the determinant in 128 bits", "[inspect]")
{
    using typemesh::detail::int128;
    test::dice d{5};
    int seen[3] = {};
    for (int i = 0; i < 100'000; ++i) {
        const std::int32_t reach = 1 << (2 + d.roll(27));
        const auto roll = [&] { return grid_point{d.roll(2 * reach + 1) - reach, d.roll(2 * reach + 1) - reach}; };
        const grid_point a = roll(), b = roll(), c = roll(), e = roll();
        if (inspect::side(a, b, c) <= 0) continue;
        const std::int64_t ax = std::int64_t{a.x} - e.x, ay = std::int64_t{a.y} - e.y, bx = std::int64_t{b.x} - e.x,
                           by = std::int64_t{b.y} - e.y, cx = std::int64_t{c.x} - e.x, cy = std::int64_t{c.y} - e.y;
        const int128 determinant = int128{ax * ax + ay * ay} * (bx * cy - by * cx) -
                                   int128{bx * bx + by * by} * (ax * cy - ay * cx) +
                                   int128{cx * cx + cy * cy} * (ax * by - ay * bx);
        const int wanted = determinant > 0 ? 1 : determinant < 0 ? -1 : 0, got = inspect::circle_side(a, b, c, e);
        ++seen[wanted + 1];
        if (got != wanted) FAIL("wrong side");
    }
    for (const int count : seen) CHECK(count > 10);
    const std::int32_t most = 1 << 28;  // the largest circle that has all corners of the grid on it
    CHECK(inspect::circle_side({-most, -most}, {most, -most}, {most, most}, {-most, most}) == 0);
    CHECK(inspect::circle_side({-most, -most}, {most, -most}, {most, most}, {1 - most, most}) == 1);
    CHECK(inspect::circle_side({-most, -most}, {most, -most}, {most - 1, most}, {-most, most}) == -1);
}
#endif
