// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/option_hash.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/option_bits.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/extrude/inner_region.hpp>
#include <typemesh/extrude/region_step.hpp>
#include <typemesh/glyph/impl/curve_coarsener.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A step before any solid that makes the levels of detail of a text. All levels come from the same fill, at the
/// tolerance of the text, which is the finest: a coarser level only drops points, and moves none.
///
///      .-o-o-.         .-----o         o-----o        level 0: the text at its own tolerance
///     o       o       o       \         \     \       level 1: within tolerances[0] of the true curves
///     |       |  -->  |       |  -->     \     |      level 2: within tolerances[1], with points of level 1 only
///     o       o       o       o           o----o
///
///     coarsened levels{.tolerances = {quality::normal, 1.0 / 60, 1.0 / 25}};
///     text_mesher mesher{font, levels};
///     for (mesh_of_level& mesh : meshes) {                                   // 4 of them: levels 0 to 3
///         mesher.build("Hello", into(mesh.vertices, mesh.indices), {.tolerance = quality::high});
///         ++mesher.policy<coarsened>()->level;
///     }
///
/// Points are dropped only between points of one curve. So corners stay, each point keeps its normals, and the levels
/// have the same loops with the same nesting: a hole, a gap or a stroke of the finest level is in all levels. Each edge
/// of a level is within the level's tolerance of its true curve, or is an edge of the finest level. Where dropping a
/// point would let edges meet, it stays. Every loop keeps at least 3 points.
///
/// A level can have a few more points than a text that is flattened at the level's tolerance, because it must choose
/// among the points of the finer level. The ratio is best where tolerances are far apart, or in the ratio of squares
/// (1, 4, 16: then every second point stays).
///
/// Fails  error::bad_option: a tolerance of a level up to `level` is not positive and finite, or is smaller than the
///        one before it ("coarsened::tolerances"); `level` is above max_levels ("coarsened::level")
///        error::out_of_memory; as the triangulator does
/// Cost   O(n log n) for n points of the finest level, for each level up to `level`
///
/// From  M. de Berg, M. van Kreveld, S. Schirra, "Topologically correct subdivision simplification using the bandwidth
/// criterion" (1998), section 3, for the test that no point lies between a line and its simplification
struct coarsened {
    static constexpr std::uint32_t max_levels = 6;

    double tolerances[max_levels] = {};  ///< of levels 1, 2, ..., in em; each at least as large as the one before
    std::uint32_t level = 0;             ///< 0: the text as it is; otherwise the number of tolerances that are used

    /// The coarser letter, and the working memory for making it.
    struct scratch : inner_region {
        detail::curve_coarsener drop;  ///< chooses the points that are dropped

        explicit scratch(memory source = heap()) noexcept : inner_region{source}, drop{source} {}
    };

    /// See option_bits.
    [[nodiscard]] option_bits cache_key() const noexcept
    {
        option_hash all;
        for (std::uint32_t k = 0; k < level && k < max_levels; ++k) all.add(option_bits{tolerances[k]});
        return {all.first, all.second};
    }

    /// See region_step.
    [[nodiscard]] error refused_options() const noexcept
    {
        if (level > max_levels) return error::bad("coarsened::level");
        for (std::uint32_t k = 0; k < level; ++k)
            if (!is_finite(tolerances[k]) || !(tolerances[k] > 0.0) || (k != 0 && tolerances[k] < tolerances[k - 1]))
                return error::bad("coarsened::tolerances");
        return {};
    }

    template <cap_maker Caps>
    [[nodiscard]] result<stepped_region> operator()(const region& drawn, scratch& made, Caps& caps) const noexcept
    {
        if (error e = refused_options()) return e;
        if (level == 0) return stepped_region{drawn, caps.triangles()};
        const double em = drawn.grid().cells * drawn.grid().units_per_em;
        if (!(em > 0.0)) return error::bad("units_per_em");
        contours& loops = made.loops;
        if (!loops.points.append(drawn.points()) || !loops.edges.append(drawn.edges()) ||
            !loops.starts.append(drawn.starts()))
            return error::out_of_memory;
        loops.curves = drawn.curves();
        loops.grid = drawn.grid();
        loops.corners = drawn.corners();
        loops.tolerance = drawn.tolerance();
        if (!keep_order(drawn, loops)) return error::out_of_memory;
        for (std::uint32_t k = 0; k < level; ++k) {
            const double tolerance = tolerances[k] * em;
            if (error e = made.drop(loops, tolerance)) return e;
            if (loops.tolerance > 0.0 && loops.tolerance < tolerance) loops.tolerance = tolerance;
        }
        // Each point was dropped by an exact test, so the loops bound a region without a further proof.
        const region filled = region::proven(loops, drawn.holes(), drawn.outers(), drawn.is_touching());
        if (error e = caps(filled, made.triangles)) return e;
        return stepped_region{filled, made.triangles.view()};
    }

private:
    [[nodiscard]] static bool keep_order(const region& drawn, contours& loops) noexcept
    {
        const array_view<const std::uint32_t> order = drawn.order();
        if (order.empty()) return true;
        std::uint32_t* next = loops.new_order(order.size());
        if (next == nullptr) return false;
        for (const std::uint32_t i : order) *next++ = i;
        return true;
    }
};
static_assert(region_step<coarsened>);

}  // namespace typemesh::inline TYPEMESH_ABI
