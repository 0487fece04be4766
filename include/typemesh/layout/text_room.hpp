// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The room that a range of a text needs, because something stands beside it: ruby_writer makes rooms for rubies. No
/// line ends inside the range. Text that is narrower is spread; the ends get half of the space of a gap (CSS Ruby,
/// ruby-align: space-around; JLREQ 3.3.6):
///
///     |.han..han..han.|      gaps are beside ideographs and kana      |....word....|
struct text_room {
    std::uint32_t first = 0;  ///< the range of the text, in its units
    std::uint32_t last = 0;
    double width = 0.0;  ///< em; at least this width, along the line
    double above = 0.0;  ///< em above the range's own ascender, in columns to its right; the line is as high as this
                         ///< needs, except with line_box::uniform
};

}  // namespace typemesh::inline TYPEMESH_ABI
