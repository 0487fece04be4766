// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/taken.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/extrude/impl/wall_normal.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

struct loop_arrays {
    array_view<const grid_point> points;
    array_view<const contour_edge> edges;
    array_view<const std::uint32_t> starts;
};
[[nodiscard]] inline loop_arrays arrays_of(const region& r) noexcept { return {r.points(), r.edges(), r.starts()}; }
[[nodiscard]] inline loop_arrays arrays_of(const contours& c) noexcept
{
    return {c.points.view(), c.edges.view(), c.starts.view()};
}

}  // namespace detail

/// Appends loops to contours without curves. False if out of memory.
[[nodiscard]] inline bool append_loops(array_view<const grid_point> points, array_view<const std::uint32_t> starts,
                                       contours& out) noexcept
{
    const auto before = static_cast<std::uint32_t>(out.points.size());
    if (out.starts.empty() && !out.starts.push_back(0)) return false;
    contour_edge* const edges = out.edges.append(points.size());
    if ((edges == nullptr && !points.empty()) || !out.points.append(points)) return false;
    for (std::size_t i = 0; i < points.size(); ++i) edges[i] = {};
    for (std::size_t k = 1; k < starts.size(); ++k)
        if (!out.starts.push_back(before + starts[k])) return false;
    out.forget_order();
    return true;
}

/// Appends the loops of a region or of contours. False if out of memory.
template <class Loops>
[[nodiscard]] bool append_loops(const Loops& loops, contours& out) noexcept
{
    const auto [points, edges, starts] = detail::arrays_of(loops);
    if (!append_loops(points, starts, out)) return false;
    for (std::size_t i = 0; i < edges.size(); ++i) out.edges[out.edges.size() - edges.size() + i] = edges[i];
    return true;
}

/// Reverses a loop, so that each edge runs against its curve.
inline void turn_loop(contours& loops, std::uint32_t k) noexcept
{
    const std::uint32_t begin = loops.starts[k], end = loops.starts[k + 1];
    for (std::uint32_t i = begin, j = end - 1; i < j; ++i, --j) swap_values(loops.points[i], loops.points[j]);
    // The last edge, back to the first point, stays the last one.
    for (std::uint32_t i = begin, j = end - 2; i < j; ++i, --j) swap_values(loops.edges[i], loops.edges[j]);
    for (std::uint32_t i = begin; i < end; ++i) swap_values(loops.edges[i].t0, loops.edges[i].t1);
    loops.forget_order();
}

/// The distance that corners of a region may move while its edges move outwards by `distance`, rounded up to a multiple
/// of it. Corners sharper than the mitre limit (0: none) get joins.
[[nodiscard]] inline double farthest_way(const region& filled, double distance, double mitre_limit) noexcept
{
    const double most = mitre_limit > 0.0 ? mitre_limit : 0x1p18;
    double longest = 2.0;
    for (std::uint32_t k = 0; longest < most && k < filled.loop_count(); ++k) {
        const std::uint32_t begin = filled.starts()[k], end = filled.starts()[k + 1];
        grid_point a = filled.points()[end - 2], b = filled.points()[end - 1];
        for (std::uint32_t i = begin; i < end; ++i) {
            const grid_point c = filled.points()[i];
            const point in = delta(a, b), on = delta(b, c);
            const double halved =
                0.5 + 0.5 * dot(in, on) / (length(in) * length(on));  // squared cosine of half the turn
            if (cross(in, on) > 0.0 && halved * longest * longest < 1.0)
                longest = std::sqrt(1.0 / std::fmax(halved, 0x1p-36));
            a = b;
            b = c;
        }
    }
    return std::ceil(longest < most ? longest : std::fmax(most, 2.0)) * distance;
}

