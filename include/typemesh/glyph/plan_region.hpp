// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/plan_scratch.hpp>
#include <typemesh/glyph/policies.hpp>
#include <typemesh/triangulate/cut_region.hpp>

#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// The caps that an extruder's plan() asks for, cut by the text's own triangulator.
template <triangulator Triangulator>
class region_caps {
public:
    region_caps(const Triangulator& cut, workspace& space) noexcept : cut_{cut}, space_{space} {}

    error operator()(const region& r, triangle_list& out) noexcept { return cut_region(r, cut_, space_, out); }
    [[nodiscard]] workspace& space() noexcept { return space_; }

private:
    const Triangulator& cut_;
    workspace& space_;
};

}  // namespace detail

/// What the extruder plans for a region; its plan data lies in `data` afterwards.
///
/// Fails  error::out_of_memory, and with what its plan() fails with
template <class... Policy>
[[nodiscard]] result<solid_plan> plan_region(const region& filled, const policies<Policy...>& with, workspace& space,
                                             plan_scratch& data) noexcept
{
    using extruder_type = std::remove_cvref_t<decltype(with.raise)>;
    auto* fresh = data.fresh<plan_data_of<extruder_type>>();
    if (fresh == nullptr) return error::out_of_memory;
    detail::region_caps caps{with.cut, space};
    return plan_solid(with.raise, filled, *fresh, caps);
}

}  // namespace typemesh::inline TYPEMESH_ABI
