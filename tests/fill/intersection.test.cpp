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

/// Records its intersections, with curves in ascending order, and refuses those at one point.
struct witness {
    std::set<std::tuple<std::int32_t, std::int32_t, std::uint32_t, std::uint32_t>> seen;
    grid_point refused{1'000'000, 0};
    bool is_sound = true;

    bool operator()(const intersection& m) noexcept
    {
        is_sound = is_sound && !(m.a.ends_in(m.at) && m.b.ends_in(m.at));
        const auto [low, high] = std::minmax(m.a.source.curve, m.b.source.curve);
        seen.emplace(m.at.x, m.at.y, low, high);
        return !(m.at == refused);
    }
};

/// Curve k is the edge from the k-th point.
witness filter_of(const std::vector<test::polyline>& given, fill_rule rule = fill_rule::non_zero)
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

TEST_CASE("a filter sees crossings and corners on edges, but not corners on corners", "[fill][intersection]")
{
    CHECK(filter_of({square}).seen.empty());
    CHECK(filter_of({square, {{2, 2}, {2, 6}, {6, 6}, {6, 2}}}).seen.empty());
    const decltype(witness::seen) crossings{{8, 4, 1, 4}, {4, 8, 2, 7}};
    CHECK(filter_of({square, over_its_corner}).seen == crossings);
    CHECK(filter_of({square, over_its_corner}, fill_rule::even_odd).seen == crossings);
    // A corner on an edge: both edges of the corner reach it.
    CHECK(filter_of({square, {{8, 4}, {12, 2}, {12, 6}}}).seen == decltype(witness::seen){{8, 4, 1, 4}, {8, 4, 1, 6}});
    // A line that is crossed only inside a third contour bounds nothing.
    CHECK(filter_of({square, {{2, 4}, {6, 3}, {6, 5}}}).seen.empty());
    CHECK(filter_of({{{0, 0}, {40, 0}, {40, 40}, {0, 40}},
                     {{4, 4}, {12, 4}, {12, 12}, {4, 12}},
                     {{8, 8}, {16, 8}, {16, 16}, {8, 16}}})
              .seen.empty());
}

TEST_CASE("a filter sees where edges meet that cancel", "[fill][intersection]")
{
    //   0,8 .---------. 8,8       The lower edge of the square and a part of the other contour's upper edge run
    //       |         |           against each other and leave no segment. Only the ends of that part show it.
    //   0,0 '===.=====x----. 12,0
    //       2,0 '----------' -4
    CHECK(filter_of({square, {{12, 0}, {2, 0}, {2, -4}, {12, -4}}}).seen ==
          decltype(witness::seen){{2, 0, 0, 5}, {8, 0, 1, 4}});
}

TEST_CASE("a filter sees touching loops, but no point where more than 16 edges meet", "[fill][intersection]")
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
    CHECK(filter_of(fan(5)).seen.empty());  // common ends
    auto crossed = fan(5);
    crossed.push_back({{0, -100}, {0, 100}, {-100, 0}});  // an edge through the common corner
    const auto few = filter_of(crossed).seen;
    CHECK(std::any_of(few.begin(), few.end(), [](const auto& t) { return std::get<3>(t) == 15; }));
    crossed = fan(14);
    crossed.push_back({{0, -100}, {0, 100}, {-100, 0}});
    const auto many = filter_of(crossed).seen;
    CHECK(std::none_of(many.begin(), many.end(),
                       [](const auto& t) { return std::get<0>(t) == 0 && std::get<1>(t) == 0; }));
}

TEST_CASE("after a refusal the filter still sees all crossings, and the contours stay", "[fill][intersection]")
{
    contours loops = test::contours_of({square, over_its_corner});
    const std::vector<grid_point> before(loops.points.begin(), loops.points.end());
    workspace space;
    witness w;
    w.refused = {4, 8};
    const auto made = resolve(loops, fill_rule::non_zero, space, w);
    REQUIRE(made);
    CHECK(made->points().empty());
    CHECK(w.seen.size() == 2);
    CHECK(std::ranges::equal(before, loops.points));
}
