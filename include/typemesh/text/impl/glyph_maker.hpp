// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/glyph/built_glyph.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/text/impl/run_glyph_styles.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

/// A glyph that a text needs: the arguments of glyph_builder::build().
struct wanted_glyph {
    drawn_face& face;
    glyph_id id;
    const glyph_settings& how;
    const policies& with;
    solid_place place;
};

/// Makes a text's different glyphs in another way than glyph_builder::build(), one after the other.
struct glyph_maker {
    /// `number` is the glyph's number among the different glyphs.
    result<glyph_draft> (*make)(void* self, std::size_t number, glyph_builder& builder,
                                const wanted_glyph& wanted) noexcept = nullptr;
    void* self = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI
