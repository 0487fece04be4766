// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "windows/windows_font.hpp"

#include <typemesh/adapt/directwrite.hpp>
#include <typemesh/compat/d3dx_text.hpp>

#include <windows.h>

#include <cstddef>
#include <string>
#include <vector>

using namespace typemesh;

TEST_CASE("the metrics of D3DXCreateText's stand-in may be copied into GLYPHMETRICSFLOAT", "[windows]")
{
    STATIC_REQUIRE(sizeof(d3dx_glyph_metrics) == sizeof(GLYPHMETRICSFLOAT));
    CHECK(offsetof(d3dx_glyph_metrics, box_width) == offsetof(GLYPHMETRICSFLOAT, gmfBlackBoxX));
    CHECK(offsetof(d3dx_glyph_metrics, box_height) == offsetof(GLYPHMETRICSFLOAT, gmfBlackBoxY));
    CHECK(offsetof(d3dx_glyph_metrics, origin) == offsetof(GLYPHMETRICSFLOAT, gmfptGlyphOrigin));
    CHECK(offsetof(vec2, y) == offsetof(POINTFLOAT, y));
    CHECK(offsetof(d3dx_glyph_metrics, advance_x) == offsetof(GLYPHMETRICSFLOAT, gmfCellIncX));
    CHECK(offsetof(d3dx_glyph_metrics, advance_y) == offsetof(GLYPHMETRICSFLOAT, gmfCellIncY));
}

TEST_CASE("D3DXCreateText's stand-in makes closed meshes of TrueType and of CFF through DirectWrite", "[windows]")
{
    const std::string file = GENERATE("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                      "/usr/share/fonts/opentype/comic-neue/ComicNeue-Regular.otf");
    const double deviation = GENERATE(0.1, 0.001);
    auto font = directwrite_font::open(test::windows_path(file).c_str());
    REQUIRE(font);
    d3dx_text maker{*font};
    const auto plan = maker.plan(u"Hello world!", {.deviation = deviation, .extrusion = 0.3});
    REQUIRE(plan);
    CHECK(plan->report().complete());

    test::full_mesh m;
    m.vertices.resize(static_cast<std::size_t>(plan->size().vertices));
    m.indices.resize(static_cast<std::size_t>(plan->size().indices()));
    REQUIRE(plan->write(std::span{m.vertices}, std::span{m.indices}));
    const auto closed = test::examine(m);
    CHECK(closed.unmatched_edges == 0);
    CHECK(closed.zero_area == 0);
    CHECK(test::volume(m.vertices, m.indices) > 0.1);

    std::vector<d3dx_glyph_metrics> metrics(plan->metrics_size());
    REQUIRE(plan->metrics(metrics));
    CHECK(metrics[2].advance_x == metrics[3].advance_x);
    CHECK(metrics[0].box_height > metrics[1].box_height);
    CHECK(metrics[5].box_width == 0.0f);
}
