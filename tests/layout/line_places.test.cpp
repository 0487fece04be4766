// SPDX-License-Identifier: MIT

#include <typemesh/layout/impl/line_places.hpp>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

constexpr line_metrics metrics{800.0, -200.0, 90.0};

}  // namespace

TEST_CASE("lines stand one line distance apart, whichever way they run", "[layout][line_places]")
{
    for (const double spacing : {1.0, 1.5, -1.0}) {
        const line_places down{metrics, 1000.0, direction::left_to_right, {.line_spacing = spacing}};
        const line_places left{metrics, 1000.0, direction::top_to_bottom, {.line_spacing = spacing}};
        const line_places right{metrics, 1000.0, direction::top_to_bottom, {.line_spacing = spacing}, true};
        for (std::size_t line = 0; line < 5; ++line) {
            CHECK(down.origin(line, 0.0) == point{0.0, -1090.0 * spacing * double(line)});
            CHECK(left.origin(line, 0.0) == point{-1090.0 * spacing * double(line), 0.0});
            CHECK(right.origin(line, 0.0) == point{1090.0 * spacing * double(line), 0.0});
        }
    }
    const line_places unmeasured{line_metrics{}, 1000.0, direction::left_to_right, {}};  // an em
    CHECK(unmeasured.origin(3, 0.0) == point{0.0, -3000.0});
}

TEST_CASE("every line of an alignment has the same point at 0", "[layout][line_places]")
{
    for (const double advance : {0.0, 1.0, 777.0}) {
        for (const auto& [align, share] :
             {std::pair{alignment::left, 0.0}, std::pair{alignment::centre, 0.5}, std::pair{alignment::right, 1.0}}) {
            const line_places level{metrics, 1000.0, direction::left_to_right, {.align = align}};
            const line_places upright{metrics, 1000.0, direction::top_to_bottom, {.align = align}};
            CHECK(level.origin(2, advance).x + share * advance == 0.0);
            CHECK(upright.origin(2, advance).y - share * advance == 0.0);  // lines run down
        }
    }
}

TEST_CASE("a line runs along its direction only, and never backwards", "[layout][line_places]")
{
    const line_places level{metrics, 1000.0, direction::left_to_right, {}};
    const line_places upright{metrics, 1000.0, direction::top_to_bottom, {}};
    CHECK(level.advance({500.0, -3.0}) == 500.0);
    CHECK(level.advance({-500.0, -3.0}) == 0.0);
    CHECK(upright.advance({20.0, -700.0}) == 700.0);
    CHECK(upright.advance({20.0, 700.0}) == 0.0);
}
