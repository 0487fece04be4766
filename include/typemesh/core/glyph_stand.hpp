// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// Where an outline step lets a glyph of a run stand: moved and turned as a whole, or warped. See outline_step.hpp.
struct glyph_stand {
    point origin = {};         ///< the place of the glyph's own origin, in font units
    point right = {1.0, 0.0};  ///< the direction of its own x axis: a unit vector. Exactly {1, 0}: it is not turned
    double start = 0.0;        ///< for the step itself, if it warps the glyph
    double stretch = 1.0;      ///< likewise
    bool warped = false;       ///< whether the step warps it; `origin` and `right` then say where it stands roughly
    bool left_out = false;     ///< whether there is no place for it, so that it is not drawn
};

}  // namespace typemesh::inline TYPEMESH_ABI
