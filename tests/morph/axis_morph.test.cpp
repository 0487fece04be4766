// SPDX-License-Identifier: MIT
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/mesh_laws.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

TEST_CASE("glyphs that are replaced along the axis begin a new section", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    const auto plan = morph.plan("oro", {});
    REQUIRE(plan);
    REQUIRE(plan->section_count() == 2);
    CHECK(plan->keys(0)[0] == -16384);
    CHECK(plan->keys(0).back() == 999);
    CHECK(plan->keys(1)[0] == 1000);
    CHECK(plan->keys(1).back() == 16384);
    CHECK(plan->section_at(999.5) == 0);
    CHECK(plan->section_at(1000.0) == 1);
    CHECK(plan->size(0).triangles != plan->size(1).triangles);
    axis.masters = {0};
    const auto other = morph.plan("oo", {.from = -0.5, .to = 0.25});
    REQUIRE(other);
    REQUIRE(other->section_count() == 1);
    CHECK(other->keys(0).size() == 3);
    CHECK(other->keys(0)[0] == -8192);
}

TEST_CASE("a report counts letters that are split, refused, overlapping or missing", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    const auto plan = morph.plan("o x8w?p", {});
    REQUIRE(plan);
    const morph_report& r = plan->report();
    CHECK(r.letters == 5);
    CHECK(r.overlapping >= 2);
    CHECK(r.refused == 1);
    CHECK(r.missing == 1);
    CHECK(r.pinched >= 1);
    CHECK(morph.plan("p", {})->report().pinched == 1);
    CHECK(morph.plan("o", {})->report().pinched == 0);
    CHECK(plan->section_count() > 1);
    std::uint64_t most = 0, last = plan->size(plan->section_count() - 1).triangles;
    for (std::size_t s = 0; s < plan->section_count(); ++s)
        most = most > plan->size(s).triangles ? most : plan->size(s).triangles;
    CHECK(last < most);  // without the refused letter
}

TEST_CASE("letters that are replaced along the axis are counted where most are", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    for (const char* text : {"r", "R"}) {  // both are an 'o' and an 'x', which overlaps
        const auto plan = morph.plan(text, {});
        REQUIRE(plan);
        CHECK(plan->report().letters == 1);
        CHECK(plan->report().overlapping == 1);
    }
    CHECK(morph.plan("rR", {})->report().overlapping == 1);  // one at each place
}

TEST_CASE("pens move with the advances, between their masters evenly", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    auto plan = morph.plan("xx", {.size = 1000.0, .depth = 0.0f});
    REQUIRE(plan);
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (const double v : {-1.0, -0.5, -0.25, 0.0, 0.3, 1.0}) {
        REQUIRE(plan->write_at(16384.0 * v, into(vertices, indices)));
        const double way = as_double(vertices[vertices.size() / 2].x) - as_double(vertices[0].x);
        CHECK(std::fabs(way - (500.0 + (v < 0.0 ? 40.0 : 100.0) * v)) < 1e-2);
    }
}

TEST_CASE("a morph refuses styles and boxes that it would not draw, and takes the others", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    for (const text_style& style :
         {text_style{.size = 2.0}, text_style{.slant = 0.2}, text_style{.decorations = decoration::underline}}) {
        const style_span spans[] = {{1, 2, style}};
        const auto refused = morph.plan("oxo", {.shape = {.styles = spans}});
        REQUIRE_FALSE(refused);
        CHECK(refused.error() == error::bad_option);
        CHECK(std::string_view{refused.error().option} == "styles");
    }
    const inline_box boxes[] = {{.unit = 1, .width = 1.0, .ascent = 0.5}};
    CHECK(morph.plan(u"o\uFFFCo", {.shape = {.boxes = boxes}}).error() == error::bad_option);
    const style_span spans[] = {{1, 2, {.letter_spacing = 0.1, .rise = 0.2, .style = style_id{3}}}};
    CHECK(morph.plan("oxo", {.shape = {.styles = spans}}));
}

TEST_CASE("a morph refuses bad options and survives memory that runs out", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    CHECK(morph.plan("o", {.from = 0.5, .to = 0.5}).error() == error::bad_option);
    CHECK(morph.plan("o", {.from = none}).error() == error::bad_option);
    CHECK(morph.plan("o", {.from = 5.0, .to = 6.0}).error() == error::bad_option);
    CHECK(morph.plan("o", {.tolerance = 0.0}).error() == error::bad_tolerance);
    CHECK(morph.plan("o", {.tolerance = none}).error() == error::bad_tolerance);
    CHECK(morph.plan("o", {.size = 0.0}).error() == error::bad_option);
    CHECK(morph.plan("o", {.depth = -1.0f}).error() == error::bad_option);
    CHECK(morph.plan("o", {.crease_degrees = 181.0f}).error() == error::bad_option);
    CHECK(morph.plan("", {}));

    struct vertex {
        vec3 position;
    };
    const auto keep = [](const surface_point<attribute::position>& s) noexcept { return vertex{s.position}; };
    const auto written = [&](memory source, test::counting_memory* counted) -> error {
        axis_morph own{axis, source};
        auto plan = own.plan("xr", {});
        if (!plan) return plan.error();
        std::vector<vertex> vertices(plan->size(0).vertices);
        std::vector<std::uint32_t> indices(3 * plan->size(0).triangles);
        const std::size_t before = counted != nullptr ? counted->requests : 0;
        for (const double c : {-16384.0, -1.5, 999.0})
            if (const auto done = plan->write_at(c, into(std::span{vertices}, std::span{indices}, keep)); !done)
                return done.error();
        if (counted != nullptr) CHECK(counted->requests == before);  // a frame takes no memory
        return {};
    };
    test::counting_memory counted;
    CHECK_FALSE(written(counted.source(), &counted));
    CHECK(test::check_each_failure([&](memory source) { return written(source, nullptr); }) > 50);
}
