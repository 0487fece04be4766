// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/each_failure.hpp"

#include <typemesh/core/orientation.hpp>
#include <typemesh/fill/cut_where_met.hpp>
#include <typemesh/fill/resolve.hpp>

#include <cstdint>
#include <cstdlib>
#include <random>
#include <utility>
#include <vector>

using namespace typemesh;

namespace {

using polyline = std::vector<grid_point>;

bool put(contours& loops, const std::vector<polyline>& all)
{
    if (!loops.starts.push_back(0)) return false;
    std::uint32_t number = 0;
    for (const polyline& one : all) {
        for (std::size_t i = 0; i < one.size(); ++i)
            if (!loops.points.push_back(one[i]) || !loops.edges.push_back({number++, 0.0f, 1.0f})) return false;
        if (!loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()))) return false;
    }
    return true;
}

struct edge {
    grid_point a, b;
};
std::vector<edge> edges_of(const contours& loops)
{
    std::vector<edge> all;
    for (std::size_t c = 0; c + 1 < loops.starts.size(); ++c)
        for (std::uint32_t i = loops.starts[c]; i < loops.starts[c + 1]; ++i)
            all.push_back({loops.points[i], loops.points[i + 1 < loops.starts[c + 1] ? i + 1 : loops.starts[c]]});
    return all;
}

bool lies_inside(grid_point p, const edge& e)
{
    return !(p == e.a) && !(p == e.b) && orientation(e.a, e.b, p) == 0 &&
           (p.x - e.a.x) * std::int64_t{p.x - e.b.x} <= 0 && (p.y - e.a.y) * std::int64_t{p.y - e.b.y} <= 0;
}
bool cross(const edge& e, const edge& f)
{
    const auto side = [](const edge& of, grid_point p) { return orientation(of.a, of.b, p); };
    return ((side(e, f.a) > 0 && side(e, f.b) < 0) || (side(e, f.a) < 0 && side(e, f.b) > 0)) &&
           ((side(f, e.a) > 0 && side(f, e.b) < 0) || (side(f, e.a) < 0 && side(f, e.b) > 0));
}

std::vector<polyline> random_loops(std::mt19937& random, int range)
{
    std::vector<polyline> all(random() % 4 + 1);
    for (polyline& one : all)
        for (std::size_t n = random() % 6 + 3; n-- > 0;)
            one.push_back({static_cast<std::int32_t>(random() % static_cast<unsigned>(range)),
                           static_cast<std::int32_t>(random() % static_cast<unsigned>(range))});
    return all;
}

}  // namespace

TEST_CASE("after the cut, edges have at most ends in common, and no edge has moved by more than a cell", "[cut]")
{
    std::mt19937 random{5};
    for (int round = 0; round < 600; ++round) {
        const int range = round % 3 == 0 ? 6 : round % 3 == 1 ? 40 : 100'000;
        contours loops;
        workspace space;
        const auto given = random_loops(random, range);
        REQUIRE(put(loops, given));
        const std::vector<edge> before = edges_of(loops);
        REQUIRE(cut_where_met(loops, space));
        REQUIRE(loops.contour_count() == given.size());
        REQUIRE(loops.edges.size() == loops.points.size());
        const std::vector<edge> after = edges_of(loops);
        std::size_t faults = 0, strayed = 0;
        for (std::size_t i = 0; i < after.size(); ++i) {
            for (std::size_t k = 0; k < after.size(); ++k) {
                faults += i < k && cross(after[i], after[k]) ? 1u : 0u;
                faults += lies_inside(after[k].a, after[i]) ? 1u : 0u;
            }
            // The piece's ends lie within half a cell in x and y of the edge that it was cut from: its number is kept.
            const edge& home = before[loops.edges[i].curve];
            const std::int64_t reach = std::abs(home.a.x - home.b.x) + std::abs(home.a.y - home.b.y);
            if (home.a == home.b) continue;
            strayed += std::abs(orientation(home.a, home.b, after[i].a)) > reach ? 1u : 0u;
            if (!(after[i].a == home.a)) strayed += loops.edges[i].t0 > 0.0f ? 0u : 1u;
        }
        CHECK(faults == 0);
        CHECK(strayed == 0);
    }
}

