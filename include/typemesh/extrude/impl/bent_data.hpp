// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/bend/double3.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/impl/bevel_bisection.hpp>
#include <typemesh/extrude/impl/refined_solid.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/refine/impl/edge_bisection.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// What a bent solid needs when it is written.
struct bent_form {
    double low = 0.0;  ///< its heights after it is bent, in the extruder's unit
    double high = 0.0;
    std::uint32_t segments = 1;  ///< of its walls
    std::uint32_t unused = 0;    ///< fills the structure up to a multiple of its alignment
};

/// The plan data of bent: the solid of the refined region, which is not bent yet.
template <class Solid>
struct bent_data {
    using arrays = plan_arrays<bent_form>;  ///< one bent_form
    /// The parts that are stored with the glyph.
    struct view {
        typename arrays::view form;
        solid_of<Solid> flat;
    };

    arrays form;
    refined_solid<Solid> flat;       ///< the other extruder's solid
    detail::edge_bisection working;  ///< the refiner's memory, which is not stored with the glyph
    detail::bevel_bisection slopes;  ///< likewise
    buffer<double3> places;          ///< likewise, for the certificate
    contours rim;                    ///< likewise, the loops of a cap that is refined
    contours same_rim;               ///< the same loops, as the refiner writes them
    buffer<grid_point> inner;        ///< and the points that it adds
    triangle_list triangles;         ///< and its triangles

    explicit bent_data(memory source = heap()) noexcept
        : form{source},
          flat{source},
          working{source},
          slopes{source},
          places{source},
          rim{source},
          same_rim{source},
          inner{source},
          triangles{source}
    {
    }
    void clear() noexcept
    {
        form.clear();
        flat.clear();
        places.clear();
    }
    [[nodiscard]] view read() const noexcept { return {form.read(), flat.read()}; }

    // --- as bytes: see plan_arrays

    [[nodiscard]] std::size_t bytes() const noexcept { return form.bytes() + flat.bytes(); }
    ///     block   [ form ][ flat ]
    void copy_to(std::byte* block) const noexcept
    {
        form.copy_to(block);
        flat.copy_to(block + form.bytes());
    }
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        const typename arrays::view own = arrays::read_from(block);
        return {own, refined_solid<Solid>::read_from(block + own.bytes())};
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
