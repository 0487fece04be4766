// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>

#include <concepts>
#include <optional>

namespace typemesh::inline TYPEMESH_ABI {

/// The place of a region in the text, for extruders whose solids differ from place to place. Where corners are treated,
/// low walls depend on its unit of depths.
struct solid_place {
    point origin = {};          ///< the region's own origin, relative to the text's, in em
    double em_per_depth = 1.0;  ///< em per unit of the extruder's depths

    /// The pen in font units, if the origin becomes this pen, rounded to the region's grid: see rounded_pen(). Until
    /// the region is made, its grid is unknown.
    std::optional<point> pen = {};
};

/// The resources of an extruder's plan(): caps of further regions (for example levels of a bevel), triangulated like
/// all others of the text, and the scratch memory that all stages share.
///
///     caps.triangles()     the triangles of the region that is being planned
///     caps(region, out)    appends a region's triangles to `out`: indices into its points, as many as its
///                          triangle_count(); `out` is unchanged after an error. error::outline_beyond_grid if a
///                          point is farther than grid::reach, 2^28 cells, from 0 in x or y
///     caps.loops()         contours to be filled in, for loops that are no region yet; storage is kept. The loops
///                          are valid until the next call
///     caps.fill(out)       makes the region that these loops fill by fill_rule::non_zero, with its triangles, as
///                          above. The region refers to loops(), which are unchanged if they already bound a region
///     caps.space()         for scopes of your own, which release their memory at the end
///     caps.place()         optional, see solid_place_of(): the place of the region in the text
///
/// The library supplies a cap_maker. Write your own for an extruder's tests, or to call the stage by itself.
template <class C>
concept cap_maker = requires(C& caps, const region& r, triangle_list& out) {
    { caps.triangles() } noexcept -> std::convertible_to<array_view<const triangle>>;
    { caps(r, out) } noexcept -> std::same_as<error>;
    { caps.loops() } noexcept -> std::same_as<contours&>;
    { caps.fill(out) } noexcept -> std::same_as<result<region>>;
    { caps.space() } noexcept -> std::same_as<workspace&>;
};

/// A cap_maker for an empty region, which an extruder must plan before any other region.
class no_caps {
public:
    [[nodiscard]] array_view<const triangle> triangles() const noexcept { return {}; }
    error operator()(const region&, triangle_list&) noexcept { return {}; }
    [[nodiscard]] contours& loops() noexcept { return loops_; }
    result<region> fill(triangle_list&) noexcept { return region{}; }
    [[nodiscard]] workspace& space() noexcept { return space_; }

private:
    contours loops_;
    workspace space_;
};
static_assert(cap_maker<no_caps>);

/// The place of the region that is being planned; the text's origin if the cap_maker does not know.
template <cap_maker Caps>
[[nodiscard]] solid_place solid_place_of(const Caps& caps) noexcept
{
    if constexpr (requires { caps.place(); })
        return caps.place();
    else
        return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
