// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The properties of a cluster of a shaped text: a set, joined by |.
enum class cluster_flags : std::uint16_t {
    none = 0,
    unsafe = 1u << 0,     ///< if a line ends before it, both sides must be shaped again
    hangs = 1u << 1,      ///< ignored at the end of a line: white space, breaks, invisible characters
    stretches = 1u << 2,  ///< a space, which becomes wider in justified lines
    tab = 1u << 3,
    silent = 1u << 4,          ///< a tab or a line break: it has no glyph
    spaced = 1u << 5,          ///< letter spacing has made it wider
    foreign = 1u << 6,         ///< it shows text that is not in the caller's text: a hyphen, an ellipsis
    tatweel = 1u << 7,         ///< U+0640 may be inserted before it to fill a line
    unseen = 1u << 8,          ///< invisible, but not trailing by rule L1 of UAX #9: for example a direction mark
    inset = 1u << 9,           ///< an inline box, or text in a room: its line may be higher
    unshown = hangs | unseen,  ///< invisible at the end of a line
};

[[nodiscard]] constexpr cluster_flags operator|(cluster_flags a, cluster_flags b) noexcept
{
    return static_cast<cluster_flags>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}

/// A set without the flags of another.
[[nodiscard]] constexpr cluster_flags without(cluster_flags set, cluster_flags others) noexcept
{
    return static_cast<cluster_flags>(static_cast<unsigned>(set) & ~static_cast<unsigned>(others));
}

/// Whether a set contains a flag. With several flags: whether it contains any of them.
[[nodiscard]] constexpr bool has(cluster_flags set, cluster_flags one) noexcept
{
    return (static_cast<unsigned>(set) & static_cast<unsigned>(one)) != 0;
}

/// Glyphs that a shaper keeps together, and the text that they represent.
struct text_cluster {
    cluster_id first = 0;  ///< in the text; for a foreign cluster, the text that it replaces or follows
    cluster_id last = 0;
    std::uint32_t glyph = 0;  ///< its first glyph in drawing order
    std::uint32_t glyph_count = 0;
    double advance = 0.0;  ///< of all its glyphs, in font units
    std::uint32_t item = 0;
    cluster_flags flags = cluster_flags::none;
    double before = 0.0;  ///< the sum of the advances of all clusters before it in its shaped_text
};

}  // namespace typemesh::inline TYPEMESH_ABI
