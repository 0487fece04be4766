// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/unicode/impl/class_set.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A character's role in the bidirectional algorithm: Bidi_Class of UAX #9, by its short names.
enum class bidi_class : std::uint8_t {
    l,    ///< letters that are read to the right
    r,    ///< letters that are read to the left
    al,   ///< letters of Arabic and related scripts
    en,   ///< European digits
    es,   ///< + and -
    et,   ///< % $ and similar characters
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

/// Whether a character is half of a pair of brackets: Bidi_Paired_Bracket_Type.
enum class bracket_kind : std::uint8_t { none, opening, closing };

using bidi_classes = class_set<bidi_class>;

}  // namespace typemesh::inline TYPEMESH_ABI
