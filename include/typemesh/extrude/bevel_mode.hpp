// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The treatment of bevels where a stroke is thinner than twice their width.
enum class bevel_mode : std::uint8_t {
    clip,  ///< the bevels close in a ridge
    fit,   ///< the glyph's bevels become narrower: at most 0.9 times the width at which a connected component of the
           ///< glyph would lose all of its cap. Thinner strokes of a component still close in ridges. A speck is a
           ///< component too small to hold a circle of the tolerance; it may lose its cap (solid_plan::lost_caps)
           ///< unless all components are specks
    fit_text,  ///< all bevels of the text become as narrow as the narrowest bevels that any of its glyphs needs; the
               ///< text is planned twice. Only a text_mesher does this; elsewhere it means fit
};

}  // namespace typemesh::inline TYPEMESH_ABI
