// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/point.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The place of a glyph's outline in the text, for steps that depend on it.
struct drawn_place {
    point origin = {};         ///< the glyph's own origin, relative to the text's, in em
    double em_per_unit = 0.0;  ///< em per font unit
    box text = {};             ///< from the first pen position of the text to its last, lowest and highest baseline
                               ///< included, in em; empty: unknown
};

}  // namespace typemesh::inline TYPEMESH_ABI
