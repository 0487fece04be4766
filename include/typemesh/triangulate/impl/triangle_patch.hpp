// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/triangulate/impl/triangle_heights.hpp>
#include <typemesh/triangulate/impl/triangle_neighbours.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A polygon of adjacent triangles that grows triangle by triangle and is retriangulated in the best way.
///
///            c3 ------- c2            Corners are counter-clockwise. If the region's boundary visits a point twice
///           /  '-._    /  \           along the polygon, the point is two corners. A polygon with m corners has
///         c4        '-c0 -- c1        m - 2 triangles.
///
/// The levels of the triangles (see triangle_heights) decide which triangulation is best: the fewest of the lowest
/// triangles, then the fewest of the next level, and so on. Dynamic programming considers all triangulations: the best
/// one over corners i to j consists of the best over i to k, the best over k to j, and the triangle i k j between them,
/// for the best k. Triangles need only be counter-clockwise: if they fill in a polygon's corners, they then cover its
/// inside once.
///
/// Cost   examines at most m^3 / 6 triangles
/// From   G. Klincsek, Minimal triangulations of polygonal domains (1980)
class triangle_patch {
public:
    static constexpr std::uint32_t most = 32;  ///< corners: the counts of each level fit into 5 bits

    triangle_patch(array_view<const grid_point> points, array_view<triangle> triangles, const triangle_heights& heights,
                   triangle_neighbours& neighbours) noexcept
        : points_{points}, triangles_{triangles}, heights_{heights}, neighbours_{neighbours}
    {
    }

    struct outcome {
        bool improved;  ///< some triangles have changed
        bool clear;     ///< no examined triangle is low any more
    };

    /// Grows around triangle t, and retriangulates everything that can be improved, until no triangle in it is low.
    /// Subtracts the examined triangles from `looks` and ends when it is used up.
    [[nodiscard]] outcome raise(std::uint32_t t, std::int64_t& looks) noexcept
    {
        start(t);
        outcome found{false, false};
        for (std::uint32_t wanted = 4; looks > 0;
             wanted += 1 + wanted / 4) {  // corners: 4, 6, 8, 11, 14, 18, 23, 29, 32
            while (size_ < wanted && grow()) {
            }
            const std::uint64_t best = find_best(looks);
            if (best < cost_) {
                exchange();
                cost_ = best;
                found.improved = true;
            }
            found.clear = cost_ < std::uint64_t{1} << bits * (triangle_heights::low - 1);
            if (found.clear || size_ < wanted) break;
        }
        return found;
    }

private:
    static constexpr std::uint32_t bits = 5;
    static constexpr std::uint64_t impossible = ~std::uint64_t{0};
    static_assert((triangle_heights::levels - 1) * bits < 64 && most - 2 < 1u << bits);

    void start(std::uint32_t t) noexcept
    {
        size_ = 3;
        taken_[0] = t;
        for (std::uint32_t k = 0; k < 3; ++k) {
            place_[k] = points_[corner_[k] = neighbours_.origin(3 * t + k)];
            edge_[k] = 3 * t + k;
            closed_[k] = false;
        }
        cost_ = cost(place_[0], place_[1], place_[2], orientation(place_[0], place_[1], place_[2]));
    }

    /// Adds the triangle across the longest edge that has one. False if there is none, or no room.
    [[nodiscard]] bool grow() noexcept
    {
        for (;;) {
            std::uint32_t longest = size_;
            std::int64_t length = 0;
            for (std::uint32_t i = 0; i < size_ && size_ < most; ++i) {
                const std::int64_t here = squared_distance(place_[i], place_[i + 1 < size_ ? i + 1 : 0]);
                if (closed_[i] || here <= length) continue;
                length = here;
                longest = i;
            }
            if (longest == size_) return false;
            const std::uint32_t h = neighbours_.across(edge_[longest]);
            if (h != triangle_neighbours::none && !has(h / 3)) {
                take(longest, h);
                return true;
            }
            closed_[longest] = true;
        }
    }

    /// The number of triangles of each level except 0; the highest bits count the lowest triangles.
    [[nodiscard]] std::uint64_t cost(grid_point a, grid_point b, grid_point c, std::int64_t doubled_area) const noexcept
    {
        const std::uint32_t level = heights_.level(a, b, c, doubled_area);
        return level == 0 ? 0 : std::uint64_t{1} << bits * (level - 1);
    }

