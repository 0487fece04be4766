// SPDX-License-Identifier: MIT

// Letters that are strokes along their outlines.

#include <typemesh/glyph/outline_step.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/outline/stroked.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <vector>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

static_assert(outline_step<stroked>);

TEST_CASE("a stroked letter is a closed solid with the volume of its strokes", "[outline][stroke]")
{
    test::toy_font font;
    constexpr auto position = [](const surface_point<attribute::position>& s) noexcept { return s.position; };
    for (const double width : {0.02, 0.04}) {
        text_mesher mesher{font, extruded<>{.depth = 1.0f}, stroked{{.width = width}}};
        std::vector<vec3> points;
        std::vector<std::uint32_t> indices;
        text_options how;
        how.tolerance = 1e-4;
        const auto made = mesher.build("o", into(points, indices, position), how);
        REQUIRE(made);
        CHECK(made->refused == 0);
        const inspect::mesh_view mesh{points, indices};
        CHECK(inspect::check_closedness(mesh).is_closed());
        // Two circles, of 0.25 and 0.15 em: the length of the middle line times the width.
        CHECK(inspect::measure(mesh).volume == Approx(2.0 * 3.14159265 * 0.4 * width).epsilon(2e-3));
    }
}

TEST_CASE("a stroke's options are refused by the mesher, and long outlines too", "[outline][stroke]")
{
    test::toy_font font;
    text_mesher mesher{font, flat{}, stroked{{.width = -1.0}}};
    const auto refused = mesher.plan("o");
    REQUIRE_FALSE(refused);
    CHECK(refused.error() == error::bad_option);
    outline drawn, out;
    REQUIRE(record(font, 1, drawn));
    const drawn_place at{{}, 1e-3, {}};
    CHECK(stroked{}(drawn, at, 1e-3, 10, out).error() == error::too_many_points);
    const auto made = stroked{}(drawn, at, 1e-3, 1000, out);
    REQUIRE(made);
    CHECK(*made == Approx(0.75e-3));
}

TEST_CASE("a path becomes a solid of the right volume", "[outline][svg]")
{
    svg_path ring{"M0 12a12 12 0 1 1 24 0a12 12 0 1 1-24 0zm6 0a6 6 0 1 0 12 0a6 6 0 1 0-12 0z", 24.0};
    glyph_run run;
    REQUIRE(run.glyphs.push_back({}));
    text_mesher mesher{ring, extruded<>{.depth = 1.0f}};
    std::vector<vec3> points;
    std::vector<std::uint32_t> indices;
    constexpr auto position = [](const surface_point<attribute::position>& s) noexcept { return s.position; };
    const auto made = mesher.build(run, into(points, indices, position), {.tolerance = 1e-4});
    REQUIRE(made);
    CHECK(made->refused == 0);
    CHECK(inspect::measure(inspect::mesh_view{points, indices}).volume ==
          Approx(3.14159265 * 0.25 * 0.75).epsilon(1e-3));
}
