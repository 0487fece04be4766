// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/impl/profile_levels.hpp>
#include <typemesh/offset/swept_region.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The heights of a bevel at the levels of its sweep: how far it lies behind the front, or before the back, in the unit
/// of depths.
class swept_heights {
public:
    static constexpr std::uint32_t no_frame = ~std::uint32_t{0};

    /// `frame` is the first of the four edges around an outward bevel's surroundings, whose sweep takes the levels in
    /// reverse order; or no_frame.
    swept_heights(const profile_levels& profile, double rise, std::uint32_t frame = no_frame) noexcept
        : profile_{profile}, rise_{rise}, frame_{frame}
    {
    }

    /// The heights at which a band begins and ends.
    [[nodiscard]] double begin(std::uint32_t band) const noexcept
    {
        return behind(is_outward() ? at(band).arrives : at(band).leaves);
    }
    [[nodiscard]] double end(std::uint32_t band) const noexcept
    {
        return behind(is_outward() ? at(band + 1).leaves : at(band + 1).arrives);
    }
    /// The height of the riser at a level; 0 if there is none.
    [[nodiscard]] double riser(std::uint32_t level) const noexcept { return rise_ * at(level).riser(); }
    [[nodiscard]] bool is_outward() const noexcept { return frame_ != no_frame; }
    [[nodiscard]] bool is_frame(std::uint32_t edge) const noexcept
    {
        return is_outward() && edge >= frame_ && edge - frame_ < 4;
    }
    [[nodiscard]] std::uint32_t last() const noexcept { return static_cast<std::uint32_t>(profile_.view().size() - 1); }

private:
    [[nodiscard]] double behind(float share) const noexcept { return rise_ * (1.0 - as_double(share)); }
    [[nodiscard]] const profile_level& at(std::uint32_t level) const noexcept
    {
        return profile_.view()[is_outward() ? last() - level : level];
    }

    profile_levels profile_;
    double rise_;
    std::uint32_t frame_;
};

/// A point of a bevel: a grid point, and how far it lies behind the front or before the back, in the unit of depths.
struct raised_point {
    grid_point at;
    double behind;
};

/// Halves the edges of a bevel's triangles until none is too large for a measure: of its faces' triangles, and of the
/// upright faces on its levels. The edges of the region itself stay as they are; the cap gets the new points of its
/// edges.
///
///      ____________________          ____________________      in a map that bends along the text, the slopes on
///     |\__________________/|        |\__.____.____.____/|      upright edges are divided across, and those on level
///     | |                | |        |.\|                |.|    edges are divided along
///     | |                | |        | .|                | |
///
///     measure.slope(a, b, c)      the size of a triangle of three raised points
///     measure.turns(a, b, c)      whether it is too large although its size is not
///     measure.span(a, b)          for the choice: the edge of a triangle with the greatest span is halved
///     measure.upright(p, q, h)    the size of a face of height h on an edge, in the unit of depths
///     measure.outer(p, q)         the size of an edge at the end of an outward sweep, with its walls
///     measure.rim(p, q)           the size of an edge of a cap, which a cap's refiner will keep
///
/// Sizes above 1, and sizes that are not a number, are too large. The middle of an edge is rounded to the grid, in any
/// of four ways that keep all triangles counter-clockwise, and on the cap's edges beyond the cap, so that the cap stays
/// simple. Edges shorter than eight cells, and those that cannot be halved so, stay.
class bevel_bisection {
public:
    explicit bevel_bisection(memory source = heap()) noexcept
        : twins_{source},
          cells_{source},
          levels_{source},
          waiting_{source},
          sorted_{source},
          halved_{source},
          triangles_{source},
          edges_{source},
          points_{source},
          indices_{source}
    {
    }