TEST_CASE("crossing squares are cut in their two crossings, and coinciding edges stay apart", "[cut]")
{
    contours loops;
    workspace space;
    const polyline a{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, b{{50, 50}, {150, 50}, {150, 150}, {50, 150}},
        c{{100, 0}, {200, 0}, {200, 30}, {100, 30}};
    REQUIRE(put(loops, {a, b, a, c}));
    REQUIRE(cut_where_met(loops, space));
    REQUIRE(loops.starts.size() == 5);
    // The square has its corners, two crossings with b and the corner of c on its side.
    CHECK(loops.starts[1] == 7);
    CHECK(loops.starts[2] == 7 + 6);
    CHECK(loops.starts[3] == 7 + 6 + 7);
    CHECK(loops.starts[4] == 7 + 6 + 7 + 4);
    for (std::uint32_t i = 0; i < 7; ++i) CHECK(loops.points[i] == loops.points[13 + i]);
    CHECK(inspect::doubled_area(loops) == 2 * (3 * 10'000 + 3'000));
}

TEST_CASE("regions that were cut together are joined and cut without moving a point", "[cut]")
{
    std::mt19937 random{7};
    for (int round = 0; round < 200; ++round) {
        contours loops;
        workspace space;
        const auto given = random_loops(random, 1000);
        REQUIRE(put(loops, given));
        REQUIRE(cut_where_met(loops, space));
        // By inclusion and exclusion over the first contour and all others: what either fills, plus what both fill, is
        // what the two fill; what both fill is what either fills, without what only one of them fills.
        const auto filled = [&](std::uint32_t first, std::uint32_t last) {
            contours some;
            REQUIRE(some.starts.push_back(0));
            for (std::uint32_t c = first; c < last; ++c) {
                const std::size_t begin = loops.starts[c], size = loops.starts[c + 1] - begin;
                REQUIRE(some.points.append(loops.points.view().subspan(begin, size)));
                REQUIRE(some.edges.append(loops.edges.view().subspan(begin, size)));
                REQUIRE(some.starts.push_back(static_cast<std::uint32_t>(some.points.size())));
            }
            REQUIRE(resolve(some, fill_rule::non_zero, space));
            return some;
        };
        contours one = filled(0, 1), others = filled(1, loops.contour_count());
        const std::int64_t a = inspect::doubled_area(one), b = inspect::doubled_area(others);
        contours both;
        REQUIRE(both.starts.push_back(0));
        for (const contours* part : {&one, &others})
            for (std::uint32_t c = 0; c < part->contour_count(); ++c) {
                const std::size_t begin = part->starts[c], size = part->starts[c + 1] - begin;
                REQUIRE(both.points.append(part->points.view().subspan(begin, size)));
                REQUIRE(both.edges.append(part->edges.view().subspan(begin, size)));
                REQUIRE(both.starts.push_back(static_cast<std::uint32_t>(both.points.size())));
            }
        contours apart;
        REQUIRE(apart.points.append(both.points.view()));
        REQUIRE(apart.edges.append(both.edges.view()));
        REQUIRE(apart.starts.append(both.starts.view()));
        REQUIRE(resolve(both, fill_rule::non_zero, space));
        REQUIRE(resolve(apart, fill_rule::even_odd, space));
        const std::int64_t either = inspect::doubled_area(both), only_one = inspect::doubled_area(apart);
        CHECK(2 * either == a + b + only_one);  // exactly: nothing was rounded
    }
}

TEST_CASE("too many pieces and failing memory are refused", "[cut]")
{
    const polyline comb{{0, 0}, {1000, 7}, {0, 11}, {1000, 17}, {0, 23}, {1000, 31}},
        bars{{100, -50}, {137, 60}, {171, -50}, {223, 60}};
    contours loops;
    workspace space;
    REQUIRE(put(loops, {comb, bars}));
    CHECK(cut_where_met(loops, space, 4).error() == error::too_many_pieces);
    const std::size_t requests = test::check_each_failure([&](memory source) -> error {
        contours own{source};
        workspace scratch{source};
        if (!put(own, {comb, bars})) return error::out_of_memory;
        return cut_where_met(own, scratch).error();
    });
    CHECK(requests > 4);
}
