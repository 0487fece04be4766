// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/cap_maker.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A number that identifies a set of edges, in any order: the sum of a hash of each edge, modulo 2^64. If the hash were
/// random, two different sets would collide with a probability of 2^-64: nearly certain, but no proof.
[[nodiscard]] inline std::uint64_t edges_of(const contours& loops) noexcept
{
    std::uint64_t sum = 0;
    const auto bits = [](grid_point p) noexcept {
        return std::uint64_t{static_cast<std::uint32_t>(p.x)} << 32 | static_cast<std::uint32_t>(p.y);
    };
    for (std::uint32_t k = 0; k < loops.contour_count(); ++k) {
        grid_point from = loops.points[loops.starts[k + 1] - 1];
        for (std::uint32_t i = loops.starts[k]; i < loops.starts[k + 1]; ++i) {
            sum += mixed_key(mixed_key(1, bits(from)), bits(loops.points[i]));
            from = loops.points[i];
        }
    }
    return sum;
}

/// Makes a region of loops that already bound one, edge by edge, and appends its triangles to `out`. Without points,
/// the result is a region without points. The region refers to `loops`; only their order may have changed. `caps`
/// proves the region; edges_of() checks that its edges are the edges of `loops`.
///
/// Fails  error::crossing_contours: the loops do not yet bound a region; and as caps.fill() does. `out` is then
///        unchanged, and `loops` are void
template <cap_maker Caps>
[[nodiscard]] result<region> fill_exactly(contours& loops, Caps& caps, triangle_list& out) noexcept
{
    if (loops.points.empty()) return region{};
    const std::uint64_t edges = edges_of(loops);
    const std::size_t before = out.size();
    caps.loops() = std::move(loops);  // move exchanges their storage
    const result<region> made = caps.fill(out);
    const bool crossing = made && edges_of(caps.loops()) != edges;
    if (!made || crossing) out.truncate(before);
    loops = std::move(caps.loops());
    return crossing ? error{error::crossing_contours} : made;
}

}  // namespace typemesh::inline TYPEMESH_ABI