    /// Divides the triangles of a sweep to the levels of `heights`.
    ///
    /// Fails  error::out_of_memory, error::too_many_points: more than max_points nodes
    template <class Measure>
    [[nodiscard]] error run(swept_region& swept, const swept_heights& heights, const Measure& measure,
                            std::uint32_t max_points) noexcept
    {
        if (swept.triangles.empty()) return {};
        swept_ = &swept;
        heights_ = &heights;
        if (!open()) return error::out_of_memory;
        while (!waiting_.empty()) {
            const std::uint32_t t = waiting_.back();
            waiting_.truncate(waiting_.size() - 1);
            if (!halve_within(measure, t)) return error::out_of_memory;
            if (!halved_.empty() && swept.nodes.size() > max_points) return {error::too_many_points, max_points};
        }
        if (halved_.empty() && !has_flipped_) return {};
        std::sort(halved_.begin(), halved_.end(), [](const half& a, const half& b) noexcept { return a.key < b.key; });
        return sort_cells() && divide_levels() && divide_cap() ? error{} : error{error::out_of_memory};
    }

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    static constexpr std::uint32_t fixed = none - 1;  ///< instead of a twin: an edge that cannot be halved

    struct keyed {
        std::uint64_t key;  ///< of an edge's two nodes
        std::uint32_t h;
    };
    struct half {
        std::uint64_t key;
        std::uint32_t middle;
    };

    [[nodiscard]] static std::uint64_t key_of(std::uint32_t a, std::uint32_t b) noexcept
    {
        return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
    }
    [[nodiscard]] static std::uint32_t next(std::uint32_t h) noexcept { return h % 3 == 2 ? h - 2 : h + 1; }
    [[nodiscard]] std::uint32_t& origin(std::uint32_t h) noexcept
    {
        triangle& t = swept_->triangles[h / 3];
        return h % 3 == 0 ? t.a : h % 3 == 1 ? t.b : t.c;
    }
    [[nodiscard]] grid_point place(std::uint32_t node) const noexcept { return swept_->nodes[node].at; }
    [[nodiscard]] const swept_cell& cell_of(std::uint32_t t) const noexcept { return swept_->cells[cells_[t]]; }

    /// Finds each triangle's cell, each node's level, and the triangles that share edges.
    [[nodiscard]] bool open() noexcept
    {
        const auto count = static_cast<std::uint32_t>(swept_->triangles.size());
        for (auto* all : {&twins_, &cells_, &levels_, &waiting_}) all->clear();
        halved_.clear();
        has_flipped_ = false;
        if (twins_.append(3 * std::size_t{count}) == nullptr || cells_.append(count) == nullptr ||
            levels_.append(swept_->nodes.size()) == nullptr || !waiting_.reserve(count))
            return false;
        for (std::uint32_t c = 0; c + 1 < swept_->cells.size(); ++c)
            for (std::uint32_t t = swept_->cells[c].first_triangle; t < swept_->cells[c + 1].first_triangle; ++t) {
                cells_[t] = c;
                if (!heights_->is_frame(swept_->cells[c].edge)) waiting_.push_back_unchecked(t);
            }
        for (std::uint32_t& level : levels_) level = none;
        for (std::uint32_t k = 0; k + 1 < swept_->at_level.size(); ++k)
            for (std::uint32_t i = swept_->at_level[k]; i < swept_->at_level[k + 1]; ++i)
                levels_[swept_->edges_at[i].a] = levels_[swept_->edges_at[i].b] = k;
        return find_twins();
    }

    [[nodiscard]] bool find_twins() noexcept
    {
        sorted_.clear();
        const auto count = static_cast<std::uint32_t>(twins_.size());
        if (!sorted_.reserve(count)) return false;
        for (std::uint32_t h = 0; h < count; ++h) sorted_.push_back_unchecked({key_of(origin(h), origin(next(h))), h});
        std::sort(sorted_.begin(), sorted_.end(),
                  [](const keyed& a, const keyed& b) noexcept { return a.key != b.key ? a.key < b.key : a.h < b.h; });
        for (std::size_t i = 0, end = 0; i < count; i = end) {
            for (end = i + 1; end < count && sorted_[end].key == sorted_[i].key;) ++end;
            const std::uint32_t h = sorted_[i].h, other = sorted_[end - 1].h;
            if (end - i == 2 && origin(h) != origin(other)) {
                twins_[h] = other;
                twins_[other] = h;
            } else {
                for (std::size_t k = i; k < end; ++k) twins_[sorted_[k].h] = end - i == 1 && is_rim(h) ? none : fixed;
            }
        }
        return true;
    }

