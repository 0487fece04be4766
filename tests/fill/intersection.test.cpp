// SPDX-License-Identifier: MIT

#include <typemesh/fill/resolve.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

/// Writes down what it is asked, curves in ascending order, and refuses the intersections in one point.
struct witness {
    std::set<std::tuple<std::int32_t, std::int32_t, std::uint32_t, std::uint32_t>> told;
    grid_point refused{1'000'000, 0};
    bool is_sound = true;

    bool operator()(const intersection& m) noexcept
    {
        is_sound = is_sound && !(m.a.ends_in(m.at) && m.b.ends_in(m.at));
        const auto [low, high] = std::minmax(m.a.source.curve, m.b.source.curve);
        told.emplace(m.at.x, m.at.y, low, high);
        return !(m.at == refused);
    }
};

/// Curve k is the edge from the k-th point.
witness ask(const std::vector<test::polyline>& given, fill_rule rule = fill_rule::non_zero)
{
    contours loops = test::contours_of(given);
    for (std::uint32_t i = 0; i < loops.edges.size(); ++i) loops.edges[i].curve = i;
    workspace space;
    witness w;
    const auto made = resolve(loops, rule, space, w);
    REQUIRE(made);
    CHECK(w.is_sound);
    return w;
}

const test::polyline square{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
const test::polyline over_its_corner{{4, 4}, {12, 4}, {12, 12}, {4, 12}};

}  // namespace

TEST_CASE("a filter is told of crossings and of corners on edges, not of corners", "[fill][intersection]")
{
    CHECK(ask({square}).told.empty());
    CHECK(ask({square, {{2, 2}, {2, 6}, {6, 6}, {6, 2}}}).told.empty());
    const decltype(witness::told) crossings{{8, 4, 1, 4}, {4, 8, 2, 7}};
    CHECK(ask({square, over_its_corner}).told == crossings);
    CHECK(ask({square, over_its_corner}, fill_rule::even_odd).told == crossings);
    // a corner on an edge: both edges of the corner come there
    CHECK(ask({square, {{8, 4}, {12, 2}, {12, 6}}}).told == decltype(witness::told){{8, 4, 1, 4}, {8, 4, 1, 6}});
    // one line, crossed by the other contour only where it is covered by a third: that bounds nothing
    CHECK(ask({square, {{2, 4}, {6, 3}, {6, 5}}}).told.empty());
    CHECK(ask({{{0, 0}, {40, 0}, {40, 40}, {0, 40}},
               {{4, 4}, {12, 4}, {12, 12}, {4, 12}},
               {{8, 8}, {16, 8}, {16, 16}, {8, 16}}})
              .told.empty());
}

TEST_CASE("a filter is told where edges come together that cancel", "[fill][intersection]")
{
    //   0,8 .---------. 8,8       The lower edge of the square and a part of the other contour's upper edge run
    //       |         |           against each other and leave no segment. Only the ends of that part tell of it.
    //   0,0 '===.=====x----. 12,0
    //       2,0 '----------' -4
    CHECK(ask({square, {{12, 0}, {2, 0}, {2, -4}, {12, -4}}}).told ==
          decltype(witness::told){{2, 0, 0, 5}, {8, 0, 1, 4}});
}

TEST_CASE("a filter is told of loops that touch, but not where more than 16 edges come through one point",
          "[fill][intersection]")
{
    const auto fan = [](int blades) {  // triangles that share a corner
        std::vector<test::polyline> all;
        for (int i = 0; i < blades; ++i) {
            const auto at = [&](double share) {
                const double turn = 6.283185307 * (i + share) / blades;
                return grid_point{static_cast<std::int32_t>(std::lround(1000 * std::cos(turn))),
                                  static_cast<std::int32_t>(std::lround(1000 * std::sin(turn)))};
            };
            all.push_back({{0, 0}, at(0.0), at(0.5)});
        }
        return all;
    };
    CHECK(ask(fan(5)).told.empty());  // common ends
    auto crossed = fan(5);
    crossed.push_back({{0, -100}, {0, 100}, {-100, 0}});  // an edge through the common corner
    const auto few = ask(crossed).told;
    CHECK(std::any_of(few.begin(), few.end(), [](const auto& t) { return std::get<3>(t) == 15; }));
    crossed = fan(14);
    crossed.push_back({{0, -100}, {0, 100}, {-100, 0}});
    const auto many = ask(crossed).told;
    CHECK(std::none_of(many.begin(), many.end(),
                       [](const auto& t) { return std::get<0>(t) == 0 && std::get<1>(t) == 0; }));
}

TEST_CASE("where a filter refuses, all are asked none the less, and the contours stay as they were",
          "[fill][intersection]")
{
    contours loops = test::contours_of({square, over_its_corner});
    const std::vector<grid_point> before(loops.points.begin(), loops.points.end());
    workspace space;
    witness w;
    w.refused = {4, 8};
    const auto made = resolve(loops, fill_rule::non_zero, space, w);
    REQUIRE(made);
    CHECK(made->points().empty());
    CHECK(w.told.size() == 2);
    CHECK(std::equal(before.begin(), before.end(), loops.points.begin(), loops.points.end()));
}
