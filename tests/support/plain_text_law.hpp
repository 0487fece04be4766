// SPDX-License-Identifier: MIT
#pragma once

// The law of the one text engine: plain text and a paragraph without a width are laid out alike.

#include "support/catch.hpp"

#include <typemesh/layout/layout.hpp>
#include <typemesh/paragraph/paragraph.hpp>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace test {

using namespace typemesh;

struct code_points {
    char32_t first, last;
};

/// Random text of one script with spaces, digits and punctuation, or of many scripts with marks and controls. `lines`:
/// with line breaks and tabs.
class random_text {
public:
    explicit random_text(std::uint32_t seed) : random_{seed} {}

    [[nodiscard]] std::u16string operator()(bool lines)
    {
        static const std::vector<code_points> many_scripts{
            {0x20, 0x7E}, {0x5D0, 0x5EA},     {0x300, 0x310},     {0x200B, 0x200F}, {0x202A, 0x202E}, {0x2066, 0x2069},
            {0xAD, 0xAD}, {0x1F600, 0x1F610}, {0x1F1E6, 0x1F1FF}, {0x1000, 0x103F}, {0xD800, 0xD800}};
        static const std::vector<std::vector<code_points>> alphabets{
            {{0x20, 0x7E}},
            {{0x20, 0x7E}, {0xA0, 0x17F}},
            {{0x20, 0x40}, {0x370, 0x3FF}, {0x400, 0x45F}},
            {{0x20, 0x40}, {0x5D0, 0x5EA}, {0x41, 0x5A}},
            {{0x20, 0x40}, {0x620, 0x64A}, {0x64B, 0x652}, {0x660, 0x669}},
            {{0x20, 0x40}, {0x900, 0x97F}},
            {{0x20, 0x40}, {0xE01, 0xE3A}, {0xE3F, 0xE5B}},
            {{0x3040, 0x30FF}, {0x4E00, 0x4FFF}, {0x20, 0x7E}, {0x3000, 0x3010}, {0xFF01, 0xFF20}},
            many_scripts};
        static const std::vector<code_points> ends{{0x09, 0x0D}, {0x85, 0x85}, {0x2028, 0x2029}, {0x1C, 0x1E}};
        const auto& alphabet = alphabets[below(alphabets.size())];
        std::u16string text;
        for (std::size_t n = below(24); n > 0; --n) {
            const auto& from = lines && below(6) == 0 ? ends : alphabet;
            const auto [first, last] = from[below(from.size())];
            const auto c = static_cast<char32_t>(first + below(last - first + 1));
            if (c > 0xFFFF) text += static_cast<char16_t>(0xD7C0 + (c >> 10));
            text += static_cast<char16_t>(c > 0xFFFF ? 0xDC00 + (c & 0x3FF) : c);
        }
        return text;
    }
    [[nodiscard]] std::size_t below(std::size_t n) { return random_() % n; }

private:
    std::mt19937 random_;
};

/// What differs between two runs, or "".
inline std::string difference(const glyph_run& a, const glyph_run& b)
{
    const auto same_glyph = [&](const placed_glyph& g, const placed_glyph& h) {
        const glyph_style plain;
        const glyph_style &own = a.glyph_styles.empty() ? plain : a.glyph_styles[g.glyph_style],
                          &other = b.glyph_styles.empty() ? plain : b.glyph_styles[h.glyph_style];
        return g.id == h.id && g.cluster == h.cluster && g.origin == h.origin && g.missing == h.missing && own == other;
    };
    const auto same_line = [](const text_line& l, const text_line& m) {
        return l.first_glyph == m.first_glyph && l.glyph_count == m.glyph_count && l.origin == m.origin &&
               l.advance == m.advance;
    };
    if (!std::equal(a.glyphs.begin(), a.glyphs.end(), b.glyphs.begin(), b.glyphs.end(), same_glyph)) return "glyphs";
    if (!std::equal(a.lines.begin(), a.lines.end(), b.lines.begin(), b.lines.end(), same_line)) return "lines";
    if (a.missing != b.missing || a.first_missing != b.first_missing || a.parted != b.parted ||
        a.first_parted != b.first_parted)
        return "missing glyphs";
    if (a.invalid_units != b.invalid_units || a.first_invalid_unit != b.first_invalid_unit) return "invalid units";
    return a.units_per_em == b.units_per_em ? "" : "units";
}
/// Checks the law on texts of one line and as many of several, in all directions, with random options and styles.
template <shaper Font>
void check_plain_text(Font& font, random_text& random, std::size_t texts)
{
    plain_layout lay_out;
    paragraph words{font};
    glyph_run plain, laid;
    for (std::size_t k = 0; k < 2 * texts; ++k) {
        const std::u16string text = random(k % 2 != 0);
        shape_options how{.direction = static_cast<direction>(random.below(4))};
        if (random.below(3) == 0) how.letter_spacing = 0.1;
        if (random.below(4) == 0) how.columns = {.latin = column_latin::upright, .combined_digits = 2};
        layout_options options{.align = static_cast<alignment>(random.below(6)),
                               .anchor = static_cast<vertical_anchor>(random.below(5))};
        if (random.below(4) == 0) options.indent = 0.5;
        if (random.below(4) == 0) options.max_lines = 2;
        if (random.below(4) == 0) options.wrap = wrap_mode::none, options.width = 7.0;
        const style_span styles[] = {
            {2, 5, {.size = 1.5, .slant = 0.2, .decorations = decoration::underline, .style = style_id{3}}}};
        if (text.size() > 5 && random.below(4) == 0) how.styles = styles;

        INFO("text " << k);
        REQUIRE(lay_out(font, text, how, options, plain));
        REQUIRE(words.set(text, how));
        REQUIRE(words.lay_out(options, laid));
        REQUIRE(difference(plain, laid) == "");
    }
}

}  // namespace test
