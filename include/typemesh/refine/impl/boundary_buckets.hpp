// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds the boundary edges near a place outside the region, where the mesh has no triangles. The box of the region is
/// divided into square buckets; each lists the boundary edges that may pass through it.
///
/// Cost   O(1) for each bucket that an edge or a query passes through
class boundary_buckets {
public:
    explicit boundary_buckets(memory source = heap()) noexcept : heads_{source}, entries_{source} {}

    /// Lists all boundary edges of a mesh. False if out of memory.
    [[nodiscard]] bool open(const refinable_mesh& mesh) noexcept
    {
        heads_.clear();
        entries_.clear();
        const std::uint32_t n = mesh.vertex_count();
        full_at_ = 2 * std::size_t{n} + 64;
        grid_point low = mesh.place(0), high = low;
        for (std::uint32_t v = 0; v < n; ++v) {
            const grid_point p = mesh.place(v);
            low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y};
            high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y};
        }
        const std::int64_t width = std::int64_t{high.x} - low.x, height = std::int64_t{high.y} - low.y;
        shift_ = 4;
        while (((width >> shift_) + 1) * ((height >> shift_) + 1) > 2 * std::int64_t{n} + 16) ++shift_;
        low_ = low;
        columns_ = (width >> shift_) + 1;
        rows_ = (height >> shift_) + 1;
        const auto count = static_cast<std::size_t>(columns_ * rows_);
        std::uint32_t* const heads = heads_.append(count);
        if (heads == nullptr) return false;
        for (std::size_t i = 0; i < count; ++i) heads[i] = refinable_mesh::none;
        for (std::uint32_t v = 0; v < n; ++v)
            if (mesh.at(v).boundary != refinable_mesh::none && !add(mesh, v)) return false;
        return true;
    }

    /// Whether open() must be called first: before the first use, and when the mesh has twice as many points.
    [[nodiscard]] bool is_stale(const refinable_mesh& mesh) const noexcept { return mesh.vertex_count() > full_at_; }
    void clear() noexcept { full_at_ = 0; }

    /// Lists the boundary edge that leaves v. False if out of memory.
    [[nodiscard]] bool add(const refinable_mesh& mesh, std::uint32_t v) noexcept
    {
        const grid_point ends[] = {mesh.place(v), mesh.place(mesh.next_on_boundary(v))};
        return each_bucket(ends, [&](std::size_t bucket) noexcept {
            if (!entries_.push_back({v, heads_[bucket]})) return false;
            heads_[bucket] = static_cast<std::uint32_t>(entries_.size() - 1);
            return true;
        });
    }

    /// Whether the triangle a, p, b, which lies outside beyond the boundary edge from vertex `from`, meets no other
    /// boundary edge, not even in a point other than a and b.
    [[nodiscard]] bool is_free(const refinable_mesh& mesh, std::uint32_t from, grid_point p) const noexcept
    {
        const grid_point corners[] = {mesh.place(from), p, mesh.place(mesh.next_on_boundary(from))};
        return each_bucket(corners, [&](std::size_t bucket) noexcept {
            for (std::uint32_t e = heads_[bucket]; e != refinable_mesh::none; e = entries_[e].next) {
                const std::uint32_t v = entries_[e].vertex;
                if (v == from) continue;
                if (!misses(corners, mesh.place(v), mesh.place(mesh.next_on_boundary(v)))) return false;
            }
            return true;
        });
    }

