// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>
#include <typemesh/layout/column_options.hpp>

#include <cstdint>
#include <span>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The direction of a line or a column: where it begins, and the order of its parts that are read in either direction.
/// UAX #9 calls it the level of the paragraph. Letters keep their own direction: a Hebrew word reads to the left in a
/// left-to-right line, too, but the full stop after it is on its right.
enum class direction : std::uint8_t {
    automatic,  ///< left-to-right or right-to-left: as the first letter, otherwise as the requested script
    left_to_right,
    right_to_left,
    top_to_bottom,  ///< columns, each to the left of the previous one; in Mongolian to its right: column_progress
};

/// An OpenType feature for the whole text, switched on (1), off (0) or set to one of its alternates (2, 3, ...):
/// {"liga", 0}.
struct feature {
    char tag[5] = {};  ///< four letters and a terminating zero
    std::uint32_t value = 1;
};

/// Turns the optional ligatures off: see shape_options::ligatures.
inline constexpr feature no_ligatures[] = {{"liga", 0}, {"clig", 0}};

/// The input of a shaper besides the text.
struct shape_options {
    typemesh::direction direction = typemesh::direction::automatic;
    std::string_view language = {};  ///< BCP 47, such as "tr" or "zh-Hant"; empty: none, never the machine's locale
    std::string_view script = {};    ///< ISO 15924, such as "Arab"; empty: found from the text
    std::span<const feature> features = {};  ///< in addition to the default features of the script
    bool ligatures = true;  ///< optional ligatures ("liga", "clig"), unless `features` has them; none in spaced text
    column_options columns = {};  ///< the orientation of characters in columns
};

}  // namespace typemesh::inline TYPEMESH_ABI
