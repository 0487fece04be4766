// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/part_sizes.hpp>
#include <typemesh/glyph/built_glyph.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// One of a text's distinct glyphs, which is drawn glyph_count times; for instanced drawing.
struct glyph_mesh {
    const built_glyph* built = nullptr;  ///< the built glyph, valid as long as the plan
    glyph_id id = no_glyph;              ///< its number in its own face; text_plan::shape_of() tells faces apart
    std::uint32_t first_vertex = 0;      ///< its start in the output of write_meshes()
    std::uint32_t first_index = 0;
    std::uint32_t first_instance = 0;  ///< the position of its first instance in the output of write_instances()
    std::uint32_t glyph_count = 0;     ///< the number of instances
    std::uint32_t first_glyph = 0;     ///< the first instance among the text's glyphs;
    std::uint32_t last_glyph = 0;      ///< the last instance; drawn_glyph::next_alike links the instances
};

/// One occurrence of a glyph_mesh: every position of the mesh is turned, then translated. Normals and tangents are
/// turned. Only letters on a path are turned (on_path.hpp).
///
///     place of a vertex p of the mesh = p.x * x + p.y * y + p.z * z + translation
struct glyph_instance {
    vec3 translation;         ///< the translation, in the output's unit and frame
    std::uint32_t mesh = 0;   ///< the index in the plan's meshes(), for shape_of(), too
    std::uint32_t glyph = 0;  ///< the index in the plan's glyphs()
    glyph_id id = no_glyph;   ///< its number in its own face, so no key for its mesh: see text_plan::shape_of()
    cluster_id cluster = no_cluster;
    style_id style = {};
    std::uint32_t letter = not_a_letter;  ///< the index in letters().letters, if the plan's letters were found
    vec3 x{1.0f, 0.0f, 0.0f};             ///< the images of the output's axes: the columns of a rotation
    vec3 y{0.0f, 1.0f, 0.0f};
    vec3 z{0.0f, 0.0f, 1.0f};
};

/// Consecutive instances in the output of write_instances().
struct instance_range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
