// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/line_room.hpp>

using namespace typemesh;

TEST_CASE("a tab leads to the next stop, never to where the pen is", "[paragraph]")
{
    const double own[] = {0.3, 0.5};
    const line_room room{.tab = 400.0, .stops = own, .stop_unit = 1000.0};
    for (const auto& [pen, next] :
         {std::pair{0.0, 300.0}, {299.0, 300.0}, {300.0, 500.0}, {500.0, 800.0}, {799.0, 800.0}, {800.0, 1200.0}})
        CHECK(room.after_tab(pen) == next);
    const line_room apart{.tab = 400.0, .least_tab = 50.0, .stops = own, .stop_unit = 1000.0};
    for (const auto& [pen, next] :
         {std::pair{250.0, 300.0}, {251.0, 500.0}, {450.0, 500.0}, {451.0, 800.0}, {750.0, 800.0}, {751.0, 1200.0}})
        CHECK(apart.after_tab(pen) == next);
    CHECK(line_room{}.after_tab(7.0) == 7.0);
    CHECK(line_room{.tab = 10.0}.after_tab(-15.0) == -10.0);
}

TEST_CASE("only a paragraph's first line is indented", "[paragraph]")
{
    const line_room room{.indent = 20.0};
    CHECK(room.start(true) == 20.0);
    CHECK(room.start(false) == 0.0);
}

TEST_CASE("a width holds what was measured, and hardly more", "[paragraph]")
{
    for (double em = 100.0; em < 3000.0; em += 1.0)
        for (double width = 0.1; width < 1e4; width *= 3.0) {
            CHECK(widened(width / em * em) >= width);
            CHECK(widened(width) < width + 1e-11 * width);
        }
    CHECK(widened(line_room{}.width) == line_room{}.width);
}
