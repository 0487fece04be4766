// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/boundary_cycles.hpp>
#include <typemesh/fill/impl/resolving_sweep.hpp>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

struct traced {
    std::vector<test::polyline> loops;
    std::uint32_t holes = 0, outers = 0;
};

/// One sweep, which suffices where every crossing is a grid point, and the boundary's.
traced trace_boundary(const std::vector<test::polyline>& given, fill_rule rule)
{
    contours loops = test::contours_of(given);
    workspace space;
    workspace::scope scratch{space};
    detail::arrangement a;
    REQUIRE(a.reserve(scratch, 400));
    REQUIRE(sort_points(loops, space));
    REQUIRE(a.from_contours(loops, space));
    detail::resolving_sweep sweep{a, rule};
    REQUIRE(sweep.run(space));
    REQUIRE_FALSE(sweep.again);
    detail::boundary_cycles boundary;
    bool all_accepted = true;
    REQUIRE_FALSE(boundary.trace(a, scratch, {}, all_accepted));
    REQUIRE_FALSE(boundary.write(a, loops, scratch));
    std::vector<std::uint32_t> sorted(loops.points.size());
    REQUIRE(sweep_order(loops.points.view(), space, sorted.data()));
    CHECK(std::equal(sorted.begin(), sorted.end(), loops.order().begin(), loops.order().end()));
    traced w{{}, boundary.holes, boundary.outers};
    for (const auto l : test::oracle::loops_of(loops)) w.loops.emplace_back(l.begin(), l.end());
    return w;
}

std::vector<test::oracle::loop> views(const traced& w) { return {w.loops.begin(), w.loops.end()}; }

}  // namespace

TEST_CASE("A boundary cycle stays in its sector: outer loops that touch stay apart, holes that touch are one",
          "[fill][boundary_cycles]")
{
    const test::polyline around{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    const traced two = trace_boundary({test::square(0, 0, 4), test::square(4, 4, 4)}, fill_rule::non_zero);
    CHECK(two.outers == 2);
    CHECK(two.holes == 0);
    CHECK(test::oracle::broken_cycle(views(two)).empty());

    const traced holes =
        trace_boundary({around, {{2, 2}, {2, 4}, {4, 4}}, {{4, 4}, {4, 6}, {6, 6}}}, fill_rule::non_zero);
    CHECK(holes.outers == 1);
    CHECK(holes.holes == 1);
    CHECK(test::oracle::broken_cycle(views(holes)).empty());

    const traced joined = trace_boundary({around, {{0, 0}, {2, 4}, {4, 2}}}, fill_rule::even_odd);
    CHECK(joined.outers == 1);
    CHECK(joined.holes == 0);
    REQUIRE(joined.loops.size() == 1);
    CHECK(joined.loops[0].size() == 7);
}

TEST_CASE("Any number of sectors round one point are told apart", "[fill][boundary_cycles]")
{
    // A windmill of n triangles round (0, 0), which alternate with holes of a square round them.
    const test::polyline rim{{9, 0},  {9, 4},   {9, 9},   {4, 9},   {0, 9},  {-4, 9}, {-9, 9}, {-9, 4},
                             {-9, 0}, {-9, -4}, {-9, -9}, {-4, -9}, {0, -9}, {4, -9}, {9, -9}, {9, -4}};
    for (std::size_t wings = 1; wings <= 8; ++wings) {
        std::vector<test::polyline> loops;
        for (std::size_t i = 0; i < wings; ++i) loops.push_back({{0, 0}, rim[2 * i], rim[2 * i + 1]});
        const traced outers = trace_boundary(loops, fill_rule::non_zero);
        INFO(wings);
        CHECK(outers.outers == wings);
        CHECK(outers.holes == 0);
        CHECK(test::oracle::broken_cycle(views(outers)).empty());

        loops.push_back({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
        const traced holes = trace_boundary(loops, fill_rule::even_odd);
        CHECK(holes.outers == 1);
        CHECK(holes.holes == 1);  // they touch in one point: one
        CHECK(test::oracle::broken_cycle(views(holes)).empty());
    }
}

TEST_CASE("The boundary encloses what is filled and nothing else, where all crossings are grid points",
          "[fill][boundary_cycles]")
{
    test::dice d{71};
    for (int i = 0; i < 3000; ++i) {
        // Upright and slanted edges of even coordinates cross in grid points.
        std::vector<test::polyline> given;
        for (int c = 1 + d.roll(5); c > 0; --c) {
            const int x = 2 * d.roll(8), y = 2 * d.roll(8), r = 2 * (1 + d.roll(4));
            if (d.roll(2) == 0)
                given.push_back({{x, y}, {x + r, y}, {x + r, y + r}, {x, y + r}});
            else
                given.push_back({{x - r, y}, {x, y - r}, {x + r, y}, {x, y + r}});
            if (d.roll(3) == 0) given.back() = test::reversed(given.back());
        }
        const std::vector<test::oracle::loop> in(given.begin(), given.end());
        for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
            const traced w = trace_boundary(given, rule);
            const auto out = views(w);
            REQUIRE(test::oracle::broken_cycle(out).empty());
            REQUIRE(static_cast<double>(test::oracle::doubled_area(out)) ==
                    Approx(test::oracle::doubled_filled_area(in, rule)));
            std::uint32_t holes = 0;
            for (const auto l : out) holes += test::oracle::doubled_area(l) < 0;
            CHECK(holes == w.holes);
            CHECK(out.size() == w.holes + w.outers);
        }
    }
}
