// SPDX-License-Identifier: MIT
#pragma once

#include "fonts.hpp"
#include "mesh_arrays.hpp"
#include "text_to_mesh/options.hpp"

#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/morph/axis_morph.hpp>

#include <string_view>

namespace typemesh_web {

/// A text that moves along an axis of its font, with the same triangles throughout. Extruded letters without bevels.
class weight_morph {
public:
    explicit weight_morph(typemesh::harfbuzz_axis&& axis) noexcept : axis_{std::move(axis)}, morph_{axis_} {}
    weight_morph(const weight_morph&) = delete;
    weight_morph& operator=(const weight_morph&) = delete;

    /// Plans a text. What `o` says of depth, size, quality, shaping and lines holds.
    [[nodiscard]] typemesh::result<void> plan(std::u16string_view text, const text_to_mesh::options& o);

    /// Fills `out` with the mesh at a value of the axis. Texture coordinates are x and y in em.
    [[nodiscard]] typemesh::result<void> write(double value, mesh_arrays& out);

private:
    typemesh::harfbuzz_axis axis_;
    typemesh::axis_morph<typemesh::harfbuzz_axis> morph_;
    typemesh::morph_plan plan_;
    double size_ = 1.0;
};

}  // namespace typemesh_web
