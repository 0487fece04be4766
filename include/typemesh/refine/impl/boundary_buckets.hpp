// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/impl/row_walk.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds the boundary edges near a place outside the region, where the mesh has no triangles. The box of the region is
/// divided into square buckets; each lists the boundary edges that may pass through it. A bucket with many edges that
/// are short beside it is divided into 4 x 4 smaller ones, and these again. Its short edges are listed in them, its
/// long ones stay, so that an edge is listed a few times only.
///
///     +-------+-------+-------+
///     |       |       |       |     a bucket with a cluster of points
///     |       |       |     --|--
///     +-------+-+-+-+-+----/--+     a long edge: listed in the large buckets
///     |       +-+-+:+:|   /   |
///     |       +-+-+:+-|  /    |     short edges (:): listed in the small ones
///     |       +-+-+-+-| /     |
///     +-------+-+-+-+-+-------+
///
/// Cost   O(1) for each bucket that an edge or a query passes through
class boundary_buckets {
public:
    explicit boundary_buckets(memory source = heap()) noexcept : buckets_{source}, entries_{source} {}

    /// Lists all boundary edges of a mesh. False if out of memory.
    [[nodiscard]] bool open(const refinable_mesh& mesh) noexcept
    {
        buckets_.clear();
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
        int shift = 4;
        while (((width >> shift) + 1) * ((height >> shift) + 1) > 2 * std::int64_t{n} + 16) ++shift;
        whole_ = {.low = low, .columns = (width >> shift) + 1, .rows = (height >> shift) + 1, .shift = shift};
        if (!append_buckets(static_cast<std::size_t>(whole_.columns * whole_.rows))) return false;
        for (std::uint32_t v = 0; v < n; ++v)
            if (mesh.at(v).boundary != refinable_mesh::none && !add(mesh, v)) return false;
        return true;
    }

    /// Whether open() must be called first: before the first use, and when the mesh has twice as many points.
    [[nodiscard]] bool is_stale(const refinable_mesh& mesh) const noexcept { return mesh.vertex_count() > full_at_; }
    void clear() noexcept { full_at_ = 0; }

    /// Lists the boundary edge that leaves v. False if out of memory.
    [[nodiscard]] bool add(const refinable_mesh& mesh, std::uint32_t v) noexcept { return add_in(whole_, mesh, v); }

    /// Whether the triangle a, p, b, which lies outside beyond the boundary edge from vertex `from`, meets no other
    /// boundary edge, not even in a point other than a and b.
    [[nodiscard]] bool is_free(const refinable_mesh& mesh, std::uint32_t from, grid_point p) const noexcept
    {
        const grid_point corners[] = {mesh.place(from), p, mesh.place(mesh.next_on_boundary(from))};
        return each_near(corners, [&](std::uint32_t v) noexcept {
            return v == from || misses(corners, mesh.place(v), mesh.place(mesh.next_on_boundary(v)));
        });
    }

    /// Visits the vertices whose edges may meet a triangle, some of them several times, until visit() returns false;
    /// returns its last result.
    template <class Visit>
    [[nodiscard]] bool each_near(const grid_point (&corners)[3], Visit&& visit) const noexcept
    {
        return each_near_in(whole_, corners, visit);
    }

private:
    struct entry {
        std::uint32_t vertex;
        std::uint32_t next;
    };

    struct bucket {
        std::uint32_t first;        // entry
        std::uint32_t inner;        // the first of the smaller buckets
        std::uint32_t short_count;  // short edges listed here, while there are no smaller buckets
    };

    /// Square buckets in rows and columns. Those at the border extend to the bounds.
    struct bucket_grid {
        grid_point low = {};
        std::int64_t columns = 0, rows = 0;
        int shift = 0;  // a bucket is 2^shift cells wide
        std::size_t first = 0;
        std::int64_t left = -limit, right = limit, bottom = -limit, top = limit;

        [[nodiscard]] std::int64_t column_of(std::int64_t x) const noexcept
        {
            return clamped((x - low.x) >> shift, columns);
        }
        [[nodiscard]] std::int64_t row_of(std::int64_t y) const noexcept { return clamped((y - low.y) >> shift, rows); }
        [[nodiscard]] std::int64_t x_of(std::int64_t column) const noexcept
        {
            return column == 0 ? left : column == columns ? right : low.x + (column << shift);
        }
        [[nodiscard]] std::int64_t y_of(std::int64_t row) const noexcept
        {
            return row == 0 ? bottom : row == rows ? top : low.y + (row << shift);
        }
        [[nodiscard]] std::size_t at(std::int64_t column, std::int64_t row) const noexcept
        {
            return first + static_cast<std::size_t>(row * columns + column);
        }

