// SPDX-License-Identifier: MIT

#include <typemesh/core/policy_key.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/extrude/flat_outline.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

static_assert(extruder<flat_outline> && cacheable_policy<flat_outline> && has_front_triangles<flat_outline>);

TEST_CASE("an outline's plan has all its curves and no triangles", "[extrude][boundary]")
{
    test::toy_font font;
    outline drawn;
    REQUIRE(record(font, 1, drawn));
    const auto cells = grid::fitting(font.units_per_em(), drawn.bounds);
    REQUIRE(cells);
    contours loops;
    workspace space;
    REQUIRE(discretise(drawn, certified{}, 1.0, *cells, loops));
    const auto filled = fill(loops, drawn.rule, space);
    REQUIRE(filled);
    flat_outline_data data;
    const auto made = flat_outline{}.plan(*filled, data);
    REQUIRE(made);
    std::size_t begins = 0;
    for (const boundary_piece& piece : data.of<boundary_piece>()) begins += piece.begins;
    CHECK(begins == filled->loop_count());
    CHECK(data.of<boundary_piece>().size() == drawn.curves.size());
    CHECK(made->around.low == cells->cells * drawn.bounds.low);
    CHECK(made->around.high == cells->cells * drawn.bounds.high);
    for (const part p : all_parts) CHECK(made->sizes.triangles[p] == 0);
    const auto nothing = flat_outline{}.plan(region{}, data);
    REQUIRE(nothing);
}
