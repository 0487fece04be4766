// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/in_circle.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/refine/impl/row_walk.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Squares that cover the plane, smaller ones where edges come close to each other. The largest squares, the *roots*,
/// lie at multiples of their width. A square is split into four; those that are not split are the *leaves*.
///
///     +-------+-------+      Leaves that share a part of a side differ at most by a factor of two: before a square is
///     |       |       |      split, each of its four neighbours is split until it is as small.
///     |       |       |
///     |       +---+---+      Only roots near an edge, and roots that are split, are stored. All others are leaves.
///     |       |   |   |
///     +-------+---+---+      Each leaf lists the edges that may pass within a quarter of its width.
///
/// It keeps its memory for the next use.
///
/// Cost   O(1) on average for each leaf that is looked up, and for each leaf near an edge
/// From   M. de Berg et al., Computational Geometry, chapter 14; M. Bern, D. Eppstein & J. Gilbert, Provably good mesh
///        generation (1994)
class balanced_quadtree {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    static constexpr std::int32_t least_width = 16;  ///< of a leaf, in cells of the grid, unless the roots are smaller
    static constexpr std::uint32_t max_levels = 6;   ///< below the roots

    /// How far a refinement's points keep from the outline, and on the outline from each other: two fifths of a
    /// square's width.
    [[nodiscard]] static std::int64_t clearance(std::int64_t width) noexcept { return 2 * width / 5; }

    /// A square, in squares of its own width from 0. The roots have level 0.
    struct square {
        std::int32_t column, row;
        std::uint32_t level;
        std::uint32_t first_child = none;  ///< the lower left one; then lower right, upper left, upper right
        std::uint32_t first_entry = none;  ///< of the list of edges
    };

    explicit balanced_quadtree(memory source = heap()) noexcept
        : squares_{source}, roots_{source}, edges_{source}, entries_{source}
    {
    }

    /// Begins anew, with roots of this width or up to a 64th less: their width is divisible by the smallest leaf's.
    void open(std::int32_t width) noexcept
    {
        squares_.clear();
        roots_.clear();
        root_count_ = 0;
        forget_edges();
        deepest_ = 0;
        while (deepest_ < max_levels && width >> (deepest_ + 1) >= least_width) ++deepest_;
        width_ = width >> deepest_ << deepest_;
    }

    [[nodiscard]] std::int32_t width(std::uint32_t level) const noexcept { return width_ >> level; }
    [[nodiscard]] std::uint32_t deepest() const noexcept { return deepest_; }
    [[nodiscard]] std::uint32_t square_count() const noexcept { return static_cast<std::uint32_t>(squares_.size()); }
    [[nodiscard]] const square& at(std::uint32_t n) const noexcept { return squares_[n]; }
    [[nodiscard]] bool is_leaf(std::uint32_t n) const noexcept { return squares_[n].first_child == none; }

    /// The lower left corner of a stored square.
    [[nodiscard]] grid_point corner(std::uint32_t n) const noexcept
    {
        const square& q = squares_[n];
        return {q.column * width(q.level), q.row * width(q.level)};
    }

    // ---- leaves

    /// The stored leaf that holds a place; none if a root holds it that is not stored. Squares hold their left and
    /// lower sides.
    [[nodiscard]] std::uint32_t leaf_at(std::int64_t x, std::int64_t y) const noexcept
    {
        std::uint32_t n =
            find_root(static_cast<std::int32_t>(divided(x, width_)), static_cast<std::int32_t>(divided(y, width_)));
        while (n != none && !is_leaf(n)) {
            const square& q = squares_[n];
            const std::int64_t half = width(q.level + 1), column = 2 * std::int64_t{q.column} + 1,
                               row = 2 * std::int64_t{q.row} + 1;
            n = q.first_child + (x >= column * half ? 1u : 0u) + (y >= row * half ? 2u : 0u);
        }
        return n;
    }
    [[nodiscard]] std::uint32_t level_at(std::int64_t x, std::int64_t y) const noexcept
    {
        const std::uint32_t n = leaf_at(x, y);
        return n == none ? 0 : squares_[n].level;
    }

