// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/grid.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/resolve.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The place of a region in a pool.
struct pooled_region {
    std::size_t first_point = 0, points = 0;
    std::size_t first_end = 0;  ///< of its loops' ends, which count from first_point
    std::uint32_t holes = 0, outers = 0;
    bool touching = false;
    grid_point low, high;  ///< its bounds, if it has points

    [[nodiscard]] bool meets(const pooled_region& other) const noexcept
    {
        return points != 0 && other.points != 0 && low.x <= other.high.x && other.low.x <= high.x &&
               low.y <= other.high.y && other.low.y <= high.y;
    }
};

/// Regions, one after the other, whose edges are pieces of one set that meets in common points only. They are joined
/// and cut exactly: a point that both bound is never moved.
class region_pool {
public:
    explicit region_pool(memory source = heap()) noexcept
        : points_{source}, edges_{source}, ends_{source}, work_{source}
    {
    }

    void clear() noexcept
    {
        points_.clear();
        edges_.clear();
        ends_.clear();
    }

    /// The grid of all regions, the largest distance of their edges from the curves (in cells), and the greatest number
    /// of pieces in one operation, and of points at a time. All operations together may take 64 times as many points.
    void begin(const grid& cells, double tolerance, std::uint32_t max_pieces) noexcept
    {
        clear();
        grid_ = cells;
        tolerance_ = tolerance;
        max_pieces_ = max_pieces;
        work_left_ = std::uint64_t{64} * max_pieces;
    }

    /// How much is stored; to give it up again with rewind().
    struct mark {
        std::size_t points = 0, ends = 0;
    };
    [[nodiscard]] mark here() const noexcept { return {points_.size(), ends_.size()}; }

    /// Forgets all that was added after a mark, but the region `kept`, which moves there.
    void rewind(const mark& to, pooled_region& kept) noexcept
    {
        const std::size_t ends = std::size_t{kept.holes} + kept.outers;
        for (std::size_t i = 0; i < kept.points; ++i) {
            points_[to.points + i] = points_[kept.first_point + i];
            edges_[to.points + i] = edges_[kept.first_point + i];
        }
        for (std::size_t i = 0; i < ends; ++i) ends_[to.ends + i] = ends_[kept.first_end + i];
        points_.truncate(to.points + kept.points);
        edges_.truncate(to.points + kept.points);
        ends_.truncate(to.ends + ends);
        kept.first_point = to.points;
        kept.first_end = to.ends;
    }

    /// Adds a copy of a region of another pool.
    [[nodiscard]] error copy(const region_pool& from, const pooled_region& r, pooled_region& out) noexcept
    {
        const std::size_t first_point = points_.size(), first_end = ends_.size();
        if (r.points > max_pieces_ - first_point) return {error::too_many_points, max_pieces_};
        if (!points_.append(from.points_.view().subspan(r.first_point, r.points)) ||
            !edges_.append(from.edges_.view().subspan(r.first_point, r.points)) ||
            !ends_.append(from.ends_.view().subspan(r.first_end, std::size_t{r.holes} + r.outers)))
            return error::out_of_memory;
        out = r;
        out.first_point = first_point;
        out.first_end = first_end;
        return {};
    }

    /// Adds what some contours of the set fill.
    [[nodiscard]] error fill(const contours& set, std::uint32_t first, std::uint32_t count, fill_rule rule,
                             workspace& space, pooled_region& out) noexcept
    {
        begin_work();
        for (std::uint32_t c = first; c < first + count; ++c) {
            const std::size_t begin = set.starts[c], size = set.starts[c + 1] - begin;
            if (!add_loop(set.points.view().subspan(begin, size), set.edges.view().subspan(begin, size)))
                return error::out_of_memory;
        }
        return keep(rule, space, out);
    }

    /// Adds what two regions cover together (non_zero), or what only one of them covers (even_odd).
    [[nodiscard]] error join(const pooled_region& a, const pooled_region& b, fill_rule rule, workspace& space,
                             pooled_region& out) noexcept
    {
        begin_work();
        if (!load(a) || !load(b)) return error::out_of_memory;
        return keep(rule, space, out);
    }