    /// Whether both ends of an edge lie on the last level.
    [[nodiscard]] bool is_rim(std::uint32_t h) noexcept
    {
        const std::uint32_t last = heights_->last();
        return levels_[origin(h)] == last && levels_[origin(next(h))] == last;
    }

    [[nodiscard]] raised_point raised(std::uint32_t node, std::uint32_t band) const noexcept
    {
        const double from = swept_->levels[band], to = swept_->levels[band + 1], low = heights_->begin(band),
                     high = heights_->end(band);
        const double share = levels_[node] == band ? 0.0
                             : levels_[node] == band + 1
                                 ? 1.0
                                 : (as_double(swept_->nodes[node].distance) - from) / (to - from);
        return {place(node), low + (share < 0.0 ? 0.0 : share > 1.0 ? 1.0 : share) * (high - low)};
    }

    /// The size of what else lies on an edge of a triangle.
    template <class Measure>
    [[nodiscard]] bool is_level_too_large(const Measure& measure, std::uint32_t h) noexcept
    {
        const std::uint32_t a = origin(h), b = origin(next(h)), level = levels_[a];
        if (level == none || level != levels_[b] || level == 0) return false;
        const grid_point p = place(a), q = place(b);
        const double riser = heights_->riser(level);
        if (riser > 0.0 && !(measure.upright(p, q, riser) <= 1.0)) return true;
        if (twins_[h] != none) return false;
        return !(measure.rim(p, q) <= 1.0) || (heights_->is_outward() && !(measure.outer(p, q) <= 1.0));
    }

    /// Halves an edge of a triangle if it is too large. False if out of memory.
    template <class Measure>
    [[nodiscard]] bool halve_within(const Measure& measure, std::uint32_t t) noexcept
    {
        bool fits = true;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
            if (twins_[h] != fixed && is_level_too_large(measure, h) && halve(h, fits)) return fits;
        const std::uint32_t band = cell_of(t).band;
        const raised_point corners[] = {raised(origin(3 * t), band), raised(origin(3 * t + 1), band),
                                        raised(origin(3 * t + 2), band)};
        const double size = measure.slope(corners[0], corners[1], corners[2]);
        if (size <= 1.0 && !measure.turns(corners[0], corners[1], corners[2])) return true;
        double spans[3];
        for (std::uint32_t k = 0; k < 3; ++k)
            spans[k] = twins_[3 * t + k] == fixed ? -1.0 : measure.span(corners[k], corners[(k + 1) % 3]);
        // Beside an edge that stays and is small enough, another one is not much smaller.
        const double least = 0x1p-6 * size;
        for (;;) {
            const std::uint32_t k = spans[0] >= spans[1] && spans[0] >= spans[2] ? 0 : spans[1] >= spans[2] ? 1 : 2;
            const std::uint32_t h = 3 * t + k;
            if (!(spans[k] > 0.0) || spans[k] < least) return true;
            // A thin triangle that turns would need many points.
            if ((size <= 1.0 && is_thin(h) && flip(h, fits)) || halve(h, fits) || flip(h, fits)) return fits;
            spans[k] = -1.0;
        }
    }

    /// Whether the corner opposite to an edge is less than 16 cells away from it.
    [[nodiscard]] bool is_thin(std::uint32_t h) noexcept
    {
        const grid_point p = place(origin(h)), q = place(origin(next(h))), r = place(origin(next(next(h))));
        const auto area = static_cast<double>(orientation(p, q, r));
        return area * area < 256.0 * static_cast<double>(squared_distance(p, q));
    }

    /// Whether an edge has been halved. `fits` becomes false if out of memory.
    [[nodiscard]] bool halve(std::uint32_t h, bool& fits) noexcept
    {
        const std::uint32_t a = origin(h), b = origin(next(h)), other = twins_[h];
        const grid_point p = place(a), q = place(b), r = place(origin(next(next(h))));
        if (squared_distance(p, q) < 64) return false;
        const grid_point s = other == none ? grid_point{} : place(origin(next(next(other))));
        for (std::int64_t way = 0; way < 4; ++way) {
            const grid_point m{static_cast<std::int32_t>((std::int64_t{p.x} + q.x + way % 2) >> 1),
                               static_cast<std::int32_t>((std::int64_t{p.y} + q.y + way / 2) >> 1)};
            if (orientation(p, m, r) <= 0 || orientation(m, q, r) <= 0) continue;
            if (other == none ? orientation(p, q, m) < 0 : orientation(q, m, s) <= 0 || orientation(m, p, s) <= 0)
                continue;
            fits = put_in(h, m);
            return true;
        }
        return false;
    }

