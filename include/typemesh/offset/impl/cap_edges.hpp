// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Finds edges of the last level by their two nodes.
class last_level_edges {
public:
    /// False if out of memory.
    [[nodiscard]] bool prepare(const swept_region& swept, workspace::scope& scratch) noexcept
    {
        const std::size_t n = swept.nodes.size(), levels = swept.levels.size();
        const std::uint32_t first = swept.at_level[levels - 1], end = swept.at_level[levels];
        edges_ = swept.edges_at.view().subspan(first, end - first);
        first_ = scratch.take<std::uint32_t>(n);
        next_ = scratch.take<std::uint32_t>(edges_.size());
        if ((n != 0 && first_ == nullptr) || (!edges_.empty() && next_ == nullptr)) return false;
        for (std::size_t i = 0; i < n; ++i) first_[i] = none;
        for (std::uint32_t e = 0; e < edges_.size(); ++e) {
            next_[e] = first_[edges_[e].a];
            first_[edges_[e].a] = e;
        }
        return true;
    }

    /// The edge of the region, or the join, that now lies between two nodes.
    [[nodiscard]] std::uint32_t from(std::uint32_t a, std::uint32_t b) const noexcept
    {
        std::uint32_t e = first_[a];
        while (e != none && edges_[e].b != b) e = next_[e];
        TYPEMESH_ASSERT(e != none, "an edge of a cap does not lie at the last level");
        return e == none ? 0 : edges_[e].edge;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    array_view<const swept_edge_at> edges_;
    std::uint32_t* first_ = nullptr;
    std::uint32_t* next_ = nullptr;
};

/// The curves of moved edges, and the parameters of their ends.
class moved_edges {
public:
    moved_edges(const region& r, const swept_region& swept, std::uint32_t first_join_curve) noexcept
        : region_{r}, swept_{swept}, first_join_curve_{first_join_curve}
    {
    }

    /// `before` and `after` are the edge's neighbours in the loop; the edge goes from a to b.
    [[nodiscard]] contour_edge named(std::uint32_t before, std::uint32_t edge, std::uint32_t after, grid_point a,
                                     grid_point b) const noexcept
    {
        const auto n = static_cast<std::uint32_t>(region_.points().size());
        if (edge >= n) return {first_join_curve_ + (edge - n), 0.0f, 1.0f};
        const contour_edge own = region_.edges()[edge];
        const double from = before < n && goes_on(region_.edges()[before], own) ? 0.0 : share(edge, a),
                     to = after < n && goes_on(own, region_.edges()[after]) ? 1.0 : share(edge, b);
        const contour_edge cut{own.curve, at(own, from), at(own, to)};
        const bool forwards = own.t0 < own.t1 ? cut.t0 < cut.t1 : cut.t0 > cut.t1;
        return forwards ? cut : own;  // rounding may reverse an edge that has nearly vanished
    }

private:
    static bool goes_on(const contour_edge& stopped, const contour_edge& e) noexcept
    {
        return e.curve == stopped.curve && same(e.t0, stopped.t1);
    }

    /// The parameter, from 0 to 1, of the unmoved edge's point that is nearest to `at`.
    [[nodiscard]] double share(std::uint32_t edge, grid_point at) const noexcept
    {
        const grid_point p = swept_.nodes[swept_.edges_at[edge].a].at, q = swept_.nodes[swept_.edges_at[edge].b].at;
        const std::int64_t x = std::int64_t{q.x} - p.x, y = std::int64_t{q.y} - p.y;
        const std::int64_t along = (std::int64_t{at.x} - p.x) * x + (std::int64_t{at.y} - p.y) * y, all = x * x + y * y;
        return along <= 0 ? 0.0 : along >= all ? 1.0 : static_cast<double>(along) / static_cast<double>(all);
    }

    /// The summand is rounded to a float first, so that no compiler can fuse the two operations.
    static float at(const contour_edge& e, double share) noexcept
    {
        if (share >= 1.0) return e.t1;
        return e.t0 + static_cast<float>(share * (as_double(e.t1) - as_double(e.t0)));
    }

