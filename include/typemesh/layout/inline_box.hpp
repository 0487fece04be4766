// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/impl/same.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A place in a text for an icon or a mesh of the caller's. The text has U+FFFC there, which is not drawn. Lengths are
/// in em of the whole text, whatever the size of the style; the style's rise moves the box.
///
///     {.unit = 4, .width = 1.2, .ascent = 0.8, .descent = 0.2}         a text  +-----+  a text
///                                                                    ---------| box |--------- baseline
///     A line may end on both sides (class CB of UAX #14). For the                +-----+
///     bidirectional algorithm it is neutral. Its line is as high as the box needs. In a column it stands upright in
///     the middle, and takes the place of ascent + descent.
struct inline_box {
    std::uint32_t unit = 0;  ///< the place of its U+FFFC in the text
    double width = 1.0;      ///< 0 or more
    double ascent = 1.0;     ///< the height above the baseline
    double descent = 0.0;    ///< the depth below the baseline; the sum of both is 0 or more

    friend bool operator==(const inline_box& a, const inline_box& b) noexcept
    {
        return a.unit == b.unit && same(a.width, b.width) && same(a.ascent, b.ascent) && same(a.descent, b.descent);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
