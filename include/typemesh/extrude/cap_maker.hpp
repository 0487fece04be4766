// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// What an extruder's plan() may use: caps of further regions (levels of a bevel, say), triangulated like all others of
/// the text, and the scratch memory that all stages share.
///
///     caps(region, out)    appends the region's triangles to `out`: indices into its points, as many as its
///                          triangle_count(); `out` is unchanged after an error. error::outline_beyond_grid if a
///                          point is farther than grid::reach, 2^28 cells, from 0 in x or y
///     caps.space()         for scopes of your own, which give back what they took
///
/// The library passes one in. Your own are for an extruder's tests, or for calling the stage by itself.
template <class C>
concept cap_maker = requires(C& caps, const region& r, triangle_list& out) {
    { caps(r, out) } noexcept -> std::same_as<error>;
    { caps.space() } noexcept -> std::same_as<workspace&>;
};

/// A cap_maker for an empty region, which an extruder has to plan before any other.
class no_caps {
public:
    error operator()(const region&, triangle_list&) noexcept { return {}; }
    [[nodiscard]] workspace& space() noexcept { return space_; }

private:
    workspace space_;
};
static_assert(cap_maker<no_caps>);

}  // namespace typemesh::inline TYPEMESH_ABI
