// SPDX-License-Identifier: MIT

#include <typemesh/extrude/inner_region.hpp>

#include <typemesh/extrude/impl/surroundings.hpp>

#include "capped.hpp"
#include "support/catch.hpp"

using namespace typemesh;
using namespace meshes;

TEST_CASE("an inner region is filled with triangles, and clear() empties it", "[extrude][inner_region]")
{
    for (const shapes::shape& s : shapes::all()) {
        INFO(s.name);
        const region drawn = s.made();
        caps_by<> caps{drawn};
        auto maker = caps.maker();
        inner_region inner;
        REQUIRE(append_loops(drawn, inner.loops));
        inner.loops.grid = s.loops.grid;
        const auto made = inner.fill(maker);
        REQUIRE(made);
        CHECK(made->points().size() == drawn.points().size());
        CHECK(inner.triangles.size() == made->triangle_count());
        CHECK(inner.parting.corners == 0);
        inner.clear();
        CHECK(inner.loops.points.empty());
        CHECK(inner.triangles.empty());
    }
}