    /// Whether the square of this level at this place is stored and split.
    [[nodiscard]] bool is_split(std::uint32_t level, std::int32_t column, std::int32_t row) const noexcept
    {
        std::uint32_t n = find_root(column >> level, row >> level);
        for (std::uint32_t l = 0; n != none && !is_leaf(n); ++l) {
            if (l == level) return true;
            n = child_towards(n, level - l - 1, column, row);
        }
        return false;
    }

    /// Splits a leaf, and larger ones around it. Precondition: its level is less than deepest(). False if out of
    /// memory.
    [[nodiscard]] bool split(std::uint32_t n) noexcept
    {
        const square q = squares_[n];
        if (q.level > 0)
            for (const int side : {0, 1, 2, 3})
                if (!store(q.level, q.column + (side == 0) - (side == 1), q.row + (side == 2) - (side == 3)))
                    return false;
        const std::uint32_t first = square_count();
        square* const four = squares_.append(4);
        if (four == nullptr) return false;
        for (const int k : {0, 1, 2, 3})
            four[k] = {2 * q.column + (k & 1), 2 * q.row + (k >> 1), q.level + 1, none, none};
        squares_[n].first_child = first;
        squares_[n].first_entry = none;
        for (std::uint32_t e = q.first_entry; e != none; e = entries_[e].next)
            for (std::uint32_t k = 0; k < 4; ++k)
                if (!list(first + k, entries_[e].edge)) return false;
        return true;
    }

    /// Stores the root that holds a place. Returns none if out of memory.
    [[nodiscard]] std::uint32_t root_at(grid_point p) noexcept
    {
        return make_root(static_cast<std::int32_t>(divided(p.x, width_)),
                         static_cast<std::int32_t>(divided(p.y, width_)));
    }

    // ---- edges

    /// Lists an edge from one point to the next, which have numbers. Its left side is inside. False if out of memory.
    [[nodiscard]] bool add_edge(grid_point a, grid_point b, std::uint32_t from, std::uint32_t to) noexcept
    {
        const auto number = static_cast<std::uint32_t>(edges_.size());
        if (!edges_.push_back({a, b, from, to})) return false;
        const grid_point ends[] = {a, b};
        return each_root(ends, margin_of(width_), [&](std::int32_t column, std::int32_t row) noexcept {
            const std::uint32_t n = make_root(column, row);
            return n != none && list(n, number);
        });
    }

    /// Removes all edges, and leaves the squares as they are.
    void forget_edges() noexcept
    {
        for (square& q : squares_) q.first_entry = none;
        edges_.clear();
        entries_.clear();
    }

    /// Splits leaves while, in one, two edges that share no point come closer to each other than a third of its width,
    /// as seen from inside, or while it has more than max_edges. The smallest leaves stay.
    ///
    /// False if out of memory, or if there would be more than `most` squares.
    [[nodiscard]] bool split_crowded(std::size_t most) noexcept
    {
        for (std::uint32_t n = 0; n < square_count(); ++n) {
            if (square_count() > most) return false;
            if (is_leaf(n) && squares_[n].level < deepest_ && is_crowded(n) && !split(n)) return false;
        }
        return true;
    }

    /// Whether an edge comes closer to a corner of leaves than the clearance of the smallest leaf there.
    [[nodiscard]] bool is_close(grid_point p) const noexcept
    {
        std::uint32_t around[4];
        std::uint32_t level = 0;
        bool has_edges = false;
        for (const int k : {0, 1, 2, 3}) {
            around[k] = leaf_at(std::int64_t{p.x} - (k & 1), std::int64_t{p.y} - (k >> 1));
            if (around[k] == none) continue;
            const square& q = squares_[around[k]];
            level = q.level > level ? q.level : level;
            has_edges = has_edges || q.first_entry != none;
        }
        if (!has_edges) return false;
        for (const std::uint32_t n : around)
            if (n != none)
                for (std::uint32_t e = squares_[n].first_entry; e != none; e = entries_[e].next)
                    if (is_within(clearance(width(level)), p, edges_[entries_[e].edge])) return true;
        return false;
    }

    // ---- corners

