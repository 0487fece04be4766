// SPDX-License-Identifier: MIT
#pragma once

// A shaper without a font, for what layout() does of its own.

#include <typemesh/layout/shaper.hpp>
#include <typemesh/unicode/utf.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace test {

/// Every code point is a glyph of that number, `advance` units on (or down), 1000 units to the em; combining marks
/// belong to the letter before, lines of Hebrew or Arabic run to the left, '!' is refused. Notes the lines of UTF-8 that
/// it is given, and whether ligatures were allowed.
struct toy_shaper {
    typemesh::line_metrics lines{700.0, -200.0, 100.0};
    double advance = 500.0;
    std::vector<std::string> seen{};
    std::vector<bool> ligatures{};

    double units_per_em() const noexcept { return 1000.0; }
    typemesh::line_metrics metrics(typemesh::direction) const noexcept { return lines; }
    typemesh::result<typemesh::point> shape(typemesh::text_view text, std::size_t first, std::size_t last,
                                            const typemesh::shape_options& how, typemesh::glyph_run& run) noexcept
    {
        using namespace typemesh;
        if (text.encoding() == encoding::utf8) seen.emplace_back(text.utf8() + first, last - first);
        ligatures.push_back(how.ligatures);
        struct letter {
            char32_t value;
            cluster_id cluster;
        };
        std::vector<letter> letters;
        bool leftward = false;
        for (std::size_t i = first; i < last;) {
            const code_point c = decode(text, i, last);
            if (c.value == '!') return error{error::needs_shaping}.at(no_glyph, static_cast<cluster_id>(i));
            const bool mark = c.value >= 0x300 && c.value < 0x370 && !letters.empty();
            letters.push_back({c.value, mark ? letters.back().cluster : static_cast<cluster_id>(i)});
            leftward = leftward || (c.value >= 0x590 && c.value < 0x700);
            i = c.next;
        }
        if (leftward) std::reverse(letters.begin(), letters.end());
        point pen;
        for (const letter& l : letters) {
            if (!run.glyphs.push_back({static_cast<glyph_id>(l.value), l.cluster, pen})) return error::out_of_memory;
            if (how.direction == direction::top_to_bottom)
                pen.y -= advance;
            else
                pen.x += advance;
        }
        return pen;
    }
};
static_assert(typemesh::shaper<toy_shaper>);

}  // namespace test
