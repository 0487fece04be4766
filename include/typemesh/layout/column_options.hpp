// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The orientation of letters in a column if their script is normally written in lines: Latin, Greek, Arabic, and the
/// digits of all scripts.
enum class column_latin : std::uint8_t {
    sideways,  ///< turned clockwise by a quarter, as in UAX #50; Hebrew and Arabic are then read upwards
    upright,   ///< one below the other, for all scripts
};

/// The side of a column on which the next column follows.
enum class column_progress : std::uint8_t {
    automatic,   ///< to the right in Mongolian and its relatives, otherwise to the left
    leftwards,   ///< as in Chinese and Japanese
    rightwards,  ///< as in Mongolian
};

/// The orientation of a range of a text in a column.
enum class column_style : std::uint8_t {
    automatic,  ///< every character follows Unicode (UAX #50) and column_options
    upright,    ///< all characters are upright, one below the other
    sideways,   ///< all characters lie on their side
    combined,   ///< side by side in the space of one character (tate-chu-yoko), made narrower if necessary
};

/// The orientation of characters in columns.
struct column_options {
    column_latin latin = column_latin::sideways;
    std::uint8_t combined_digits = 0;  ///< numbers of at most this many ASCII digits are combined: 2 for dates
    double combined_gap = 0.0;         ///< the space between combined letters, in em, 0 to 0.5: it lets them become
                                       ///< bolder
    column_progress progress = column_progress::automatic;  ///< the side of the next column
};

}  // namespace typemesh::inline TYPEMESH_ABI
