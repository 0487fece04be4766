// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/part_sizes.hpp>
#include <typemesh/glyph/built_glyph.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One glyph of the mesh: its id and cluster, its built glyph and its position. Or several merged glyphs, represented
/// by the first one.
struct drawn_glyph {
    const built_glyph* built = nullptr;
    point origin;              ///< the glyph's origin, in font units
    point right = {1.0, 0.0};  ///< the direction of its own x axis: {1, 0} unless a path turns it (on_path.hpp)
    point flat;                ///< its origin in the run, from which textures begin; `origin`, unless a path moves it
    glyph_id id = no_glyph;
    cluster_id cluster = no_cluster;
    style_id style = {};
    std::uint32_t line = 0;
    std::uint32_t glyph = 0;          ///< its index in the run
    std::uint32_t merged = none;      ///< the number of its group of merged glyphs, or none
    std::uint32_t mesh = 0;           ///< its index in the text's meshes
    std::uint32_t next_alike = none;  ///< the next record with this mesh, or none
    part_sizes before = {};           ///< the counts of all preceding glyphs

    static constexpr std::uint32_t none = 0xFFFF'FFFFu;
};

}  // namespace typemesh::inline TYPEMESH_ABI
