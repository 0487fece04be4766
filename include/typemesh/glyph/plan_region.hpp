// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/plan_scratch.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/policies.hpp>

#include <cstdint>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The caps that an extruder's plan() asks for, made by the text's own triangulator.
template <triangulator Triangulator>
class region_caps {
public:
    region_caps(cap_builder& caps, const Triangulator& cut) noexcept : caps_{caps}, cut_{cut} {}

    error operator()(const region& r, triangle_list& out) noexcept
    {
        constexpr auto reach = static_cast<std::int32_t>(grid::reach);
        for (const grid_point p : r.points())
            if (p.x < -reach || p.x > reach || p.y < -reach || p.y > reach) return error::outline_beyond_grid;
        return caps_.cap(r, cut_, out);
    }
    [[nodiscard]] workspace& space() noexcept { return caps_.space(); }

private:
    cap_builder& caps_;
    const Triangulator& cut_;
};

}  // namespace detail

/// The extruder's plan for a region; its plan data is then in `data`. `caps` makes the caps of further regions that it
/// asks for, and keeps its own.
///
/// Fails  error::out_of_memory, and with what its plan() fails with
template <class... Policy>
[[nodiscard]] result<solid_plan> plan_region(const region& filled, const policies<Policy...>& with, cap_builder& caps,
                                             plan_scratch& data) noexcept
{
    using extruder_type = std::remove_cvref_t<decltype(with.raise)>;
    auto* fresh = data.fresh<plan_data_of<extruder_type>>();
    if (fresh == nullptr) return error::out_of_memory;
    detail::region_caps further{caps, with.cut};
    return plan_solid(with.raise, filled, *fresh, further);
}

}  // namespace typemesh::inline TYPEMESH_ABI
