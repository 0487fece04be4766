// SPDX-License-Identifier: MIT
#include "text_icons.hpp"

#include "options.hpp"

#include <typemesh/outline/bar_face.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <vector>

namespace text_to_mesh {

using namespace typemesh;

std::string text_icons::open(const options& o)
{
    for (const std::string& file : o.icons) {
        const std::string trouble =
            icons_.emplace_back().open(file, o.tolerance, layer_cut::visible, o.colour.value_or(rgb_colour{{0, 0, 0}}));
        if (!trouble.empty()) return "--icon: " + trouble;
    }
    return {};
}

const svg_layers* text_icons::icon(std::uint32_t face) noexcept
{
    const std::uint32_t first = fonts_.face_count();
    if (face < first || face - first >= icons_.size()) return nullptr;
    return &*std::next(icons_.begin(), static_cast<std::ptrdiff_t>(face - first));
}

const svg_layers* text_icons::icon_of(style_id style) const
{
    const std::uint32_t number = (static_cast<std::uint32_t>(style) - first_style) / styles_each;
    if (static_cast<std::uint32_t>(style) < first_style || number >= icons_.size()) return nullptr;
    return &*std::next(icons_.begin(), static_cast<std::ptrdiff_t>(number));
}

std::optional<rgb_colour> text_icons::colour_of(style_id style) const
{
    const svg_layers* const drawing = icon_of(style);
    if (drawing == nullptr) return {};
    return drawing->colour_of(style_id{(static_cast<std::uint32_t>(style) - first_style) % styles_each});
}

result<void> text_icons::place(glyph_run& page, bool colours)
{
    std::vector<placed_glyph> made;
    std::size_t next = 0;
    const auto fit = [](const svg_layers& drawing, const affine& to) {  // `to` maps the unit square to the box
        const point size = drawing.view_size();
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
        const svg_layers& drawing = *std::next(icons_.begin(), static_cast<std::ptrdiff_t>(number));
        glyph_run layers;
        if (const auto done = drawing.lay_out(layers, colours); !done) return done.error();
        for (const placed_glyph& layer : layers.glyphs) {
            glyph_style own{.face = fonts_.face_count() + number, .map = fit(drawing, look.map), .style = look.style};
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
    for (const svg_layers& drawing : icons_) lost = drawing.name_losses(who) || lost;
    return lost;
}

}  // namespace text_to_mesh
