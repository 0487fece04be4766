// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/unicode/impl/bidi_levels.hpp>
#include <typemesh/unicode/text_analysis.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <concepts>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The input of an analyser besides the text.
struct analysis_options {
    paragraph_direction direction = paragraph_direction::automatic;  ///< the direction of every paragraph
    std::string_view language = {};  ///< BCP 47, such as "th"; for analysers whose line breaks depend on the language
};

/// Finds what a paragraph must know about a text before shaping: levels, scripts, graphemes, and where lines may end.
///
///     a.analyse(text, o, found)    empties `found` and fills it in. Levels, graphemes and scripts follow Unicode.
///                                  Where lines may end depends on the analyser, and so does whether a needed
///                                  dictionary is missing. Paragraphs end at paragraph separators (Bidi_Class B:
///                                  line feed, U+2029 and similar), and so do lines.
///
/// Fails  error::too_large: the text has more than 2^32 - 1 units
///        error::out_of_memory, and any other error of the analyser; `found` is then empty
template <class A>
concept text_analyser = requires(A& a, text_view text, const analysis_options& o, text_analysis& found) {
    { a.analyse(text, o, found) } noexcept -> std::same_as<error>;
};

}  // namespace typemesh::inline TYPEMESH_ABI
