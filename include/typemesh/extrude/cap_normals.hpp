// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/extrude/side_normals.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The normals of the caps, also on the walls: walls share the caps' vertices, 2N in all, and every normal points
/// straight forward or straight back. When lit, walls look like the caps' rim smeared along the depth. Use these
/// normals for meshes that are unlit or in one colour, for shadows, or for collisions. Only the rows between the caps,
/// which walls in several segments have, get the normals of their walls (extruded.hpp).
///
/// The naive extrusion of section 6.1 of "Study of mesh generation and optimization techniques applied to parametric
/// forms", J. Vandenbergh, 2020.
struct cap_normals {
    static constexpr bool shares_caps = true;
    static constexpr bool leaves_caps_alone = true;

    error operator()(const region&, array_view<side_point>) const noexcept { return {}; }
};
static_assert(side_normals<cap_normals>);

}  // namespace typemesh::inline TYPEMESH_ABI
