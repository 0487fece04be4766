// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/most_pieces.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/arrangement.hpp>
#include <typemesh/fill/boundary_cycles.hpp>
#include <typemesh/fill/intersection.hpp>
#include <typemesh/fill/resolving_sweep.hpp>
#include <typemesh/fill/snap_rounding.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

/// What resolve() did, for those who want to know.
struct resolve_effort {
    std::uint32_t walks = 0;   ///< sweeps over the arrangement; nearly always one
    std::uint32_t rounds = 0;  ///< of snap rounding: none or one
    std::uint32_t pieces = 0;  ///< that the edges were cut into: n + k
};

/// What resolve() is told beside the contours.
struct resolve_options {
    std::uint32_t most_pieces = default_most_pieces;  ///< see resolve()
    std::span<const std::uint32_t> order = {};  ///< of the points, as sweep_order() makes it; empty: not known
    resolve_effort* effort = nullptr;           ///< where to tell what was done
};

namespace detail {

enum class quick_walk { no_memory, done, not_done };

/// The contours' edges cut by one walk, or a second; not_done when these do not do.
[[nodiscard]] inline quick_walk walk_quickly(const contours& loops, fill_rule rule, workspace& space,
                                             workspace::scope& scratch, const resolve_options& how,
                                             arrangement& a) noexcept
{
    const std::size_t n = loops.points.size();
    constexpr std::size_t bytes_a_piece = 144;  // of the arrangement (84) and its walk
    const std::size_t most = n + n / 8 + 48;
    if (!scratch.reserve(bytes_a_piece * most) || !a.reserve(scratch, static_cast<std::uint32_t>(most)) ||
        !a.from_contours(loops, space, how.order))
        return quick_walk::no_memory;
    for (int walk = 0; walk < 2; ++walk) {
        resolving_sweep sweep{a, rule};
        if (!sweep.run(space)) return quick_walk::no_memory;
        if (how.effort != nullptr) *how.effort = {how.effort->walks + 1, how.effort->rounds, a.count};
        if (!sweep.again && !sweep.partial) return quick_walk::done;
        if (sweep.full || sweep.rough || sweep.partial) break;
    }
    return quick_walk::not_done;
}

/// The contours' edges cut by snap rounding, and walked over.
[[nodiscard]] inline error walk_rounded(const contours& loops, fill_rule rule, workspace& space,
                                        workspace::scope& scratch, const resolve_options& how,
                                        arrangement& a) noexcept
{
    snap_rounding rounding{loops, how.most_pieces};
    if (error e = rounding.run(how.order, rule, space, scratch, a)) return e;
    for (;;) {
        resolving_sweep sweep{a, rule};
        if (!sweep.run(space)) return error::out_of_memory;
        if (how.effort != nullptr) *how.effort = {how.effort->walks + 1, 1, a.count};
        if (!sweep.again) return {};
        if (!sweep.full) return error::crossing_contours;
        // The room grows by half until it is twice what may be needed: nothing that may stand takes more.
        if (a.capacity / 2 > rounding.most_pieces() + 64)
            return error{error::too_many_pieces, rounding.most_pieces()};
        a.most_active = no_number;
        if (!a.reserve(scratch, a.capacity + a.capacity / 2) || !a.put_in_order(space)) return error::out_of_memory;
    }
}

}  // namespace detail

/// As resolve() below, for those who know more and want more.
///
///     then    error then(r) or error then(r, order): what to do with the region r at once, while the order of its
///             points is known, too. Its error is the answer, and `loops` is the region's then. Not asked when there is
///             no region.
template <intersection_filter Filter, class Then>
[[nodiscard]] result<region> resolve_then(contours& loops, fill_rule rule, workspace& space, Filter& filter, Then&& then,
                                          const resolve_options& how = {}) noexcept
{
    const std::size_t n = loops.points.size();
    if (n > std::size_t{1} << 29) return error::too_large;
    if (n > how.most_pieces) return error{error::too_many_pieces, how.most_pieces};
    workspace::scope scratch{space};
    detail::arrangement a;
    const auto walked = detail::walk_quickly(loops, rule, space, scratch, how, a);
    if (walked == detail::quick_walk::no_memory) return error::out_of_memory;
    if (walked == detail::quick_walk::not_done) {
        scratch.keep();
        a = {};
        if (error e = detail::walk_rounded(loops, rule, space, scratch, how, a)) return e;
    }
    if (a.count > how.most_pieces) return error{error::too_many_pieces, how.most_pieces};
    constexpr bool judging = !std::is_same_v<Filter, every_intersection_stands>;
    const bool touching = judging && a.is_touching, changing = judging && !a.is_touching;
    bool all_stand = true;
    if (touching && !detail::filter_touches(a, space, filter, all_stand)) return error::out_of_memory;
    detail::boundary_cycles boundary;
    const auto watch = [&](const auto& s, const auto& t, grid_point at) noexcept {
        if (changing && !detail::filter_change(a, s, t, at, filter)) all_stand = false;
    };
    if (const error e = boundary.trace(a, scratch, watch)) return e;
    if (!all_stand) return region{};
    if (const error e = boundary.write(a, loops)) return e;
    const region made = region::proven(loops, boundary.holes, boundary.outers, a.is_touching);
    error e;
    if constexpr (std::is_invocable_v<Then, const region&>) {
        scratch.keep();
        e = then(made);
    } else {
        std::span<std::uint32_t> order{boundary.order(a, scratch), made.points().size()};
        if (order.data() == nullptr) return error::out_of_memory;
        scratch.keep(order);
        e = then(made, std::span<const std::uint32_t>{order});
    }
    if (e) return e;
    return made;
}

