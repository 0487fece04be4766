// SPDX-License-Identifier: MIT
#pragma once

#include "fonts.hpp"
#include "text_to_mesh/options.hpp"

#include <typemesh/markup/markup_styles.hpp>
#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/paragraph/ruby_writer.hpp>

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace typemesh_web {

/// A text whose tags have been read: [b], [size=1.5], [colour=#c33] and all the others of typemesh/markup/markup.hpp.
/// [font=2] is the second font of the mesher.
class marked_words {
public:
    /// Reads the tags of a text, which must stay as long as this object is used.
    [[nodiscard]] typemesh::result<void> read(std::u16string_view source, std::size_t fonts);

    /// The text without its tags.
    [[nodiscard]] std::u16string_view text() const noexcept { return read_.text(); }

    /// Adds what the tags say of shaping, and makes room for rubies.
    [[nodiscard]] typemesh::error add_to(typemesh::shape_options& how, font_set& fonts);

    /// Adds backgrounds and rubies to a page.
    template <class Paragraph>
    [[nodiscard]] typemesh::error write(const Paragraph& words, font_set& fonts, typemesh::glyph_run& page)
    {
        if (rubies_.empty() && styles_.marks().empty()) return {};
        const typemesh::highlight_options round{.pad_along = 0.08, .pad_across = 0.0, .radius = 0.15};
        const auto behind = backgrounds_.write(fonts, words.laid(), styles_.marks(), round, page);
        return behind ? ruby_writer_.write(fonts, words.laid(), rubies_, ruby_options_, page).error() : behind.error();
    }

    /// How many different solids the tags ask for; solid 0 is the usual one.
    [[nodiscard]] std::uint32_t solids() const noexcept { return static_cast<std::uint32_t>(styles_.solids().size()); }
    [[nodiscard]] std::uint32_t solid_of(typemesh::style_id style) const noexcept { return styles_.solid_of(style); }
    /// The options with which a solid is made.
    [[nodiscard]] text_to_mesh::options options_of(const text_to_mesh::options& o, std::uint32_t solid) const;

    /// 0xRRGGBB of a style, if it has a colour of its own.
    [[nodiscard]] std::optional<std::uint32_t> colour_of(typemesh::style_id style) const noexcept;

private:
    typemesh::basic_markup<char16_t> read_;
    typemesh::markup_styles styles_;
    std::vector<typemesh::ruby_span> rubies_;
    typemesh::ruby_options ruby_options_{.overhang = 0.25};  // as browsers have it
    typemesh::ruby_writer ruby_writer_;
    typemesh::highlight_writer backgrounds_;
};

}  // namespace typemesh_web
