// SPDX-License-Identifier: MIT
#include "marked_words.hpp"

#include "text_to_mesh/solids.hpp"

#include <algorithm>

namespace typemesh_web {
namespace {

using typemesh::markup_tag;

/// Fonts by their numbers; bold letters take more room.
struct numbered_fonts {
    std::size_t fonts;

    typemesh::error operator()(const typemesh::basic_markup_look<char16_t>& look,
                               typemesh::text_style& style) const noexcept
    {
        if (look.has(markup_tag::bold)) style.letter_spacing += 2.0 * text_to_mesh::bold_growth;
        if (!look.has(markup_tag::font)) return {};
        std::size_t number = 0;
        for (const char16_t c : look.font)
            number = c >= u'0' && c <= u'9' && number < 1000 ? 10 * number + (c - u'0') : 100000;
        if (number < 1 || number > fonts) return typemesh::error::no_such_face;
        style.face = static_cast<std::uint16_t>(number - 1);
        return {};
    }
};

}  // namespace

typemesh::result<void> marked_words::read(std::u16string_view source, std::size_t fonts)
{
    rubies_.clear();
    if (const auto done = read_.read(source); !done) return done.error();
    if (const auto done = styles_.set(read_, numbered_fonts{fonts}); !done) return done.error();
    read_.each_ruby([&](std::uint32_t first, std::uint32_t last, std::u16string_view ruby, std::uint32_t look) {
        rubies_.push_back({first, last, ruby, styles_.style_of(look)});
    });
    return {};
}

typemesh::error marked_words::add_to(typemesh::shape_options& how, font_set& fonts)
{
    how.styles = styles_.spans();
    how.boxes = read_.boxes();
    if (rubies_.empty()) return {};
    ruby_options_.shape.language = how.language;
    ruby_options_.shape.direction =
        how.direction == typemesh::direction::top_to_bottom ? how.direction : typemesh::direction::automatic;
    const auto rooms = ruby_writer_.rooms(fonts, text(), rubies_, ruby_options_);
    if (rooms) how.rooms = *rooms;
    return rooms.error();
}

text_to_mesh::options marked_words::options_of(const text_to_mesh::options& o, std::uint32_t solid) const
{
    text_to_mesh::options own = text_to_mesh::options_of(o, styles_.solids()[solid]);
    // text_to_mesh refuses bevels that are deeper than their letters. Here they are cut: a page is typed letter by letter.
    if (!(own.depth > 0.0f)) own.bevel.width = 0.0f;
    const float room = own.bevel.sides == typemesh::bevel_sides::both ? own.depth / 2.0f : own.depth;
    own.bevel.depth = (std::min)(own.bevel.depth, room);
    return own;
}

std::optional<std::uint32_t> marked_words::colour_of(typemesh::style_id style) const noexcept
{
    const auto number = static_cast<std::size_t>(style);
    if (number >= styles_.paints().size()) return {};
    const typemesh::markup_paint& p = styles_.paints()[number];
    if (!p.has(markup_tag::colour) && !p.has(markup_tag::mark)) return {};
    return p.colour;
}

}  // namespace typemesh_web
