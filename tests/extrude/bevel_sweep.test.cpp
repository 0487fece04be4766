// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_sweep.hpp>

#include <typemesh/extrude/bevel_profile.hpp>

#include "shapes.hpp"
#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a sweep to nowhere has the region's points and edges at level 0", "[bevel_sweep]")
{
    for (const auto& s : shapes::all()) {
        swept_region out;
        REQUIRE(sweep_nowhere(s.made(), out));
        REQUIRE(out.nodes.size() == s.points());
        REQUIRE(out.edges_at.size() == s.points());
        REQUIRE(out.at_level.size() == 2);
        CHECK(out.at_level[1] == s.points());
        CHECK(out.levels.size() == 1);
        CHECK(out.triangles.empty());
        for (std::uint32_t i = 0; i < s.points(); ++i) {
            CHECK(out.nodes[i].at == s.loops.points[i]);
            CHECK(out.edges_at[i].edge == i);
            CHECK(out.edges_at[i].a == i);
            CHECK(out.edges_at[i].b == s.next(i));
        }
    }
}

TEST_CASE("an outward bevel sweeps to its profile's levels, beginning at the cap", "[bevel_sweep]")
{
    const auto s = shapes::rectangle();
    const profile_points points{{0, 0}, {0.25f, 0.5f}, {1, 1}};
    const profile_levels levels{points, {4096.0, 4096.0, 0.0}};
    workspace space;
    swept_region out;
    for (const bool outward : {false, true}) {
        REQUIRE_FALSE(bevel_sweep{.outward = outward}(s.made(), s.cap, levels, space, out));
        REQUIRE(out.levels.size() == 3);
        CHECK(is_zero(out.levels[0]));
        CHECK(out.levels[1] == Catch::Approx(outward ? 3072.0 : 1024.0));
        CHECK(same(out.levels[2], 4096.0));
    }
    const profile_levels one{points, {0.0, 4096.0, 0.0}};
    REQUIRE_FALSE(bevel_sweep{}(s.made(), s.cap, one, space, out));
    CHECK(out.levels.size() == 1);
}
