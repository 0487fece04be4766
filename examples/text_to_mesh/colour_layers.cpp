// SPDX-License-Identifier: MIT
#include "colour_layers.hpp"

#include "marked_text.hpp"
#include "options.hpp"

#include <cmath>
#include <cstdio>

namespace text_to_mesh {

namespace {

typemesh::palette_colour text_colour_of(const options& o)
{
    const rgb_colour c = o.colour.value_or(rgb_colour{{0, 0, 0}});
    return {c.rgb[0], c.rgb[1], c.rgb[2], static_cast<float>(c.alpha) / 255.0f};
}

}  // namespace

colour_layers::colour_layers(font_set& fonts, const options& o)
    : fonts_{fonts},
      source_{fonts,
              {.layers = *o.colour_layers, .tolerance = o.tolerance, .choice = {.foreground = text_colour_of(o)}}}
{
}

std::string colour_layers::split(typemesh::glyph_run& run)
{
    for (std::uint32_t face = static_cast<std::uint32_t>(tables_.size()); face < fonts_.face_count(); ++face) {
        auto tables = typemesh::harfbuzz_colours::of(fonts_.font(face));
        if (!tables) return tables.error().message();
        tables_.push_back(std::move(*tables));
        if (const auto used = source_.use(face, tables_.back().tables()); !used) return used.error().message();
    }
    const auto report = source_.split(run);
    if (!report) return report.error().message();
    report_ = *report;
    return {};
}

std::optional<rgb_colour> colour_layers::colour_of(typemesh::style_id style, const options& o) const
{
    const typemesh::colour_style* const own = source_.style_of(style);
    if (own == nullptr) return {};
    const typemesh::palette_colour& c = own->paint.colour;
    rgb_colour made{{c.red, c.green, c.blue}};
    if (own->paint.is_text_colour()) made = colour_of_style(o, own->own).value_or(rgb_colour{{0, 0, 0}});
    made.alpha = static_cast<unsigned char>(std::lround(c.alpha * 255.0f));
    return made;
}

bool name_colour_losses(const typemesh::colour_report& report, const std::string& who)
{
    const auto warn = [&who](std::uint32_t count, const char* what) {
        if (count == 0) return false;
        std::fprintf(stderr, "%swarning: %u coloured glyph%s %s\n", who.c_str(), count, count == 1 ? "" : "s", what);
        return true;
    };
    bool warned = warn(report.refused, "cannot be read or cut, and have one colour.");
    warned = warn(report.pictures, "without outlines may be pictures, which are not drawn.") || warned;
    warned = warn(report.blended, "mix colours in a way that is not drawn.") || warned;
    return warn(report.unbounded, "lack a layer without bounds.") || warned;
}

}  // namespace text_to_mesh
