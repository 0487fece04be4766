// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/paragraph/paragraph.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace test {

/// A paragraph in a toy font, and the run that it was last laid out to. The text must outlive it.
template <class Font = toy_shaper, class Breaker = typemesh::first_fit>
struct laid_paragraph {
    Font font{};
    typemesh::paragraph<Font, typemesh::unicode_analyser, Breaker> words{font, typemesh::heap(),
                                                                         typemesh::unicode_analyser{}, Breaker{}};
    typemesh::glyph_run run{};

    explicit laid_paragraph(typemesh::text_view text, const typemesh::layout_options& options = {},
                            const typemesh::shape_options& how = {})
    {
        REQUIRE(words.set(text, how));
        again(options);
    }
    void again(const typemesh::layout_options& options) { REQUIRE(words.lay_out(options, run)); }

    [[nodiscard]] typemesh::laid_text laid() const { return words.laid(); }
    [[nodiscard]] auto glyphs_of(std::size_t line) const
    {
        return run.glyphs.view().subspan(run.lines[line].first_glyph, run.lines[line].glyph_count);
    }
    /// What a line shows, from left to right: in the toy font a glyph has its character's number.
    [[nodiscard]] std::u16string line(std::size_t k) const
    {
        std::u16string shown;
        for (const typemesh::placed_glyph& g : glyphs_of(k)) shown.push_back(static_cast<char16_t>(g.id));
        return shown;
    }
    [[nodiscard]] std::vector<std::u16string> lines() const
    {
        std::vector<std::u16string> all;
        for (std::size_t k = 0; k < run.lines.size(); ++k) all.push_back(line(k));
        return all;
    }
    [[nodiscard]] typemesh::glyph_style style(std::size_t glyph) const
    {
        return run.glyph_styles.empty() ? typemesh::glyph_style{} : run.glyph_styles[run.glyphs[glyph].glyph_style];
    }
    [[nodiscard]] std::vector<double> places() const
    {
        std::vector<double> x;
        for (const typemesh::placed_glyph& g : run.glyphs) x.push_back(g.origin.x);
        return x;
    }
    [[nodiscard]] std::vector<double> advances() const
    {
        std::vector<double> all;
        for (const typemesh::text_line& l : run.lines) all.push_back(l.advance);
        return all;
    }
    [[nodiscard]] std::size_t count(typemesh::glyph_id id) const
    {
        std::size_t n = 0;
        for (const typemesh::placed_glyph& g : run.glyphs) n += g.id == id ? 1u : 0u;
        return n;
    }
    [[nodiscard]] std::vector<typemesh::box> boxes(std::uint32_t first, std::uint32_t last) const
    {
        std::vector<typemesh::box> all;
        laid().boxes_of(first, last, [&](const typemesh::box& b) { all.push_back(b); });
        return all;
    }
};

/// Whether two runs have the same glyphs at the same places.
inline bool same_glyphs(const typemesh::glyph_run& a, const typemesh::glyph_run& b)
{
    return std::equal(a.glyphs.begin(), a.glyphs.end(), b.glyphs.begin(), b.glyphs.end(),
                      [](const typemesh::placed_glyph& g, const typemesh::placed_glyph& h) {
                          return g.id == h.id && g.cluster == h.cluster && g.origin == h.origin;
                      });
}

}  // namespace test
