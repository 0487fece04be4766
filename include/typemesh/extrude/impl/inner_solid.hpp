// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/extrude/cap_maker.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/inner_region.hpp>
#include <typemesh/extrude/plan_arrays.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Forwards to a cap_maker, for another region.
template <cap_maker Caps>
class caps_of_region {
public:
    caps_of_region(Caps& caps, array_view<const triangle> triangles) noexcept : caps_{caps}, triangles_{triangles} {}

    [[nodiscard]] array_view<const triangle> triangles() const noexcept { return triangles_; }
    error operator()(const region& r, triangle_list& out) noexcept { return caps_(r, out); }
    [[nodiscard]] contours& loops() noexcept { return caps_.loops(); }
    result<region> fill(triangle_list& out) noexcept { return caps_.fill(out); }
    [[nodiscard]] workspace& space() noexcept { return caps_.space(); }
    [[nodiscard]] solid_place place() const noexcept { return solid_place_of(caps_); }

private:
    Caps& caps_;
    array_view<const triangle> triangles_;
};

}  // namespace detail

/// A solid that an extruder has another extruder make, over its own region: all or part of its plan data.
///
///     inner.loops = ...                          in plan(): loops that already bound a region
///     inner.plan(other_extruder, caps)
///     other_extruder.vertices<Wants>(p, s.data, at, put)     when it writes: the other extruder reads this view
template <class E>
struct inner_solid : inner_region {
    using view = solid_of<E>;

    plan_data_of<E> data;

    explicit inner_solid(memory source = heap()) noexcept : inner_region{source}, data{source} {}

    void clear() noexcept
    {
        inner_region::clear();
        data.clear();
    }

    /// The other extruder's plan for that region; its box is never omitted.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan(const E& how, const region& filled, Caps& caps) noexcept
    {
        detail::caps_of_region<Caps> own{caps, triangles.view()};
        return plan_by(how, filled, own);
    }
    /// Likewise, by a cap_maker that knows the region's triangles.
    template <cap_maker Caps>
    [[nodiscard]] result<solid_plan> plan_by(const E& how, const region& filled, Caps& own) noexcept
    {
        auto made = plan_solid(how, filled, data, own);
        if (made) {
            made->corners_moved += parting.corners;
            made->touching = made->touching || parting.still_touching;
        }
        if (made && made->around.empty())
            for (const grid_point p : filled.points()) made->around.add(placement::exact(p));
        return made;
    }

    [[nodiscard]] view read() const noexcept
    {
        return {{loops.points.view(), loops.starts.view(), triangles.view()}, data.read()};
    }

    // --- as bytes: see plan_arrays

    [[nodiscard]] std::size_t bytes() const noexcept { return own_bytes() + data.bytes(); }

    ///     block   [ numbers of the three ][ points ][ starts ][ triangles ][ data ]
    void copy_to(std::byte* block) const noexcept
    {
        const std::uint64_t counts[] = {loops.points.size(), loops.starts.size(), triangles.size()};
        std::memcpy(block, counts, sizeof counts);
        std::byte* to = block + sizeof counts;
        detail::store_array(loops.points.view(), to);
        detail::store_array(loops.starts.view(), to);
        detail::store_array(triangles.view(), to);
        data.copy_to(to);
    }
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        std::uint64_t counts[3];
        std::memcpy(counts, block, sizeof counts);
        const std::byte* from = block + sizeof counts;
        view all;
        all.points = detail::stored_array<grid_point>(counts[0], from);
        all.starts = detail::stored_array<std::uint32_t>(counts[1], from);
        all.triangles = detail::stored_array<triangle>(counts[2], from);
        all.data = plan_data_of<E>::read_from(from);
        return all;
    }

private:
    [[nodiscard]] std::size_t own_bytes() const noexcept
    {
        return 3 * sizeof(std::uint64_t) + detail::rounded_up_to_8(loops.points.view().size_bytes()) +
               detail::rounded_up_to_8(loops.starts.view().size_bytes()) +
               detail::rounded_up_to_8(triangles.view().size_bytes());
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
