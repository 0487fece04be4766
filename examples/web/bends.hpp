// SPDX-License-Identifier: MIT
#pragma once

#include "text_to_mesh/options.hpp"

#include <typemesh/layout/glyph_run.hpp>

#include <memory>
#include <optional>

namespace typemesh_web {

/// How a text is bent in space, or warped in the plane. Angles and waves fit the whole text, so they become deformations
/// when its width is known.
struct bends {
    double cylinder = 0.0;         ///< degrees of an upright cylinder that the text goes around; 0: none
    std::optional<double> radius;  ///< of that cylinder, in em, instead of degrees
    double twist = 0.0;            ///< degrees from the first letter to the last; 0: none
    double wave = 0.0;             ///< the height of one wave towards the reader, in em; 0: none
    double arc = 0.0;              ///< degrees; in the plane; 0: none
    double flag = 0.0;             ///< the height of one wave in the plane, in em; 0: none
    double ring = 0.0;             ///< the radius of a ring on which letters stand, in em; negative: inside it; 0: none
    double path_wave = 0.0;        ///< the height of waves of 6 em on which letters stand, in em; 0: none

    [[nodiscard]] bool in_space() const noexcept { return cylinder != 0.0 || radius || twist != 0.0 || wave != 0.0; }
    /// Whether choose() needs the text.
    [[nodiscard]] bool fit_text() const noexcept { return in_space() && !radius; }

    /// The path on which letters stand, or none.
    [[nodiscard]] std::shared_ptr<const typemesh::plane_path> path() const;

    /// One sentence if they cannot be had together, else null.
    [[nodiscard]] const char* refused() const noexcept;

    /// The bend of a text; `run` may be null unless fit_text().
    [[nodiscard]] text_to_mesh::bend_options choose(const typemesh::glyph_run* run) const;
};

}  // namespace typemesh_web