/// The region that any closed polylines fill under `rule`, however they cross, touch, overlap or run back on
/// themselves.
///
///      .------.                .------.            Crossings, corners on edges, shared edges, doubled contours,
///      |   .--|---.            |      '---.        spikes, edges without length, contours of one point, any nesting,
///      |   |  |   |     ->     |          |        any winding number. In every point where boundaries touch, a walk
///      '---|--'   |            '---.      |        stays in its own sector of interior: a hole that touches its outer
///          '------'                '------'        loop joins it, holes that touch become one, outer loops stay apart.
///
/// Replaces `loops`; nothing may be left: a region without points. Edges keep the curve and t that they come from
/// (where several lie upon each other, those of the curve with the lowest number), t0 > t1 where they are run against
/// it. Points of the contours that lie on the boundary stay; points are added where edges are cut, and nowhere else.
///
/// Crossings are rounded to the grid. The boundary stays within about 1.5 cells of the contours' edges, and farther
/// from all edges every place is filled as the rule says; where all crossings are grid points, everywhere.
///
/// What comes out depends on the set of edges alone, as loops, each a cyclic sequence of points: not on where contours
/// begin, on their order, or on their direction when all are reversed; under even_odd, of each contour's for itself. It
/// is the snap rounding of the edges (see snap_rounding.hpp); one quick walk makes it where no point lies within about
/// a cell of an edge that is not its own, which is nearly always. Crossings are rounded half up in x and y, so a mirrored
/// or turned shape may be rounded otherwise.
///
/// Fails  error::too_many_pieces: more than most_pieces points, crossings or pieces; told as soon as it is known, after
///        O(most_pieces log n) steps; more than 2^30 count as 2^30. error::too_large: more than 2^29 points.
///        error::out_of_memory. Then `loops` is as it was. (error::crossing_contours stands for a mistake in here.)
/// Cost   O((n + k) log n) for n points and k crossings, which may be n^2 / 2: 50 to 70 ns a piece for letters. Where snap
///        rounding is needed, about five times as much, the first walk included, and about sqrt(n + k) steps an edge to
///        find the hot pixels that it comes through; an edge is cut in each of them.
/// Memory at most 200 bytes a piece from `space`, and a block of 16 kB, which is never smaller. Before the workspace has
///        seen as many pieces they lie in several blocks: up to 210 bytes a piece where snap rounding is needed, and
///        32 kB.
/// Exact  in 64 bits; from equal grid points every compiler makes the same region (t apart, which is floating point)
///
/// `filter` is told where edges of the contours cross, or one ends on the other, on the boundary of what they fill (see
/// intersection.hpp). Where it does not let one stand, the answer is a region without points, and `loops` is as it was. About
/// 15 instructions a point, and the filter's own.
template <intersection_filter Filter>
[[nodiscard]] result<region> resolve(contours& loops, fill_rule rule, workspace& space, Filter& filter,
                                     const resolve_options& how = {}) noexcept
{
    return resolve_then(loops, rule, space, filter, [](const region&) noexcept { return error{}; }, how);
}

[[nodiscard]] inline result<region> resolve(contours& loops, fill_rule rule, workspace& space,
                                            const resolve_options& how = {}) noexcept
{
    every_intersection_stands nobody;
    return resolve(loops, rule, space, nobody, how);
}

}  // namespace typemesh::inline TYPEMESH_ABI
