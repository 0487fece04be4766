// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/boundary_cycles.hpp>
#include <typemesh/fill/impl/resolving_sweep.hpp>

#include "fill/taken_apart.hpp"

using namespace typemesh;

namespace {

struct traced {
    std::vector<test::polyline> loops;
    std::uint32_t holes = 0, outers = 0;
};

/// One sweep, which suffices if every crossing is a grid point, and the boundary that it leaves.
traced trace_boundary(const std::vector<test::polyline>& given, fill_rule rule)
{
    taken_apart apart{given, 400};
    auto& [loops, space, scratch, a] = apart;
    detail::resolving_sweep sweep{a, rule};
    REQUIRE(sweep.run(space));
    REQUIRE_FALSE(sweep.again);
    detail::boundary_cycles boundary;
    bool all_accepted = true;
    REQUIRE_FALSE(boundary.trace(a, scratch, {}, all_accepted));
    REQUIRE_FALSE(boundary.write(a, loops, scratch));
    std::vector<std::uint32_t> sorted(loops.points.size());
    REQUIRE(sweep_order(loops.points.view(), space, sorted.data()));
    CHECK(std::ranges::equal(sorted, loops.order()));
    traced w{{}, boundary.holes, boundary.outers};
    for (const auto l : test::oracle::loops_of(loops)) w.loops.emplace_back(l.begin(), l.end());
    return w;
}

std::vector<test::oracle::loop> views(const traced& w) { return {w.loops.begin(), w.loops.end()}; }

void check_traced(const traced& w, std::uint32_t outers, std::uint32_t holes)
{
    CHECK(w.outers == outers);
    CHECK(w.holes == holes);
    CHECK(test::oracle::broken_cycle(views(w)).empty());
}

}  // namespace

TEST_CASE("Outer loops that touch stay apart, and holes that touch become one", "[fill][boundary_cycles]")
{
    const test::polyline around{{0, 0}, {8, 0}, {8, 8}, {0, 8}};
    check_traced(trace_boundary({test::square(0, 0, 4), test::square(4, 4, 4)}, fill_rule::non_zero), 2, 0);
    check_traced(trace_boundary({around, {{2, 2}, {2, 4}, {4, 4}}, {{4, 4}, {4, 6}, {6, 6}}}, fill_rule::non_zero), 1,
                 1);
    const traced joined = trace_boundary({around, {{0, 0}, {2, 4}, {4, 2}}}, fill_rule::even_odd);
    check_traced(joined, 1, 0);
    REQUIRE(joined.loops.size() == 1);
    CHECK(joined.loops[0].size() == 7);
}

TEST_CASE("A boundary cycle finds its way among any number of sectors round one point", "[fill][boundary_cycles]")
{
    // A windmill of n triangles round (0, 0), which become holes inside a square.
    const test::polyline rim{{9, 0},  {9, 4},   {9, 9},   {4, 9},   {0, 9},  {-4, 9}, {-9, 9}, {-9, 4},
                             {-9, 0}, {-9, -4}, {-9, -9}, {-4, -9}, {0, -9}, {4, -9}, {9, -9}, {9, -4}};
    for (std::size_t wings = 1; wings <= 8; ++wings) {
        std::vector<test::polyline> loops;
        for (std::size_t i = 0; i < wings; ++i) loops.push_back({{0, 0}, rim[2 * i], rim[2 * i + 1]});
        INFO(wings);
        check_traced(trace_boundary(loops, fill_rule::non_zero), static_cast<std::uint32_t>(wings), 0);
        loops.push_back({{-20, -20}, {20, -20}, {20, 20}, {-20, 20}});
        check_traced(trace_boundary(loops, fill_rule::even_odd), 1, 1);  // the holes touch in one point
    }
}

TEST_CASE("The boundary encloses exactly what is filled if all crossings are grid points", "[fill][boundary_cycles]")
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
