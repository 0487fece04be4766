// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>
#include <typemesh/layout/column_options.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The direction of a line, or a column: where it begins, and in which order its stretches of either direction follow
/// each other; what UAX #9 calls the level of the paragraph. Letters keep their own direction: a Hebrew word reads to
/// the left in a left-to-right line, too, but the full stop behind it stands on its right.
enum class direction : std::uint8_t {
    automatic,  ///< left-to-right or right-to-left: that of the first letter, else of the script asked for
    left_to_right,
    right_to_left,
    top_to_bottom,  ///< columns, each to the left of the one before, in Mongolian to its right: column_progress
};

/// An OpenType feature switched on (1), off (0) or set to one of its alternates (2, 3, ...), for the whole text:
/// {"liga", 0}.
struct feature {
    char tag[5] = {};  ///< four letters and a terminating zero
    std::uint32_t value = 1;
};

/// Turns the optional ligatures off: see shape_options::ligatures.
inline constexpr feature no_ligatures[] = {{"liga", 0}, {"clig", 0}};

/// What a shaper gets besides the text.
struct shape_options {
    typemesh::direction direction = typemesh::direction::automatic;
    std::string_view language = {};  ///< BCP 47, such as "tr" or "zh-Hant"; empty: none, never the machine's locale
    std::string_view script = {};    ///< ISO 15924, such as "Arab"; empty: found from the text
    std::span<const feature> features = {};  ///< besides those that are on by default for the script
    bool ligatures = true;  ///< the optional ones ("liga", "clig"), unless `features` names them; none in spaced text
    column_options columns = {};  ///< which characters lie on their side in columns
};

}  // namespace typemesh::inline TYPEMESH_ABI
