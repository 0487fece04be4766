// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/font_path.hpp"
#include "support/mesh_laws.hpp"

#include <typemesh/adapt/harfbuzz_colours.hpp>
#include <typemesh/colour/colour_outlines.hpp>
#include <typemesh/colour/read_colour_glyph.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <hb-ot.h>

#include <cmath>
#include <cstdint>
#include <vector>

using namespace typemesh;

namespace {

harfbuzz_font coloured_amiri()
{
    auto font = harfbuzz_font::open(font_path("opentype/fonts-hosny-amiri/AmiriQuranColored.ttf").string());
    REQUIRE(font);
    return std::move(*font);
}

}  // namespace

TEST_CASE("layers and colours of a font are those that HarfBuzz reads", "[adapt]")
{
    const harfbuzz_font font = coloured_amiri();
    const auto colours = harfbuzz_colours::of(font);
    REQUIRE(colours);
    CHECK(colours->tables().has_layers());
    CHECK_FALSE(colours->tables().has_bitmaps);
    hb_face_t* const face = hb_font_get_face(font.handle());
    unsigned palette_size = 0;
    palette_size = hb_ot_color_palette_get_colors(face, 0, 0, nullptr, nullptr);
    std::vector<hb_color_t> palette(palette_size);
    hb_ot_color_palette_get_colors(face, 0, 0, &palette_size, palette.data());
    colour_glyph g;
    unsigned coloured = 0, all_layers = 0, wrong = 0;
    for (glyph_id id = 0; id < font.glyph_count(); ++id) {
        const unsigned count = hb_ot_color_glyph_get_layers(face, id, 0, nullptr, nullptr);
        std::vector<hb_ot_color_layer_t> layers(count);
        unsigned room = count;
        hb_ot_color_glyph_get_layers(face, id, 0, &room, layers.data());
        const auto found = read_colour_glyph(colours->tables(), id, {}, g);
        REQUIRE(found);
        REQUIRE(g.layers.size() == count);
        coloured += *found ? 1u : 0u;
        all_layers += count;
        for (unsigned i = 0; i < count; ++i) {
            const glyph_paint& paint = g.layers[i].paint;
            wrong +=
                g.shapes[g.layers[i].shape].id != layers[i].glyph || paint.entry != layers[i].color_index ? 1u : 0u;
            if (layers[i].color_index >= palette_size) continue;
            const hb_color_t c = palette[layers[i].color_index];
            wrong += paint.colour.red != hb_color_get_red(c) || paint.colour.green != hb_color_get_green(c) ||
                             paint.colour.blue != hb_color_get_blue(c) ||
                             std::lround(paint.colour.alpha * 255.0f) != hb_color_get_alpha(c)
                         ? 1u
                         : 0u;
        }
    }
    CHECK(wrong == 0);
    CHECK(coloured == 614);
    CHECK(all_layers == 1164);
}

TEST_CASE("a coloured verse is one mesh of closed solids in several styles", "[adapt]")
{
    harfbuzz_font font = coloured_amiri();
    const auto tables = harfbuzz_colours::of(font);
    REQUIRE(tables);
    colour_outlines colours{font};
    REQUIRE(colours.use(0, tables->tables()));
    text_mesher mesher{colours, extruded<>{}};
    test::full_mesh m;
    const auto plan =
        mesher.plan("بِسۡمِ ٱللَّهِ ٱلرَّحۡمَٰنِ ٱلرَّحِيمِ ۝", {}, colours.edit());
    REQUIRE(plan);
    REQUIRE(colours.report());
    CHECK(colours.report()->coloured > 5);
    CHECK(plan->report().complete());
    CHECK(plan->styles().size() >= 2);
    REQUIRE(plan->write(into(m.vertices, m.indices)));
    CHECK(test::examine(m).is_closed());
}

TEST_CASE("a font without colours has empty tables", "[adapt]")
{
    auto font = harfbuzz_font::open(font_path("truetype/dejavu/DejaVuSans.ttf").string());
    REQUIRE(font);
    const auto tables = harfbuzz_colours::of(*font);
    REQUIRE(tables);
    CHECK_FALSE(tables->tables().has_layers());
    colour_outlines colours{*font};
    REQUIRE(colours.use(0, tables->tables()));
    text_mesher mesher{colours};
    const auto plan = mesher.plan("abc", {}, colours.edit());
    REQUIRE(plan);
    CHECK(colours.report()->coloured == 0);
    CHECK(plan->glyphs().size() == 3);
}
