// SPDX-License-Identifier: MIT
#include "svg_layers.hpp"

#include "../report.hpp"

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/fill/boundary_curves.hpp>
#include <typemesh/outline/draw_outline.hpp>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// The shapes of a drawing, each with its own fill rule.
class shape_source {
public:
    explicit shape_source(const std::vector<outline>& shapes) : shapes_{shapes} {}

    [[nodiscard]] double units_per_em() const noexcept { return svg_drawing::units_per_em; }
    /// Of the last shape that was drawn.
    [[nodiscard]] fill_rule fill() const noexcept { return rule_; }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        const typemesh::outline& o = shapes_[id];
        rule_ = o.rule;
        draw_outline(o, sink);
        return {};
    }

private:
    const std::vector<typemesh::outline>& shapes_;
    fill_rule rule_ = fill_rule::non_zero;
};

bool same(const rgb_colour& a, const rgb_colour& b)
{
    return std::memcmp(a.rgb, b.rgb, sizeof a.rgb) == 0 && a.alpha == b.alpha;
}

/// Makes the layers of a drawing.
class layer_writer {
public:
    layer_writer(const svg_drawing& from, colour_glyph& to) : from_{from}, to_{to}, clips_(from.clips.size(), none) {}

    /// Gives the colours of the layers.
    [[nodiscard]] bool write(std::vector<rgb_colour>& colours)
    {
        std::vector<std::uint32_t> together;  // the shapes of one layer
        for (std::size_t i = 0; i < from_.items.size(); ++i) {
            const svg_drawing::item& one = from_.items[i];
            const std::uint32_t shape = add({.id = static_cast<glyph_id>(one.shape)});
            together.push_back(one.within == svg_drawing::no_clip ? shape : both(shape, clip(one.within)));
            if (i + 1 < from_.items.size() && same(from_.items[i + 1].colour, one.colour)) continue;
            fits_ = fits_ && to_.layers.push_back({any_of(together), {}});
            colours.push_back(one.colour);
            together.clear();
        }
        if (!from_.view.empty()) to_.clip = from_.view;
        return fits_;
    }

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;

    std::uint32_t add(const layer_shape& shape)
    {
        fits_ = fits_ && to_.shapes.push_back(shape);
        return static_cast<std::uint32_t>(to_.shapes.size() - 1);
    }
    std::uint32_t both(std::uint32_t a, std::uint32_t b)
    {
        return add({.is = layer_shape::kind::both, .a = a, .b = b});
    }
    /// What any of some shapes cover. They are joined in pairs, so that each point takes part in few of the joins.
    std::uint32_t any_of(std::vector<std::uint32_t> shapes)
    {
        for (; shapes.size() > 1; shapes.resize((shapes.size() + 1) / 2))
            for (std::size_t i = 0; i < shapes.size(); i += 2)
                shapes[i / 2] = i + 1 == shapes.size()
                                    ? shapes[i]
                                    : add({.is = layer_shape::kind::either, .a = shapes[i], .b = shapes[i + 1]});
        return shapes.front();
    }
    /// The shape of a clip; a clip without shapes is what a shape leaves of itself.
    std::uint32_t clip(std::size_t number)
    {
        if (clips_[number] != none) return clips_[number];
        const svg_drawing::clip& c = from_.clips[number];
        std::vector<std::uint32_t> shapes;
        for (const auto& [shape, within] : c.shapes) {
            const std::uint32_t whole = add({.id = static_cast<glyph_id>(shape)});
            shapes.push_back(within == svg_drawing::no_clip ? whole : both(whole, clip(within)));
        }
        std::uint32_t all = 0;
        if (shapes.empty())
            all = add({.is = layer_shape::kind::without, .a = 0, .b = 0});
        else
            all = any_of(std::move(shapes));
        if (c.inside != svg_drawing::no_clip) all = both(all, clip(c.inside));
        clips_[number] = all;
        return all;
    }

    const svg_drawing& from_;
    colour_glyph& to_;
    std::vector<std::uint32_t> clips_;
    bool fits_ = true;
};

}  // namespace

std::string svg_layers::open(const std::string& path, double tolerance, layer_cut cut, const rgb_colour& colour)
{
    const svg_options how{0.25 * tolerance * svg_drawing::units_per_em, colour};
    if (std::string trouble = read_svg(path, how, drawing_); !trouble.empty()) return trouble;
    constexpr std::size_t max_layers = 5000;  // cutting takes time in proportion to the square
    std::size_t changes = 0;
    for (std::size_t i = 1; i < drawing_.items.size(); ++i)
        changes += same(drawing_.items[i - 1].colour, drawing_.items[i].colour) ? 0 : 1;
    if (changes >= max_layers)
        return path + " has more than 5000 layers of different colours: join the shapes of one colour.";
    is_stacked_ = cut == layer_cut::stacked;
    const auto built = build(tolerance, cut);
    if (built) return {};
    const error& e = built.error();
    if (e == error::too_many_points || e == error::too_many_pieces)
        return path + " has more than " + std::to_string(default_max_pieces) +
               " points at this quality: choose a coarser --quality, or divide the drawing.";
    return path + ": " + in_words(e);
}

result<void> svg_layers::build(double tolerance, layer_cut cut)
{
    shape_source source{drawing_.shapes};
    colour_glyph glyph;
    if (!layer_writer{drawing_, glyph}.write(layers_)) return error::out_of_memory;
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
        const auto is_it = [&](const rgb_colour& c) { return same(c, layers_[i]); };
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
