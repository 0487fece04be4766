// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/crossing_sweep.hpp>
#include <typemesh/fill/impl/growing.hpp>
#include <typemesh/fill/impl/hot_pixels.hpp>
#include <typemesh/fill/impl/net_edges.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>

#include <cstddef>
#include <cstdint>
#include <new>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Cuts the edges of contours where they cross, all at once: snap rounding wherever anything must be rounded.
///
///      .   .   .   .   .      The pixel of a grid point is hot if a contour's point lies in it, or if two edges cross
///        +---+   _.-''.       in it. An edge that passes through a hot point itself is cut there. A piece of an edge
///      . | x-+-''  .   .      between two such cuts, if it must be bent, is routed through the centre of every hot
///     .-'+---+ `-.            pixel that it passes through. No piece moves by more than half a cell in x and y, and no
///      .   .   .   `.  .      two of them cross afterwards: the second paper proves this.
///
/// A piece must be bent if it crosses others off the grid points, or if it passes through a hot pixel through whose
/// centre another piece is routed that did not pass through this centre by itself; and so on. All others stay as they
/// are. A bent piece may end up beside points whose pixels it does not pass through, or on them. The sweep that follows
/// cuts it in these, bending nothing.
///
/// All this depends only on the set of edges: not on the starts or the order of contours.
///
/// Cost   O((n + k) log n) for n points and k crossings, and for each edge a search among the hot pixels: about the
///        square root of their number. An edge that passes through many pixels of others' crossings is cut in each.
/// Exact  in 64 bits: see crossing_sweep and hot_pixels
/// From   Hobby, Practical segment intersection with finite precision output (1999); Guibas & Marimont, Rounding
///        arrangements dynamically (1998)
class snap_rounding {
public:
    static constexpr std::uint32_t max_ever = 1u << 30;  ///< pieces that 32-bit numbers can count, with a margin

    /// `max_pieces` is clamped to max_ever.
    explicit snap_rounding(const contours& loops, std::uint32_t max_pieces) noexcept
        : loops_{&loops}, most_{max_pieces < max_ever ? max_pieces : max_ever}
    {
    }

    [[nodiscard]] std::uint32_t max_pieces() const noexcept { return most_; }

