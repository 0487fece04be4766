// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/layout/alignment.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The options for arranging shaped lines.
struct layout_options {
    alignment align = alignment::left;
    double line_spacing = 1.0;    ///< times the font's distance between lines; any finite number
    double tab_width = 4.0;       ///< between tab stops, in spaces; 0: tabs are ordinary characters (shape_line.hpp)
    double letter_spacing = 0.0;  ///< added between letters, in em; any finite number (see letter_spacing.hpp)
};

/// The error for an option that is out of range, or none.
[[nodiscard]] inline error refused_option(const layout_options& options) noexcept
{
    if (!is_finite(options.line_spacing)) return error::bad("line_spacing");
    if (!is_finite(options.tab_width) || options.tab_width < 0.0) return error::bad("tab_width");
    if (!is_finite(options.letter_spacing)) return error::bad("letter_spacing");
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
