// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a line may end behind a piece.
enum class piece_end : std::uint8_t {
    never,
    in_need,  ///< only where its word stands at the beginning of a line and is too long for it
    allowed,
    line,       ///< a line ends here, as U+2028 demands
    paragraph,  ///< a paragraph does, as a line feed demands: the next line is indented
};

/// A piece of a text between two places where a line may end, a word usually, as breakers of lines see it. Lengths are
/// in font units.
///
///     |begin_change|   width   |  space  |             a line that begins or ends with a piece may be wider there, or
///                  |  letters  | ....... |             narrower, by the change: its end has a hyphen, or is not kerned
///                              |end_change|            with what would follow. White space at a line's end hangs.
struct break_piece {
    std::uint32_t first = 0;  ///< in the text
    std::uint32_t last = 0;
    double width = 0.0;    ///< without the white space at its end; 0 if it is nothing else
    double space = 0.0;    ///< of that white space, but for a tab
    double stretch = 0.0;  ///< of all its spaces, which justified lines make wider
    double begin_change = 0.0;
    double end_change = 0.0;
    piece_end end = piece_end::allowed;
    bool hyphen = false;  ///< a line that ends with it shows a hyphen
    bool tab = false;     ///< it ends with a tab: the next piece begins at a tab stop
    bool drawn = false;   ///< something of it is drawn, though it may have no width, as a mark without a letter

    /// Whether a line must end with it.
    [[nodiscard]] constexpr bool ends_line() const noexcept
    {
        return end == piece_end::line || end == piece_end::paragraph;
    }
    /// Whether a line that ends with it shows something of it: no mere white space, though a soft hyphen alone.
    [[nodiscard]] constexpr bool is_visible() const noexcept { return drawn || width > 0.0 || end_change > 0.0; }

    /// The room that is enough for it, wherever in a line it stands: 0 for mere white space.
    [[nodiscard]] constexpr double room() const noexcept
    {
        if (!is_visible()) return 0.0;
        return width + (begin_change > 0.0 ? begin_change : 0.0) + (end_change > 0.0 ? end_change : 0.0);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
