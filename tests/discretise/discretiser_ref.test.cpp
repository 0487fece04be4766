// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/impl/discretiser_ref.hpp>
#include <typemesh/discretise/two_lines.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <algorithm>
#include <vector>

using namespace typemesh;

TEMPLATE_TEST_CASE("a discretiser makes the same points through its reference", "[discretise]", certified, two_lines)
{
    test::toy_font font;
    outline drawn;
    REQUIRE(record(font, 1, drawn));
    const auto cells = grid::fitting(1000.0, drawn.bounds);
    REQUIRE(cells);
    const TestType how;
    const discretiser_ref refers{how};
    CHECK(refers.keeps_tolerance() == keeps_tolerance<TestType>);
    CHECK(refers.key() == key_of(how));
    for (const double tolerance : {0.1, 10.0}) {
        std::vector<std::uint8_t> halvings(drawn.curves.size());
        for (const std::uint8_t times : {std::uint8_t{0}, std::uint8_t{2}}) {
            halvings.assign(halvings.size(), times);
            contours own, by_ref;
            REQUIRE(discretise(drawn, how, tolerance, *cells, own, halvings));
            REQUIRE_FALSE(refers.flatten(drawn, tolerance, *cells, by_ref, halvings));
            CHECK(own.tolerance == by_ref.tolerance);
            CHECK(std::ranges::equal(own.points, by_ref.points));
        }
    }
    contours none;
    CHECK(refers.flatten(drawn, -1.0, *cells, none) == error::bad_tolerance);
}
