// SPDX-License-Identifier: MIT
#include "marked_text.hpp"

#include "colour_layers.hpp"
#include "option_values.hpp"
#include "options.hpp"
#include "solids.hpp"
#include "svg/svg_layers.hpp"
#include "text_icons.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>

namespace text_to_mesh {
namespace {

/// The fonts of the command line, by their numbers or as they are given there; bold letters take more room.
struct given_fonts {
    const options* o;

    typemesh::error operator()(const typemesh::basic_markup_look<char>& look,
                               typemesh::text_style& style) const noexcept
    {
        if (look.has(typemesh::markup_tag::bold)) style.letter_spacing += 2.0 * bold_growth;
        if (!look.has(typemesh::markup_tag::font)) return {};
        const std::size_t fonts = o->fallback.size() + 1;
        std::size_t face = fonts;
        if (look.font == o->font) face = 0;
        for (std::size_t i = 0; i < o->fallback.size(); ++i)
            if (look.font == o->fallback[i]) face = i + 1;
        if (const auto number = decimal(look.font);
            number && *number >= 1.0 && *number <= static_cast<double>(fonts) && *number == std::floor(*number))
            face = static_cast<std::size_t>(*number) - 1;
        if (face == fonts) return typemesh::error::no_such_face;
        style.face = static_cast<std::uint16_t>(face);
        return {};
    }
};

/// "line 2, character 5" of a place in bytes.
std::string in_words(std::string_view source, std::size_t place)
{
    std::size_t line = 1, character = 1;
    for (std::size_t i = 0; i < place;) {
        const bool ends = source[i] == '\n';
        i = typemesh::decode(source, i, source.size()).next;
        line += ends ? 1 : 0;
        character = ends ? 1 : character + 1;
    }
    return "line " + std::to_string(line) + ", character " + std::to_string(character);
}

/// Why the solids that the tags ask for cannot be made, or an empty string.
std::string refused_solids(const options& o)
{
    const auto solids = o.marked->styles.solids();
    if (solids.size() < 2) return {};
    if (o.instances) return "[depth], [bevel], [b] and [mark] do not work with --instances";
    if (o.letters || o.per_letter)
        return "[depth], [bevel], [b] and [mark] do not work with --letters and --per-letter";
    if (o.carve.tool_angle > 0.0f || o.outline.width > 0.0f || o.inflate.height > 0.0f || o.tube.radius > 0.0f ||
        o.refine.refiner != refiner_name::none)
        return "[depth], [bevel], [b] and [mark] do not work with --carve, --outline, --inflate, --tube and --refine";
    for (std::uint32_t i = 1; i < solids.size(); ++i) {
        const options own = options_of_solid(o, i);
        if (solids[i].has(typemesh::markup_tag::depth) && !(own.depth > 0.0f)) return "[depth=...] must be more than 0";
        if (own.bevel.width > 0.0f && !(own.depth > 0.0f)) return "[bevel=...] needs a [depth=...] or --depth above 0";
        const float both = own.bevel.sides == typemesh::bevel_sides::both ? 2.0f : 1.0f;
        if (own.bevel.width > 0.0f && !(own.bevel.depth * both <= own.depth))
            return "a bevel is deeper than " + std::string{both > 1.0f ? "half of " : ""} +
                   "its letters: give a smaller [bevel=...] or a larger [depth=...]";
    }
    return {};
}

}  // namespace

std::string read_markup(options& o)
{
    o.marked = std::make_shared<marked_text>();
    marked_text& m = *o.marked;
    m.source = o.text;
    if (const auto read = m.read.read(m.source); !read)
        return "--markup: " + in_words(m.source, read.error().cluster) + ": there is " + read.error().option +
               "; write [[ for a bracket of the text.";
    o.text = std::string{m.read.text()};
    if (const auto set = m.styles.set(m.read, given_fonts{&o}); set == typemesh::error::no_such_face)
        return "--markup: [font=...] must be 1 for --font, 2 for the first --fallback, or a font as it is given there.";
    else if (!set)
        return "--markup: " + std::string{set.error().message()};
    const std::size_t boxes = m.read.boxes().size(), icons = o.icons.size();
    if (boxes < icons && o.batch.empty())  // the lines of a batch share the files
        return "--icon: there " + std::string{icons == 1 ? "is 1 file" : "are " + std::to_string(icons) + " files"} +
               ", but the text has " + (boxes == 0 ? "no" : "only " + std::to_string(boxes)) + " [box=W,H].";
    const std::string trouble = refused_solids(o);
    return trouble.empty() ? trouble : "--markup: " + trouble + ".";
}

std::optional<rgb_colour> colour_of_style(const options& o, typemesh::style_id style)
{
    if (o.drawing) {
        const auto own = o.drawing->colour_of(style);
        return own ? own : o.colour;
    }
    if (o.layers && o.layers->owns(style)) return o.layers->colour_of(style, o);
    if (o.placed_icons && o.placed_icons->owns(style)) return o.placed_icons->colour_of(style);
    const auto number = static_cast<std::size_t>(style);
    if (number == 0) return o.colour;
    if (!o.marked) return o.styles[number - 1].colour;
    const typemesh::markup_paint& p = o.marked->styles.paints()[number];
    if (!p.has(typemesh::markup_tag::colour) && !p.has(typemesh::markup_tag::mark)) return o.colour;
    const auto byte = [&p](unsigned shift) { return static_cast<unsigned char>(p.colour >> shift & 255u); };
    return rgb_colour{{byte(16), byte(8), byte(0)}};
}

std::optional<std::uint32_t> tag_of_style(const options& o, typemesh::style_id style)
{
    if (!o.marked || (o.layers && o.layers->owns(style))) return {};
    if (o.placed_icons) style = o.placed_icons->style_of_box(style);
    const typemesh::markup_paint& p = o.marked->styles.paints()[static_cast<std::size_t>(style)];
    if (!p.has(typemesh::markup_tag::style)) return {};
    return p.style;
}

std::uint32_t solids_of(const options& o)
{
    return o.marked ? static_cast<std::uint32_t>(o.marked->styles.solids().size()) : 1;
}

std::uint32_t solid_of_style(const options& o, typemesh::style_id style)
{
    return o.marked->styles.solid_of(o.placed_icons ? o.placed_icons->style_of_box(style) : style);
}

options options_of_solid(const options& o, std::uint32_t solid)
{
    return options_of(o, o.marked->styles.solids()[solid]);
}

void keep_only_solids(const options& o, typemesh::glyph_run& run)
{
    const auto paints = o.marked ? o.marked->styles.paints() : typemesh::array_view<const typemesh::markup_paint>{};
    for (typemesh::glyph_style& l : run.glyph_styles) {
        const std::uint32_t solid = o.marked ? o.marked->styles.solid_of(l.style) : 0;
        std::uint32_t first = 0;
        while (first < paints.size() && paints[first].solid != solid) ++first;
        l.style = typemesh::style_id{solid == 0 ? 0 : first};
    }
}

}  // namespace text_to_mesh
