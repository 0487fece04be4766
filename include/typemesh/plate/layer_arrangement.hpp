// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/impl/arrangement.hpp>
#include <typemesh/fill/impl/boundary_cycles.hpp>
#include <typemesh/fill/impl/sector_links.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/plate/cell_set.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The exact arrangement of several layers: all boundaries together cut the plane into cells, and each cell knows which
/// layers cover it.
///
///      +-------plate------+        begin(grid)                  removes all layers
///      |   .----text---.  |        add(region, layer)           adds a region to a layer
///      |   |  both  .--|--|--.     cut(space)                   divides all edges where they meet
///      |   '--------|--'  |  |     trace(cells, space, loops)   the region that some cells fill
///      +------------|-----+  |
///                   '--------'     All regions that are traced share points and edges exactly. So walls and caps that
///                                  stand on them fit together without a gap, and their areas add up in integers.
///
/// The regions of one layer must not overlap each other. They may touch, and they may overlap other layers in any way.
/// Memory is kept for the next arrangement.
///
/// How it works: resolve()'s sweep runs once over all layers. The loops of layer k are given to it 2^k times, so the
/// winding number of a cell is its label. Snap rounding moves boundaries, but it never lets them pass each other, so it
/// only shrinks cells to nothing and no label changes.
class layer_arrangement {
public:
    explicit layer_arrangement(memory source = heap()) noexcept
        : loops_{source}, segments_{source}, points_{source}, star_{source}, star_starts_{source}
    {
    }

    /// Removes all layers.
    void begin(const grid& onto) noexcept
    {
        loops_.clear();
        loops_.grid = onto;
        sources_ = 0;
        clear_pieces();
    }

    /// Adds a region, whose points lie on the grid given to begin(). Its edges are numbered on from source_count(); a
    /// traced edge names its source as its curve. Where boundaries coincide, the lowest number is named, so add first
    /// what should be named.
    ///
    ///     starts   the number of each loop's first point, and at the end the number of points; empty without points
    ///     layer    below max_layers. Points are processed 2^layer times: the largest region should have layer 0
    ///
    /// Fails  error::too_large, error::out_of_memory; the layers are then unchanged
    [[nodiscard]] result<void> add(array_view<const grid_point> points, array_view<const std::uint32_t> starts,
                                   std::uint32_t layer) noexcept
    {
        TYPEMESH_ASSERT(layer < max_layers, "an arrangement has at most five layers");
        clear_pieces();
        const std::size_t copies = std::size_t{1} << layer, count = points.size();
        if (count == 0) return {};
        TYPEMESH_ASSERT(!starts.empty() && starts.front() == 0 && starts.back() == count,
                        "the starts of loops begin with 0 and end with the number of points");
        if (count > (std::size_t{1} << 29) / copies || loops_.points.size() > (std::size_t{1} << 29) - copies * count)
            return error::too_large;
        const std::size_t room = copies * count;
        if (!loops_.points.reserve(loops_.points.size() + room) || !loops_.edges.reserve(loops_.edges.size() + room) ||
            !loops_.starts.reserve(loops_.starts.size() + copies * starts.size() + 1))
            return error::out_of_memory;
        if (loops_.starts.empty()) loops_.starts.push_back_unchecked(0);
        for (std::size_t copy = 0; copy < copies; ++copy) {
            const auto first = static_cast<std::uint32_t>(loops_.points.size());
            for (std::size_t i = 0; i < count; ++i) {
                loops_.points.push_back_unchecked(points[i]);
                loops_.edges.push_back_unchecked({sources_ + static_cast<std::uint32_t>(i), 0.0f, 1.0f});
            }
            for (std::size_t k = 1; k < starts.size(); ++k) loops_.starts.push_back_unchecked(first + starts[k]);
        }
        sources_ += static_cast<std::uint32_t>(count);
        loops_.forget_order();
        return {};
    }
    [[nodiscard]] result<void> add(const region& r, std::uint32_t layer) noexcept
    {
        return add(r.points(), r.starts(), layer);
    }

    /// The number of edges that were added.
    [[nodiscard]] std::uint32_t source_count() const noexcept { return sources_; }

