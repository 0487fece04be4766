// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a line may end after a piece.
enum class piece_end : std::uint8_t {
    never,
    in_need,  ///< only if its word is at the beginning of a line and too long for this line
    allowed,
    line,       ///< a line ends here, for example after U+2028
    paragraph,  ///< a paragraph ends here, for example after a line feed: the next line is indented
};

/// A piece of a text between two places where a line may end, usually a word. Line breakers work with pieces. Lengths
/// are in font units.
///
///     |begin_change|   width   |  space  |             A line that begins or ends with a piece may be wider there, or
///                  |  letters  | ....... |             narrower, by the change: there it has a hyphen, or no kerning
///                              |end_change|            with the next letter. White space at a line's end hangs.
struct break_piece {
    std::uint32_t first = 0;  ///< the start of the piece in the text
    std::uint32_t last = 0;
    double width = 0.0;    ///< the width without the white space at its end; 0 if the piece is only white space
    double space = 0.0;    ///< the width of this white space, except a tab
    double stretch = 0.0;  ///< the stretch of all its spaces, which grow in justified lines
    double begin_change = 0.0;
    double end_change = 0.0;
    piece_end end = piece_end::allowed;
    bool hyphen = false;  ///< whether a line that ends with this piece shows a hyphen
    bool tab = false;     ///< whether the piece ends with a tab: the next piece then begins at a tab stop
    bool drawn = false;   ///< whether part of it is visible; its width may still be 0, for example if it is a mark
                          ///< without a letter

    /// Whether a line must end with this piece.
    [[nodiscard]] constexpr bool ends_line() const noexcept
    {
        return end == piece_end::line || end == piece_end::paragraph;
    }
    /// Whether part of it is visible in a line that ends with it. White space is not; a single soft hyphen is.
    [[nodiscard]] constexpr bool is_visible() const noexcept { return drawn || width > 0.0 || end_change > 0.0; }

    /// The width that suffices for the piece anywhere in a line: 0 for white space.
    [[nodiscard]] constexpr double room() const noexcept
    {
        if (!is_visible()) return 0.0;
        return width + (begin_change > 0.0 ? begin_change : 0.0) + (end_change > 0.0 ? end_change : 0.0);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
