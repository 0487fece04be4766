// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/boundary_walk.hpp>
#include <typemesh/fill/meeting.hpp>
#include <typemesh/fill/resolving_sweep.hpp>
#include <typemesh/fill/snap_rounding.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace typemesh {

/// What resolve() did, for those who want to know.
struct resolve_effort {
    std::uint32_t walks = 0;   ///< sweeps over the arrangement; nearly always one
    std::uint32_t rounds = 0;  ///< of snap rounding
    std::uint32_t pieces = 0;  ///< that the edges were cut into: n + k
};

/// As resolve() below, for those who know more and want more.
///
///     order   the order of the points, as sweep_order() makes it; empty: not known
///     then    error then(r) or error then(r, order): what to do with the region r at once, while the order of its
///             points is known, too. Its error is the answer, and `loops` is the region's then. Not asked when there is
///             no region.
template <meeting_judge Judge, class Then>
[[nodiscard]] result<region> resolve_then(contours& loops, std::span<const std::uint32_t> order, fill_rule rule,
                                          workspace& space, Judge& judge, Then&& then,
                                          resolve_effort* effort = nullptr) noexcept
{
    constexpr std::uint32_t most_walks = 4, most_rounds = 3;  // in a round
    const std::size_t n = loops.points.size();
    if (n > std::size_t{1} << 29) return error::too_large;
    workspace::scope scratch{space};
    detail::arrangement a;
    if (!a.reserve(scratch, static_cast<std::uint32_t>(n + n / 2 + 64)) || !a.take_apart(loops, space, order))
        return error::out_of_memory;
    std::uint32_t rounds = 0;
    for (std::uint32_t walks = 0;;) {
        detail::resolving_sweep sweep{a, rule};
        if (!sweep.run(space)) return error::out_of_memory;
        if (effort != nullptr) *effort = {effort->walks + 1, rounds, a.count};
        if (!sweep.again) {
            constexpr bool judging = !std::is_same_v<Judge, every_meeting_stands>;
            const bool touching = judging && sweep.touching, changing = judging && !sweep.touching;
            bool all_stand = true;
            if (touching && !detail::judge_touches(a, space, judge, all_stand)) return error::out_of_memory;
            detail::boundary_walk boundary;
            const auto watch = [&](const auto& s, const auto& t, grid_point at) noexcept {
                if (changing && !detail::judge_change(a, s, t, at, judge)) all_stand = false;
            };
            if (const error e = boundary.trace(a, scratch, watch)) return e;
            if (!all_stand) return region{};
            if (const error e = boundary.write(a, loops)) return e;
            const region made = region::proven(loops, boundary.holes, boundary.outers, sweep.touching);
            error e;
            if constexpr (std::is_invocable_v<Then, const region&>) {
                e = then(made);
            } else {
                const std::uint32_t* const sorted = boundary.order(a, scratch);
                if (sorted == nullptr) return error::out_of_memory;
                e = then(made, std::span{sorted, made.points().size()});
            }
            if (e) return e;
            return made;
        }
        if (sweep.full && !sweep.astray && rounds == 0 && a.capacity < 12 * n + 256) {
            walks = 0;
            if (!a.reserve(scratch, 2 * a.capacity) || !a.take_apart(loops, space, order)) return error::out_of_memory;
        } else if (rounds > most_rounds) {  // what is left to do bends nothing: it can only lack room
            if (!sweep.full) return error::crossing_contours;
            if (a.capacity > std::uint32_t{1} << 29) return error::too_large;
            if (!a.reserve(scratch, 2 * a.capacity) || !a.put_in_order(space)) return error::out_of_memory;
        } else if (sweep.full || sweep.astray || ++walks == most_walks) {
            walks = 0;
            const std::size_t found = rounds == 0 ? 0 : a.point_count;  // at first what was bent is of no use
            auto* const hot = scratch.take<grid_point>(found);
            if (hot == nullptr) return error::out_of_memory;
            for (std::size_t i = 0; i < found; ++i) hot[i] = a.points[i];
            if (!a.take_apart(loops, space, order)) return error::out_of_memory;
            if (!(++rounds > most_rounds ? detail::snap_rounding::run_all(a, scratch, space)
                                         : detail::snap_rounding::run(a, {hot, found}, scratch, space)))
                return error::out_of_memory;
        }
    }
}

/// The region that any closed polylines fill under `rule`, however they cross, touch, overlap or run back on
/// themselves.
///
///      .------.                .------.            Crossings, corners on edges, shared edges, doubled contours,
///      |   .--|---.            |      '---.        spikes, edges without length, contours of one point, any nesting,
///      |   |  |   |     ->     |          |        any winding number. In every point where boundaries touch, a walk
///      '---|--'   |            '---.      |        stays in its own wedge of interior: a hole that touches its outer
///          '------'                '------'        loop joins it, holes that touch become one, outer loops stay apart.
///
/// Replaces `loops`; nothing may be left: a region without points. Edges keep the curve and t that they come from
/// (where several lie upon each other, those of the curve with the lowest number), t0 > t1 where they are run against
/// it. Points of the contours that lie on the boundary stay; points are added where edges are cut, and nowhere else.
///
/// Crossings are rounded to the grid. The boundary stays within about 1.5 cells of the contours' edges, and farther
/// from all edges every place is filled as the rule says; where all crossings are grid points, everywhere.
///
/// Fails  error::too_large: more than 2^29 points, or 2^30 pieces; error::out_of_memory. Then `loops` is as it was.
///        (error::crossing_contours stands for a mistake in here: no input is known that leads to it.)
/// Cost   O((n + k) log n) for n points and k cuts, about 270 bytes a point from `space`. Where edges run together for
///        long at a distance below a cell (snap rounding) a cut is a hot cell that an edge comes through, and to find
///        those takes about sqrt(n + k) steps an edge. Should three rounds of that not do, for which no input is known,
///        all pairs of edges whose boxes meet are tested: O(n^2) at worst.
/// Exact  in 64 bits; from equal grid points every compiler makes the same region (t apart, which is floating point)
///
/// `judge` is told where edges of the contours cross, or one ends on the other, on the boundary of what they fill (see
/// meeting.hpp). Where it does not let one stand, the answer is a region without points, and `loops` is as it was. About
/// 15 instructions a point, and the judge's own.
template <meeting_judge Judge>
[[nodiscard]] result<region> resolve(contours& loops, fill_rule rule, workspace& space, Judge& judge,
                                     resolve_effort* effort = nullptr) noexcept
{
    return resolve_then(loops, {}, rule, space, judge, [](const region&) noexcept { return error{}; }, effort);
}

[[nodiscard]] inline result<region> resolve(contours& loops, fill_rule rule, workspace& space,
                                            resolve_effort* effort = nullptr) noexcept
{
    every_meeting_stands nobody;
    return resolve(loops, rule, space, nobody, effort);
}

}  // namespace typemesh