    [[nodiscard]] bool has(std::uint32_t t) const noexcept
    {
        for (std::uint32_t i = 0; i + 2 < size_; ++i)
            if (taken_[i] == t) return true;
        return false;
    }

    /// Adds the triangle of half-edge h, the twin of edge i of the polygon.
    void take(std::uint32_t i, std::uint32_t h) noexcept
    {
        for (std::uint32_t k = size_; k-- > i + 1;) {
            corner_[k + 1] = corner_[k];
            place_[k + 1] = place_[k];
            edge_[k + 1] = edge_[k];
            closed_[k + 1] = closed_[k];
        }
        const std::uint32_t onwards = triangle_neighbours::next(h), back = triangle_neighbours::previous(h);
        place_[i + 1] = points_[corner_[i + 1] = neighbours_.origin(back)];
        edge_[i] = onwards;
        edge_[i + 1] = back;
        closed_[i + 1] = false;
        taken_[size_ - 2] = h / 3;
        ++size_;
        const grid_point a = place_[i], b = place_[i + 1], c = place_[i + 2 < size_ ? i + 2 : 0];
        cost_ += cost(a, b, c, orientation(a, b, c));
    }

    [[nodiscard]] std::uint64_t find_best(std::int64_t& looks) noexcept
    {
        for (std::uint32_t i = 0; i + 1 < size_; ++i) best_[i][i + 1] = 0;
        for (std::uint32_t width = 2; width < size_; ++width) {
            for (std::uint32_t i = 0, j = width; j < size_; ++i, ++j) {
                std::uint64_t least = impossible;
                for (std::uint32_t k = i + 1; k < j && least != 0; ++k) {
                    if (best_[i][k] == impossible || best_[k][j] == impossible) continue;
                    std::uint64_t sum = best_[i][k] + best_[k][j];
                    if (sum >= least) continue;
                    --looks;
                    const std::int64_t turn = orientation(place_[i], place_[k], place_[j]);
                    if (turn <= 0) continue;
                    sum += cost(place_[i], place_[k], place_[j], turn);
                    if (sum >= least) continue;
                    least = sum;
                    apex_[i][j] = static_cast<std::uint8_t>(k);
                }
                best_[i][j] = least;
            }
        }
        return best_[0][size_ - 1];
    }

    /// Replaces the old triangles with the best ones.
    void exchange() noexcept
    {
        constexpr std::uint32_t none = triangle_neighbours::none;
        std::uint32_t outside[most],
            partner[most];  // across each edge; if that is an edge of this polygon, its number
        for (std::uint32_t i = 0; i < size_; ++i) {
            outside[i] = neighbours_.knows_all() ? neighbours_.across(edge_[i]) : none;
            partner[i] = size_;
            for (std::uint32_t k = 0; k < size_ && outside[i] != none; ++k)
                if (edge_[k] == outside[i]) partner[i] = k;
        }
        struct piece {
            std::uint32_t from, to, above;  // corners, and the half-edge of the triangle on the other side
        };
        piece pieces[most];
        pieces[0] = {0, size_ - 1, none};
        std::uint32_t made = 0;
        for (std::uint32_t left = 1; left != 0;) {
            const auto [i, j, above] = pieces[--left];
            const std::uint32_t k = apex_[i][j], first = 3 * taken_[made];
            triangles_[taken_[made++]] = {corner_[i], corner_[k], corner_[j]};
            if (above == none)
                edge_[size_ - 1] = first + 2;
            else
                neighbours_.join(first + 2, above);
            if (k == i + 1)
                edge_[i] = first;
            else
                pieces[left++] = {i, k, first};
            if (j == k + 1)
                edge_[k] = first + 1;
            else
                pieces[left++] = {k, j, first + 1};
        }
        for (std::uint32_t i = 0; i < size_; ++i)
            neighbours_.join(edge_[i], partner[i] < size_ ? edge_[partner[i]] : outside[i]);
    }

    array_view<const grid_point> points_;
    array_view<triangle> triangles_;
    const triangle_heights& heights_;
    triangle_neighbours& neighbours_;
    std::uint64_t cost_ = 0;
    std::uint32_t size_ = 0;
    std::uint32_t corner_[most];
    grid_point place_[most];
    std::uint32_t edge_[most];  // the inner half-edge from corner i to the next
    bool closed_[most];         // no triangle to add across this edge
    std::uint32_t taken_[most];
    std::uint64_t best_[most][most];
    std::uint8_t apex_[most][most];
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
