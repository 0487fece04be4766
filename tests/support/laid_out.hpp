// SPDX-License-Identifier: MIT
#pragma once

// Runs of glyphs by layout() and by a paragraph, or a failed test.

#include "support/catch.hpp"

#include <typemesh/layout/layout.hpp>

namespace test {

/// A text in lines that only its line breaks end.
template <class Font>
typemesh::glyph_run shaped(Font& font, typemesh::text_view text, const typemesh::shape_options& how = {},
                           const typemesh::layout_options& lines = {})
{
    typemesh::glyph_run run;
    const typemesh::error e = layout(font, text, how, lines, run).error();
    INFO(e.message());
    REQUIRE_FALSE(e);
    return run;
}

/// A text in a paragraph's lines.
template <class Paragraph>
typemesh::glyph_run laid_out(Paragraph& words, typemesh::text_view text, const typemesh::shape_options& how = {},
                             const typemesh::layout_options& lines = {})
{
    typemesh::glyph_run run;
    REQUIRE(words.set(text, how));
    REQUIRE(words.lay_out(lines, run));
    return run;
}

}  // namespace test
