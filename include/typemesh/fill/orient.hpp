// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/orientation.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Reverses one contour in place: the neighbours of its first point swap roles, and every edge runs against its curve.
///
///     points  a b c d            ->  d c b a
///     edges   ab bc cd da        ->  dc cb ba ad      with t0 and t1 swapped
inline void reverse_contour(array_view<grid_point> points, array_view<contour_edge> edges) noexcept
{
    if (points.empty()) return;
    for (std::size_t i = 0, j = points.size() - 1; i < j; ++i, --j) {
        const grid_point p = points[i];
        points[i] = points[j];
        points[j] = p;
    }
    const auto exchange_turned = [](contour_edge& a, contour_edge& b) noexcept {
        const contour_edge turned{b.curve, b.t1, b.t0};
        b = {a.curve, a.t1, a.t0};
        a = turned;
    };
    const std::size_t closing = edges.size() - 1;  // from the last point to the first: stays in place, reversed
    for (std::size_t i = 0, j = closing; i < j--; ++i) exchange_turned(edges[i], edges[j]);
    exchange_turned(edges[closing], edges[closing]);
}

/// Reverses all contours together if the sum of their signed areas is negative. TrueType winds outer contours
/// clockwise, PostScript counter-clockwise; a region has its interior on the left.
///
/// This is a guess for simple outlines, from exact sums. The guess may be wrong if contours overlap or disagree in
/// direction; a proving triangulator then refuses the contours, and fill() resolves them. O(n), no allocation.
inline void orient(contours& loops) noexcept
{
    std::int64_t high = 0, low = 0;  // 2^32 high + low: a sum of 2^32 terms below 2^58 needs more than 64 bits
    const grid_point* const points = loops.points.data();
    for (std::uint32_t c = 0; c < loops.contour_count(); ++c) {
        const std::size_t begin = loops.starts[c], end = loops.starts[c + 1];
        if (begin == end) continue;
        grid_point p = points[end - 1];
        for (std::size_t i = begin; i < end;) {
            std::int64_t sum = 0;  // of 16 terms: below 2^62
            for (const std::size_t stop = end - i < 16 ? end : i + 16; i < stop; ++i) {
                const grid_point q = points[i];
                sum += std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x;
                p = q;
            }
            high += sum >> 32;
            low += sum & 0xFFFF'FFFF;
        }
    }
    if (high + (low >> 32) >= 0) return;
    loops.forget_order();
    for (std::uint32_t c = 0; c < loops.contour_count(); ++c) {
        const std::size_t begin = loops.starts[c], size = loops.starts[c + 1] - begin;
        reverse_contour(loops.points.view().subspan(begin, size), loops.edges.view().subspan(begin, size));
    }
}

}  // namespace typemesh::inline TYPEMESH_ABI
