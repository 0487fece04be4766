// SPDX-License-Identifier: MIT
#include "svg_layers.hpp"

#include "../report.hpp"
#include "svg_glyph.hpp"

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/fill/boundary_curves.hpp>

#include <algorithm>
#include <cstdio>

namespace text_to_mesh {
using namespace typemesh;

std::string svg_layers::open(const std::string& path, double tolerance, layer_cut cut, const rgb_colour& colour)
{
    const svg_options how{0.25 * tolerance * svg_drawing::units_per_em, colour};
    if (std::string trouble = read_svg(path, how, drawing_); !trouble.empty()) return trouble;
    constexpr std::size_t max_layers = 20'000;
    std::size_t changes = 0;
    for (std::size_t i = 1; i < drawing_.items.size(); ++i)
        changes += same_colour(drawing_.items[i - 1].colour, drawing_.items[i].colour) ? 0 : 1;
    if (changes >= max_layers)
        return path + " has more than 20000 layers of different colours: join the shapes of one colour.";
    is_stacked_ = cut == layer_cut::stacked;
    const auto built = build(tolerance, cut);
    if (built) return {};
    const error& e = built.error();
    const std::string advice = " at this quality: choose a coarser --quality, or divide the drawing.";
    if (e == error::too_many_points)
        return path + " has more than " + std::to_string(default_max_pieces) + " points" + advice;
    if (e == error::too_many_pieces) return path + " is too complex" + advice;
    return path + ": " + in_words(e);
}

result<void> svg_layers::build(double tolerance, layer_cut cut)
{
    svg_shape_source source{drawing_.shapes};
    colour_glyph glyph;
    if (!write_layers(drawing_, glyph, layers_)) return error::out_of_memory;
    const auto shows_through = [](const rgb_colour& c) { return c.alpha != 255; };
    if (cut == layer_cut::visible && layers_.size() > 1 &&
        std::any_of(layers_.begin() + 1, layers_.end(), shows_through))
        drawing_.warnings.push_back("translucent shapes hide what they cover");
    if (const auto done = regions_.build(source, 0, glyph, tolerance, cut); !done) return done.error();
    contours loops;
    for (glyph_id g = 0; g <= layers_.size(); ++g) {
        const auto filled = region_of(g, loops);
        if (!filled) return filled.error();
        const auto kept = glyphs_.add([&](auto& pen) { layer_regions::draw(*filled, pen); });
        if (!kept) return kept.error();
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        const auto is_it = [&](const rgb_colour& c) { return same_colour(c, layers_[i]); };
        const auto found =
            is_stacked_ ? style_colours_.end() : std::find_if(style_colours_.begin(), style_colours_.end(), is_it);
        styles_.push_back(static_cast<std::uint32_t>(found - style_colours_.begin()) + 1);
        if (found == style_colours_.end()) style_colours_.push_back(layers_[i]);
    }
    return {};
}

result<region> svg_layers::region_of(glyph_id glyph, contours& loops) const
{
    return glyph < layers_.size() ? regions_.layer(glyph, loops) : regions_.silhouette(loops);
}

result<void> svg_layers::boundary(glyph_id glyph, typemesh::outline& out) const
{
    contours loops;
    const auto filled = region_of(glyph, loops);
    if (!filled) return filled.error();
    boundary_curves finder;
    return finder.find(*filled, out);
}

result<void> svg_layers::lay_out(glyph_run& page, bool colours) const
{
    page.clear();
    page.units_per_em = svg_drawing::units_per_em;
    if (!colours) {
        if (regions_.layer_count() == 0) return {};
        return page.glyphs.push_back({.id = static_cast<glyph_id>(layers_.size())}) ? error{} : error::out_of_memory;
    }
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (regions_.is_empty(i)) continue;
        const auto style = page.number_of({.style = style_id{styles_[i]}});
        if (!style) return style.error();
        if (!page.glyphs.push_back({.id = static_cast<glyph_id>(i), .glyph_style = *style}))
            return error::out_of_memory;
    }
    return {};
}

std::optional<rgb_colour> svg_layers::colour_of(style_id style) const
{
    const auto number = static_cast<std::size_t>(style);
    if (number == 0 || number > style_colours_.size()) return {};
    return style_colours_[number - 1];
}

std::uint32_t svg_layers::level_of(style_id style) const
{
    const auto number = static_cast<std::uint32_t>(style);
    return is_stacked_ && number != 0 ? number - 1 : 0;
}
std::uint32_t svg_layers::level_count() const
{
    return is_stacked_ && !layers_.empty() ? static_cast<std::uint32_t>(layers_.size()) : 1;
}

bool svg_layers::name_losses(const std::string& who) const
{
    for (const std::string& what : drawing_.warnings)
        std::fprintf(stderr, "%swarning: %s.\n", who.c_str(), what.c_str());
    return !drawing_.warnings.empty();
}

}  // namespace text_to_mesh
