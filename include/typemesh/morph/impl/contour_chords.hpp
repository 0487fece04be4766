// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/morph/impl/morph_points.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Divides contours that cross themselves, such as a stroke that overlaps itself, into contours that do not:
///
///         ______________                 A chord joins two points of the contour, u and v. One piece goes from u to v
///        |   ______     |                and back along the chord, the other from v to u and back. The two ways along
///     ___|__|__u   |    |                the chord cancel, so the winding numbers of the pieces add up to those of
///    |   |  |      |    |                the contour: the pieces together fill what the contour fills. They overlap.
///    |___|__v______|    |
///        |______________|
///
/// Chords begin and end near crossings. A chord is chosen if it leaves fewest crossings, at all keys together; if none
/// leaves fewer than before, the contour stays as it is. This only proposes contours: the proof comes later.
class contour_chords {
public:
    explicit contour_chords(memory source = heap()) noexcept : pairs_{source}, piece_{source} {}

    /// Divides all contours of `points` that cross themselves at a key. Sets `changed` if there was one.
    ///
    /// Cost   O(n^2) for each crossing of a contour of n points, with a factor of about 50
    ///
    /// Fails  error::out_of_memory
    error divide(morph_points& points, const keyed_outlines& outlines, const grid& g, bool& changed) noexcept
    {
        changed = false;
        std::uint32_t pieces = 0;
        for (std::uint32_t c = 0; c < points.contours() && pieces < most_pieces;) {
            keys_ = points.places.size() / points.count();
            points_ = &points;
            const std::uint32_t first = points.starts[c], size = points.starts[c + 1] - first;
            std::uint32_t crossings = 0;
            pairs_.clear();
            if (!count(first, 0, size, size, crossings, true)) return error::out_of_memory;
            ends best;
            if (crossings == 0 || size > most_points || !find(first, size, crossings, best)) {
                ++c;
                continue;
            }
            if (error e = points.split(c, best.u, best.v)) return e;
            if (error e = points.place_all(outlines, g)) return e;
            changed = true;
            ++pieces;  // contour c is now the first piece
        }
        return {};
    }

private:
    static constexpr std::uint32_t most_pieces = 64;
    static constexpr std::uint32_t most_points = 1000;
    static constexpr std::uint32_t most_pairs = 24;

    struct ends {
        std::uint32_t u = 0, v = 0;
    };

    /// Tries chords near the crossings that were noted. Finds the one that leaves fewest.
    [[nodiscard]] bool find(std::uint32_t first, std::uint32_t size, std::uint32_t crossings, ends& best) noexcept
    {
        std::uint32_t fewest = crossings;
        for (const std::uint32_t reach : {1u, 3u}) {
            const std::uint32_t back = reach == 1 ? 0 : 1;
            for (std::size_t p = 0; p < pairs_.size() && p < most_pairs && fewest != 0; ++p)
                for (std::uint32_t i = 0; i <= reach; ++i)
                    for (std::uint32_t j = 0; j <= reach; ++j) {
                        std::uint32_t u = (pairs_[p].u + size + i - back) % size,
                                      v = (pairs_[p].v + size + j - back) % size;
                        if (u > v) {
                            const std::uint32_t other = u;
                            u = v;
                            v = other;
                        }
                        if (v - u < 2 || size - (v - u) < 2) continue;
                        std::uint32_t left = 0;
                        static_cast<void>(count(first, u, v - u + 1, size, left, false));
                        if (left >= fewest) continue;
                        static_cast<void>(count(first, v, size - (v - u) + 1, size, left, false));
                        if (left >= fewest) continue;
                        fewest = left;
                        best = {u, v};
                    }
            if (fewest < crossings) return true;
        }
        return false;
    }

    /// Adds the number of pairs of edges that meet, at all keys, in the closed piece of `length` points from `begin` of
    /// a contour. Notes the pairs on request; returns false when out of memory.
    [[nodiscard]] bool count(std::uint32_t first, std::uint32_t begin, std::uint32_t length, std::uint32_t size,
                             std::uint32_t& sum, bool noted) noexcept
    {
        const std::size_t n = points_->count();
        for (std::size_t k = 0; k < keys_; ++k) {
            piece_.clear();
            for (std::uint32_t i = 0; i <= length; ++i)
                if (!piece_.push_back(points_->places[k * n + first + (begin + i % length) % size])) return false;
            for (std::uint32_t i = 0; i < length; ++i)
                for (std::uint32_t j = i + 2; j < length; ++j) {
                    if ((i == 0 && j + 1 == length) || !meet(piece_[i], piece_[i + 1], piece_[j], piece_[j + 1]))
                        continue;
                    ++sum;
                    if (noted && !pairs_.push_back({i, j})) return false;
                }
        }
        return true;
    }

    /// Whether two edges have a point in common.
    static bool meet(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
    {
        const auto apart = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) noexcept {
            return (p > q ? p : q) < (r < s ? r : s) || (r > s ? r : s) < (p < q ? p : q);
        };
        if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
        const auto sides = [](std::int64_t p, std::int64_t q) noexcept {
            return (p > 0 && q > 0) || (p < 0 && q < 0);
        };
        return !sides(orientation(a, b, c), orientation(a, b, d)) && !sides(orientation(c, d, a), orientation(c, d, b));
    }

    const morph_points* points_ = nullptr;
    std::size_t keys_ = 0;
    buffer<ends> pairs_;
    buffer<grid_point> piece_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
