// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/intersect.hpp>
#include <typemesh/fill/resolve.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <vector>

using namespace typemesh;

namespace {

/// A region that owns its loops.
struct owned_region {
    contours loops;
    region made;

    owned_region(const test::shape& s, fill_rule rule) : loops{test::contours_of(s)}
    {
        workspace space;
        const auto r = resolve(loops, rule, space);
        REQUIRE(r);
        made = *r;
    }
    [[nodiscard]] placed_loops at(std::int64_t x, std::int64_t y) const { return {made.points(), made.starts(), x, y}; }
};

bool do_meet(const placed_loops& a, const placed_loops& b)
{
    workspace space;
    const auto one = meet(a, b, space), other = meet(b, a, space);
    REQUIRE(one);
    REQUIRE(other);
    REQUIRE(*one == *other);
    return *one;
}

void append(test::shape& all, const region& r, std::int32_t x, std::int32_t y)
{
    for (std::size_t loop = 0; loop + 1 < r.starts().size(); ++loop) {
        test::polyline line;
        for (std::uint32_t i = r.starts()[loop]; i < r.starts()[loop + 1]; ++i)
            line.push_back({r.points()[i].x + x, r.points()[i].y + y});
        all.loops.push_back(line);
    }
}

std::vector<grid_point> sorted_points(const contours& loops)
{
    std::vector<grid_point> all{loops.points.begin(), loops.points.end()};
    std::sort(all.begin(), all.end(), lexicographic_less);
    return all;
}

}  // namespace

TEST_CASE("two regions meet exactly if their union changes them", "[fill][meet]")
{
    test::dice d{77};
    int intersection = 0, apart = 0;
    for (int i = 0; i < 60'000; ++i) {
        const int scale = 1 << d.roll(6);
        const owned_region a{test::random_polylines(d, 1 + d.roll(2), 3, 5, 5, scale), fill_rule::even_odd};
        const int width = 3 + d.roll(3);
        const owned_region b{test::random_polylines(d, 1 + d.roll(2), 3, 5, width, scale), fill_rule::non_zero};
        if (a.made.points().empty() || a.made.is_touching()) continue;
        if (b.made.points().empty() || b.made.is_touching()) continue;
        const std::int32_t x = (d.roll(7) - 3) * scale, y = (d.roll(7) - 3) * scale;

        test::shape both{"both", {}};
        append(both, a.made, 0, 0);
        append(both, b.made, x, y);
        const owned_region joined{both, fill_rule::non_zero};
        const bool unchanged = sorted_points(joined.loops) == sorted_points(test::contours_of(both)) &&
                               joined.made.holes() == a.made.holes() + b.made.holes() &&
                               joined.made.outers() == a.made.outers() + b.made.outers() && !joined.made.is_touching();
        INFO(both);
        CHECK(do_meet(a.at(0, 0), b.at(x, y)) == !unchanged);
        ++(unchanged ? apart : intersection);
    }
    CHECK(intersection > 2000);
    CHECK(apart > 2000);
}

TEST_CASE("a region in a hole meets the region around it only when they touch", "[fill][meet]")
{
    const owned_region ring{{"ring", {test::square(0, 0, 100), test::square(20, 20, 60)}}, fill_rule::even_odd},
        dot{{"dot", {test::square(0, 0, 10)}}, fill_rule::non_zero};
    CHECK_FALSE(do_meet(ring.at(0, 0), dot.at(45, 45)));
    CHECK_FALSE(do_meet(ring.at(0, 0), dot.at(69, 45)));
    CHECK(do_meet(ring.at(0, 0), dot.at(70, 45)));
    CHECK(do_meet(ring.at(0, 0), dot.at(84, 45)));
    CHECK(do_meet(ring.at(0, 0), dot.at(100, 100)));
    CHECK_FALSE(do_meet(ring.at(0, 0), dot.at(101, 45)));
}

TEST_CASE("regions meet in the same way anywhere on the page", "[fill][meet]")
{
    const owned_region tile{{"tile", {test::square(0, 0, 400)}}, fill_rule::non_zero};
    for (const std::int64_t page : {std::int64_t{0}, std::int64_t{1} << 40, -(std::int64_t{1} << 59)}) {
        CHECK(do_meet(tile.at(page, page), tile.at(page + 400, page + 400)));
        CHECK_FALSE(do_meet(tile.at(page, page), tile.at(page + 401, page)));
    }
    const std::int32_t reach = 1 << 28;
    const test::polyline all{{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}};
    const owned_region whole{{"whole", {all}}, fill_rule::non_zero};
    CHECK(do_meet(whole.at(0, 0), whole.at(2 * std::int64_t{reach}, 0)));
    CHECK_FALSE(do_meet(whole.at(0, 0), whole.at(2 * std::int64_t{reach} + 1, 0)));
}
