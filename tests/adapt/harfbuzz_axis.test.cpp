// SPDX-License-Identifier: MIT
#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/each_failure.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"

using namespace typemesh;

namespace {

const char* const inter_variable = "truetype/inter-vf/Inter-roman.var.ttf";

std::vector<axis_coordinate> sorted(const buffer<axis_coordinate>& list)
{
    std::vector<axis_coordinate> all(list.begin(), list.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace

TEST_CASE("an axis has the font's values, coordinates and masters", "[adapt][morph]")
{
    const auto font = harfbuzz_font::open(font_file(inter_variable));
    REQUIRE(font);
    CHECK(harfbuzz_axis::open(*font, "QQQQ").error() == error::unknown_variation);
    auto axis = harfbuzz_axis::open(*font, "wght");
    REQUIRE(axis);
    CHECK(axis->low() == 100.0);
    CHECK(axis->high() == 900.0);
    CHECK(axis->coordinate(axis->low()) == -16384);
    CHECK(axis->coordinate(axis->usual()) == 0);
    CHECK(axis->coordinate(axis->high()) == 16384);
    CHECK(axis->coordinate(5000.0) == 16384);
    buffer<axis_coordinate> masters;
    REQUIRE_FALSE(axis->append_masters(masters));
    const auto all = sorted(masters);
    for (const axis_coordinate c : {-16384, 0, 16384}) CHECK(std::binary_search(all.begin(), all.end(), c));
}

TEST_CASE("an axis takes its memory from the given source, and none later", "[adapt][morph]")
{
    const auto font = harfbuzz_font::open(font_file(inter_variable));
    REQUIRE(font);
    test::counting_memory counted;
    {
        auto axis = harfbuzz_axis::open(*font, "wght", counted.source());
        REQUIRE(axis);
        CHECK(counted.requests == 2);
        for (const double value : {100.0, 333.0, 900.0}) REQUIRE_FALSE(axis->move_to(axis->coordinate(value)));
        CHECK(counted.requests == 2);
    }
    CHECK(counted.bytes_held == 0);
    CHECK(test::check_each_failure([&](memory source) {
              const auto axis = harfbuzz_axis::open(*font, "wght", source);
              return axis ? error{} : axis.error();
          }) == 2);
}

TEST_CASE("an axis at a coordinate draws as the font opened at that value", "[adapt][morph]")
{
    const auto font = harfbuzz_font::open(font_file(inter_variable));
    REQUIRE(font);
    auto axis = harfbuzz_axis::open(*font, "wght");
    REQUIRE(axis);
    const std::uint64_t before = font->variation_key();
    for (const float value : {100.0f, 333.0f, 400.0f, 850.0f}) {
        const variation at[] = {{"wght", value}};
        auto opened = harfbuzz_font::open(font_file(inter_variable), {.variations = at});
        REQUIRE(opened);
        REQUIRE_FALSE(axis->move_to(axis->coordinate(as_double(value))));
        for (const glyph_id id : {20u, 300u, 1200u}) {
            outline a, b;
            REQUIRE(record(*opened, id, a));
            REQUIRE(record(axis->font(), id, b));
            REQUIRE(a.curves.size() == b.curves.size());
            for (std::size_t i = 0; i < a.curves.size(); ++i) CHECK(a.curves[i].p[1] == b.curves[i].p[1]);
        }
    }
    CHECK(font->variation_key() == before);  // the given font stays where it was
}

TEST_CASE("pens of a morphed text are the font's, within the units to which advances are rounded", "[adapt][morph]")
{
    const auto font = harfbuzz_font::open(font_file(inter_variable));
    REQUIRE(font);
    auto axis = harfbuzz_axis::open(*font, "wght");
    REQUIRE(axis);
    const std::string text = "AVATAR To. fi";
    axis_morph morph{*axis};
    auto plan = morph.plan(text, {.size = font->units_per_em(), .depth = 0.0f});
    REQUIRE(plan);
    REQUIRE(plan->section_count() == 1);
    struct vertex {
        vec3 position;
        cluster_id cluster;
    };
    const auto keep = [](const surface_point<attribute::position | attribute::cluster>& s) noexcept {
        return vertex{s.position, s.cluster};
    };
    for (const float value : {100.0f, 250.0f, 400.0f, 610.0f, 900.0f}) {
        const variation at[] = {{"wght", value}};
        auto opened = harfbuzz_font::open(font_file(inter_variable), {.variations = at});
        REQUIRE(opened);
        glyph_run run;
        REQUIRE(layout(*opened, text, {}, {}, run));
        std::vector<vertex> vertices;
        std::vector<std::uint32_t> indices;
        REQUIRE(plan->write_at(axis->coordinate(as_double(value)), into(vertices, indices, keep)));
        for (std::size_t j = 0; j < run.glyphs.size(); ++j) {
            outline drawn;
            REQUIRE(record(*opened, run.glyphs[j].id, drawn));
            box around;
            for (const curve& c : drawn.curves) around.add(c.p[0]), around.add(c.end());
            double left = 1e9;
            for (const vertex& v : vertices)
                if (v.cluster == run.glyphs[j].cluster) left = std::min(left, as_double(v.position.x));
            if (drawn.curves.size() == 0) continue;
            CHECK(std::fabs(left - (run.glyphs[j].origin.x + around.low.x)) < 1.0 * static_cast<double>(j + 1));
        }
    }
}