    /// Adds what `a` leaves without `b`: all that both cover, without `b`.
    [[nodiscard]] error without(const pooled_region& a, const pooled_region& b, workspace& space,
                                pooled_region& out) noexcept
    {
        const mark before = here();
        pooled_region whole;
        if (error e = join(a, b, fill_rule::non_zero, space, whole)) return e;
        if (error e = join(whole, b, fill_rule::even_odd, space, out)) return e;
        rewind(before, out);
        return {};
    }

    /// Adds what `a` and `b` have in common: all that either covers, without what only one of them covers.
    [[nodiscard]] error both(const pooled_region& a, const pooled_region& b, workspace& space,
                             pooled_region& out) noexcept
    {
        const mark before = here();
        pooled_region whole, once;
        out = {};
        if (!a.meets(b)) return {};
        if (error e = join(a, b, fill_rule::non_zero, space, whole)) return e;
        if (error e = join(a, b, fill_rule::even_odd, space, once)) return e;
        if (error e = join(whole, once, fill_rule::even_odd, space, out)) return e;
        rewind(before, out);
        return {};
    }

    /// A region, copied into `loops`.
    [[nodiscard]] result<region> region_of(const pooled_region& r, array_view<const curve> curves,
                                           contours& loops) const noexcept
    {
        loops.clear();
        if (r.points == 0) return region{};
        if (!loops.points.append(points_.view().subspan(r.first_point, r.points)) ||
            !loops.edges.append(edges_.view().subspan(r.first_point, r.points)) || !loops.starts.push_back(0) ||
            !loops.starts.append(ends_.view().subspan(r.first_end, std::size_t{r.holes} + r.outers)))
            return error::out_of_memory;
        loops.grid = grid_;
        loops.tolerance = tolerance_;
        loops.curves = curves;
        return region::proven(loops, r.holes, r.outers, r.touching);
    }

private:
    void begin_work() noexcept
    {
        work_.clear();
        work_.grid = grid_;
    }
    [[nodiscard]] bool add_loop(array_view<const grid_point> points, array_view<const contour_edge> edges) noexcept
    {
        if (work_.starts.empty() && !work_.starts.push_back(0)) return false;
        return work_.points.append(points) && work_.edges.append(edges) &&
               work_.starts.push_back(static_cast<std::uint32_t>(work_.points.size()));
    }
    [[nodiscard]] bool load(const pooled_region& r) noexcept
    {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < std::size_t{r.holes} + r.outers; ++i) {
            const std::size_t end = ends_[r.first_end + i], first = r.first_point + begin;
            if (!add_loop(points_.view().subspan(first, end - begin), edges_.view().subspan(first, end - begin)))
                return false;
            begin = end;
        }
        return true;
    }

    [[nodiscard]] error keep(fill_rule rule, workspace& space, pooled_region& out) noexcept
    {
        out = {points_.size(), 0, ends_.size(), 0, 0, false, {}, {}};
        if (work_.points.empty()) return {};
        if (work_.points.size() > work_left_) return {error::too_many_pieces, max_pieces_};
        work_left_ -= work_.points.size();
        const auto made = resolve(work_, rule, space, {.max_pieces = max_pieces_});
        if (!made) return made.error();
        if (work_.points.empty()) return {};
        if (points_.size() > max_pieces_ || work_.points.size() > max_pieces_ - points_.size())
            return {error::too_many_points, max_pieces_};
        if (!points_.append(work_.points.view()) || !edges_.append(work_.edges.view()) ||
            !ends_.append(work_.starts.view().subspan(1)))
            return error::out_of_memory;
        out.points = work_.points.size();
        out.holes = made->holes();
        out.outers = made->outers();
        out.touching = made->is_touching();
        out.low = out.high = work_.points[0];
        for (const grid_point p : work_.points) {
            out.low = {p.x < out.low.x ? p.x : out.low.x, p.y < out.low.y ? p.y : out.low.y};
            out.high = {p.x > out.high.x ? p.x : out.high.x, p.y > out.high.y ? p.y : out.high.y};
        }
        return {};
    }

    buffer<grid_point> points_;
    buffer<contour_edge> edges_;
    buffer<std::uint32_t> ends_;
    contours work_;
    grid grid_;
    double tolerance_ = 0.0;
    std::uint32_t max_pieces_ = 0;
    std::uint64_t work_left_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
