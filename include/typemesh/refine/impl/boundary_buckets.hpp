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

    [[nodiscard]] bool is_open() const noexcept { return !heads_.empty(); }
    void clear() noexcept { heads_.clear(); }

    /// Lists the boundary edge that leaves v. False if out of memory.
    [[nodiscard]] bool add(const refinable_mesh& mesh, std::uint32_t v) noexcept
    {
        const grid_point a = mesh.place(v), b = mesh.place(mesh.next_on_boundary(v));
        bool fits = true;
        // The buckets of its box, row by row, without those that the line through it misses.
        each_bucket(a, b, [&](std::size_t bucket) noexcept {
            fits = fits && entries_.push_back({v, heads_[bucket]});
            if (fits) heads_[bucket] = static_cast<std::uint32_t>(entries_.size() - 1);
        });
        return fits;
    }

    /// Whether the triangle a, p, b, which lies outside beyond the boundary edge from vertex `from`, meets no other
    /// boundary edge, not even in a point other than a and b.
    [[nodiscard]] bool is_free(const refinable_mesh& mesh, std::uint32_t from, grid_point p) const noexcept
    {
        const grid_point a = mesh.place(from), b = mesh.place(mesh.next_on_boundary(from));
        const grid_point low{least(a.x, b.x, p.x), least(a.y, b.y, p.y)},
            high{most(a.x, b.x, p.x), most(a.y, b.y, p.y)};
        bool is_clear = true;
        each_bucket(low, high, [&](std::size_t bucket) noexcept {
            for (std::uint32_t e = heads_[bucket]; is_clear && e != refinable_mesh::none; e = entries_[e].next) {
                const std::uint32_t v = entries_[e].vertex;
                if (v != from) is_clear = misses(a, p, b, mesh.place(v), mesh.place(mesh.next_on_boundary(v)));
            }
        });
        return is_clear;
    }

private:
    struct entry {
        std::uint32_t vertex;
        std::uint32_t next;
    };

    [[nodiscard]] static std::int32_t least(std::int32_t a, std::int32_t b, std::int32_t c) noexcept
    {
        return a < b ? (a < c ? a : c) : (b < c ? b : c);
    }
    [[nodiscard]] static std::int32_t most(std::int32_t a, std::int32_t b, std::int32_t c) noexcept
    {
        return a > b ? (a > c ? a : c) : (b > c ? b : c);
    }

    /// Visits the buckets of the box of p and q.
    template <class Visit>
    void each_bucket(grid_point p, grid_point q, Visit&& visit) const noexcept
    {
        const auto place = [this](std::int32_t v, std::int32_t from, std::int64_t count) noexcept {
            const std::int64_t i = (std::int64_t{v} - from) >> shift_;
            return i < 0 ? 0 : i < count ? i : count - 1;
        };
        const std::int64_t x0 = place(p.x < q.x ? p.x : q.x, low_.x, columns_),
                           x1 = place(p.x < q.x ? q.x : p.x, low_.x, columns_),
                           y0 = place(p.y < q.y ? p.y : q.y, low_.y, rows_),
                           y1 = place(p.y < q.y ? q.y : p.y, low_.y, rows_);
        for (std::int64_t y = y0; y <= y1; ++y)
            for (std::int64_t x = x0; x <= x1; ++x) visit(static_cast<std::size_t>(y * columns_ + x));
    }

    /// Whether the segment u v and the triangle a, p, b (counter-clockwise) have nothing in common but a or b.
    [[nodiscard]] static bool misses(grid_point a, grid_point p, grid_point b, grid_point u, grid_point v) noexcept
    {
        const grid_point corner[] = {a, p, b};
        // All of the segment lies beyond one side of the triangle, except for a corner that may be shared.
        const auto may_touch = [&](grid_point q) noexcept { return q == a || q == b; };
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
    grid_point low_ = {};
    std::int64_t columns_ = 0, rows_ = 0;
    int shift_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
