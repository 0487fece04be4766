// SPDX-License-Identifier: MIT
#pragma once

#include "support/colour_font.hpp"
#include "values.hpp"

#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/colour/read_colour_glyph.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

/// Colour tables, sound ones with changed bytes and random ones -> layers -> regions.
namespace fuzz {

namespace colour_laws {

using namespace typemesh;

inline test::colour_font read_font(values& in)
{
    using namespace test;
    table_writer store = table_writer{}.u16(1).u32(12).u16(1).u32(22);
    store.u16(1).u16(1).fraction(0.0).fraction(1.0).fraction(1.0);
    store.u16(3).u16(1).u16(1).u16(0).i16(100).i16(-50).i16(4096);
    const paint turned =
        moved(27, {in.between(-1.0, 1.0)}, {300, 400}, test::glyph(solid_paint(0), 1 + in.below(9)), 0);
    const paint skewed = moved(28, {in.between(-0.2, 0.2), 0.1}, {}, test::glyph(solid_paint(1, 0.5), 1 + in.below(9)));
    colour_font font =
        painted_font({{1, composite(turned, in.below(29), skewed)}, {2, colr_layers(3, 0)}},
                     {test::glyph(linear({0, 0, 1, 1, 2, 2}, colour_line(0, {{0, 1}, {1, 2}})), 1 + in.below(9)),
                      colr_glyph(1), moved(16, {0.5, -1.0}, {}, test::glyph(colr_glyph(1), 8))},
                     {{1, 2, -100, -100, 700, 800}}, store);
    font.axes = {static_cast<std::int32_t>(in.bits(2)) - 32768};
    if (in.flag()) font.colr.bytes.resize(in.below(static_cast<std::uint32_t>(font.colr.size())));
    while (!in.empty() && font.colr.size() != 0) {
        const std::size_t at = in.bits(2) % font.colr.size();
        font.colr.bytes[at] = static_cast<std::byte>(in.byte());
    }
    return font;
}

}  // namespace colour_laws

inline broken_law colours(values in)
{
    using namespace colour_laws;
    const test::colour_font font = read_font(in);
    recorded_outlines outlines = test::squares();
    colour_glyph g;
    layer_regions regions;
    contours loops;
    for (const glyph_id id : {1u, 2u}) {
        const auto found = read_colour_glyph(font.tables(), id, {.max_layers = 64, .max_paints = 4096}, g);
        if (!found && !(found.error() == error::bad_colours)) return "an unexpected error";
        if (!found && !g.layers.empty()) return "layers after an error";
        if (g.shapes.size() > 200) continue;
        if (!regions.build(outlines, 0, g, 1.0 / 160, layer_cut::visible, 100'000)) continue;
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < regions.layer_count(); ++i) {
            const auto layer = regions.layer(i, loops);
            if (!layer) return layer.error().message();
            const std::int64_t area = inspect::doubled_area(*layer);
            if (area < 0) return "a layer is inside out";
            sum += area;
        }
        const auto all = regions.silhouette(loops);
        if (!all || sum != inspect::doubled_area(*all)) return "the layers are not the silhouette";
    }
    return {};
}

}  // namespace fuzz
