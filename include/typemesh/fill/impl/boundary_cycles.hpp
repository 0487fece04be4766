// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/intersection.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Traces the boundary of the filled area and writes it as loops.
///
/// In a finished arrangement, the boundary consists of the segments with the interior on only one side, directed so
/// that the interior lies on the left. Where boundaries touch, a cycle stays in its sector of interior:
///
///      ::: \     / :::     A cycle that comes in along 1 goes out along 2, with the sector of interior on the left of
///      ::: 2\   /3 :::     both between them; 3 continues along 4. So two outer loops that touch stay two, a hole that
///      ::::: \ / :::::     touches its outer loop joins it, and two holes that touch become one.
///      :::::: x ::::::
///      ::::: / \ :::::
///      ::: 1/   \4 :::
///      ::: /     \ :::
class boundary_cycles {
public:
    std::uint32_t holes = 0;
    std::uint32_t outers = 0;

    /// Traverses all loops once and stores them in `scratch`. Passes all intersections between consecutive segments to
    /// the filter; all_accepted becomes false if it rejects one. Usable once per arrangement: traversed segments are
    /// marked.
    ///
    /// Fails with error::out_of_memory. Links that do not close would be error::crossing_contours; a finished
    /// arrangement cannot have them.
    [[nodiscard]] error trace(const arrangement& a, workspace::scope& scratch, intersection_filter_ref filter,
                              bool& all_accepted) noexcept
    {
        steps_ = scratch.take<std::uint32_t>(a.count);
        places_ = scratch.take<std::uint32_t>(a.count);
        starts_ = scratch.take<std::uint32_t>(a.count / 3 + 2);
        if (steps_ == nullptr || places_ == nullptr || starts_ == nullptr) return error::out_of_memory;
        segment* const all = a.segments;
        const std::uint32_t count = a.count;
        std::uint32_t size = 0;
        for (std::uint32_t i = 0; i < count; ++i) {
            if (all[i].interior == 0) continue;
            std::uint64_t area = 0;  // doubled; the total is below 2^60, partial sums may wrap
            const std::uint32_t begin = starts_[loop_count_++] = size;
            std::uint32_t k = i;
            do {
                segment& s = all[k];
                const bool along = s.interior > 0;
                if (s.interior == 0 || s.next >= count) return error::crossing_contours;
                s.interior = 0;  // traversed
                steps_[size] = 2 * k + !along;
                places_[size++] = along ? s.start : s.end;
                const auto term =
                    static_cast<std::uint64_t>(std::int64_t{s.from.x} * s.to.y - std::int64_t{s.from.y} * s.to.x);
                area += along ? term : std::uint64_t{0} - term;
                k = s.next;
                if (!filter.accepts_all() && !filter_change(a, s, all[k], along ? s.to : s.from, filter))
                    all_accepted = false;
            } while (k != i);
            if (size - begin < 3) return error::crossing_contours;
            ++(static_cast<std::int64_t>(area) > 0 ? outers : holes);
        }
        starts_[loop_count_] = size;
        return {};
    }

    /// Replaces the loops with the traced ones, and sorts their points: the sweep has sorted the arrangement's points.
    ///
    /// Fails with error::out_of_memory; the loops are then unchanged.
    [[nodiscard]] error write(const arrangement& a, contours& loops, workspace::scope& scratch) const noexcept
    {
        const std::uint32_t size = starts_[loop_count_];
        auto* const behind = scratch.take<std::uint32_t>(size);
        if (behind == nullptr || !loops.points.reserve(size) || !loops.edges.reserve(size) ||
            !loops.starts.reserve(loop_count_ + 1))
            return error::out_of_memory;
        std::uint32_t* const order = loops.new_order(size);
        if (order == nullptr && size != 0) return error::out_of_memory;
        loops.points.clear();
        loops.edges.clear();
        loops.starts.clear();
        grid_point* const points = loops.points.append(size);
        contour_edge* const edges = loops.edges.append(size);
        for (std::uint32_t i = 0; i < size; ++i) {
            const segment& s = a.segments[steps_[i] / 2];
            const std::uint32_t back = steps_[i] % 2;
            const grid_point ends[2] = {s.from, s.to};
            const float t[2] = {s.source.t0, s.source.t1};
            points[i] = ends[back];
            edges[i] = {s.source.curve, t[back], t[1 - back]};
        }
        for (std::uint32_t i = 0; i <= loop_count_; ++i) loops.starts.push_back_unchecked(starts_[i]);
        sort(a, order, behind);
        return {};
    }

private:
    /// Lists the points that write() writes in sweep order.
    ///
    ///     behind    an array with one entry per point: the next point in the same place
    void sort(const arrangement& a, std::uint32_t* order, std::uint32_t* behind) const noexcept
    {
        auto* const first = a.first;
        std::memset(first, 0xFF, a.point_count * sizeof *first);  // no_number
        for (std::uint32_t i = starts_[loop_count_]; i-- != 0;) {
            behind[i] = first[places_[i]];
            first[places_[i]] = i;
        }
        for (std::uint32_t place = 0; place < a.point_count; ++place)
            for (std::uint32_t i = first[place]; i != no_number; i = behind[i]) *order++ = i;
    }

    std::uint32_t* steps_ = nullptr;   // a segment's number times 2, plus 1 if it is traversed from right to left
    std::uint32_t* places_ = nullptr;  // the number of the point where each step begins
    std::uint32_t* starts_ = nullptr;  // the first step of each loop
    std::uint32_t loop_count_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
