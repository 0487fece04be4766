// SPDX-License-Identifier: MIT
#pragma once

// A shaper without a font, for tests of layout and paragraphs.

#include <typemesh/layout/shaper.hpp>
#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <vector>

namespace test {

/// Every code point is a glyph of that number, 500 units wide; a space is 250 wide, and a soft hyphen and direction marks
/// 0, at 1000 units per em. Combining marks belong to the letter before and have no width. "AV" is kerned by -100 on the
/// A, and "fi" is one glyph of 700 (id 0xFB01); both are unsafe to break between. Between two of U+0628 a tatweel may
/// stand. U+007F has no glyph, U+FFFF is missing, '!' is refused. It counts its calls.
struct toy_shaper {
    typemesh::line_metrics lines{700.0, -200.0, 100.0};
    bool all_unsafe = false;  // to break, before every glyph
    std::size_t calls = 0, units = 0;

    double units_per_em() const noexcept { return 1000.0; }
    typemesh::line_metrics metrics(typemesh::direction) const noexcept { return lines; }
    typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item, const typemesh::shape_options& how,
                          typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
    {
        using namespace typemesh;
        ++calls;
        units += item.last - item.first;
        std::vector<shaped_glyph> made;
        constexpr glyph_flags unsafe = glyph_flags::unsafe_to_break;
        for (std::size_t i = item.first; i < item.last;) {
            const code_point c = decode(text, i, item.last);
            const auto cluster = static_cast<cluster_id>(i);
            i = c.next;
            if (c.value == 0x7F) continue;
            if (c.value == '!') return error{error::font_library_failed}.at(no_glyph, cluster);
            const bool mark = c.value >= 0x300 && c.value < 0x370 && !made.empty();
            shaped_glyph g{static_cast<glyph_id>(c.value), cluster,
                           c.value == ' '                                              ? 250.0
                           : c.value == 0xAD || c.value == 0x200E || c.value == 0x200F ? 0.0
                                                                                       : 500.0};
            if (mark) g.cluster = made.back().cluster, g.advance = 0.0, g.flags = made.back().flags;
            if (all_unsafe) g.flags = unsafe;
            if (c.value == 0xFFFF) g = {0, cluster, 500.0, {}, 0, glyph_flags::missing};
            if (!made.empty() && made.back().id == 'A' && c.value == 'V')
                made.back().advance -= 100.0, g.flags = unsafe;
            if (!made.empty() && made.back().id == 0x628 && c.value == 0x628) g.flags = glyph_flags::tatweel;
            if (!made.empty() && made.back().id == 'f' && c.value == 'i' && how.ligatures)
                made.back().id = 0xFB01, made.back().advance = 700.0;
            else
                made.push_back(g);
        }
        if (item.to_the_left()) std::reverse(made.begin(), made.end());
        return glyphs.append(made) ? error{} : error{error::out_of_memory};
    }
};
static_assert(typemesh::shaper<toy_shaper>);

}  // namespace test