    /// Puts a node on an edge. False if out of memory.
    [[nodiscard]] bool put_in(std::uint32_t h, grid_point at) noexcept
    {
        const std::uint32_t a = origin(h), b = origin(next(h)), other = twins_[h];
        const auto m = static_cast<std::uint32_t>(swept_->nodes.size());
        const double distance = 0.5 * (as_double(swept_->nodes[a].distance) + as_double(swept_->nodes[b].distance));
        if (!swept_->nodes.push_back({at, static_cast<float>(distance)}) ||
            !levels_.push_back(levels_[a] == levels_[b] ? levels_[a] : none) || !halved_.push_back({key_of(a, b), m}))
            return false;
        const std::uint32_t first = split(h, m);
        if (first == none) return false;
        if (other == none) {
            twins_[h] = twins_[first] = none;
            return true;
        }
        const std::uint32_t second = split(other, m);
        if (second == none) return false;
        connect(h, second);
        connect(first, other);
        return true;
    }

    /// Divides the triangle of h from the corner opposite to h to the node m on h. Returns the second half of h, whose
    /// twin is not known yet; none if out of memory.
    ///
    ///           c
    ///          /|\        h becomes a -> m
    ///         / | \       the new triangle is m, b, c
    ///        a--m--b
    [[nodiscard]] std::uint32_t split(std::uint32_t h, std::uint32_t m) noexcept
    {
        const std::uint32_t t = h / 3, side = next(h), b = origin(side), c = origin(next(side)), twin = twins_[side];
        const auto made = static_cast<std::uint32_t>(swept_->triangles.size());
        const bool measured = !heights_->is_frame(cell_of(t).edge);
        if (!swept_->triangles.push_back({m, b, c}) || !cells_.push_back(cells_[t]) || twins_.append(3) == nullptr ||
            (measured && (!waiting_.push_back(t) || !waiting_.push_back(made))))
            return none;
        origin(side) = m;
        connect(3 * made + 1, twin);
        connect(3 * made + 2, side);
        return 3 * made;
    }
    /// Replaces an edge by the other diagonal of its two triangles, if that is the Delaunay one: for triangles that
    /// turn, or are so thin that no grid point lies inside. Both then belong to the larger one's face. Whether it has
    /// been replaced; `fits` becomes false if out of memory.
    [[nodiscard]] bool flip(std::uint32_t h, bool& fits) noexcept
    {
        const std::uint32_t g = twins_[h], t = h / 3, u = g / 3;
        if (g == none || cell_of(t).band != cell_of(u).band || heights_->is_frame(cell_of(u).edge)) return false;
        const std::uint32_t a = origin(h), b = origin(g), c = origin(next(next(h))), d = origin(next(next(g)));
        if (levels_[a] != none && levels_[a] == levels_[b]) return false;
        if (levels_[c] != none && levels_[c] == levels_[d]) return false;  // the new edge would be one of a level
        const grid_point p = place(a), q = place(b), r = place(c), s = place(d);
        if (orientation(p, s, r) <= 0 || orientation(s, q, r) <= 0 || in_circle(p, q, r, s) <= 0) return false;
        cells_[t] = cells_[u] = orientation(p, q, r) > orientation(q, p, s) ? cells_[t] : cells_[u];
        const std::uint32_t bc = twins_[next(h)], ca = twins_[next(next(h))], ad = twins_[next(g)],
                            db = twins_[next(next(g))];
        swept_->triangles[t] = {c, a, d};
        swept_->triangles[u] = {d, b, c};
        connect(3 * t, ca);
        connect(3 * t + 1, ad);
        connect(3 * t + 2, 3 * u + 2);
        connect(3 * u, db);
        connect(3 * u + 1, bc);
        has_flipped_ = true;
        fits = waiting_.push_back(t) && waiting_.push_back(u);
        return true;
    }
    void connect(std::uint32_t h, std::uint32_t twin) noexcept
    {
        twins_[h] = twin;
        if (twin != none && twin != fixed) twins_[twin] = h;
    }

