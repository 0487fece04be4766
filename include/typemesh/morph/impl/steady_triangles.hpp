// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/morph/impl/moving_points.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Flips edges of triangles over moving points until all triangles are positive throughout a stretch, if flips can
/// reach that. The edges that belong to one triangle alone are never flipped.
///
/// A triangle's fault is the number of eighths of the steps in which it is not proven positive. An edge is flipped if
/// this lessens the sum of the faults of its two triangles, so flipping ends.
class steady_triangles {
public:
    explicit steady_triangles(memory source = heap()) noexcept : twins_{source}, head_{source}, next_{source} {}

    /// Returns the faults that are left, 0 if all triangles are proven positive; ~0u when out of memory.
    [[nodiscard]] std::uint32_t repair(const moving_points& points, const moving_stretch& where,
                                       array_view<triangle> triangles) noexcept
    {
        points_ = &points;
        where_ = where;
        triangles_ = triangles;
        std::uint32_t faults = 0;
        for (const triangle& t : triangles) faults += fault(t);
        if (faults == 0) return 0;
        if (!join()) return ~0u;
        for (bool better = true; better && faults != 0;) {
            better = false;
            for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
                while (fault(triangles_[t]) != 0) {
                    const std::uint32_t gain = improve(t);
                    if (gain == 0) break;
                    faults -= gain;
                    better = true;
                }
            }
        }
        return faults;
    }

    /// The faults of a triangle.
    [[nodiscard]] std::uint32_t fault(const triangle& t) const noexcept
    {
        std::uint32_t sum = 0;
        for (std::size_t k = where_.key; k < where_.key + where_.steps; ++k) {
            const area_path area = points_->area(k, t);
            if (area.is_positive(where_.first, where_.last)) continue;
            ++sum;
            for (std::int32_t p = where_.first; p < where_.last; p += 4)
                if (!area.is_positive(p, p + 4 < where_.last ? p + 4 : where_.last)) ++sum;
        }
        return sum;
    }

private:
    static constexpr std::uint32_t none = 0xFFFF'FFFFu;

    [[nodiscard]] std::uint32_t corner(std::uint32_t half_edge) const noexcept
    {
        const triangle& t = triangles_[half_edge / 3];
        const std::uint32_t k = half_edge % 3;
        return k == 0 ? t.a : k == 1 ? t.b : t.c;
    }
    static std::uint32_t after(std::uint32_t half_edge) noexcept
    {
        return half_edge % 3 == 2 ? half_edge - 2 : half_edge + 1;
    }

    /// Finds the twin of each half-edge. Half-edge 3t + k begins at corner k of triangle t.
    [[nodiscard]] bool join() noexcept
    {
        const std::size_t n = points_->size(), half_edges = 3 * triangles_.size();
        twins_.clear();
        head_.clear();
        next_.clear();
        if (twins_.append(half_edges) == nullptr || next_.append(half_edges) == nullptr || head_.append(n) == nullptr)
            return false;
        for (std::uint32_t& h : head_) h = none;
        for (std::uint32_t h = 0; h < half_edges; ++h) {
            next_[h] = head_[corner(h)];
            head_[corner(h)] = h;
        }
        for (std::uint32_t h = 0; h < half_edges; ++h) {
            std::uint32_t twin = head_[corner(after(h))];
            while (twin != none && corner(after(twin)) != corner(h)) twin = next_[twin];
            twins_[h] = twin;
        }
        return true;
    }

    /// Flips the edge of a triangle that lessens the faults most. Returns by how much, 0 if no edge lessens them.
    [[nodiscard]] std::uint32_t improve(std::uint32_t t) noexcept
    {
        std::uint32_t best = none, gain = 0;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t g = twins_[h];
            if (g == none) continue;
            const std::uint32_t a = corner(h), b = corner(g), c = corner(after(after(h))), d = corner(after(after(g)));
            const std::uint32_t before = fault(triangles_[t]) + fault(triangles_[g / 3]);
            const std::uint32_t then = fault({a, d, c}) + fault({d, b, c});
            if (then < before && before - then > gain) {
                gain = before - then;
                best = h;
            }
        }
        if (best != none) flip(best);
        return gain;
    }

    /// The triangles a b c and b a d become a d c and d b c.
    void flip(std::uint32_t h) noexcept
    {
        const std::uint32_t g = twins_[h], t = h / 3, u = g / 3;
        const std::uint32_t a = corner(h), b = corner(g), c = corner(after(after(h))), d = corner(after(after(g)));
        const std::uint32_t bc = twins_[after(h)], ca = twins_[after(after(h))], ad = twins_[after(g)],
                            db = twins_[after(after(g))];
        triangles_[t] = {a, d, c};
        triangles_[u] = {d, b, c};
        pair(3 * t, ad);
        pair(3 * t + 1, 3 * u + 2);
        pair(3 * t + 2, ca);
        pair(3 * u, db);
        pair(3 * u + 1, bc);
    }
    void pair(std::uint32_t h, std::uint32_t g) noexcept
    {
        twins_[h] = g;
        if (g != none) twins_[g] = h;
    }

    const moving_points* points_ = nullptr;
    moving_stretch where_;
    array_view<triangle> triangles_;
    buffer<std::uint32_t> twins_, head_, next_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
