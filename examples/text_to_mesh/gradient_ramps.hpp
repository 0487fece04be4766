// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "options.hpp"
#include "policies.hpp"

#include <typemesh/colour/colour_style.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace text_to_mesh {

/// The gradients of a text's colour glyphs as textures of one row: for .glb files of letters that stay where they are.
class gradient_ramps {
public:
    gradient_ramps(const options& o, const chosen_plan& plan, model& out) : o_{o}, plan_{plan}, out_{out} {}

    /// The number of the ramp of a style in the model, where it is added; nothing if the style has no gradient.
    [[nodiscard]] std::optional<std::size_t> ramp_of(typemesh::style_id style);

    /// Gives all vertices of glyphs with gradients their coordinates in the ramps, as u.
    void place_vertices();

private:
    [[nodiscard]] const typemesh::colour_style* gradient_of(typemesh::style_id style) const;

    const options& o_;
    const chosen_plan& plan_;
    model& out_;
    std::vector<typemesh::style_id> styles_;  // of the ramps
    std::size_t first_ = 0;                   // ramp in the model
};

}  // namespace text_to_mesh
