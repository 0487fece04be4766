// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/class_set.hpp>

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

using bidi_classes = class_set<bidi_class>;

}  // namespace typemesh::inline TYPEMESH_ABI
