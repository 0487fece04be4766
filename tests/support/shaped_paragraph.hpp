// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/toy_shaper.hpp"

#include <typemesh/paragraph/impl/line_pieces.hpp>
#include <typemesh/paragraph/impl/text_pieces.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

namespace test {

/// A text shaped by the toy, and its pieces: what stands before a paragraph's lines.
struct shaped_paragraph {
    toy_shaper font;
    typemesh::shaped_text shaped;
    typemesh::text_pieces pieces;

    explicit shaped_paragraph(typemesh::text_view text, typemesh::direction d = typemesh::direction::automatic,
                              double letter_spacing = 0.0)
        : shaped_paragraph{text, {.direction = d, .letter_spacing = letter_spacing / 1000.0}}
    {
    }
    shaped_paragraph(typemesh::text_view text, const typemesh::shape_options& how)
    {
        using namespace typemesh;
        REQUIRE_FALSE(unicode_analyser{}.analyse(text, {}, shaped.analysis));
        REQUIRE_FALSE(shaped.read(font, 1, text, how));
        REQUIRE_FALSE(shaped.shape(font));
        REQUIRE_FALSE(pieces.find_words(shaped, font));
    }

    [[nodiscard]] const typemesh::text_pieces::list& wrapped(typemesh::wrap_mode wrap, double narrowest)
    {
        const auto made = pieces.pieces_for(wrap, narrowest, shaped, font);
        REQUIRE(made);
        return **made;
    }
};

}  // namespace test
