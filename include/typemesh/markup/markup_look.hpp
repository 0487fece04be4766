// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/layout/text_style.hpp>

#include <cstdint>
#include <cstring>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The tags of mark-up: see markup.hpp.
enum class markup_tag : std::uint8_t {
    bold,         ///< [b]
    italic,       ///< [i]
    underline,    ///< [u]
    strike,       ///< [s]
    overline,     ///< [o]
    superscript,  ///< [sup]
    subscript,    ///< [sub]
    size,         ///< [size=1.5]
    rise,         ///< [rise=0.2]
    spacing,      ///< [spacing=0.05]
    depth,        ///< [depth=0.1]
    bevel,        ///< [bevel=0.02]
    colour,       ///< [colour=...], [color=...]
    style,        ///< [style=7]
    font,         ///< [font=Liberation Serif]
    language,     ///< [lang=ja]
    mark,         ///< [mark=\#ff0]
    ruby,         ///< [ruby=...]
    box,          ///< [box=1.2,0.8]
};

inline constexpr std::uint32_t markup_tag_count = 19;  ///< the number of tags

/// What the tags around a text say, the innermost tag of each kind. The views refer to the source of the mark-up.
///
/// A member without a tag has its default. `has()` tells it from a member whose tag gives the default.
template <class Char>
struct basic_markup_look {
    std::uint32_t tags = 0;                              ///< a set: see has()
    script_position position = script_position::normal;  ///< of the innermost [sup] or [sub]
    double size = 1.0;                                   ///< times the text's size: more than 0, up to 1000
    double rise = 0.0;                                   ///< em, -1000 to 1000
    double spacing = 0.0;                                ///< em between letters, -1000 to 1000
    double depth = 0.0;                                  ///< em, 0 to 1000
    double bevel = 0.0;                                  ///< the width of a bevel in em, 0 to 1000
    std::uint32_t colour = 0;                            ///< 0xRRGGBB
    std::uint32_t style = 0;                             ///< the caller's number
    std::uint32_t mark = 0;                              ///< the colour of its background, 0xRRGGBB
    std::basic_string_view<Char> font = {};              ///< as it is written
    std::basic_string_view<Char> language = {};          ///< BCP 47; ASCII letters, digits and hyphens

    /// Whether the text stands in such a tag. For [sup], [sub], [ruby] and [box] it is
    /// false: see `position`, markup_span and basic_markup::boxes().
    [[nodiscard]] bool has(markup_tag t) const noexcept { return (tags >> static_cast<unsigned>(t) & 1u) != 0; }

    friend bool operator==(const basic_markup_look& a, const basic_markup_look& b) noexcept
    {
        return a.tags == b.tags && a.colour == b.colour && a.style == b.style && a.mark == b.mark &&
               a.position == b.position && same(a.size, b.size) && same(a.rise, b.rise) && same(a.spacing, b.spacing) &&
               same(a.depth, b.depth) && same(a.bevel, b.bevel) && a.font == b.font && a.language == b.language;
    }

    /// Equal looks have equal hashes. Members without their tag do not matter for the hash.
    friend std::uint64_t hash_of(const basic_markup_look& l) noexcept
    {
        std::uint64_t hash = mixed_key(1, static_cast<std::uint64_t>(l.position) << 32 | l.tags);
        const auto add = [&](markup_tag t, std::uint64_t number) noexcept {
            if (l.has(t)) hash = mixed_key(hash, number);
        };
        const auto add_number = [&](markup_tag t, double number) noexcept {
            number += 0.0;  // turns -0 into +0
            std::uint64_t bits = 0;
            std::memcpy(&bits, &number, sizeof bits);
            add(t, bits);
        };
        add_number(markup_tag::size, l.size);
        add_number(markup_tag::rise, l.rise);
        add_number(markup_tag::spacing, l.spacing);
        add_number(markup_tag::depth, l.depth);
        add_number(markup_tag::bevel, l.bevel);
        add(markup_tag::colour, l.colour);
        add(markup_tag::style, l.style);
        add(markup_tag::mark, l.mark);
        for (const std::basic_string_view<Char> word : {l.font, l.language})
            for (const Char c : word) hash = mixed_key(hash, static_cast<std::uint64_t>(c));
        return hash;
    }
};

/// A range of the text without its tags, in the text's units, in which nothing changes.
struct markup_span {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    std::uint32_t look = 0;  ///< the index of its look; 0: the plain look
    std::uint32_t ruby =
        0;  ///< one more than the index of its ruby; 0: none. All text of one [ruby=...] has its number

    friend bool operator==(const markup_span&, const markup_span&) noexcept = default;
};

}  // namespace typemesh::inline TYPEMESH_ABI
