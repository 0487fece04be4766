// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/triangulate/impl/appended_triangles.hpp>
#include <typemesh/triangulate/impl/low_triangles.hpp>
#include <typemesh/triangulate/triangulator.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Checks what a triangulator promises about the triangles that it has appended for a region after the first `before`,
/// and flips edges of those too low for 32-bit floats, unless its diagonals are final. The rule depends on the region
/// alone, wherever it will stand. After an error `out` is unchanged.
[[nodiscard]] inline error settle_triangles(const region& r, triangle_list& out, std::size_t before, workspace& space,
                                            bool has_final_diagonals) noexcept
{
    if (!assert_triangles(r, out, before) || has_final_diagonals) return {};
    error e = raise_low_triangles(r, out.view().subspan(before), space);
    if (e) out.truncate(before);
    return e;
}

}  // namespace detail

/// Appends a region's triangles to `out`: how(r, space, out), checked, and without triangles too low for 32-bit floats
/// (see low_triangles.hpp) where the triangulator lets edges be flipped.
///
/// Fails  as the triangulator does; error::out_of_memory. `out` is then unchanged
template <triangulator Triangulator>
[[nodiscard]] result<void> cut_region(const region& r, const Triangulator& how, workspace& space,
                                      triangle_list& out) noexcept
{
    const std::size_t before = out.size();
    if (error e = how(r, space, out)) return e;
    return detail::settle_triangles(r, out, before, space, has_final_diagonals<Triangulator>);
}

}  // namespace typemesh::inline TYPEMESH_ABI