/// The surroundings of a region: a frame far outside, and the region's own loops, reversed. Filled by non_zero, they
/// are the region of an outward sweep.
///
///     +------------------+      The frame's corners come first. It is so far outside that it meets nothing while
///     |   .-->--.        |      edges and corners move, by at most `reach` (farthest_way).
///     |   |     |        |
///     |   '--<--'        |
///     +------------------+
///
/// Fails  error::out_of_memory, error::outline_beyond_grid
[[nodiscard]] inline error surround(const region& filled, double reach, contours& out) noexcept
{
    out.clear();
    out.grid = filled.grid();
    out.corners = filled.corners();
    out.curves = filled.curves();
    out.tolerance = filled.tolerance();
    const std::size_t n = filled.points().size();
    if (!out.points.reserve(n + 4) || !out.edges.reserve(n + 4) || !out.starts.reserve(filled.loop_count() + 2))
        return error::out_of_memory;
    if (n == 0) return out.starts.push_back(0) ? error::none : error::out_of_memory;

    grid_point low = filled.points()[0], high = low;
    for (const grid_point p : filled.points()) {
        low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
        high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
    }
    const double margin = 2.0 * reach + 64.0;
    if (!(margin < grid::reach)) return error::outline_beyond_grid;
    const auto m = static_cast<std::int32_t>(margin);
    for (const grid_point p : {grid_point{low.x - m, low.y - m},
                               {high.x + m, low.y - m},
                               {high.x + m, high.y + m},
                               {low.x - m, high.y + m}}) {
        constexpr auto most = static_cast<std::int32_t>(grid::reach);
        if (p.x < -most || p.x > most || p.y < -most || p.y > most) return error::outline_beyond_grid;
        out.points.push_back_unchecked(p);
        out.edges.push_back_unchecked({});  // the curve does not matter
    }
    out.starts.push_back_unchecked(0);
    out.starts.push_back_unchecked(4);
    out.grid.span += 2.0 * std::sqrt(2.0) * margin;
    if (!append_loops(filled, out)) return error::out_of_memory;
    for (std::uint32_t k = 1; k < out.contour_count(); ++k) turn_loop(out, k);
    return {};
}

/// The first of the frame's four points in the region that surround() has filled: only the frame has points so low.
[[nodiscard]] inline std::uint32_t frame_of(const region& around) noexcept
{
    std::uint32_t lowest = 0;
    for (std::uint32_t k = 0; k < around.loop_count(); ++k) {
        const std::uint32_t begin = around.starts()[k], end = around.starts()[k + 1];
        for (std::uint32_t i = begin; i < end; ++i)
            if (around.points()[i].y < around.points()[lowest].y) lowest = i;
    }
    for (std::uint32_t k = 0; k < around.loop_count(); ++k)
        if (lowest >= around.starts()[k] && lowest < around.starts()[k + 1]) return around.starts()[k];
    return 0;
}

/// Whether an outward sweep has left a frame of four corners, and no other point farther from the region's box than
/// `reach`. Otherwise corners have met and grown a spike.
[[nodiscard]] inline bool is_in_reach(const contours& left, const region& filled, double reach) noexcept
{
    box around;
    for (const grid_point p : filled.points()) around.add({static_cast<double>(p.x), static_cast<double>(p.y)});
    std::size_t beyond = 0;
    for (const grid_point p : left.points)
        beyond += p.x < around.low.x - reach || p.x > around.high.x + reach || p.y < around.low.y - reach ||
                          p.y > around.high.y + reach
                      ? 1u
                      : 0u;
    return left.starts.empty() || beyond == 4;
}

/// Turns the remaining surroundings of a region into the larger region: removes the frame and reverses all other loops.
inline void leave_frame(contours& loops) noexcept
{
    if (loops.starts.empty()) return;  // nothing has been swept
    std::uint32_t lowest = 0, kept = 0;
    for (std::uint32_t i = 0; i < loops.points.size(); ++i)
        if (loops.points[i].y < loops.points[lowest].y) lowest = i;
    std::size_t end = 0;
    for (std::uint32_t k = 0, begin = 0; k < loops.contour_count(); ++k) {
        const std::uint32_t after = loops.starts[k + 1], size = after - begin;
        if (lowest < begin || lowest >= after) {
            for (std::uint32_t i = 0; i < size; ++i) {
                loops.points[end + i] = loops.points[begin + i];
                loops.edges[end + i] = loops.edges[begin + i];
            }
            end += size;
            loops.starts[++kept] = static_cast<std::uint32_t>(end);
        }
        begin = after;
    }
    loops.points.truncate(end);
    loops.edges.truncate(end);
    loops.starts.truncate(kept + 1);
    for (std::uint32_t k = 0; k < kept; ++k) turn_loop(loops, k);
}

}  // namespace typemesh::inline TYPEMESH_ABI
