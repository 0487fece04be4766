// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <concepts>

namespace typemesh::inline TYPEMESH_ABI {

/// What an extruder's plan() may ask for while it plans: caps of further regions (levels of a bevel, say), cut like all
/// others of the text, and the scratch memory that all stages share.
///
///     caps(region, out)    appends the region's triangles to `out`: indices into its points, as many as its
///                          triangle_count(); `out` is as it was after an error
///     caps.space()         for scopes of your own; what they took goes at their end
///
/// The library hands one in. Of your own: for an extruder's tests, or to call the stage by itself.
template <class C>
concept cap_maker = requires(C& caps, const region& r, triangle_list& out) {
    { caps(r, out) } noexcept -> std::same_as<error>;
    { caps.space() } noexcept -> std::same_as<workspace&>;
};

/// One for an empty region: an extruder is asked about that before there are any others.
class no_caps {
public:
    error operator()(const region&, triangle_list&) noexcept { return {}; }
    [[nodiscard]] workspace& space() noexcept { return space_; }

private:
    workspace space_;
};
static_assert(cap_maker<no_caps>);

}  // namespace typemesh::inline TYPEMESH_ABI
