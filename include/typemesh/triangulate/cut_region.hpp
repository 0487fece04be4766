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

/// Checks a triangulator's guarantees for the triangles that it appended after the first `before` triangles. Flips
/// edges of triangles that are too thin for 32-bit floats, unless the diagonals are final. This rule depends only on
/// the region, not on its later position. After an error `out` is unchanged.
[[nodiscard]] inline error settle_triangles(const region& r, triangle_list& out, std::size_t before, workspace& space,
                                            bool has_final_diagonals) noexcept
{
    if (!assert_triangles(r, out, before) || has_final_diagonals) return {};
    error e = raise_low_triangles(r, out.view().subspan(before), space);
    if (e) out.truncate(before);
    return e;
}

}  // namespace detail

/// Appends a region's triangles to `out`: calls how(r, space, out) and checks the result. If the triangulator's
/// diagonals are not final, flips edges of triangles that are too thin for 32-bit floats (lower than 2^-20 em).
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
