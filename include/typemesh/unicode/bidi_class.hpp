// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// How a character takes part in the bidirectional algorithm: Bidi_Class of UAX #9, by its short names.
enum class bidi_class : std::uint8_t {
    l,    ///< letters that are read to the right
    r,    ///< letters that are read to the left
    al,   ///< those of Arabic and its kin
    en,   ///< European digits
    es,   ///< + and -
    et,   ///< % $ and the like
    an,   ///< Arabic-Indic digits
    cs,   ///< . , : /
    nsm,  ///< marks
    bn,   ///< controls without a direction
    b,    ///< ends a paragraph
    s,    ///< tab
    ws,   ///< spaces
    on,   ///< all other neutral characters
    lre,  ///< embeddings and overrides, ended by pdf
    lro,
    rle,
    rlo,
    pdf,
    lri,  ///< isolates, ended by pdi
    rli,
    fsi,
    pdi,
};

/// Whether a character is one half of a pair of brackets: Bidi_Paired_Bracket_Type.
enum class bracket_kind : std::uint8_t { none, opening, closing };

/// A set of classes, for tests of several at once.
class bidi_classes {
public:
    template <class... Classes>
    constexpr bidi_classes(Classes... c) noexcept : bits_{(0u | ... | bit(c))}
    {
    }
    [[nodiscard]] constexpr bool holds(bidi_class c) const noexcept { return (bits_ & bit(c)) != 0; }
    [[nodiscard]] constexpr bool meets(bidi_classes other) const noexcept { return (bits_ & other.bits_) != 0; }
    constexpr void add(bidi_class c) noexcept { bits_ |= bit(c); }
    constexpr void add(bidi_classes other) noexcept { bits_ |= other.bits_; }

private:
    static constexpr std::uint32_t bit(bidi_class c) noexcept { return 1u << static_cast<unsigned>(c); }

    std::uint32_t bits_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
