// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How letters stand in a column whose script is written in lines: Latin, Greek, Arabic, and digits of all of them.
enum class column_latin : std::uint8_t {
    sideways,  ///< turned clockwise by a quarter, as UAX #50 has it; Hebrew and Arabic are then read upwards
    upright,   ///< one below the other, whatever their script
};

/// To which side of a column the next one stands.
enum class column_progress : std::uint8_t {
    automatic,   ///< to the right in Mongolian and its relatives (column_progress.hpp), else to the left
    leftwards,   ///< as in Chinese and Japanese
    rightwards,  ///< as in Mongolian
};

/// How a range of a text stands in a column.
enum class column_style : std::uint8_t {
    automatic,  ///< every character as Unicode (UAX #50) and column_options say
    upright,    ///< all of it, one below the other
    sideways,   ///< all of it
    combined,   ///< side by side in the room of one character (tate-chu-yoko), made narrower where that is too small
};

/// How characters stand in columns.
struct column_options {
    column_latin latin = column_latin::sideways;
    std::uint8_t combined_digits = 0;  ///< numbers of so many ASCII digits or fewer are combined: 2 for dates
    double combined_gap = 0.0;         ///< em added between combined letters, 0 to 0.5: room to make them bolder
    column_progress progress = column_progress::automatic;  ///< which side the next column stands on
};

}  // namespace typemesh::inline TYPEMESH_ABI
