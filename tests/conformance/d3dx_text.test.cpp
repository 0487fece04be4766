// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/adapt/freetype.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/compat/d3dx_text.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

harfbuzz_font open(const std::string& name)
{
    auto font = harfbuzz_font::open(font_file(name).c_str());
    REQUIRE(font);
    return std::move(*font);
}

std::vector<d3dx_glyph_metrics> metrics_of(harfbuzz_font& font, const std::u16string& text,
                                           const d3dx_text_options& options = {})
{
    d3dx_text maker{font};
    const auto plan = maker.plan(text, options);
    REQUIRE(plan);
    std::vector<d3dx_glyph_metrics> m(plan->metrics_size());
    REQUIRE(plan->metrics(m));
    return m;
}

float width_of(const std::vector<d3dx_glyph_metrics>& metrics)
{
    float sum = 0.0f;
    for (const auto& m : metrics) sum += m.advance_x;
    return sum;
}

const std::vector<std::string> fonts{"truetype/dejavu/DejaVuSans.ttf", "truetype/liberation/LiberationSans-Regular.ttf",
                                     "opentype/comic-neue/ComicNeue-Regular.otf"};

}  // namespace

TEST_CASE("the metrics of D3DXCreateText's stand-in are HarfBuzz's advances and extents", "[conformance]")
{
    auto font = open(GENERATE(from_range(fonts)));
    const std::u16string text = u"Hello world! AVAT fi \u00C9j";
    const double em = font.units_per_em();
    const auto metrics = metrics_of(font, text, {.deviation = 0.0, .size = d3dx_size::em});
    REQUIRE(metrics.size() == text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        INFO("character " << i);
        hb_codepoint_t id = 0;
        REQUIRE(hb_font_get_nominal_glyph(font.handle(), text[i], &id));
        hb_glyph_extents_t box = {};
        REQUIRE(hb_font_get_glyph_extents(font.handle(), id, &box));
        const double unit = 1.0 / (64.0 * em), close = 2.0 / em;  // HarfBuzz rounds boxes outwards; curves are chords
        CHECK(metrics[i].advance_x == Approx(hb_font_get_glyph_h_advance(font.handle(), id) * unit).margin(1e-6));
        CHECK(metrics[i].box_width == Approx(box.width * unit).margin(close));
        CHECK(metrics[i].box_height == Approx(-box.height * unit).margin(close));
        if (box.width == 0) continue;
        CHECK(metrics[i].origin.x == Approx(box.x_bearing * unit).margin(close));
        CHECK(metrics[i].origin.y == Approx(box.y_bearing * unit).margin(close));
    }
}

TEST_CASE("kerning moves letters closer together only if it is switched on", "[conformance]")
{
    auto font = open("truetype/liberation/LiberationSans-Regular.ttf");
    const auto apart = metrics_of(font, u"AV"), together = metrics_of(font, u"AV", {.kerning = true});
    CHECK(together[0].advance_x < apart[0].advance_x);
    CHECK(together[1].advance_x == Approx(apart[1].advance_x));
    CHECK(width_of(metrics_of(font, u"lo")) == Approx(width_of(metrics_of(font, u"lo", {.kerning = true}))));
}

TEST_CASE("a ligature, if switched on, is one glyph whose letters share the metrics of the first", "[conformance]")
{
    auto font = open(fonts[0]);
    const auto plain = metrics_of(font, u"fi"), joined = metrics_of(font, u"fi", {.ligatures = true});
    CHECK(plain[1].advance_x > 0.0f);
    CHECK(joined[1].advance_x == 0.0f);
    CHECK(joined[0].advance_x > plain[0].advance_x);
}

TEST_CASE("a letter outside the first plane has its metrics at its first unit", "[conformance]")
{
    auto font = open("truetype/dejavu/DejaVuSans.ttf");
    const auto m = metrics_of(font, u"\U0001D49C!");
    REQUIRE(m.size() == 3);
    CHECK(m[0].advance_x > 0.0f);
    CHECK(m[1].advance_x == 0.0f);
    CHECK(m[2].box_height > 0.0f);
}

TEST_CASE("fonts of both orientations have closed meshes that face outwards, with either font library", "[conformance]")
{
    const std::string path = font_file(GENERATE(from_range(fonts)));
    const double deviation = GENERATE(0.1, 0.01, 0.005, 0.001);
    const auto test_with = [&](auto font) {
        REQUIRE(font);
        d3dx_text maker{*font};
        const auto plan = maker.plan(u"Hello world! \u00C5\u0105&", {.deviation = deviation, .extrusion = 0.3});
        REQUIRE(plan);
        CHECK(plan->report().complete());
        const auto m = test::written<test::full_mesh>(*plan);
        const auto closed = test::examine(m);
        CHECK(closed.unmatched_edges == 0);
        CHECK(closed.zero_area == 0);
        CHECK(test::volume(m.vertices, m.indices) > 0.2);
    };
    test_with(harfbuzz_font::open(path.c_str()));
    test_with(freetype_font::open(path.c_str()));
}
