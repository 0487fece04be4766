// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/impl/box_tree.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds the points of loops that lie in a box: by the boxes of chunks of consecutive points, and a tree of these if
/// they are many.
///
/// Cost   O(n) for n points to open; O(log n) for a search, and what it finds, if loops are not entangled
class point_chunks {
public:
    explicit point_chunks(memory source = heap()) noexcept : tree_{source}, chunks_{source} {}

    /// Takes points, in the order along the loops, which must stay until the last search. False if out of memory; then
    /// searches find nothing.
    [[nodiscard]] bool open(array_view<const grid_point> points) noexcept
    {
        points_ = points;
        chunks_.clear();
        const std::size_t count = (points.size() + chunk - 1) / chunk;
        if (chunks_.append(count) == nullptr) return false;
        for (grid_box& b : chunks_) b = {};
        for (std::size_t i = 0; i < points.size(); ++i) chunks_[i / chunk].add(points[i]);
        if (count <= few_chunks) return true;
        if (!tree_.open(count)) {
            chunks_.clear();
            return false;
        }
        for (std::size_t k = 0; k < count; ++k) tree_.set(k, chunks_[k]);
        tree_.close();
        return true;
    }

    /// Calls found(i) for the points in a box, which is not empty.
    template <class Found>
    void each_in(const grid_box& b, const Found& found) const noexcept
    {
        const array_view<const grid_point> points = points_;
        const auto apart = [](std::int32_t from, std::int32_t to) noexcept {
            return static_cast<std::uint32_t>(to) - static_cast<std::uint32_t>(from);
        };
        const std::uint32_t width = apart(b.low.x, b.high.x), height = apart(b.low.y, b.high.y);
        const auto look_into = [&](std::size_t k) noexcept {
            const std::size_t end = (k + 1) * chunk < points.size() ? (k + 1) * chunk : points.size();
            for (std::size_t i = k * chunk; i < end; ++i) {
                const bool is_beside = apart(b.low.x, points[i].x) <= width,
                           is_above = apart(b.low.y, points[i].y) <= height;
                if (is_beside & is_above) found(i);
            }
        };
        if (chunks_.size() > few_chunks) return tree_.each_meeting(b, look_into);
        for (std::size_t k = 0; k < chunks_.size(); ++k)
            if (b.meets(chunks_[k])) look_into(k);
    }

private:
    static constexpr std::size_t chunk = 8, few_chunks = 64;  // few are looked at faster one by one than in a tree

    array_view<const grid_point> points_;
    box_tree tree_;            // of the chunks, if they are many
    buffer<grid_box> chunks_;  // boxes of so many consecutive points
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
