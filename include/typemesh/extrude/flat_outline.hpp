// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/extrude/extruder.hpp>
#include <typemesh/extrude/plan_arrays.hpp>
#include <typemesh/fill/boundary_curves.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A curve of a letter's boundary, in cells.
struct boundary_piece {
    curve shape;               ///< the curve, with its ends
    std::uint32_t begins = 0;  ///< 1: a loop begins with it
};

/// The plan data of flat_outline: the pieces, loop by loop.
class flat_outline_data : public plan_arrays<boundary_piece> {
public:
    boundary_curves finder;  ///< the memory of plan(), which is not stored with the glyph
    outline found;           ///< the boundary as an outline, which is not stored with the glyph

    explicit flat_outline_data(memory source = heap()) noexcept : plan_arrays{source}, finder{source}, found{source} {}
    void clear() noexcept
    {
        plan_arrays::clear();
        found.clear();
    }
};

/// An extruder that makes no triangles at all: it keeps the boundary of the filled letters as curves, for
/// each_outline() (text/each_outline.hpp), which gives them to a file or to a machine that cuts.
///
///     text_mesher mesher{font, flat_outline{}};
///     auto plan = mesher.plan("Hello", {.merge = true});       // letters that overlap are one outline
///     each_outline(*plan, svg);                                // an svg_path_writer
///
/// The curves are the font's own, up to where they meet others: see boundary_curves. The steps before an extruder work
/// as always; the moved edges of `embolden` are lines.
///
/// Fails  error::out_of_memory
struct flat_outline {
    using plan_data = flat_outline_data;

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    [[nodiscard]] result<solid_plan> plan(const region& filled, plan_data& data) const noexcept
    {
        solid_plan made;
        if (filled.points().empty()) return made;
        if (const auto done = data.finder.find(filled, data.found); !done) return done.error();
        const double cells = filled.grid().cells;
        auto& pieces = data.of<boundary_piece>();
        std::uint32_t loop = 0, i = 0;
        for (curve c : data.found.curves) {
            const bool begins = i++ == data.found.starts[loop];
            if (begins) ++loop;
            for (std::uint32_t k = 0; k <= c.degree; ++k) {
                c.p[k] = cells * c.p[k];
                made.around.add(c.p[k]);
            }
            if (!pieces.push_back({c, begins ? 1u : 0u})) return error::out_of_memory;
        }
        return made;
    }

    [[nodiscard]] height_range heights() const noexcept { return {}; }

    template <attribute Wants, class Put>
    void vertices(part, const solid_with<plan_data>&, const placement&, Put&&) const noexcept
    {
    }
    template <class Put>
    void triangles(part, const solid_with<plan_data>&, const first_vertices&, Put&&) const noexcept
    {
    }
    template <class Put>
    void seen_from_front(const solid_with<plan_data>&, Put&&) const noexcept
    {
    }
};
static_assert(extruder<flat_outline>);

}  // namespace typemesh::inline TYPEMESH_ABI
