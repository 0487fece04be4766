// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/fill/arrangement.hpp>

#include <cstdint>

namespace typemesh::detail {

/// Walks the boundary of the filled area and writes it down as loops.
///
/// Of a finished arrangement, the stretches with the interior on one side only are the boundary, run so that it lies on the
/// left. Where boundaries touch, the walk stays in the wedge of interior that it is in:
///
///      ::::\  /::::       in at 1, out at 2: the wedge on the left of 1 ends at 2
///      :::: \/ ::::       in at 3, out at 4
///      1 -> /\ -> 4'      so two outer loops that touch stay two, a hole that touches its outer loop joins it, and two
///      ::: /  \ :::       holes that touch become one.
///         2    3
class boundary_walk {
public:
    std::uint32_t holes = 0;
    std::uint32_t outers = 0;

    /// Replaces the loops. False when there is no memory, or when the links do not close; then the loops are as they were.
    [[nodiscard]] bool run(const arrangement& a, fill_rule rule, contours& loops, bool& broken) noexcept
    {
        broken = false;
        std::uint32_t kept = 0;
        for (std::uint32_t i = 0; i < a.count; ++i) kept += direction(a.stretches[i], rule) != 0;
        std::uint32_t loop_count = 0, walked = 0;
        // First round: count the loops, and mark by `start`, which is not needed any more, what was walked.
        for (std::uint32_t i = 0; i < a.count; ++i) {
            if (direction(a.stretches[i], rule) == 0 || a.stretches[i].start == no_number) continue;
            std::uint32_t k = i;
            do {
                if (k >= a.count || a.stretches[k].start == no_number || direction(a.stretches[k], rule) == 0) {
                    broken = true;
                    return false;
                }
                a.stretches[k].start = no_number;
                k = a.stretches[k].next;
                ++walked;
            } while (k != i);
            ++loop_count;
        }
        if (!loops.points.reserve(kept) || !loops.edges.reserve(kept) || !loops.starts.reserve(std::size_t{loop_count} + 1)) return false;
        loops.points.clear();
        loops.edges.clear();
        loops.starts.clear();
        loops.starts.push_back_unchecked(0);
        for (std::uint32_t i = 0; i < a.count; ++i) {
            if (direction(a.stretches[i], rule) == 0 || a.stretches[i].end == no_number) continue;
            std::uint64_t area = 0;  // doubled; below 2^60 in the end, may wrap on the way
            std::uint32_t k = i;
            do {
                stretch& s = a.stretches[k];
                const bool along = direction(s, rule) > 0;
                loops.points.push_back_unchecked(along ? s.from : s.to);
                loops.edges.push_back_unchecked(along ? s.source : contour_edge{s.source.curve, s.source.t1, s.source.t0});
                const auto term = static_cast<std::uint64_t>(std::int64_t{s.from.x} * s.to.y - std::int64_t{s.from.y} * s.to.x);
                area += along ? term : std::uint64_t{0} - term;
                s.end = no_number;
                k = s.next;
            } while (k != i);
            ++(static_cast<std::int64_t>(area) > 0 ? outers : holes);
            loops.starts.push_back_unchecked(static_cast<std::uint32_t>(loops.points.size()));
        }
        return true;
    }

private:
    /// 1: the interior is above, -1: below, 0: no boundary.
    [[nodiscard]] static int direction(const stretch& s, fill_rule rule) noexcept
    {
        if (s.turn == 0) return 0;
        return int{is_filled(rule, s.below + s.turn)} - int{is_filled(rule, s.below)};
    }
};

}  // namespace typemesh::detail
