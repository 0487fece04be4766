// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/glyph/cap_builder.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The caps that an extruder's plan() requests, made by the text's own triangulator: the library's cap_maker.
class region_caps {
public:
    /// Makes caps for a region that `caps` has built; `further` makes regions of the loops that plan() finds.
    region_caps(cap_builder& caps, cap_builder& further, triangulator_ref cut) noexcept
        : region_caps{caps, further, cut, caps.triangles().view()}
    {
    }
    /// Makes caps for another region, which has these triangles.
    region_caps(cap_builder& caps, cap_builder& further, triangulator_ref cut, array_view<const triangle> triangles,
                const solid_place& place = {}) noexcept
        : caps_{caps}, further_{further}, cut_{cut}, triangles_{triangles}, place_{place}
    {
    }

    [[nodiscard]] array_view<const triangle> triangles() const noexcept { return triangles_; }
    error operator()(const region& r, triangle_list& out) noexcept
    {
        return is_on_grid(r.points()) ? caps_.cap(r, cut_, out).error() : error{error::outline_beyond_grid};
    }
    [[nodiscard]] contours& loops() noexcept { return further_.loops(); }
    /// See cap_maker.
    result<region> fill(triangle_list& out) noexcept
    {
        if (!is_on_grid(loops().points.view())) return error::outline_beyond_grid;
        const auto made = further_.fill({}, cut_);
        if (made && !out.append(further_.triangles().view())) return error::out_of_memory;
        return made;
    }
    /// Scratch memory, shared with the stages.
    [[nodiscard]] workspace& space() noexcept { return caps_.space(); }
    /// The place of the region in the text.
    [[nodiscard]] solid_place place() const noexcept { return place_; }

private:
    [[nodiscard]] static bool is_on_grid(array_view<const grid_point> points) noexcept
    {
        constexpr auto reach = static_cast<std::int32_t>(grid::reach);
        for (const grid_point p : points)
            if (p.x < -reach || p.x > reach || p.y < -reach || p.y > reach) return false;
        return true;
    }

    cap_builder& caps_;
    cap_builder& further_;
    triangulator_ref cut_;
    array_view<const triangle> triangles_;
    solid_place place_;
};
static_assert(cap_maker<region_caps>);

}  // namespace typemesh::inline TYPEMESH_ABI
