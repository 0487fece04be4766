// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Makes the triangles of a sweep's cells Delaunay, within each cell.
///
///       a-------b                    a-------b         A cell is flat, so its diagonals do not change the surface.
///       | ' -__  ' ._                | \      ' ._     Without this, an edge at the last level may belong to a thin
///       |       ' -__ ' .            |  '.        ' .  triangle whose third corner r lies far beyond the edge's end.
///       |            '-_ r    -->    |    \       __r  No point of the grid on such an edge leaves both of its parts
///       |          _.-'              |     \  _.-'     counter-clockwise.
///       a'------b'                   a'-----b'
///
/// From  C. Lawson, Software for C1 surface interpolation (1977)
class cell_diagonals {
public:
    explicit cell_diagonals(memory source = heap()) noexcept : sides_{source}, twins_{source}, waiting_{source} {}

    /// For the cells between levels[band] and levels[band + 1]. False if out of memory.
    ///
    /// Cost   O(n log n), and O(1) for each flip: usually few, at worst the square of a cell's triangles
    [[nodiscard]] bool improve(swept_region& swept, std::size_t band) noexcept
    {
        swept_ = &swept;
        const auto& cells = swept.cells;
        for (std::size_t c = 0; c + 1 < cells.size(); ++c) {
            if (cells[c].band != band) continue;
            const std::uint32_t first = cells[c].first_triangle, end = cells[c + 1].first_triangle;
            if (end - first < 2) continue;
            if (!open(3 * first, 3 * end) || !flip_waiting()) return false;
        }
        return true;
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    struct side {
        std::uint64_t key;  // of its two nodes, the lower number first
        std::uint32_t h;
    };

    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static std::uint32_t previous(std::uint32_t h) noexcept { return h % 3 == 0 ? h + 2 : h - 1; }
    [[nodiscard]] std::uint32_t& origin(std::uint32_t h) noexcept
    {
        triangle& t = swept_->triangles[h / 3];
        return h % 3 == 0 ? t.a : h % 3 == 1 ? t.b : t.c;
    }
    [[nodiscard]] grid_point place(std::uint32_t h) noexcept { return swept_->nodes[origin(h)].at; }
    [[nodiscard]] std::uint32_t& twin(std::uint32_t h) noexcept { return twins_[h - first_]; }

    /// Finds the triangles of a cell that share edges. An edge with more than two sides, or two in one direction,
    /// stays.
    [[nodiscard]] bool open(std::uint32_t first, std::uint32_t end) noexcept
    {
        first_ = first;
        for (buffer<std::uint32_t>* one : {&twins_, &waiting_}) one->clear();
        sides_.clear();
        const std::size_t count = end - first;
        if (twins_.append(count) == nullptr || !sides_.reserve(count)) return false;
        for (std::uint32_t h = first; h < end; ++h) {
            const std::uint64_t a = origin(h), b = origin(next(h));
            sides_.push_back_unchecked({a < b ? a << 32 | b : b << 32 | a, h});
            twin(h) = none;
        }
        std::sort(sides_.begin(), sides_.end(),
                  [](const side& a, const side& b) noexcept { return a.key != b.key ? a.key < b.key : a.h < b.h; });
        for (std::size_t i = 0, after = 0; i < count; i = after) {
            for (after = i + 1; after < count && sides_[after].key == sides_[i].key;) ++after;
            const std::uint32_t h = sides_[i].h, g = sides_[after - 1].h;
            if (after - i != 2 || origin(h) == origin(g)) continue;
            twin(h) = g;
            twin(g) = h;
            if (!waiting_.push_back(h)) return false;
        }
        return true;
    }

    /// Flips until all edges that wait, and those around edges that are flipped, are Delaunay. False if out of memory.
    [[nodiscard]] bool flip_waiting() noexcept
    {
        while (!waiting_.empty()) {
            const std::uint32_t h = waiting_.back();
            waiting_.truncate(waiting_.size() - 1);
            const std::uint32_t g = twin(h);
            if (g == none || in_circle(place(h), place(g), place(previous(h)), place(previous(g))) <= 0) continue;
            flip(h, g);
            for (const std::uint32_t around : {h, previous(h), g, previous(g)})
                if (!waiting_.push_back(around)) return false;
        }
        return true;
    }

    /// Replaces the edge of two twins by the other diagonal.
    ///
    ///         r                  h and g are then the outer edges p s and q r
    ///        /  ^                next(h) and next(g) the new diagonal
    ///       p -h-> q
    ///        \  /
    ///         s
    void flip(std::uint32_t h, std::uint32_t g) noexcept
    {
        const std::uint32_t h1 = next(h), g1 = next(g), at_h = twin(g1), at_g = twin(h1);
        const std::uint32_t r = origin(previous(h)), s = origin(previous(g));
        origin(h1) = s;
        origin(g1) = r;
        join(h, at_h);
        join(g, at_g);
        join(h1, g1);
    }
    void join(std::uint32_t h, std::uint32_t g) noexcept
    {
        twin(h) = g;
        if (g != none) twin(g) = h;
    }

    buffer<side> sides_;
    buffer<std::uint32_t> twins_;    // of the half-edges 3 t + k of a cell's triangles
    buffer<std::uint32_t> waiting_;  // half-edges to be looked at
    swept_region* swept_ = nullptr;
    std::uint32_t first_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
