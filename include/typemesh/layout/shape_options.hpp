// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/layout/column_options.hpp>
#include <typemesh/layout/feature.hpp>
#include <typemesh/layout/inline_box.hpp>
#include <typemesh/layout/text_room.hpp>
#include <typemesh/layout/text_style.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The direction of a line or a column: where it begins, and the order of its left-to-right and right-to-left runs. UAX
/// #9 calls it the level of the paragraph. Letters keep their own direction: a Hebrew word reads to the left even in a
/// left-to-right line, but the full stop after the word is on its right.
enum class direction : std::uint8_t {
    automatic,  ///< each paragraph has the direction of its first letter; left-to-right if it has no letters
    left_to_right,
    right_to_left,
    top_to_bottom,  ///< columns, each to the left of the previous column, or to its right in Mongolian: see
                    ///< column_progress
};

/// The options for shaping a text.
///
///     {.language = "tr"}                           a language whose letters differ from others
///     {.letter_spacing = 0.1}                      every letter a tenth of an em farther from the next
///     {.styles = spans}                            const style_span spans[] = {{6, 11, {.style = style_id{1}}}};
///
/// Everything that the options refer to must stay unchanged as long as the text is used. A shaper gets these options
/// with each item of a text. It follows language, script, features and ligatures, and ignores the other options.
struct shape_options {
    typemesh::direction direction = typemesh::direction::automatic;
    std::string_view language = {};  ///< BCP 47, such as "tr" or "zh-Hant"; empty: none, never the machine's locale
    std::string_view script = {};    ///< ISO 15924, such as "Arab"; empty: found from the text
    std::span<const feature> features = {};  ///< features for the whole text, in addition to the script's default
                                             ///< features
    bool ligatures = true;  ///< whether to use optional ligatures ("liga", "clig"), unless `features` sets them; text
                            ///< with letter spacing has none
    double letter_spacing = 0.0;              ///< the space added between letters, in em; any finite number
    column_options columns = {};              ///< the orientation of characters in columns
    std::span<const style_span> styles = {};  ///< the styles of ranges of the text: see text_style.hpp
    std::span<const inline_box> boxes = {};   ///< places for icons and the like: see inline_box.hpp
    std::span<const text_room> rooms = {};    ///< the rooms of rubies: see text_room.hpp
};

/// The error for an option that is out of range; error::none if all are valid.
[[nodiscard]] inline error refused_option(const shape_options& options) noexcept
{
    return is_finite(options.letter_spacing) ? error{} : error::bad("letter_spacing");
}

}  // namespace typemesh::inline TYPEMESH_ABI