    /// Calls put(number, points) for each loop that was added: the number of its first edge, and its points.
    template <class Put>
    void each_source_loop(Put&& put) const noexcept
    {
        std::uint32_t next = 0;
        for (std::uint32_t k = 0; k < loops_.contour_count(); ++k) {
            const std::uint32_t begin = loops_.starts[k], first = loops_.edges[begin].curve;
            if (first != next) continue;  // a copy
            const std::size_t count = loops_.starts[k + 1] - begin;
            next += static_cast<std::uint32_t>(count);
            put(first, loops_.points.view().subspan(begin, count));
        }
    }

    /// Divides all edges where they meet, and labels the cells.
    ///
    /// Fails  as resolve() does; then there are no pieces
    /// Cost   as resolve(), plus the sorting of the edges around each point
    template <class = void>  // see resolve()
    [[nodiscard]] result<void> cut(workspace& space, std::uint32_t max_pieces = default_max_pieces) noexcept
    {
        clear_pieces();
        if (loops_.points.empty()) return {};
        if (loops_.points.size() > max_pieces) return error{error::too_many_pieces, max_pieces};
        const resolve_options how{.max_pieces = max_pieces};
        detail::resolving work{loops_, fill_rule::non_zero, space, how};
        if (error e = work.cut()) return e;
        if (error e = keep(work.pieces())) {
            clear_pieces();
            return e;
        }
        return {};
    }

    /// The region that some cells fill. It has the interior on the left of its edges; every edge is a piece of the
    /// arrangement, whole. The region lies in `out`.
    ///
    /// Fails  error::bad_option ("cells"): the set is unbounded. error::out_of_memory
    [[nodiscard]] result<region> trace(cell_set cells, workspace& space, contours& out) noexcept
    {
        if (cells.is_unbounded()) return error::bad("cells");
        out.clear();
        out.grid = loops_.grid;
        if (segments_.empty()) return region{};
        bool touches = false;
        for (detail::segment& s : segments_) {
            s.interior = side_of(s, cells);
            s.next = detail::no_number;
        }
        for (std::size_t p = 0; p < points_.size(); ++p) {
            detail::sector_links links{segments_.data()};
            for (std::uint32_t i = star_starts_[p]; i < star_starts_[p + 1]; ++i)
                links.take(star_[i] / 2, star_[i] % 2 != 0);
            touches |= links.close();
        }
        workspace::scope scratch{space};
        detail::arrangement a;
        a.segments = segments_.data();
        a.count = static_cast<std::uint32_t>(segments_.size());
        a.points = points_.data();
        a.point_count = static_cast<std::uint32_t>(points_.size());
        a.first = scratch.take<std::uint32_t>(points_.size());
        a.loops = &loops_;
        if (a.first == nullptr) return error::out_of_memory;
        detail::boundary_cycles cycles;
        bool unread = true;
        if (error e = cycles.trace(a, scratch, {}, unread)) return e;
        if (error e = cycles.write(a, out, scratch)) return e;
        return region::proven(out, cycles.holes, cycles.outers, touches);
    }

    /// Twice the area that some cells fill, in cells of the grid; exact. An unbounded set has minus the area of its
    /// complement: what is missing from the whole plane.
    [[nodiscard]] std::int64_t doubled_area(cell_set cells) const noexcept
    {
        std::uint64_t sum = 0;  // partial sums may wrap; the total, below 2^59, cannot
        for (const detail::segment& s : segments_) {
            const auto term =
                static_cast<std::uint64_t>(std::int64_t{s.from.x} * s.to.y - std::int64_t{s.from.y} * s.to.x);
            const std::int32_t side = side_of(s, cells);
            sum += side > 0 ? term : side < 0 ? std::uint64_t{0} - term : 0;
        }
        return static_cast<std::int64_t>(sum);
    }

    /// Calls put(point) for each point through which the boundary of the cells passes more than once.
    template <class Put>
    void each_touching(cell_set cells, Put&& put) const noexcept
    {
        for (std::size_t p = 0; p < points_.size(); ++p) {
            std::uint32_t out = 0;  // the boundary leaves the point along these edges
            for (std::uint32_t i = star_starts_[p]; i < star_starts_[p + 1]; ++i) {
                const std::int32_t side = side_of(segments_[star_[i] / 2], cells);
                out += side != 0 && (side > 0) == (star_[i] % 2 != 0);
            }
            if (out > 1) put(points_[p]);
        }
    }

