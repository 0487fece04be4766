// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/plate/layer_arrangement.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The normals of the walls on an arrangement. A source's normal turns evenly from its first to its second end. At an
/// end it is the mean of both edges' normals if they differ by at most 30 degrees; otherwise the edge's own.
class edge_normals {
public:
    explicit edge_normals(memory source = heap()) noexcept : ends_{source} {}

    /// Finds the normals of all sources. Fails with error::out_of_memory.
    [[nodiscard]] error find(const layer_arrangement& cells) noexcept
    {
        ends_.clear();
        ends* const all = ends_.append(cells.source_count());
        if (all == nullptr && cells.source_count() != 0) return error::out_of_memory;
        cells.each_source_loop([&](std::uint32_t first, array_view<const grid_point> loop) noexcept {
            const std::size_t n = loop.size();
            for (std::size_t i = 0; i < n; ++i) {
                const vec2 before = normal(loop[(i + n - 1) % n], loop[i]), own = normal(loop[i], loop[(i + 1) % n]);
                const vec2 after = normal(loop[(i + 1) % n], loop[(i + 2) % n]);
                all[first + i] = {mean(own, before), mean(own, after)};
            }
        });
        return {};
    }

    /// The outward normal of a wall at a place of its source. side as in slab_walls::wall.
    [[nodiscard]] vec2 at(const layer_arrangement::piece& s, float t, std::int32_t side) const noexcept
    {
        const vec2 flat = side > 0 ? normal(s.from, s.to) : normal(s.to, s.from);
        const ends& e = ends_[s.source.curve];
        const vec2 turned = unit({e.first.x + (e.second.x - e.first.x) * t, e.first.y + (e.second.y - e.first.y) * t});
        const float along = turned.x * flat.x + turned.y * flat.y;
        return along < 0.0f ? vec2{-turned.x, -turned.y} : along > 0.0f ? turned : flat;
    }

private:
    struct ends {
        vec2 first, second;
    };

    static vec2 unit(vec2 v) noexcept
    {
        const float length = std::sqrt(v.x * v.x + v.y * v.y);
        return length > 0.0f ? vec2{v.x / length, v.y / length} : vec2{0.0f, 0.0f};
    }
    /// The unit normal on the right of an edge.
    static vec2 normal(grid_point a, grid_point b) noexcept
    {
        const double x = static_cast<double>(b.x) - a.x, y = static_cast<double>(b.y) - a.y;
        const double length = std::sqrt(x * x + y * y);
        if (!(length > 0.0)) return {0.0f, 0.0f};
        return {static_cast<float>(y / length), static_cast<float>(-x / length)};
    }
    static vec2 mean(vec2 own, vec2 other) noexcept
    {
        constexpr float crease = 0.866025f;  // the cosine of 30 degrees
        return own.x * other.x + own.y * other.y < crease ? own : unit({own.x + other.x, own.y + other.y});
    }

    buffer<ends> ends_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
