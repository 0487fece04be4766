// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/layout/glyph_style.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// What a mesh shows: a glyph of a face, under the map of its glyph style, which has its size and its slant. The number
/// of a glyph alone is not enough, because each face numbers its own glyphs.
///
/// In all plans of one mesher with the same font and options, equal shapes have the same mesh, as long as no option
/// depends on the whole text: output_unit::unit_box and bevel_mode::fit_text do, and text_options::corners in texts
/// that reach far. So a shape is the key for meshes that are kept from plan to plan: text_plan::shape_of() tells it,
/// and glyph_run::add() takes it over into another run. A mesh that belongs to one text alone has no shape: `id` is
/// then no_glyph. This holds for merged glyphs, and for glyphs that a path or another deformation makes at their place.
struct glyph_shape {
    glyph_id id = no_glyph;  ///< its number in its own face
    std::uint32_t face = 0;  ///< as in glyph_style
    affine map = {};         ///< as in glyph_style

    friend constexpr bool operator==(const glyph_shape& a, const glyph_shape& b) noexcept
    {
        return a.id == b.id && a.face == b.face && a.map == b.map;
    }

    /// Equal shapes have equal hashes.
    friend std::uint64_t hash_of(const glyph_shape& s) noexcept
    {
        return hash_of(glyph_style{.face = s.face, .map = s.map, .style = style_id{s.id}});
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
