// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/fill/arrangement.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::detail {

/// Walks the boundary of the filled area and writes it down as loops.
///
/// Of a finished arrangement, the stretches with the interior on one side only are the boundary, run so that it lies on
/// the left. Where boundaries touch, the walk stays in the wedge of interior that it is in:
///
///      ::: \     / :::     What comes in along 1 goes out along 2, with the wedge of interior on the left of both
///      ::: 2\   /3 :::     between them; 3 goes out along 4. So two outer loops that touch stay two, a hole that
///      ::::: \ / :::::     touches its outer loop joins it, and two holes that touch become one.
///      :::::: x ::::::
///      ::::: / \ :::::
///      ::: 1/   \4 :::
///      ::: /     \ :::
class boundary_walk {
public:
    std::uint32_t holes = 0;
    std::uint32_t outers = 0;

    /// Replaces the loops. Fails with error::out_of_memory, the loops being as they were.
    ///
    /// Links that do not close, which a finished arrangement cannot have, would be error::crossing_contours.
    [[nodiscard]] error run(const arrangement& a, fill_rule rule, contours& loops) noexcept
    {
        if (!loops.points.reserve(a.count) || !loops.edges.reserve(a.count) || !loops.starts.reserve(a.count / 3 + 1))
            return error::out_of_memory;
        loops.points.clear();
        loops.edges.clear();
        loops.starts.clear();
        loops.starts.push_back_unchecked(0);
        for (std::uint32_t i = 0; i < a.count; ++i) {
            if (a.stretches[i].end == no_number || a.stretches[i].interior(rule) == 0) continue;
            std::uint64_t area = 0;  // doubled; below 2^60 in the end, may wrap on the way
            std::size_t size = 0;
            std::uint32_t k = i;
            do {
                if (k >= a.count || a.stretches[k].end == no_number) return error::crossing_contours;
                stretch& s = a.stretches[k];
                s.end = no_number;  // walked
                const bool along = s.interior(rule) > 0;
                loops.points.push_back_unchecked(along ? s.from : s.to);
                loops.edges.push_back_unchecked(along ? s.source
                                                      : contour_edge{s.source.curve, s.source.t1, s.source.t0});
                const auto term =
                    static_cast<std::uint64_t>(std::int64_t{s.from.x} * s.to.y - std::int64_t{s.from.y} * s.to.x);
                area += along ? term : std::uint64_t{0} - term;
                k = s.next;
                ++size;
            } while (k != i);
            if (size < 3) return error::crossing_contours;
            ++(static_cast<std::int64_t>(area) > 0 ? outers : holes);
            loops.starts.push_back_unchecked(static_cast<std::uint32_t>(loops.points.size()));
        }
        return {};
    }
};

}  // namespace typemesh::detail