    const region& region_;
    const swept_region& swept_;
    std::uint32_t first_join_curve_;
};

/// Appends a curve for each join. It starts along the edge before the corner (or along the mean with the previous join)
/// and ends along the edge after it (or the mean with the next join). Only directions matter: it lies at the corner.
[[nodiscard]] inline bool add_join_curves(const region& r, bool round, const swept_region& swept,
                                          buffer<curve>& curves) noexcept
{
    const auto joins = swept.joins.view();
    const auto along = [&](std::size_t j) noexcept {
        return point{as_double(joins[j].inward.y), -as_double(joins[j].inward.x)};
    };
    const auto of_edge = [&](std::uint32_t edge) noexcept {
        const grid_point p = swept.nodes[swept.edges_at[edge].a].at, q = swept.nodes[swept.edges_at[edge].b].at;
        const point d{static_cast<double>(q.x) - p.x, static_cast<double>(q.y) - p.y};
        return (1.0 / length(d)) * d;
    };
    for (std::size_t j = 0, loop = 0; j < joins.size(); ++j) {
        const std::uint32_t corner = joins[j].point;
        const point at = r.grid().place(r.points()[corner]), own = along(j);
        if (!round) {
            if (!curves.push_back(curve::from(at, at + own))) return false;
            continue;
        }
        while (corner >= r.starts()[loop + 1]) ++loop;
        const std::uint32_t before = corner == r.starts()[loop] ? r.starts()[loop + 1] - 1 : corner - 1;
        const bool first = j == 0 || joins[j - 1].point != corner,
                   last = j + 1 == joins.size() || joins[j + 1].point != corner;
        const point from = first ? of_edge(before) : 0.5 * (along(j - 1) + own),
                    to = last ? of_edge(corner) : 0.5 * (own + along(j + 1));
        if (!curves.push_back(curve::from(quadratic{at, at + from, at + from + to}))) return false;
    }
    return true;
}

}  // namespace detail

/// Names the curves of a swept region's cap edges, so that walls on them are lit like walls on the region's own edges.
/// Each edge gets the curve of the edge that has moved there, and its parameters opposite the remaining part. Joins get
/// new curves, which are appended to `curves`: round ones turn from the edge before the corner to the edge after it,
/// others are straight.
///
///     r         the region that was swept; its curves are the first of `curves`
///     round     whether the joins are round
///
/// So an edge is as far from its curve as the boundary has moved, but has the same direction.
///
/// Fails  error::out_of_memory
/// Cost   O(nodes)
[[nodiscard]] inline error name_cap_edges(const region& r, bool round, swept_region& swept, buffer<curve>& curves,
                                          workspace::scope& scratch) noexcept
{
    if (swept.cap.points.empty()) return {};
    const auto first_join_curve = static_cast<std::uint32_t>(curves.size());
    detail::last_level_edges moved;
    auto* const source = scratch.take<std::uint32_t>(swept.cap.points.size());
    if (source == nullptr || !moved.prepare(swept, scratch) || !detail::add_join_curves(r, round, swept, curves))
        return error::out_of_memory;
    const detail::moved_edges edges{r, swept, first_join_curve};
    contours& cap = swept.cap;
    for (std::uint32_t k = 0; k < cap.contour_count(); ++k) {
        const std::uint32_t first = cap.starts[k], last = cap.starts[k + 1] - 1;
        const auto next = [&](std::uint32_t i) noexcept { return i == last ? first : i + 1; };
        for (std::uint32_t i = first; i <= last; ++i)
            source[i] = moved.from(swept.cap_nodes[i], swept.cap_nodes[next(i)]);
        for (std::uint32_t i = first, before = last; i <= last; before = i++)
            cap.edges[i] = edges.named(source[before], source[i], source[next(i)], cap.points[i], cap.points[next(i)]);
    }
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
