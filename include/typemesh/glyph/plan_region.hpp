// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/plan_scratch.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>

#include <cstdint>
#include <span>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The caps that an extruder's plan() asks for, made by the text's own triangulator.
template <triangulator Triangulator>
class region_caps {
public:
    region_caps(cap_builder& caps, cap_builder& further, const Triangulator& cut) noexcept
        : caps_{caps}, further_{further}, cut_{cut}
    {
    }

    [[nodiscard]] std::span<const triangle> triangles() const noexcept { return caps_.triangles().view(); }
    error operator()(const region& r, triangle_list& out) noexcept
    {
        return is_on_grid(r.points()) ? caps_.cap(r, cut_, out) : error{error::outline_beyond_grid};
    }
    [[nodiscard]] contours& loops() noexcept { return further_.loops(); }
    result<region> fill(triangle_list& out) noexcept
    {
        if (!is_on_grid(loops().points.view())) return error::outline_beyond_grid;
        const auto made = further_.fill({}, cut_);
        if (made && !out.append(further_.triangles().view())) return error::out_of_memory;
        return made;
    }
    [[nodiscard]] workspace& space() noexcept { return caps_.space(); }

private:
    [[nodiscard]] static bool is_on_grid(std::span<const grid_point> points) noexcept
    {
        constexpr auto reach = static_cast<std::int32_t>(grid::reach);
        for (const grid_point p : points)
            if (p.x < -reach || p.x > reach || p.y < -reach || p.y > reach) return false;
        return true;
    }

    cap_builder& caps_;
    cap_builder& further_;
    const Triangulator& cut_;
};

}  // namespace detail

/// The extruder's plan for a region that `caps` has built; its plan data is then in `data`. `further` makes regions of
/// the loops that it finds.
///
/// Fails  error::out_of_memory, and with what its plan() fails with
template <class... Policy>
[[nodiscard]] result<solid_plan> plan_region(const region& filled, const policies<Policy...>& with, cap_builder& caps,
                                             cap_builder& further, plan_scratch& data) noexcept
{
    using extruder_type = std::remove_cvref_t<decltype(with.raise)>;
    auto* fresh = data.fresh<plan_data_of<extruder_type>>();
    if (fresh == nullptr) return error::out_of_memory;
    detail::region_caps maker{caps, further, with.cut};
    return plan_solid(with.raise, filled, *fresh, maker);
}

}  // namespace typemesh::inline TYPEMESH_ABI