    /// Calls put(corner) for the corners of all leaves that lie in a triangle (counter-clockwise) or on its sides, each
    /// once, until put() returns false; with `old` squares given, only those that newer squares have added, though
    /// perhaps with others. Returns its last result.
    template <class Put>
    [[nodiscard]] bool each_corner(const grid_point (&in)[3], std::uint32_t old, Put&& put) const noexcept
    {
        return each_root(in, 0, [&](std::int32_t column, std::int32_t row) noexcept {
            const grid_point p{column * width_, row * width_};
            if (old == 0 && holds(in, p) && !put(p)) return false;
            const std::uint32_t n = find_root(column, row);
            return n == none || each_corner_below(n, in, old, put);
        });
    }

    /// The quotient, rounded down.
    [[nodiscard]] static std::int64_t divided(std::int64_t v, std::int64_t by) noexcept
    {
        return v / by - (v % by < 0 ? 1 : 0);
    }

private:
    static constexpr std::size_t max_edges = 12;  // of a leaf that need not be split: all pairs of them are compared
    static constexpr std::int64_t crowding = 3;   // edges nearer than this part of a leaf's width need smaller leaves

    /// How far around a square edges are listed.
    [[nodiscard]] static std::int64_t margin_of(std::int64_t width) noexcept { return width / 4; }

    struct edge {
        grid_point a, b;
        std::uint32_t from, to;
    };
    struct entry {
        std::uint32_t edge;
        std::uint32_t next;
    };
    struct box {
        std::int64_t left, bottom, right, top;
    };

    [[nodiscard]] box box_of(std::uint32_t n, std::int64_t margin) const noexcept
    {
        const grid_point p = corner(n);
        const std::int64_t side = width(squares_[n].level);
        return {p.x - margin, p.y - margin, p.x + side + margin, p.y + side + margin};
    }

    // ---- roots: a hash table of open addresses

