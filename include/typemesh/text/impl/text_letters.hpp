// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/text/impl/letter_move.hpp>
#include <typemesh/text/text_letter.hpp>
#include <typemesh/unicode/impl/word_boundaries.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The letters of a planned text, as letter_finder finds them, and the room for one move of each.
struct text_letters {
    /// A grapheme of the text while letters are being found.
    struct grapheme {
        std::uint32_t first = 0;  ///< in units of the text
        std::uint32_t word = 0;
        std::uint32_t paragraph = 0;
        std::uint32_t line = 0;               ///< of its glyphs, if it has any
        std::uint32_t same = 0;               ///< an earlier grapheme of the same letter, or itself
        std::uint32_t letter = not_a_letter;  ///< of a letter's first grapheme: its number
        joining_type joins_before = joining_type::none;
        joining_type joins_after = joining_type::none;
        bool joins = false;  ///< whether the two are set
        letter_bond bonds = letter_bond::none;
        bool shown = false;  ///< whether it is the first grapheme of a cluster
        bool drawn = false;  ///< whether a drawn glyph shows it
        bool blank = true;   ///< white space or invisible
    };

    buffer<grapheme> graphemes;
    buffer<text_letter> rows;      ///< [ letters | bars ]
    buffer<std::uint32_t> row_of;  ///< for each drawn glyph
    buffer<letter_group> words;
    buffer<letter_group> lines;
    buffer<letter_group> paragraphs;
    buffer<letter_move> moves;  ///< for each row; room for them
    letter_group whole;
    std::uint32_t letters = 0;  ///< the number of rows that are letters
    std::uint32_t grapheme_count = 0;
    std::uint64_t found_for = ~std::uint64_t{0};  ///< the plan's generation

    explicit text_letters(memory source) noexcept
        : graphemes{source},
          rows{source},
          row_of{source},
          words{source},
          lines{source},
          paragraphs{source},
          moves{source}
    {
    }

    /// Forgets what was found.
    void forget() noexcept
    {
        for (buffer<letter_group>* groups : {&words, &lines, &paragraphs}) groups->clear();
        rows.clear();
        row_of.clear();
        moves.clear();
        letters = 0;
    }

    /// The move of a drawn glyph; null as long as letters are not found.
    [[nodiscard]] const letter_move* move_of(std::size_t glyph) const noexcept
    {
        return glyph < row_of.size() && row_of[glyph] < moves.size() ? &moves[row_of[glyph]] : nullptr;
    }

    /// The row of the letter that a place of the text belongs to; it must belong to one.
    [[nodiscard]] std::uint32_t row_at(cluster_id place) const noexcept
    {
        const auto begins_behind = [&](std::size_t k) noexcept { return graphemes[k].first > place; };
        std::size_t k = first_where(1, graphemes.size(), begins_behind) - 1;
        while (graphemes[k].same != k) k = graphemes[k].same;
        return graphemes[k].letter;
    }

    /// The place of a row in the text.
    [[nodiscard]] letter_place place(std::size_t row, const typemesh::frame& frame) const noexcept
    {
        const text_letter& l = rows[row];
        const bool bar = row >= letters;
        return {l,
                l.word < words.size() ? words[l.word] : nothing,
                l.line < lines.size() ? lines[l.line] : nothing,
                l.letters == 0 ? nothing : paragraphs[l.paragraph],
                whole,
                bar ? not_a_letter : static_cast<std::uint32_t>(row),
                static_cast<std::uint32_t>(words.size()),
                static_cast<std::uint32_t>(lines.size()),
                static_cast<std::uint32_t>(paragraphs.size()),
                grapheme_count,
                frame};
    }

    static constexpr letter_group nothing{};
};

}  // namespace typemesh::inline TYPEMESH_ABI
