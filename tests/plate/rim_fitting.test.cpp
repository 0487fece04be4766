// SPDX-License-Identifier: MIT
#include <typemesh/core/orientation.hpp>
#include <typemesh/plate/impl/rim_fitting.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "plate/rim_boxes.hpp"
#include "support/catch.hpp"

#include <cstdint>

using namespace typemesh;
using detail::rim_fitting;
using detail::rim_widths;

TEST_CASE("a bevel and a fillet that fit leave the floor between them, exactly", "[rim_fitting]")
{
    test::rim_boxes boxes;
    rim_fitting rims;
    rim_widths widths{0.05f, 0.1f};
    CHECK_FALSE(rims.fit(boxes.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
    CHECK(widths.bevel == 0.05f);
    CHECK(widths.fillet == 0.1f);
    std::int64_t floor = 0;
    for (const triangle& t : rims.triangles())
        floor += orientation(rims.points()[t.a], rims.points()[t.b], rims.points()[t.c]);
    CHECK(rims.inner().doubled_area() == 2 * 900 * 900);
    CHECK(floor == rims.inner().doubled_area() - rims.outer().doubled_area());
}

TEST_CASE("what meets a rim becomes narrower, and what stands on a rim or beyond it has no bevel", "[rim_fitting]")
{
    rim_fitting rims;
    {
        test::rim_boxes close{30, 300};  // 30 cells from the plate's edge
        rim_widths widths{0.02f, 0.1f};
        CHECK_FALSE(rims.fit(close.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
        CHECK(widths.bevel == 0.02f);
        CHECK(widths.fillet > 0.0f);
        CHECK(widths.fillet < 0.01f);  // 10 cells are left
        widths = {0.2f, 0.0f};
        CHECK_FALSE(rims.fit(close.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
        CHECK(widths.bevel > 0.02f);
        CHECK(widths.bevel < 0.03f);
        widths = {0.0f, 100.0f};  // thousands of times as wide as what fits
        CHECK_FALSE(rims.fit(close.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
        CHECK(widths.fillet > 0.01f);
        CHECK(widths.fillet < 0.03f);
    }
    for (const std::int32_t x : {0, -100}) {
        test::rim_boxes beyond{x, 300};
        rim_widths widths{0.02f, 0.1f};
        CHECK_FALSE(rims.fit(beyond.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
        CHECK(widths.bevel == 0.0f);
        CHECK(widths.fillet == 0.0f);
    }
}

TEST_CASE("a fillet near the grid's end becomes narrower until its surroundings have room there", "[rim_fitting]")
{
    constexpr auto end = static_cast<std::int32_t>(grid::reach);
    test::rim_boxes boxes{300, 300, {end - 1010, -500}};  // the box has 310 cells beside it
    rim_fitting rims;
    rim_widths widths{0.05f, 0.1f};
    CHECK_FALSE(rims.fit(boxes.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
    CHECK(widths.bevel == 0.05f);
    CHECK(widths.fillet > 0.04f);
    CHECK(widths.fillet < 0.1f);
    test::rim_boxes last{580, 300, {end - 1010, -500}};  // 30 cells, which have room for no surroundings
    widths = {0.0f, 0.1f};
    CHECK_FALSE(rims.fit(last.cells, test::rim_boxes::plate, test::rim_boxes::pocket, widths, {}, monotone{}));
    CHECK(widths.fillet == 0.0f);
}
