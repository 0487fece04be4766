// SPDX-License-Identifier: MIT
#include "text_icons.hpp"

#include "options.hpp"

#include <typemesh/markup/markup.hpp>
#include <typemesh/outline/bar_face.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace text_to_mesh {

using namespace typemesh;

std::string text_icons::open(const options& o, double largest_side)
{
    const double tolerance = o.tolerance / std::max(1.0, largest_side);  // place() makes drawings as large as boxes
    for (const std::string& file : o.icons) {
        const std::string trouble =
            icons_.emplace_back().open(file, tolerance, layer_cut::visible, o.colour.value_or(rgb_colour{{0, 0, 0}}));
        if (!trouble.empty()) return "--icon: " + trouble;
    }
    return {};
}

const svg_layers* text_icons::icon(std::uint32_t face) noexcept
{
    const std::uint32_t first = fonts_.face_count();
    if (face < first || face - first >= icons_.size()) return nullptr;
    return &drawing(face - first);
}

const svg_layers& text_icons::drawing(std::uint32_t number) const
{
    return *std::next(icons_.begin(), static_cast<std::ptrdiff_t>(number));
}

std::optional<std::uint32_t> text_icons::number_of(style_id style) const
{
    const std::uint32_t number = (static_cast<std::uint32_t>(style) - first_style) / styles_each;
    if (static_cast<std::uint32_t>(style) < first_style || number >= icons_.size()) return {};
    return number;
}

style_id text_icons::style_of_box(style_id style) const
{
    const auto number = number_of(style);
    return number && *number < box_styles_.size() ? box_styles_[*number] : style;
}

std::optional<rgb_colour> text_icons::colour_of(style_id style) const
{
    const auto number = number_of(style);
    if (!number) return {};
    return drawing(*number).colour_of(style_id{(static_cast<std::uint32_t>(style) - first_style) % styles_each});
}

result<void> text_icons::place(glyph_run& page, bool colours)
{
    std::vector<placed_glyph> made;
    std::size_t next = 0;
    box_styles_.assign(icons_.size(), style_id{});
    const auto fit = [](const svg_layers& drawn, const affine& to) {  // `to` maps the unit square to the box
        const point size = drawn.view_size();
        const double scale = std::min(to.xx / size.x, to.yy / size.y);
        return affine{.xx = scale,
                      .dx = to.dx + 0.5 * (to.xx - scale * size.x),
                      .yy = scale,
                      .dy = to.dy + 0.5 * (to.yy - scale * size.y)};
    };
    const auto add = [&](std::size_t i) -> error {
        const placed_glyph box = page.glyphs[i];
        made.push_back(box);
        if (page.glyph_styles.empty()) return {};
        const glyph_style look = page.glyph_styles[box.glyph_style];
        const bool is_box = look.face == bar_face && is_blank_bar(box.id);
        if (!is_box || box.id - blank_bar >= icons_.size()) return {};
        const std::uint32_t number = box.id - blank_bar;
        box_styles_[number] = look.style;
        const svg_layers& own_drawing = drawing(number);
        glyph_run layers;
        if (const auto done = own_drawing.lay_out(layers, colours); !done) return done.error();
        for (const placed_glyph& layer : layers.glyphs) {
            glyph_style own{
                .face = fonts_.face_count() + number, .map = fit(own_drawing, look.map), .style = look.style};
            if (colours) {
                const auto style = static_cast<std::uint32_t>(layers.glyph_styles[layer.glyph_style].style);
                own.style = style_id{first_style + number * styles_each + style};
            }
            const auto of_page = page.number_of(own);
            if (!of_page) return of_page.error();
            placed_glyph drawn = box;
            drawn.id = layer.id;
            drawn.glyph_style = *of_page;
            made.push_back(drawn);
        }
        return {};
    };
    for (auto& line : page.lines) {
        for (; next < line.first_glyph; ++next)
            if (error e = add(next)) return e;
        const std::size_t end = next + line.glyph_count;
        line.first_glyph = static_cast<std::uint32_t>(made.size());
        for (; next < end; ++next)
            if (error e = add(next)) return e;
        line.glyph_count = static_cast<std::uint32_t>(made.size()) - line.first_glyph;
    }
    for (; next < page.glyphs.size(); ++next)
        if (error e = add(next)) return e;
    page.glyphs.clear();
    return page.glyphs.append(array_view<const placed_glyph>{made}) ? error{} : error::out_of_memory;
}

bool text_icons::name_losses(const std::string& who) const
{
    bool lost = false;
    for (const svg_layers& one : icons_) lost = one.name_losses(who) || lost;
    return lost;
}

double largest_box(std::string_view source, std::size_t count)
{
    markup read;
    double side = 0.0;
    if (!read.read(source)) return side;  // read_markup() says why
    const auto boxes = read.boxes();
    for (std::size_t i = 0; i < std::min(count, boxes.size()); ++i)
        side = std::max({side, boxes[i].width, boxes[i].ascent + boxes[i].descent});
    return side;
}

}  // namespace text_to_mesh
