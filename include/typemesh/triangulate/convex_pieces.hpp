// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Joins triangles into convex pieces: for physics engines, whose moving bodies are unions of convex shapes.
///
///     .------.------.         convex_pieces pieces;
///     |      |      |         if (auto done = pieces.find(form.points, form.triangles); !done) ...
///     |      '---.--'         for (std::size_t k = 0; k < pieces.count(); ++k)
///     |          |                for (std::uint32_t i : pieces[k]) ... form.points[i] ...
///     '----------'
///
/// A piece is a convex polygon over the triangles' own points, counter-clockwise. Angles of 180 degrees are allowed.
/// Diagonals are removed one by one, the longest first, as long as the two angles that they divide stay at most 180
/// degrees. Convexity is decided exactly. The areas of the pieces add up to the triangles' area, exactly, and the
/// corners of all pieces, less two for each, are as many as the triangles. If no point lies inside the region and
/// it has at most one hole, there are at most four times as many pieces as necessary; with h holes, at most
/// 3 * (h - 1) pieces more than that.
///
/// Memory is kept for the next call.
///
/// This work is based on: S. Hertel, K. Mehlhorn, "Fast Triangulation of Simple Polygons" (1983)
class convex_pieces {
public:
    explicit convex_pieces(memory source = heap()) noexcept
        : edges_{source}, twin_{source}, next_{source}, previous_{source}, starts_{source}, corners_{source}
    {
    }

    /// Finds the pieces of triangles, which are counter-clockwise and share whole edges: the cap of a region, or a part
    /// of it. Triangles without an area are no obstacle, but may stay pieces of their own.
    ///
    ///     points    |coordinate| <= 2^28
    ///
    /// Fails  error::bad_option ("triangles"): a corner is no index of a point; error::too_large: more than 2^30
    ///        triangles; error::out_of_memory. There are then no pieces
    /// Cost   O(n log n) for n triangles
    [[nodiscard]] result<void> find(array_view<const grid_point> points, array_view<const triangle> triangles) noexcept
    {
        starts_.clear();
        corners_.clear();
        if (triangles.size() > 0x3FFF'FFFFu) return error::too_large;
        for (const triangle& t : triangles)
            if (t.a >= points.size() || t.b >= points.size() || t.c >= points.size()) return error::bad("triangles");
        points_ = points.data();
        triangles_ = triangles.data();
        if (!link(triangles.size())) return error::out_of_memory;
        remove_diagonals();
        if (write()) return {};
        starts_.clear();
        corners_.clear();
        return error::out_of_memory;
    }

    /// The number of pieces.
    [[nodiscard]] std::size_t count() const noexcept { return starts_.empty() ? 0 : starts_.size() - 1; }
    /// The corners of a piece, as indices of points. k < count().
    [[nodiscard]] array_view<const std::uint32_t> operator[](std::size_t k) const noexcept
    {
        return corners_.view().subspan(starts_[k], starts_[k + 1] - starts_[k]);
    }
    /// The corners of all pieces.
    [[nodiscard]] array_view<const std::uint32_t> corners() const noexcept { return corners_.view(); }
    /// Where each piece begins in corners(), and their number at the end.
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return starts_.view(); }

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;

    /// An edge of a triangle by its ends, the smaller first; half-edge 3t + k runs from corner k of triangle t.
    struct edge {
        std::uint32_t low, high, half;
        std::int64_t square;  // of its length

        [[nodiscard]] bool before(const edge& e) const noexcept
        {
            return low != e.low ? low < e.low : high != e.high ? high < e.high : half < e.half;
        }
    };

    [[nodiscard]] std::uint32_t origin(std::uint32_t h) const noexcept
    {
        const triangle& t = triangles_[h / 3];
        return h % 3 == 0 ? t.a : h % 3 == 1 ? t.b : t.c;
    }
    [[nodiscard]] std::uint32_t target(std::uint32_t h) const noexcept { return origin(h % 3 == 2 ? h - 2 : h + 1); }

