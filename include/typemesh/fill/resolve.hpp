// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/boundary_cycles.hpp>
#include <typemesh/fill/impl/resolving_sweep.hpp>
#include <typemesh/fill/impl/snap_rounding.hpp>
#include <typemesh/fill/intersection.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The work that resolve() did, for diagnosis.
struct resolve_effort {
    std::uint32_t sweeps = 0;  ///< the number of sweeps over the arrangement; nearly always one
    std::uint32_t rounds = 0;  ///< the number of rounds of snap rounding: none or one
    std::uint32_t pieces = 0;  ///< the number of pieces into which the edges were divided: n + k
};

/// The options of resolve().
struct resolve_options {
    std::uint32_t max_pieces = default_max_pieces;  ///< the greatest number of pieces: see resolve()
    resolve_effort* effort = nullptr;               ///< receives the work done, unless null
};

namespace detail {

/// One resolve(), step by step. All intermediate results lie in scratch memory that this object gives back when it is
/// destroyed.
class resolving {
public:
    resolving(contours& loops, fill_rule rule, workspace& space, const resolve_options& how) noexcept
        : loops_{loops}, rule_{rule}, space_{space}, how_{how}, scratch_{space}
    {
    }

    /// Divides the contours' edges where they cross: by a sweep if a sweep suffices, otherwise by snap rounding.
    [[nodiscard]] error cut() noexcept
    {
        bool is_cut = false;
        if (error e = cut_by_sweep(is_cut)) return e;
        if (!is_cut)
            if (error e = cut_by_snap_rounding()) return e;
        if (a_.count > how_.max_pieces) return error{error::too_many_pieces, how_.max_pieces};
        return {};
    }

    /// Traces the boundary of the filled area, and passes all intersections on it to the filter.
    [[nodiscard]] error trace(intersection_filter_ref filter, bool& all_accepted) noexcept
    {
        all_accepted = true;
        if (a_.is_touching && !filter.accepts_all()) {
            if (!filter_touches(a_, space_, filter, all_accepted)) return error::out_of_memory;
            filter = {};
        }
        return boundary_.trace(a_, scratch_, filter, all_accepted);
    }

    /// Replaces the contours with the boundary that trace() found.
    [[nodiscard]] result<region> write() noexcept
    {
        if (error e = boundary_.write(a_, loops_, scratch_)) return e;
        return region::proven(loops_, boundary_.holes, boundary_.outers, a_.is_touching);
    }

    /// The arrangement that cut() has made.
    [[nodiscard]] const arrangement& pieces() const noexcept { return a_; }

private:
    /// Runs one sweep or two; `is_cut` is false if they do not suffice.
    [[nodiscard]] error cut_by_sweep(bool& is_cut) noexcept
    {
        constexpr std::size_t bytes_per_piece = 144;  // the bytes of the arrangement (84) and of its sweep
        constexpr int max_sweeps = 2;
        const std::size_t n = loops_.points.size(), most = n + n / 8 + 48;
        if (!scratch_.reserve(bytes_per_piece * most) || !sort_points(loops_, space_) ||
            !a_.reserve(scratch_, static_cast<std::uint32_t>(most)) || !a_.from_contours(loops_, space_))
            return error::out_of_memory;
        for (int i = 0; i < max_sweeps && !is_cut; ++i) {
            resolving_sweep sweep{a_, rule_};
            if (!sweep.run(space_)) return error::out_of_memory;
            report(0);
            is_cut = !sweep.again && !sweep.partial;
            if (sweep.full || sweep.rough || sweep.partial) break;
        }
        return {};
    }

    /// Rounds, then sweeps with increasing capacity.
    [[nodiscard]] error cut_by_snap_rounding() noexcept
    {
        scratch_.keep();
        a_ = {};
        snap_rounding rounding{loops_, how_.max_pieces};
        if (error e = rounding.run(rule_, space_, scratch_, a_)) return e;
        for (;;) {
            resolving_sweep sweep{a_, rule_};
            if (!sweep.run(space_)) return error::out_of_memory;
            report(1);
            if (!sweep.again) return {};
            if (!sweep.full) return error::crossing_contours;
            // The capacity grows by half until it is twice the maximum need: no valid result takes more.
            if (a_.capacity / 2 > rounding.max_pieces() + 64)
                return error{error::too_many_pieces, rounding.max_pieces()};
            a_.max_active = no_number;
            if (!a_.reserve(scratch_, a_.capacity + a_.capacity / 2) || !a_.put_in_order(space_))
                return error::out_of_memory;
        }
    }