    [[nodiscard]] std::size_t address_of(std::int32_t column, std::int32_t row) const noexcept
    {
        const std::uint64_t both =
            std::uint64_t{static_cast<std::uint32_t>(column)} << 32 | static_cast<std::uint32_t>(row);
        return std::size_t{static_cast<std::uint32_t>((both * 0x9E37'79B9'7F4A'7C15u) >> 32)} & (roots_.size() - 1);
    }
    [[nodiscard]] std::uint32_t find_root(std::int32_t column, std::int32_t row) const noexcept
    {
        if (roots_.empty()) return none;
        for (std::size_t i = address_of(column, row);; i = (i + 1) & (roots_.size() - 1)) {
            const std::uint32_t n = roots_[i];
            if (n == none || (squares_[n].column == column && squares_[n].row == row)) return n;
        }
    }
    [[nodiscard]] std::uint32_t make_root(std::int32_t column, std::int32_t row) noexcept
    {
        if (const std::uint32_t found = find_root(column, row); found != none) return found;
        if (2 * root_count_ >= roots_.size()) {
            const std::size_t size = roots_.empty() ? 64 : 2 * roots_.size();
            roots_.clear();
            std::uint32_t* const all = roots_.append(size);
            if (all == nullptr) return none;
            for (std::size_t i = 0; i < size; ++i) all[i] = none;
            for (std::uint32_t n = 0; n < square_count(); ++n)
                if (squares_[n].level == 0) enter_root(n);
        }
        const std::uint32_t n = square_count();
        if (!squares_.push_back({column, row, 0, none, none})) return none;
        ++root_count_;
        enter_root(n);
        return n;
    }
    void enter_root(std::uint32_t n) noexcept
    {
        std::size_t i = address_of(squares_[n].column, squares_[n].row);
        while (roots_[i] != none) i = (i + 1) & (roots_.size() - 1);
        roots_[i] = n;
    }

    /// The child of a split square in which a square lies that is `deeper` levels below the child.
    [[nodiscard]] std::uint32_t child_towards(std::uint32_t n, std::uint32_t deeper, std::int32_t column,
                                              std::int32_t row) const noexcept
    {
        return squares_[n].first_child + static_cast<std::uint32_t>((column >> deeper) & 1) +
               2 * static_cast<std::uint32_t>((row >> deeper) & 1);
    }

    /// Splits until the square of this level at this place is stored. False if out of memory.
    [[nodiscard]] bool store(std::uint32_t level, std::int32_t column, std::int32_t row) noexcept
    {
        std::uint32_t n = make_root(column >> level, row >> level);
        if (n == none) return false;
        for (std::uint32_t l = 0; l < level; ++l) {
            if (is_leaf(n) && !split(n)) return false;
            n = child_towards(n, level - l - 1, column, row);
        }
        return true;
    }

    // ---- edges

    /// Lists an edge in the leaves of a square. False if out of memory.
    [[nodiscard]] bool list(std::uint32_t n, std::uint32_t number) noexcept
    {
        const edge& e = edges_[number];
        const grid_point ends[] = {e.a, e.b};
        if (is_apart(box_of(n, margin_of(width(squares_[n].level))), ends)) return true;
        if (is_leaf(n)) {
            if (!entries_.push_back({number, squares_[n].first_entry})) return false;
            squares_[n].first_entry = static_cast<std::uint32_t>(entries_.size() - 1);
            return true;
        }
        const std::uint32_t first = squares_[n].first_child;
        for (std::uint32_t k = 0; k < 4; ++k)
            if (!list(first + k, number)) return false;
        return true;
    }

    /// Whether a box and a segment, or a box and a triangle (counter-clockwise), have no point in common.
    template <std::size_t count>
    [[nodiscard]] static bool is_apart(const box& in, const grid_point (&corners)[count]) noexcept
    {
        bool left = true, right = true, below = true, above = true;
        for (const grid_point c : corners) {
            left = left && c.x < in.left;
            right = right && c.x > in.right;
            below = below && c.y < in.bottom;
            above = above && c.y > in.top;
        }
        if (left || right || below || above) return true;
        // All of the box lies on the right of a side; of a segment the two sides are the two directions.
        for (std::size_t i = 0; i < count; ++i) {
            const grid_point s = corners[i], e = corners[i + 1 < count ? i + 1 : 0];
            const std::int64_t dx = std::int64_t{e.x} - s.x, dy = std::int64_t{e.y} - s.y;
            const std::int64_t x = dy > 0 ? in.left : in.right,
                               y = dx > 0 ? in.top : in.bottom;  // farthest to the left
            if (dx * (y - s.y) - dy * (x - s.x) < 0) return true;
        }
        return false;
    }

    /// Whether a place is closer to an edge than a distance. Exact. Budget: distance <= 2^28, see orientation() for the
    /// places.
    [[nodiscard]] static bool is_within(std::int64_t distance, grid_point p, const edge& e) noexcept
    {
        const std::int64_t dx = std::int64_t{e.b.x} - e.a.x, dy = std::int64_t{e.b.y} - e.a.y,
                           px = std::int64_t{p.x} - e.a.x, py = std::int64_t{p.y} - e.a.y;
        const std::int64_t along = dx * px + dy * py, length = dx * dx + dy * dy, within = distance * distance;
        if (along <= 0) return px * px + py * py < within;
        if (along >= length) return squared_distance(p, e.b) < within;
        const std::int64_t across = dx * py - dy * px;
        return static_cast<std::int64_t>(sum_of_products(across, across, 0, 0, within, length).high) < 0;
    }

    /// The part of an edge in a box that it passes through, each end moved by up to a cell.
    static void clip(const box& to, edge& e) noexcept
    {
        const auto cut = [](grid_point& end, grid_point other, const box& b) noexcept {
            const std::int64_t dx = std::int64_t{other.x} - end.x, dy = std::int64_t{other.y} - end.y;
            if (dx != 0 && (end.x < b.left || end.x > b.right)) {
                const std::int64_t x = end.x < b.left ? b.left : b.right;
                end = {static_cast<std::int32_t>(x), static_cast<std::int32_t>(end.y + (x - end.x) * dy / dx)};
            }
            if (dy != 0 && (end.y < b.bottom || end.y > b.top)) {
                const std::int64_t y = end.y < b.bottom ? b.bottom : b.top;
                end = {static_cast<std::int32_t>(end.x + (y - end.y) * dx / dy), static_cast<std::int32_t>(y)};
            }
        };
        const grid_point a = e.a;
        cut(e.a, e.b, to);
        cut(e.b, a, to);
    }

    [[nodiscard]] bool is_crowded(std::uint32_t n) const noexcept
    {
        edge in_it[max_edges], part[max_edges];
        std::size_t count = 0;
        const std::int64_t side = width(squares_[n].level);
        const box around = box_of(n, margin_of(side));
        for (std::uint32_t e = squares_[n].first_entry; e != none; e = entries_[e].next) {
            if (count == max_edges) return true;
            in_it[count] = part[count] = edges_[entries_[e].edge];
            clip(around, part[count++]);
        }
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < count; ++k) {
                const edge &e = in_it[i], &f = in_it[k];
                if (i == k || e.to == f.from || f.to == e.from) continue;
                for (const grid_point p : {part[i].a, part[i].b})
                    if (orientation(f.a, f.b, p) > 0 && is_within(side / crowding, p, f)) return true;
            }
        }
        return false;
    }

    // ---- walks

    /// The places of the roots for walk_rows(): those that come closer to a shape than a margin.
    struct root_squares {
        std::int64_t width, margin;

        [[nodiscard]] interval rows_between(std::int64_t bottom, std::int64_t top) const noexcept
        {
            return {divided(bottom - margin, width), divided(top + margin, width)};
        }
        [[nodiscard]] interval height_of(std::int64_t row) const noexcept
        {
            return {row * width - margin, (row + 1) * width + margin};
        }
        [[nodiscard]] interval columns_between(std::int64_t left, std::int64_t right) const noexcept
        {
            return rows_between(left, right);
        }
    };

    /// Visits the places of the roots that a segment or a triangle may touch, or come closer to than a margin, row by
    /// row, until visit() returns false. Returns its last result.
    template <std::size_t count, class Visit>
    [[nodiscard]] bool each_root(const grid_point (&corners)[count], std::int64_t margin, Visit&& visit) const noexcept
    {
        return walk_rows(root_squares{width_, margin}, corners, [&](std::int64_t column, std::int64_t row) noexcept {
            return visit(static_cast<std::int32_t>(column), static_cast<std::int32_t>(row));
        });
    }

    [[nodiscard]] static bool holds(const grid_point (&t)[3], grid_point p) noexcept
    {
        return orientation(t[0], t[1], p) >= 0 && orientation(t[1], t[2], p) >= 0 && orientation(t[2], t[0], p) >= 0;
    }

    /// The corners that the splitting of a square and of its children has added: the middle, and the middles of the
    /// sides. A side's middle belongs to the square on its right or above, if that is split as well.
    template <class Put>
    [[nodiscard]] bool each_corner_below(std::uint32_t n, const grid_point (&in)[3], std::uint32_t old,
                                         Put& put) const noexcept
    {
        if (is_leaf(n) || is_apart(box_of(n, 0), in)) return true;
        const square q = squares_[n];
        const grid_point p = corner(n);
        const std::int32_t half = width(q.level + 1), whole = 2 * half;
        const auto may_put = [&](std::int32_t x, std::int32_t y) noexcept {
            const grid_point c{p.x + x, p.y + y};
            return !holds(in, c) || put(c);
        };
        if (q.first_child >= old) {
            if (!may_put(half, half) || !may_put(0, half) || !may_put(half, 0)) return false;
            if (!is_split(q.level, q.column + 1, q.row) && !may_put(whole, half)) return false;
            if (!is_split(q.level, q.column, q.row + 1) && !may_put(half, whole)) return false;
        }
        for (std::uint32_t k = 0; k < 4; ++k)
            if (!each_corner_below(q.first_child + k, in, old, put)) return false;
        return true;
    }

    buffer<square> squares_;
    buffer<std::uint32_t> roots_;
    buffer<edge> edges_;
    buffer<entry> entries_;
    std::size_t root_count_ = 0;
    std::int32_t width_ = 1;
    std::uint32_t deepest_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