        // For walk_rows().
        [[nodiscard]] interval rows_between(std::int64_t from, std::int64_t to) const noexcept
        {
            return from > top || to < bottom ? interval{0, -1} : interval{row_of(from), row_of(to)};
        }
        [[nodiscard]] interval height_of(std::int64_t row) const noexcept { return {y_of(row), y_of(row + 1)}; }
        [[nodiscard]] interval columns_between(std::int64_t from, std::int64_t to) const noexcept
        {
            return from > right || to < left ? interval{0, -1} : interval{column_of(from), column_of(to)};
        }
    };

    static constexpr std::int64_t limit = std::int64_t{1} << 40;
    static constexpr std::uint32_t max_short = 16;

    [[nodiscard]] static std::int64_t clamped(std::int64_t i, std::int64_t count) noexcept
    {
        return i < 0 ? 0 : i < count ? i : count - 1;
    }

    [[nodiscard]] bool append_buckets(std::size_t count) noexcept
    {
        bucket* const made = buckets_.append(count);
        if (made == nullptr) return false;
        for (std::size_t i = 0; i < count; ++i) made[i] = {refinable_mesh::none, refinable_mesh::none, 0};
        return true;
    }

    /// The smaller buckets in a bucket of a grid.
    [[nodiscard]] bucket_grid inner_of(const bucket_grid& in, std::int64_t column, std::int64_t row) const noexcept
    {
        return {.low = {static_cast<std::int32_t>(in.low.x + (column << in.shift)),
                        static_cast<std::int32_t>(in.low.y + (row << in.shift))},
                .columns = 4,
                .rows = 4,
                .shift = in.shift - 2,
                .first = buckets_[in.at(column, row)].inner,
                .left = in.x_of(column),
                .right = in.x_of(column + 1),
                .bottom = in.y_of(row),
                .top = in.y_of(row + 1)};
    }

    /// Whether an edge is shorter than the smaller buckets in a bucket of a grid.
    [[nodiscard]] static bool is_short(const bucket_grid& in, grid_point p, grid_point q) noexcept
    {
        const std::int64_t x = std::int64_t{q.x} - p.x, y = std::int64_t{q.y} - p.y,
                           length = (x < 0 ? -x : x) + (y < 0 ? -y : y);
        return in.shift >= 4 && length >> (in.shift - 2) == 0;
    }

    /// Lists an edge in the buckets of a grid.
    [[nodiscard]] bool add_in(const bucket_grid& in, const refinable_mesh& mesh, std::uint32_t v) noexcept
    {
        const grid_point ends[] = {mesh.place(v), mesh.place(mesh.next_on_boundary(v))};
        const bool is_inner = is_short(in, ends[0], ends[1]);
        return walk_rows(in, ends, [&](std::int64_t column, std::int64_t row) noexcept {
            bucket& to = buckets_[in.at(column, row)];
            if (is_inner && to.inner != refinable_mesh::none) return add_in(inner_of(in, column, row), mesh, v);
            if (!entries_.push_back({v, to.first})) return false;
            to.first = static_cast<std::uint32_t>(entries_.size() - 1);
            to.short_count += is_inner;
            return to.short_count <= max_short || divide(in, column, row, mesh);
        });
    }

    /// Divides a bucket, and lists its short edges in the smaller ones.
    [[nodiscard]] bool divide(const bucket_grid& in, std::int64_t column, std::int64_t row,
                              const refinable_mesh& mesh) noexcept
    {
        const std::size_t at = in.at(column, row);
        std::uint32_t e = buckets_[at].first;
        buckets_[at] = {refinable_mesh::none, static_cast<std::uint32_t>(buckets_.size()), 0};
        if (!append_buckets(16)) return false;
        const bucket_grid inner = inner_of(in, column, row);
        while (e != refinable_mesh::none) {
            const auto [v, next] = entries_[e];
            if (is_short(in, mesh.place(v), mesh.place(mesh.next_on_boundary(v)))) {
                if (!add_in(inner, mesh, v)) return false;
            } else {
                entries_[e].next = buckets_[at].first;
                buckets_[at].first = e;
            }
            e = next;
        }
        return true;
    }

    template <class Visit>
    [[nodiscard]] bool each_near_in(const bucket_grid& in, const grid_point (&corners)[3], Visit& visit) const noexcept
    {
        return walk_rows(in, corners, [&](std::int64_t column, std::int64_t row) noexcept {
            const bucket& b = buckets_[in.at(column, row)];
            for (std::uint32_t e = b.first; e != refinable_mesh::none; e = entries_[e].next)
                if (!visit(entries_[e].vertex)) return false;
            return b.inner == refinable_mesh::none || each_near_in(inner_of(in, column, row), corners, visit);
        });
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

    buffer<bucket> buckets_;
    buffer<entry> entries_;
    std::size_t full_at_ = 0;  // points
    bucket_grid whole_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
