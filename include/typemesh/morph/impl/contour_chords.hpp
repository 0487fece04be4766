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
///     ___|__|__u   |    |                the chord cancel, so the winding numbers of the pieces add up to the one of
///    |   |  |      |    |                the contour: the pieces together fill what the contour fills. They overlap.
///    |___|__v______|    |
///        |______________|
///
/// Chords begin at the ends of edges that cross. A chord is chosen if it leaves fewest crossings, at all keys together,
/// and among those the shortest; if none leaves fewer than before, the contour stays as it is. So does a contour of too
/// many points, with too many crossings, or after too many comparisons. This only proposes contours: the proof comes
/// later.
class contour_chords {
public:
    static constexpr std::uint64_t usual_steps = 1u << 28;  // about a second

    explicit contour_chords(memory source = heap(), std::uint64_t max_steps = usual_steps) noexcept
        : max_steps_{max_steps}, pairs_{source}
    {
    }

    /// Divides all contours of `points` that cross themselves at a key. Sets `changed` if there was one.
    ///
    /// Cost   O((c + n) n c) for each chord, for c crossings of a contour of n points; at most `max_steps` comparisons
    ///        of two edges altogether
    ///
    /// Fails  error::out_of_memory
    error divide(morph_points& points, const keyed_outlines& outlines, const grid& g, bool& changed) noexcept
    {
        changed = false;
        steps_left_ = max_steps_;
        std::uint32_t pieces = 0;
        for (std::uint32_t c = 0; c < points.contours() && pieces < max_pieces;) {
            keys_ = points.places.size() / points.count();
            points_ = &points;
            const std::uint32_t first = points.starts[c], size = points.starts[c + 1] - first;
            pairs_.clear();
            if (size <= max_points && !note(first, size)) return error::out_of_memory;
            ends best;
            if (pairs_.empty() || pairs_.size() > max_pairs || !find(first, size, best)) {
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
    static constexpr std::uint32_t max_pieces = 64;
    static constexpr std::uint32_t max_points = 1000;
    static constexpr std::size_t max_pairs = 4096;  // of a contour that is worth dividing
    static constexpr std::size_t most_pairs = 256;  // more are not used as ends of chords

    struct ends {
        std::uint32_t u = 0, v = 0;
    };

    /// Notes the pairs of edges that meet, at each key, up to a few more than max_pairs.
    [[nodiscard]] bool note(std::uint32_t first, std::uint32_t size) noexcept
    {
        for (std::size_t k = 0; k < keys_; ++k)
            for (std::uint32_t i = 0; i < size && pairs_.size() <= max_pairs; ++i)
                for (std::uint32_t j = i + 2; j < size && takes_step(); ++j)
                    if (!(i == 0 && j + 1 == size) &&
                        meet(at(k, first, i), at(k, first, i + 1), at(k, first, j), at(k, first, (j + 1) % size)) &&
                        !pairs_.push_back({i, j}))
                        return false;
        return true;
    }
    [[nodiscard]] grid_point at(std::size_t key, std::uint32_t first, std::uint32_t i) const noexcept
    {
        return points_->places[key * points_->count() + first + i];
    }

    /// Finds the best chord from an end of a noted edge to any point.
    [[nodiscard]] bool find(std::uint32_t first, std::uint32_t size, ends& best) noexcept
    {
        std::size_t fewest = pairs_.size();
        std::int64_t shortest = 0;
        for (std::size_t p = 0; p < pairs_.size() && p < most_pairs; ++p)
            for (const std::uint32_t u : {pairs_[p].u, (pairs_[p].u + 1) % size, pairs_[p].v, (pairs_[p].v + 1) % size})
                for (std::uint32_t v = 0; v < size; ++v) {
                    if (steps_left_ == 0) return false;
                    const ends chord = u < v ? ends{u, v} : ends{v, u};
                    if (chord.v - chord.u < 2 || size - (chord.v - chord.u) < 2) continue;
                    const std::int64_t square = squared_distance(at(0, first, u), at(0, first, v));
                    const std::size_t left = crossings_with(chord, first, size, fewest);
                    if (left > fewest || (left == fewest && (square >= shortest || fewest == pairs_.size()))) continue;
                    fewest = left;
                    shortest = square;
                    best = chord;
                }
        return fewest < pairs_.size();
    }

    /// The number of crossings in the two pieces of a contour: pairs with both edges in one piece, and edges
    /// that meet the chord. The result is right up to `enough`.
    [[nodiscard]] std::size_t crossings_with(ends chord, std::uint32_t first, std::uint32_t size,
                                             std::size_t enough) noexcept
    {
        const auto is_between = [chord](std::uint32_t edge) noexcept { return edge >= chord.u && edge < chord.v; };
        std::size_t sum = 0;
        for (const ends& pair : pairs_) sum += is_between(pair.u) == is_between(pair.v) ? 1u : 0u;
        for (std::size_t k = 0; k < keys_; ++k) {
            const grid_point a = at(k, first, chord.u), b = at(k, first, chord.v);
            for (std::uint32_t i = 0; i < size && sum <= enough && takes_step(); ++i) {
                const std::uint32_t next = i + 1 == size ? 0 : i + 1;
                if (i == chord.u || i == chord.v || next == chord.u || next == chord.v) continue;
                sum += meet(a, b, at(k, first, i), at(k, first, next)) ? 1u : 0u;
            }
        }
        return sum;
    }

    /// Whether two edges have a point in common.
    static bool meet(grid_point a, grid_point b, grid_point c, grid_point d) noexcept
    {
        const auto apart = [](std::int32_t p, std::int32_t q, std::int32_t r, std::int32_t s) noexcept {
            return (p > q ? p : q) < (r < s ? r : s) || (r > s ? r : s) < (p < q ? p : q);
        };
        if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
        const auto sides = [](std::int64_t p, std::int64_t q) noexcept { return (p > 0 && q > 0) || (p < 0 && q < 0); };
        return !sides(orientation(a, b, c), orientation(a, b, d)) && !sides(orientation(c, d, a), orientation(c, d, b));
    }

    [[nodiscard]] bool takes_step() noexcept { return steps_left_ != 0 && --steps_left_ != 0; }

    const morph_points* points_ = nullptr;
    std::size_t keys_ = 0;
    std::uint64_t max_steps_, steps_left_ = 0;
    buffer<ends> pairs_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
