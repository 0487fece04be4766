// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/inner_solid.hpp>
#include <typemesh/refine/refiner.hpp>

#include <concepts>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// An extruder that accepts points inside the region. In solid::points they follow the points of the loops, and the
/// caps' triangles may use them.
template <class E>
concept refinable_extruder = extruder<E> && takes_inner_points<E>;

namespace detail {

/// A stand-in with which the concept refinable_caps is checked; it is never defined.
struct cap_refiner {
    /// Refines the region's own cap.
    error region_cap(std::uint32_t& added) noexcept;
    /// Refines another cap.
    error cap(buffer<grid_point>& points, array_view<const std::uint32_t> starts, buffer<triangle>& triangles,
              std::uint32_t& added) noexcept;
};

}  // namespace detail

/// An extruder that makes caps of its own and can have them refined, such as bevelled:
///
///     e.plan(filled, data, caps)           calls caps.refine(data, cap, turned), if there is such a function, with a
///                                          cap that it has made, instead of storing it: see rim_refinement
///     e.refine_caps(refine, data, made)    after plan(): has each cap that it draws refined, and adds their points and
///                                          triangles to made.sizes. Each inner point adds two triangles
///     refine.region_cap(added)             refines the region's own cap. The points follow the region's points
///     refine.cap(points, starts, triangles, added)     refines another cap. Inner points are appended to its points,
///                                          and its triangles are replaced
template <class E>
concept refinable_caps =
    extruder<E> && requires(const E& e, detail::cap_refiner& refine, plan_data_of<E>& data, solid_plan& made) {
        { e.refine_caps(refine, data, made) } noexcept -> std::same_as<error>;
    };

/// A solid over a cap that has been refined: all or part of an extruder's plan data.
///
///     refine(..., solid.out(kept))      in plan(): a refiner writes the cap here
///     solid.plan_refined(extruder, filled, caps)
template <class E>
struct refined_solid : inner_solid<E> {
    buffer<grid_point> inner;  ///< the points inside, before they follow the loops' points

    explicit refined_solid(memory source = heap()) noexcept : inner_solid<E>{source}, inner{source} {}
    void clear() noexcept
    {
        inner_solid<E>::clear();
        inner.clear();
    }

    /// For a refiner to write to. Both references must outlive the result.
    [[nodiscard]] refined_cap out(std::uint32_t& kept) noexcept { return {this->loops, inner, this->triangles, kept}; }

    /// The region that the refined loops bound, before their points are followed by the inner points.
    [[nodiscard]] region boundary_of(const region& filled) const noexcept
    {
        return region::proven(this->loops, filled.holes(), filled.outers(), filled.is_touching());
    }

    /// The other extruder's plan for the refined cap of the region `filled`.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan_refined(const E& how, const region& filled, Caps& caps) noexcept
    {
        auto made = this->plan(how, boundary_of(filled), caps);
        if (!made) return made;
        // The caps get the inner points as well. Each adds two triangles.
        const auto added = static_cast<std::uint32_t>(inner.size());
        for (const part p : {part::front, part::back}) {
            if (made->sizes.vertices[p] != 0) made->sizes.vertices[p] += added;
            if (made->sizes.triangles[p] != 0) made->sizes.triangles[p] += 2 * added;
        }
        if (!this->loops.points.append(inner.view())) return error::out_of_memory;
        return made;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
