// SPDX-License-Identifier: MIT
#pragma once

#include "floor_shadow.hpp"
#include "model.hpp"
#include "picture_options.hpp"
#include "vec3.hpp"
#include "view.hpp"

namespace text_to_mesh {

/// What is behind the model: white, or the studio with the shadow that a solid throws on its floor.
class backdrop {
public:
    backdrop(const model& mesh, const picture_options& options, const view& seen);

    /// The colour of one pixel.
    [[nodiscard]] vec3 at(int x, int y) const;

private:
    background kind_;
    const view& seen_;
    floor_shadow shadow_;
};

}  // namespace text_to_mesh