    /// Finds the twins; leaves one edge for each diagonal, the longest first.
    [[nodiscard]] bool link(std::size_t triangles) noexcept
    {
        const auto halves = static_cast<std::uint32_t>(3 * triangles);
        edges_.clear();
        for (buffer<std::uint32_t>* const b : {&twin_, &next_, &previous_}) {
            b->clear();
            if (halves != 0 && b->append(halves) == nullptr) return false;
        }
        if (!edges_.reserve(halves)) return false;
        for (std::uint32_t h = 0; h < halves; ++h) {
            const std::uint32_t a = origin(h), b = target(h);
            edges_.push_back_unchecked({a < b ? a : b, a < b ? b : a, h, squared_distance(points_[a], points_[b])});
            twin_[h] = none;
            next_[h] = h % 3 == 2 ? h - 2 : h + 1;
            previous_[h] = h % 3 == 0 ? h + 2 : h - 1;
        }
        detail::heap_sort(edges_.data(), edges_.size());
        std::size_t diagonals = 0;
        for (std::size_t i = 0, end = 0; i < edges_.size(); i = end) {
            for (end = i + 1; end < edges_.size() && is_same(edges_[i], edges_[end]);) ++end;
            if (end - i != 2 || origin(edges_[i].half) == origin(edges_[i + 1].half)) continue;
            twin_[edges_[i].half] = edges_[i + 1].half;
            twin_[edges_[i + 1].half] = edges_[i].half;
            edges_[diagonals++] = edges_[i];
        }
        edges_.truncate(diagonals);
        detail::heap_sort(edges_.data(), edges_.size(), [](const edge& a, const edge& b) noexcept {
            return a.square != b.square ? a.square > b.square : a.before(b);
        });
        return true;
    }
    [[nodiscard]] static bool is_same(const edge& a, const edge& b) noexcept
    {
        return a.low == b.low && a.high == b.high;
    }

    void remove_diagonals() noexcept
    {
        for (const edge& e : edges_) {
            const std::uint32_t h = e.half, g = twin_[h];
            if (!is_convex(previous_[h], next_[g]) || !is_convex(previous_[g], next_[h])) continue;
            join(previous_[h], next_[g]);
            join(previous_[g], next_[h]);
            next_[h] = next_[g] = none;  // removed
        }
    }
    void join(std::uint32_t h, std::uint32_t g) noexcept
    {
        next_[h] = g;
        previous_[g] = h;
    }

    /// Whether a boundary may turn from half-edge h into g: to the left, or straight on.
    [[nodiscard]] bool is_convex(std::uint32_t h, std::uint32_t g) const noexcept
    {
        const grid_point a = points_[origin(h)], b = points_[origin(g)], c = points_[target(g)];
        const std::int64_t turn = orientation(a, b, c);
        if (turn != 0) return turn > 0;
        const std::int64_t x = (std::int64_t{b.x} - a.x) * (std::int64_t{c.x} - b.x),
                           y = (std::int64_t{b.y} - a.y) * (std::int64_t{c.y} - b.y);
        return x + y > 0;
    }

    /// The boundaries of all pieces. False if out of memory.
    [[nodiscard]] bool write() noexcept
    {
        if (!starts_.push_back(0)) return false;
        for (std::uint32_t h = 0; h < next_.size(); ++h) {
            if (next_[h] == none) continue;
            for (std::uint32_t g = h; next_[g] != none;) {
                if (!corners_.push_back(origin(g))) return false;
                const std::uint32_t following = next_[g];
                next_[g] = none;  // written
                g = following;
            }
            if (!starts_.push_back(static_cast<std::uint32_t>(corners_.size()))) return false;
        }
        return true;
    }

    buffer<edge> edges_;
    buffer<std::uint32_t> twin_, next_, previous_, starts_, corners_;
    const grid_point* points_ = nullptr;
    const triangle* triangles_ = nullptr;
};

}  // namespace typemesh::inline TYPEMESH_ABI