    void report(std::uint32_t rounds) noexcept
    {
        if (how_.effort != nullptr) *how_.effort = {how_.effort->sweeps + 1, rounds, a_.count};
    }

    contours& loops_;
    fill_rule rule_;
    workspace& space_;
    const resolve_options& how_;
    workspace::scope scratch_;
    arrangement a_;
    boundary_cycles boundary_;
};

}  // namespace detail

/// The region that any closed polylines fill under `rule`, however they cross, touch, overlap or double back.
///
///      .------.                .------.            Input may have crossings, corners on edges, shared edges, spikes,
///      |   .--|---.            |      '---.        repeated contours, edges of length zero, contours of one point, any
///      |   |  |   |     ->     |          |        nesting and any winding number. Where boundaries touch in a point,
///      '---|--'   |            '---.      |        each cycle stays in its own sector of interior: a hole joins the
///          '------'                '------'        outer loop that it touches, touching holes join each other, and
///                                                  touching outer loops stay separate.
///
/// Replaces `loops`; the result may be an empty region. Edges keep their curve and t; if several edges coincide, the
/// curve with the lowest number is kept. t0 > t1 if an edge runs against its curve. Points of the contours that lie on
/// the boundary stay; points are added only where edges cross or touch. The region's points are sorted: see
/// region::order().
///
/// Crossings are rounded to the grid. The boundary stays within about 1.5 cells of the contours' edges. Every place
/// farther than this from all edges is filled as the rule says. If all crossings are grid points, the places nearer
/// than this are filled correctly as well.
///
/// The result is a set of cyclic sequences of points, which depends only on the set of edges. Neither the starts nor
/// the order of contours matter, nor whether all contours are reversed; under even_odd, no contour's direction matters.
/// The result is the snap rounding of the edges: a piece of an edge that must be bent is routed through the centre of
/// every cell that it passes through and that contains a point or a crossing. One fast sweep suffices unless a point
/// lies within about a cell of an edge that does not end in it, which is rare. Crossings are rounded half up in x and
/// y, so a mirrored or rotated figure may be rounded in another way.
///
/// Fails  error::too_many_pieces: more than max_pieces points, crossings or pieces. It is returned after at most
///        O(max_pieces log n) steps. A limit above 2^30 counts as 2^30. error::too_large: more than 2^29 points.
///        error::out_of_memory. `loops` is then unchanged. (error::crossing_contours would be a bug in resolve().)
/// Cost   O((n + k) log n) for n points and k crossings (k may be n^2 / 2): 50 to 70 ns per piece for letters. Snap
///        rounding costs about five times as much, including the first sweep, plus about sqrt(n + k) steps per edge to
///        find the hot pixels on its way; the edge gets a point in each of these pixels.
/// Memory at most 200 bytes per piece from `space`, in a block of at least 16 kB. When a workspace meets more pieces
///        than ever before, its memory is split into several blocks. These may take 32 kB instead of 16 kB and, with
///        snap rounding, 210 bytes per piece instead of 200. The order of the points takes 4 bytes per point in
///        `loops`.
/// Exact  in 64 bits; from equal grid points every compiler makes the same region (except t, which is floating point)
///
/// `filter` is called for intersections on the boundary of the filled area: two contour edges cross, or one ends on the
/// other (see intersection.hpp). If it rejects one, the result is an empty region, and `loops` is unchanged. The calls
/// cost about 15 instructions per point, plus the filter's own.
[[nodiscard]] inline result<region> resolve(contours& loops, fill_rule rule, workspace& space,
                                            intersection_filter_ref filter, const resolve_options& how = {}) noexcept
{
    const std::size_t n = loops.points.size();
    if (n > std::size_t{1} << 29) return error::too_large;
    if (n > how.max_pieces) return error{error::too_many_pieces, how.max_pieces};
    detail::resolving work{loops, rule, space, how};
    if (error e = work.cut()) return e;
    bool all_accepted = true;
    if (error e = work.trace(filter, all_accepted)) return e;
    if (!all_accepted) return region{};
    return work.write();
}

[[nodiscard]] inline result<region> resolve(contours& loops, fill_rule rule, workspace& space,
                                            const resolve_options& how = {}) noexcept
{
    return resolve(loops, rule, space, intersection_filter_ref{}, how);
}

}  // namespace typemesh::inline TYPEMESH_ABI
