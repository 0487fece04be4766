// SPDX-License-Identifier: MIT

// Texts as outlines: what they enclose is what the text's faces cover, wherever it stands.

#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/outline/svg_path_writer.hpp>
#include <typemesh/text/each_outline.hpp>
#include <typemesh/typemesh.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"
#include "support/toy_shaper.hpp"

#include <cstdint>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

double area_of(const outline& o)
{
    double sum = 0.0;
    for (std::uint32_t k = 0; k < o.contour_count(); ++k)
        sum += 0.5 * detail::doubled_area(o.curves.view().subspan(o.starts[k], o.starts[k + 1] - o.starts[k]));
    return sum;
}

template <class Font>
double area_of_faces(Font& font, const char* text, const text_options& how)
{
    text_mesher mesher{font, extruded<>{.depth = 1.0f}};
    std::vector<vec3> points;
    std::vector<std::uint32_t> indices;
    constexpr auto position = [](const surface_point<attribute::position>& s) noexcept { return s.position; };
    REQUIRE(mesher.build(text, into(points, indices, position), how).has_value());
    return inspect::measure(inspect::mesh_view{points, indices}).volume / how.size;
}

}  // namespace

TEST_CASE("a text's outlines enclose what its faces cover, also when they are merged", "[text][boundary]")
{
    test::toy_font font;
    for (const bool merge : {false, true})
        for (const double size : {1.0, 40.0}) {
            text_options how;
            how.size = size;
            how.tolerance = 1e-5;
            how.merge = merge;
            text_mesher mesher{font, flat_outline{}};
            auto plan = mesher.plan("ooolx", how);
            REQUIRE(plan);
            CHECK(plan->size().triangles == 0);
            outline all;
            outline_recorder to{all};
            each_outline(*plan, to);
            REQUIRE(to.finish() == error::none);
            CHECK(all.contour_count() > 0);
            CHECK(area_of(all) == Approx(area_of_faces(font, "ooolx", how)).epsilon(1e-3));

            svg_path_writer text{{.yy = -1.0}, 9};
            each_outline(*plan, text);
            REQUIRE(text.finish());
            outline read;
            outline_recorder again{read};
            REQUIRE(draw_svg_path(text.text(), 1e-9, again));
            REQUIRE(again.finish() == error::none);
            CHECK(read.contour_count() == all.contour_count());
            CHECK(area_of(read) == Approx(-area_of(all)).epsilon(1e-6));
        }
}

TEST_CASE("the outlines of a frame's text are turned", "[text][boundary]")
{
    test::toy_font font;
    text_mesher mesher{font, flat_outline{}};
    auto plain = mesher.plan("ox");
    REQUIRE(plain);
    outline before, after;
    outline_recorder to{before}, turned{after};
    each_outline(*plain, to);
    text_mesher second{font, flat_outline{}};
    auto plan = second.plan("ox", {.frame = {.right = {0, 1, 0}, .up = {-1, 0, 0}}});
    REQUIRE(plan);
    each_outline(*plan, turned);
    REQUIRE(before.curves.size() == after.curves.size());
    for (std::size_t i = 0; i < before.curves.size(); ++i)
        for (std::uint32_t k = 0; k <= before.curves[i].degree; ++k) {
            CHECK(after.curves[i].p[k].x == Approx(-before.curves[i].p[k].y));
            CHECK(after.curves[i].p[k].y == Approx(before.curves[i].p[k].x));
        }
}

TEST_CASE("a text of outlines allocates nothing after warm-up", "[text][boundary]")
{
    test::toy_font font;
    test::counting_memory counted;
    text_mesher mesher{font, flat_outline{}, counted.source()};
    REQUIRE(mesher.plan("ooolx", {.merge = true}).has_value());
    REQUIRE(mesher.plan("ooolx", {.merge = true}).has_value());
    const std::size_t before = counted.requests;
    REQUIRE(mesher.plan("ooolx", {.merge = true}).has_value());
    CHECK(counted.requests == before);
}