    // --- afterwards, `halved_` is sorted by its keys

    /// Calls take(node) for each node that now lies on an edge from a to b, and then for b. False as soon as take() is.
    template <class Take>
    [[nodiscard]] bool each_on(std::uint32_t a, std::uint32_t b, const Take& take) const noexcept
    {
        const std::uint64_t key = key_of(a, b);
        const half* const found = std::lower_bound(halved_.begin(), halved_.end(), key,
                                                   [](const half& x, std::uint64_t k) noexcept { return x.key < k; });
        if (found == halved_.end() || found->key != key) return take(b);
        return each_on(a, found->middle, take) && each_on(found->middle, b, take);
    }

    /// Puts the triangles into the order of their cells.
    [[nodiscard]] bool sort_cells() noexcept
    {
        auto& cells = swept_->cells;
        triangles_.clear();
        indices_.clear();
        if (triangles_.append(cells_.size()) == nullptr || indices_.append(cells.size()) == nullptr) return false;
        for (std::uint32_t& n : indices_) n = 0;
        for (const std::uint32_t c : cells_) ++indices_[c];
        std::uint32_t first = 0;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            cells[c].first_triangle = first;
            const std::uint32_t count = indices_[c];
            indices_[c] = first;
            first += count;
        }
        for (std::size_t t = 0; t < cells_.size(); ++t) triangles_[indices_[cells_[t]]++] = swept_->triangles[t];
        swept_->triangles.swap(triangles_);
        return true;
    }

    [[nodiscard]] bool divide_levels() noexcept
    {
        edges_.clear();
        std::uint32_t begin = 0;
        for (std::size_t k = 0; k + 1 < swept_->at_level.size(); ++k) {
            const std::uint32_t end = swept_->at_level[k + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                swept_edge_at last = swept_->edges_at[i];
                if (!each_on(last.a, last.b, [&](std::uint32_t node) noexcept {
                        last.b = node;
                        const bool kept = edges_.push_back(last);
                        last.a = node;
                        return kept;
                    }))
                    return false;
            }
            begin = end;
            swept_->at_level[k + 1] = static_cast<std::uint32_t>(edges_.size());
        }
        swept_->edges_at.swap(edges_);
        return true;
    }

    [[nodiscard]] bool divide_cap() noexcept
    {
        contours& cap = swept_->cap;
        points_.clear();
        indices_.clear();
        for (std::uint32_t k = 0, begin = 0; k < cap.contour_count(); ++k) {
            const std::uint32_t end = cap.starts[k + 1];
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t from = swept_->cap_nodes[i], to = swept_->cap_nodes[i + 1 == end ? begin : i + 1];
                std::uint32_t last = from;
                if (!each_on(from, to, [&](std::uint32_t node) noexcept {
                        const bool kept = indices_.push_back(last) && points_.push_back(place(last));
                        last = node;
                        return kept;
                    }))
                    return false;
            }
            begin = end;
            cap.starts[k + 1] = static_cast<std::uint32_t>(points_.size());
        }
        for (std::size_t i = cap.edges.size(); i < points_.size(); ++i)
            if (!cap.edges.push_back({})) return false;
        cap.points.swap(points_);
        swept_->cap_nodes.swap(indices_);
        cap.forget_order();
        return true;
    }

    buffer<std::uint32_t> twins_;    // of each half-edge
    buffer<std::uint32_t> cells_;    // of each triangle
    buffer<std::uint32_t> levels_;   // of each node; none: it lies between two levels
    buffer<std::uint32_t> waiting_;  // triangles
    buffer<keyed> sorted_;
    buffer<half> halved_;
    buffer<triangle> triangles_;
    buffer<swept_edge_at> edges_;
    buffer<grid_point> points_;
    buffer<std::uint32_t> indices_;
    swept_region* swept_ = nullptr;
    const swept_heights* heights_ = nullptr;
    bool has_flipped_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