private:
    struct entry {
        std::uint32_t vertex;
        std::uint32_t next;
    };

    [[nodiscard]] std::int64_t column_of(std::int64_t x) const noexcept
    {
        return clamped((x - low_.x) >> shift_, columns_);
    }
    [[nodiscard]] std::int64_t row_of(std::int64_t y) const noexcept { return clamped((y - low_.y) >> shift_, rows_); }
    [[nodiscard]] static std::int64_t clamped(std::int64_t i, std::int64_t count) noexcept
    {
        return i < 0 ? 0 : i < count ? i : count - 1;
    }

    /// x where the segment from p to q has this y, which is clamped to the segment; rounded down or up by up to a cell.
    [[nodiscard]] static std::int64_t x_at(grid_point p, grid_point q, std::int64_t y) noexcept
    {
        const std::int64_t low = p.y < q.y ? p.y : q.y, high = p.y < q.y ? q.y : p.y;
        y = y < low ? low : y > high ? high : y;
        if (low == high) return p.x;
        return p.x + (std::int64_t{q.x} - p.x) * (y - p.y) / (std::int64_t{q.y} - p.y);
    }

    /// Visits the buckets that a segment or a triangle may pass through, row by row, until visit() returns false;
    /// returns its last result. A row's buckets lie between the smallest and the largest x of all sides in the row.
    template <std::size_t count, class Visit>
    [[nodiscard]] bool each_bucket(const grid_point (&corners)[count], Visit&& visit) const noexcept
    {
        std::int64_t bottom = corners[0].y, top = bottom;
        for (const grid_point c : corners) {
            bottom = c.y < bottom ? c.y : bottom;
            top = c.y > top ? c.y : top;
        }
        for (std::int64_t row = row_of(bottom); row <= row_of(top); ++row) {
            const std::int64_t y0 = row == 0 ? bottom : low_.y + (row << shift_),
                               y1 = row == rows_ - 1 ? top : low_.y + ((row + 1) << shift_);
            std::int64_t left = std::int64_t{1} << 40, right = -left;
            const auto widen = [&](std::int64_t x) noexcept {
                left = x - 1 < left ? x - 1 : left;
                right = x + 1 > right ? x + 1 : right;
            };
            for (std::size_t i = 0; i < count; ++i) {
                const grid_point p = corners[i], q = corners[i + 1 < count ? i + 1 : 0];
                if ((p.y < q.y ? p.y : q.y) > y1 || (p.y < q.y ? q.y : p.y) < y0) continue;
                widen(p.y == q.y ? q.x : x_at(p, q, y0));
                widen(x_at(p, q, y1));
            }
            for (std::int64_t column = column_of(left); column <= column_of(right); ++column)
                if (!visit(static_cast<std::size_t>(row * columns_ + column))) return false;
        }
        return true;
    }

    /// Whether the segment u v and the triangle of these corners a, p, b (counter-clockwise) have nothing in common
    /// except a or b.
    [[nodiscard]] static bool misses(const grid_point (&corner)[3], grid_point u, grid_point v) noexcept
    {
        // All of the segment lies beyond one side of the triangle, except for a corner that may be shared.
        const auto may_touch = [&](grid_point q) noexcept { return q == corner[0] || q == corner[2]; };
        for (int i = 0; i < 3; ++i) {
            const grid_point s = corner[i], e = corner[i == 2 ? 0 : i + 1];
            const std::int64_t at_u = orientation(s, e, u), at_v = orientation(s, e, v);
            if (at_u < 0 && at_v < 0) return true;
            if (at_u < 0 && at_v == 0 && may_touch(v)) return true;
            if (at_v < 0 && at_u == 0 && may_touch(u)) return true;
        }
        // All of the triangle lies on one side of the segment's line, except for a shared corner.
        std::int64_t above = 0, below = 0, shared = 0;
        for (const grid_point c : corner) {
            const std::int64_t side = orientation(u, v, c);
            above += side > 0;
            below += side < 0;
            shared += side == 0 && may_touch(c) && (c == u || c == v);
        }
        return above + shared == 3 ? above > 0 : below + shared == 3 && below > 0;
    }

    buffer<std::uint32_t> heads_;
    buffer<entry> entries_;
    std::size_t full_at_ = 0;  // points
    grid_point low_ = {};
    std::int64_t columns_ = 0, rows_ = 0;
    int shift_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