    /// Finds all cuts, and makes the pieces an arrangement in `scratch`, which holds nothing else.
    ///
    /// Fails  error::too_many_pieces: more than `max_pieces` crossings or cuts, as soon as this is known
    ///        error::out_of_memory
    [[nodiscard]] error run(fill_rule rule, workspace& space, workspace::scope& scratch, arrangement& a) noexcept
    {
        const std::size_t n = loops_->points.size();
        edges_ = {scratch.take<net_edge>(n), n};
        cut_ends_ = {scratch.take<std::uint32_t>(n), n};
        if (edges_.data() == nullptr || cut_ends_.data() == nullptr) return error::out_of_memory;
        std::uint32_t count = 0;
        if (!make_net_edges(*loops_, rule, space, edges_.data(), count)) return error::out_of_memory;
        edges_ = edges_.first(count);
        cut_ends_ = cut_ends_.first(count);
        if (error e = find_points(scratch, space)) return e;
        if (error e = find_cuts(scratch, space)) return e;
        return cut(scratch, a);
    }

private:
    /// A hot point as one number, in sweep order; its lowest bit says whether an edge must be bent to pass through it.
    [[nodiscard]] static packed_sweep_key hot(grid_point p, bool bends) noexcept
    {
        return {static_cast<std::uint64_t>(std::int64_t{p.x} + beyond) << 32 |
                static_cast<std::uint64_t>(std::int64_t{p.y} + beyond) << 1 | std::uint64_t{bends}};
    }
    [[nodiscard]] static grid_point point_of(packed_sweep_key key) noexcept
    {
        return {static_cast<std::int32_t>(static_cast<std::int64_t>(key.word >> 32) - beyond),
                static_cast<std::int32_t>(static_cast<std::int64_t>(key.word >> 1 & 0x7FFF'FFFFu) - beyond)};
    }

    /// Sorts hot points and removes duplicates. False if out of memory.
    [[nodiscard]] static bool put_in_order(growing<packed_sweep_key>& all, workspace& space) noexcept
    {
        if (all.count == 0) return true;
        workspace::scope sorting{space};
        auto* const spare = sorting.take<packed_sweep_key>(all.count);
        if (spare == nullptr) return false;
        const packed_sweep_key* const sorted = sort_sweep_keys(all.values, spare, all.count, 0, 62);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < all.count; ++i) {
            if (kept == 0 || all.values[kept - 1].word >> 1 != sorted[i].word >> 1)
                all.values[kept++] = sorted[i];
            else
                all.values[kept - 1].word |= sorted[i].word;
        }
        all.count = kept;
        return true;
    }

    /// Finds the hot points: all points of the contours, and the crossings of edges.
    [[nodiscard]] error find_points(workspace::scope& scratch, workspace& space) noexcept
    {
        growing<packed_sweep_key> all{scratch};
        if (!all.reserve(loops_->points.size() + edges_.size() / 4 + 64)) return error::out_of_memory;
        for (const grid_point p : loops_->points) all.values[all.count++] = hot(p, false);
        std::uint32_t crossings = 0;
        const auto met = [&](grid_point x, bool is_exact) noexcept {
            const packed_sweep_key key = hot(x, !is_exact);
            if (++crossings > most_) return false;
            if (all.values[all.count - 1].word == key.word) return true;
            if (all.count == all.room) {  // many may lie in one pixel
                if (!put_in_order(all, space)) return false;
                if (all.count > all.room / 2 && !all.reserve(2 * all.room)) return false;
            }
            all.values[all.count++] = key;
            return true;
        };
        if (!crossing_sweep::run(edges_, scratch, space, met))
            return crossings > most_ ? error{error::too_many_pieces, most_} : error{error::out_of_memory};
        if (!put_in_order(all, space)) return error::out_of_memory;
        hot_ = {all.values, all.count};
        scratch.keep(edges_, cut_ends_, hot_);
        return {};
    }

    /// Finds the hot points in which each edge is cut, one edge after the other.
    [[nodiscard]] error find_cuts(workspace::scope& scratch, workspace& space) noexcept
    {
        const std::size_t m = hot_.size();
        auto* const bends = scratch.take<bool>(m);
        auto* const group = scratch.take<std::uint32_t>(m);
        hot_pixels cells;
        if (bends == nullptr || group == nullptr) return error::out_of_memory;
        // Each point is constructed in the place of its key, which is read first.
        static_assert(sizeof(grid_point) == sizeof(packed_sweep_key) &&
                      alignof(grid_point) <= alignof(packed_sweep_key));
        points_ = {};
        for (std::size_t i = 0; i < m; ++i) {
            const packed_sweep_key key = hot_[i];
            grid_point* const made = ::new (static_cast<void*>(hot_.data() + i)) grid_point{point_of(key)};
            if (i == 0) points_ = {made, m};
            bends[i] = key.word & 1;
            group[i] = static_cast<std::uint32_t>(i);
        }
        if (!cells.open(points_, scratch, space)) return error::out_of_memory;

        growing<std::uint32_t> cuts{scratch};
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const net_edge& e = edges_[i];
            std::uint32_t last = no_number;  // on the same piece
            const auto step = [&](hot_pixels::hit h) noexcept {
                if (edges_.size() + cuts.count >= most_ || !cuts.add(h.number | (h.is_exact ? exact : 0))) return false;
                if (!h.is_exact && last != no_number) join(group, bends, last, h.number);
                last = h.is_exact ? no_number : h.number;
                return true;
            };
            if (!cells.along(e.from, e.to, step))
                return edges_.size() + cuts.count >= most_ ? error{error::too_many_pieces, most_}
                                                           : error{error::out_of_memory};
            cut_ends_[i] = static_cast<std::uint32_t>(cuts.count);
        }
        std::uint32_t kept = 0, begin = 0;
        for (std::uint32_t& end : cut_ends_) {
            for (; begin < end; ++begin) {
                const std::uint32_t c = cuts.values[begin];
                if ((c & exact) != 0 || bends[root(group, c)]) cuts.values[kept++] = c & ~exact;
            }
            end = kept;
        }
        cuts_ = {cuts.values, kept};
        scratch.keep(edges_, cut_ends_, points_, cuts_);
        return {};
    }

    /// The group of hot points: if edges are bent to one of them, they are bent to all. Union-find.
    [[nodiscard]] static std::uint32_t root(std::uint32_t* group, std::uint32_t i) noexcept
    {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    }
    static void join(std::uint32_t* group, bool* bends, std::uint32_t i, std::uint32_t k) noexcept
    {
        i = root(group, i);
        k = root(group, k);
        const std::uint32_t low = i < k ? i : k;
        bends[low] = bends[i] || bends[k];
        group[i] = group[k] = low;
    }

    [[nodiscard]] error cut(workspace::scope& scratch, arrangement& a) noexcept
    {
        const std::size_t count = edges_.size() + cuts_.size(), more = count / 32 + 32;
        const std::size_t most = (count > points_.size() ? count : points_.size()) + more;
        array_view<segment> pieces{scratch.take<segment>(most), most};
        array_view<grid_point> places{scratch.take<grid_point>(most), most};
        if (pieces.data() == nullptr || places.data() == nullptr) return error::out_of_memory;
        std::uint32_t made = 0, next_cut = 0, point_count = 0;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const net_edge& e = edges_[i];
            const contour_edge source = loops_->edges[e.origin];
            const bool along = loops_->points[e.origin] == e.from;
            segment rest{e.from, e.to,   number_of(e.from), number_of(e.to), e.winding_delta,
                         0,      source, e.origin,          e.target,        no_number,
                         0,      0};
            if (!along) rest.source = {source.curve, source.t1, source.t0};
            for (; next_cut < cut_ends_[i]; ++next_cut) {
                segment& s = pieces[made++];
                s = rest;
                const grid_point p = points_[cuts_[next_cut]];
                s.source.t1 = rest.source.t0 = rest.t_at(p);
                s.end = rest.start = cuts_[next_cut];
                s.to = rest.from = p;
                if (s.end < s.start) s.flip();  // vertical, in one column of pixels
            }
            if (rest.end < rest.start) rest.flip();
            pieces[made++] = rest;
        }
        for (const grid_point p : points_) places[point_count++] = p;
        scratch.keep(pieces, places);
        a.loops = loops_;
        // Three pieces of an edge may be active at once: vertical ones along which it falls, and those before and after
        // them.
        a.max_active = 3 * static_cast<std::uint32_t>(edges_.size());
        return a.adopt(scratch, pieces, made, places, point_count) ? error{} : error{error::out_of_memory};
    }

    [[nodiscard]] std::uint32_t number_of(grid_point p) const noexcept
    {
        std::size_t low = 0, high = points_.size();
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (lexicographic_less(p, points_[middle]) ? high : low) = middle;
        }
        return static_cast<std::uint32_t>(low);
    }

    static constexpr std::int64_t beyond = std::int64_t{1} << 29;
    static constexpr std::uint32_t exact = 0x8000'0000u;

    const contours* loops_;
    std::uint32_t most_;
    array_view<net_edge> edges_;
    array_view<std::uint32_t> cut_ends_;  // for each edge: the end of its cuts
    array_view<packed_sweep_key> hot_;
    array_view<grid_point> points_;   // the same points, in the same memory
    array_view<std::uint32_t> cuts_;  // the numbers of the points
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
