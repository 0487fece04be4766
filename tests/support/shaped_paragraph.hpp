// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/toy_item_shaper.hpp"

#include <typemesh/paragraph/impl/text_pieces.hpp>
#include <typemesh/unicode/unicode_analyser.hpp>

namespace test {

/// A text shaped by the toy, and its pieces: what stands before a paragraph's lines.
struct shaped_paragraph {
    toy_item_shaper font;
    typemesh::shaped_text shaped;
    typemesh::text_pieces pieces;

    explicit shaped_paragraph(typemesh::text_view text, typemesh::direction d = typemesh::direction::automatic,
                              double letter_spacing = 0.0)
    {
        using namespace typemesh;
        REQUIRE_FALSE(unicode_analyser{}.analyse(text, {}, shaped.analysis));
        shape_options how;
        how.direction = d;
        REQUIRE_FALSE(shaped.shape(font, text, how, letter_spacing));
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
