// SPDX-License-Identifier: MIT

#include <typemesh/fill/nest.hpp>
#include <typemesh/triangulate/cut_region.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/oracle.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// Cuts the stem below, first its ears, which are low. Final or not.
template <bool Final>
struct ears_first {
    static constexpr bool has_final_diagonals = Final;
    error operator()(const region&, workspace&, triangle_list& out) const noexcept
    {
        constexpr triangle all[] = {{1, 2, 3}, {4, 5, 0}, {0, 1, 3}, {0, 3, 4}};
        return out.append(all) ? error{} : error{error::out_of_memory};
    }
};

}  // namespace

TEST_CASE("cut_region() appends, and keeps the triangles before it when the triangulator fails", "[triangulate]")
{
    struct failing {
        error operator()(const region&, workspace&, triangle_list&) const noexcept { return error::out_of_memory; }
    };
    contours loops = test::contours_of({test::square(0, 0, 8)});
    workspace space;
    const auto r = nest(loops, fill_rule::non_zero, space);
    REQUIRE(r);
    triangle_list out;
    REQUIRE(cut_region(*r, monotone{}, space, out));
    REQUIRE(cut_region(*r, monotone{}, space, out));
    CHECK(out.size() == 4);
    CHECK(cut_region(*r, failing{}, space, out) == error::out_of_memory);
    CHECK(out.size() == 4);
}

TEST_CASE("cut_region() exchanges low triangles unless the diagonals are final", "[triangulate]")
{
    // A slanted stem with a point a cell outside of each side.
    const test::shape stem{
        "stem",
        {{{0, 0}, {100'000, 0}, {350'001, 700'000}, {600'000, 1'400'000}, {500'000, 1'400'000}, {249'999, 700'000}}}};
    const auto low_of = [&](const auto& how) {
        contours loops = test::contours_of(stem);
        loops.grid.units_per_em = 8192.0;  // low: below four cells
        workspace space;
        triangle_list out;
        const auto made = nest(loops, fill_rule::non_zero, space);
        REQUIRE(made);
        REQUIRE(cut_region(*made, how, space, out));
        CHECK(test::oracle::broken_law(*made, out.view()) == "");
        const triangle_heights heights{loops.grid};
        std::size_t low = 0;
        for (const triangle t : out) low += heights.is_low(loops.points[t.a], loops.points[t.b], loops.points[t.c]);
        return low;
    };
    CHECK(low_of(ears_first<true>{}) != 0);
    CHECK(low_of(ears_first<false>{}) == 0);
    CHECK(low_of(monotone{}) == 0);
}
