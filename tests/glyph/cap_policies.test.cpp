// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

TEST_CASE("a glyph's policies can be used for its caps", "[glyph]")
{
    test::toy_font font;
    outline drawn;
    REQUIRE(record(font, 1, drawn));
    const auto cells = grid::fitting(1000.0, drawn.bounds);
    REQUIRE(cells);
    no_observer nobody;
    cap_builder one, other;
    const auto a = one.build(drawn, 1.0, *cells, {}, policies{certified{}, monotone{}, flat{}, nobody});
    const auto b = other.build(drawn, 1.0, *cells, {}, cap_policies{certified{}, monotone{}, nobody});
    REQUIRE((a && b));
    CHECK(a->points().size() == b->points().size());
    CHECK(one.triangles().size() == other.triangles().size());
}
