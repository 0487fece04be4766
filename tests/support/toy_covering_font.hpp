// SPDX-License-Identifier: MIT
#pragma once

// A font with glyphs for some characters only, for tests of several fonts together.

#include <typemesh/layout/plain_text.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace test {

using namespace typemesh;

/// Every character that it has is a glyph of that number, drawn as a square of 1/10 em, half an em wide. Marks have no
/// width, and a cluster is a grapheme, except that "fi" is one cluster. After a joiner a letter is unsafe to break before.
/// It counts its calls.
struct toy_covering_font {
    std::u32string has;
    double units = 1000.0;
    std::size_t shaped = 0, items = 0;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> asked = {};

    explicit toy_covering_font(std::u32string characters, double units_of_em = 1000.0)
        : has{std::move(characters)}, units{units_of_em}
    {
    }

    double units_per_em() const noexcept { return units; }
    fill_rule fill() const noexcept { return fill_rule::non_zero; }
    line_metrics metrics(direction) const noexcept { return {0.8 * units, -0.2 * units, 0.0}; }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        if (id == ' ') return {};
        const double side = units / 10;
        sink.move({0, 0}), sink.line({side, 0}), sink.line({side, side}), sink.line({0, side}), sink.close();
        return {};
    }

    bool covers(char32_t c) const { return has.find(c) != std::u32string::npos; }

    error shape(text_view text, const text_item& item, const shape_options&, buffer<shaped_glyph>& glyphs) noexcept
    {
        ++items;
        asked.emplace_back(item.first, item.last);
        std::vector<shaped_glyph> made;
        grapheme_boundaries begins;
        char32_t before = 0;
        for (std::size_t i = item.first; i < item.last;) {
            const code_point c = decode(text, i, item.last);
            const grapheme_class kind = character_of(c.value).grapheme;
            const bool first = begins(kind) || made.empty();
            shaped_glyph g{static_cast<glyph_id>(c.value), static_cast<cluster_id>(i), units / 2};
            if (first && before == 'f' && c.value == 'i') {
                g.cluster = made.back().cluster;
            } else if (first) {
                if (before == 0x200D) g.flags = glyph_flags::unsafe_to_break;
            } else {
                g.cluster = made.back().cluster, g.advance = 0.0, g.flags = made.back().flags;
                g.offset = {units / 4, 0};
            }
            // A character that is not drawn has no glyph of its own, whatever the font has.
            const bool drawn = !is_default_ignorable(c.value);
            if (drawn && !covers(c.value)) g.id = 0, g.flags = g.flags | glyph_flags::missing;
            if (!drawn) g.advance = 0.0;
            made.push_back(g);
            before = c.value;
            i = c.next;
        }
        if (item.to_the_left()) std::reverse(made.begin(), made.end());
        return glyphs.append(made) ? error{} : error{error::out_of_memory};
    }
};
static_assert(shaper<toy_covering_font> && outline_source<toy_covering_font>);

}  // namespace test
