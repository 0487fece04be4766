// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/extrude/side_normals.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// 2N vertices: walls share the caps' vertices, and every normal is a cap's, straight forward or straight back. Lit,
/// walls look like the caps' rim smeared along the depth: for meshes that are drawn unlit or in one colour, cast
/// shadows, or take part in collisions.
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
