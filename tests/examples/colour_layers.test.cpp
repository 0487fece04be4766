// SPDX-License-Identifier: MIT

#include "text_to_mesh/colour_layers.hpp"

#include "support/catch.hpp"
#include "support/colour_font.hpp"
#include "text_to_mesh/options.hpp"

TEST_CASE("stops of gradients in the text's colour have that of --colour", "[examples]")
{
    using namespace test;
    const colour_font tables =
        painted_font({{1, glyph(linear({0, 0, 9, 0, 0, 9}, colour_line(0, {{0, 0xFFFF}, {1, 1}})), 2)}});
    auto none = typemesh::harfbuzz_font::wrap(hb_font_get_empty());
    REQUIRE(none);
    text_to_mesh::installed_fallback nothing;
    text_to_mesh::font_set fonts{*none, nothing};
    text_to_mesh::options o;
    o.colour_layers = typemesh::layer_cut::visible;
    o.colour = text_to_mesh::rgb_colour{{10, 20, 30}};
    typemesh::colour_glyph read;
    text_to_mesh::colour_layers layers{fonts, o};
    REQUIRE(typemesh::read_colour_glyph(tables.tables(), 1, layers.source().options().choice, read));
    REQUIRE(read.layers.size() == 1);
    const auto stops = read.stops_of(read.layers[0].paint);
    REQUIRE(stops.size() == 2);
    CHECK(stops[0].colour == typemesh::palette_colour{10, 20, 30, 1.0f});
}