    /// A piece of the arrangement: an edge between two cells.
    struct piece {
        grid_point from, to;         ///< from before to in sweep order
        std::uint32_t start, end;    ///< the numbers of these points
        std::uint32_t below, above;  ///< the labels of the cells on its right and on its left
        contour_edge source;         ///< the edge that it is a part of: its number, and the parts of its length
                                     ///< at `from` and at `to`

        /// 1: of the two cells only the left one belongs to the set; -1: only the right one; 0: both or neither.
        [[nodiscard]] std::int32_t side(cell_set cells) const noexcept
        {
            return int{cells.contains(above)} - int{cells.contains(below)};
        }
    };
    /// The number of pieces: edges that end where others meet them.
    [[nodiscard]] std::size_t piece_count() const noexcept { return segments_.size(); }
    /// The number of distinct end points of all pieces.
    [[nodiscard]] std::size_t point_count() const noexcept { return points_.size(); }
    [[nodiscard]] piece operator[](std::size_t i) const noexcept
    {
        const detail::segment& s = segments_[i];
        return {s.from, s.to, s.start, s.end, label_below(s), label_above(s), s.source};
    }

    /// The grid of all its points.
    [[nodiscard]] const typemesh::grid& grid() const noexcept { return loops_.grid; }

private:
    static std::uint32_t label_below(const detail::segment& s) noexcept { return static_cast<std::uint32_t>(s.below); }
    static std::uint32_t label_above(const detail::segment& s) noexcept
    {
        return static_cast<std::uint32_t>(s.below + s.winding_delta);
    }
    static std::int32_t side_of(const detail::segment& s, cell_set cells) noexcept
    {
        return int{cells.contains(label_above(s))} - int{cells.contains(label_below(s))};
    }

    void clear_pieces() noexcept
    {
        segments_.clear();
        points_.clear();
        star_.clear();
        star_starts_.clear();
    }

    /// Copies the pieces, and sorts the pieces around each point.
    [[nodiscard]] error keep(const detail::arrangement& a) noexcept
    {
        if (!segments_.reserve(a.count) || !points_.append(array_view<const grid_point>{a.points, a.point_count}))
            return error::out_of_memory;
        for (std::uint32_t i = 0; i < a.count; ++i) {
            const detail::segment& s = a.segments[i];
            if (s.winding_delta == 0) continue;
            const std::int32_t above = s.below + s.winding_delta;
            if (s.below < 0 || above < 0 || s.below > 31 || above > 31) return error::crossing_contours;
            segments_.push_back_unchecked(s);
        }
        const std::size_t places = points_.size();
        std::uint32_t* starts = star_starts_.append(places + 1);
        std::uint32_t* star = star_.append(2 * segments_.size());
        if (starts == nullptr || (star == nullptr && !segments_.empty())) return error::out_of_memory;
        for (std::size_t p = 0; p <= places; ++p) starts[p] = 0;
        for (const detail::segment& s : segments_) {
            ++starts[s.start];
            ++starts[s.end];
        }
        std::uint32_t sum = 0;
        for (std::size_t p = 0; p <= places; ++p) {  // the end of each list, from which it is filled backwards
            sum += starts[p];
            starts[p] = sum;
        }
        for (std::uint32_t i = 0; i < segments_.size(); ++i) {
            star[--starts[segments_[i].start]] = 2 * i + 1;
            star[--starts[segments_[i].end]] = 2 * i;
        }
        for (std::size_t p = 0; p < places; ++p) {
            const auto before = [this](std::uint32_t i, std::uint32_t k) noexcept {
                if (i % 2 != k % 2) return i % 2 != 0;  // those that start here come first
                const detail::segment &s = segments_[i / 2], &t = segments_[k / 2];
                return i % 2 != 0 ? orientation(s.from, s.to, t.to) > 0 : orientation(s.to, s.from, t.from) > 0;
            };
            detail::heap_sort(star + starts[p], starts[p + 1] - starts[p], before);
        }
        return {};
    }

    contours loops_;
    std::uint32_t sources_ = 0;
    buffer<detail::segment> segments_;
    buffer<grid_point> points_;
    buffer<std::uint32_t> star_;  // [ first point's pieces, counter-clockwise | ... ]: the piece's number times 2,
                                  // plus 1 if the piece starts in the point
    buffer<std::uint32_t> star_starts_;  // the first entry of each point
};

}  // namespace typemesh::inline TYPEMESH_ABI
