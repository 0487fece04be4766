// SPDX-License-Identifier: MIT

#include <typemesh/fill/fill.hpp>
#include <typemesh/fill/region_union.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <vector>

using namespace typemesh;

namespace {

/// A region with a curve for each of its edges, and its place.
struct member {
    contours loops;
    std::vector<curve> curves;
    region shape;
    std::int32_t x = 0, y = 0;

    member(const test::shape& s, std::int32_t right, std::int32_t up) : loops{test::contours_of(s)}, x{right}, y{up}
    {
        curves.assign(loops.points.size(), curve::from({0, 0}, {1, 0}));
        loops.curves = curves;
        workspace space;
        const auto filled = fill(loops, fill_rule::non_zero, space);
        REQUIRE(filled);
        shape = *filled;
    }
    [[nodiscard]] std::vector<test::polyline> placed() const
    {
        std::vector<test::polyline> all;
        for (const auto l : test::oracle::loops_of(shape)) {
            all.emplace_back();
            for (const grid_point p : l) all.back().push_back({p.x + x, p.y + y});
        }
        return all;
    }
};

}  // namespace

TEST_CASE("a union fills what any member fills, and its edges know their member", "[fill][region_union]")
{
    test::dice d{33};
    region_union joined_by;
    int looked_at = 0;
    for (int round = 0; round < 400; ++round) {
        std::vector<member> members;
        for (int n = 1 + d.roll(4); n > 0; --n) {
            test::shape s{"polygon", {test::random_polygon(3 + d.roll(12), 20, d)}};
            for (test::polyline& l : s.loops)
                for (grid_point& p : l) p = {100 * p.x, 100 * p.y};
            members.emplace_back(s, d.roll(2000), d.roll(2000));
        }
        joined_by.begin(grid{});
        for (const member& m : members) REQUIRE(joined_by.add(m.shape, 1.0, m.x, m.y));
        workspace space;
        const auto joined = joined_by.join(space);
        REQUIRE(joined);
        const auto boundary = test::oracle::loops_of(*joined);
        CHECK(test::oracle::broken_cycle(boundary) == "");

        std::vector<std::vector<test::polyline>> placed;
        for (const member& m : members) placed.push_back(m.placed());
        for (int i = 0; i < 60; ++i) {
            const grid_point p{d.roll(4000), d.roll(4000)};
            bool filled = false;
            double nearest = test::oracle::distance(boundary, p);
            for (const auto& loops : placed) {
                const std::vector<test::oracle::loop> views{loops.begin(), loops.end()};
                filled = filled || test::oracle::winding(views, p) != 0;
                nearest = (std::min)(nearest, test::oracle::distance(views, p));
            }
            if (nearest < 2.0) continue;  // crossings are rounded
            REQUIRE((test::oracle::winding(boundary, p) == 1) == filled);
            ++looked_at;
        }

        std::vector<std::uint32_t> first_curve{0};
        for (const member& m : members)
            first_curve.push_back(first_curve.back() + static_cast<std::uint32_t>(m.curves.size()));
        for (std::size_t i = 0; i < joined->points().size(); ++i) {
            const std::uint32_t curve = joined->edges()[i].curve, who = joined_by.member_of(curve);
            REQUIRE((first_curve[who] <= curve && curve < first_curve[who + 1]));
            std::vector<test::oracle::loop> views{placed[who].begin(), placed[who].end()};
            REQUIRE(test::oracle::distance(views, joined->points()[i]) < 2.0);
        }
    }
    CHECK(looked_at > 5000);
}

TEST_CASE("members are scaled and rounded to the grid of their union", "[fill][region_union]")
{
    const member m{{"square", {test::square(1, 1, 6)}}, 0, 0};
    region_union joined_by;
    joined_by.begin(grid{});
    REQUIRE(joined_by.add(m.shape, 0.25, 10, -20));  // 0.25 to 0, 1.75 to 2
    workspace space;
    const auto joined = joined_by.join(space);
    REQUIRE(joined);
    REQUIRE(joined->points().size() == 4);
    for (const grid_point p : joined->points()) CHECK(((p.x == 10 || p.x == 12) && (p.y == -20 || p.y == -18)));
}

TEST_CASE("a member that cannot be added leaves the union unchanged", "[fill][region_union]")
{
    const member a{{"square", {test::square(0, 0, 10)}}, 0, 0};
    region_union joined_by;
    joined_by.begin(grid{});
    REQUIRE(joined_by.add(a.shape, 1.0, 0, 0));
    CHECK(joined_by.add(a.shape, 1.0, std::int64_t{1} << 28, 0) == error::outline_beyond_grid);
    workspace space;
    const auto joined = joined_by.join(space);
    REQUIRE(joined);
    CHECK(joined->points().size() == 4);

    test::counting_memory failing{.fail_at = 1};
    region_union without{failing.source()};
    without.begin(grid{});
    CHECK(without.add(a.shape, 1.0, 0, 0) == error::out_of_memory);
    without.begin(grid{});
    const auto nothing = without.join(space);
    CHECK((!nothing || nothing->points().empty()));
}
