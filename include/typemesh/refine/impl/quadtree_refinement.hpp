// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/balanced_quadtree.hpp>
#include <typemesh/refine/impl/delaunay_refinement.hpp>
#include <typemesh/refine/impl/off_centre.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// What a quadtree's refinement aims at, in cells.
struct quadtree_limits {
    std::int32_t width = 0;       ///< of the largest squares, 2^28 at most
    std::int64_t max_square = 0;  ///< the square of the greatest length of an edge; 0: any length
    std::uint32_t max_points = default_max_points;
};

/// Adds the corners of a quadtree's squares to a region's triangles.
///
///     1. squares     A balanced_quadtree is split until edges are a third of a square apart.
///     2. outline     Each boundary edge is cut where it passes lines of the local squares: the vertical ones if the
///                    edge is rather level, otherwise the horizontal ones. No cut is made within two fifths of a square
///                    of the edge's ends. Edges longer than one and a half squares are halved.
///     3. corners     The squares' corners inside become points, except where the outline is closer than two fifths of
///                    a square. The mesh is Delaunay, so the triangles within a square follow from its corners.
///     4. long edges  If a triangle still has an edge that is too long, the square at the centre of the circle around
///                    it is split.
///     5. diagonals   The two diagonals of a square are equally Delaunay. They alternate like the fields of a
///                    chessboard.
///
/// Each insertion is exact, so the mesh is valid after each step, for every region. It shares the splitting of boundary
/// edges with delaunay_refinement.
///
/// From  M. Bern, D. Eppstein & J. Gilbert, Provably good mesh generation (1994); the order of the steps and the use of
///       a constrained Delaunay triangulation are our own
class quadtree_refinement : delaunay_refinement {
public:
    explicit quadtree_refinement(memory source = heap()) noexcept
        : delaunay_refinement{source}, tree_{source}, given_{source}
    {
    }

    /// Fails  error::out_of_memory, error::too_many_points
    [[nodiscard]] error run(const region& r, array_view<const triangle> triangles,
                            const quadtree_limits& limits) noexcept
    {
        region_ = &r;
        limits_ = {};
        limits_.max_points = limits.max_points;
        cut_.open(r);
        edges_.clear();
        waiting_.clear();
        kept_ = 0;
        stamp_ = 0;
        tree_.open(limits.width);
        if (needs_too_many()) return {error::too_many_points, limits_.max_points};
        if (!mesh_.open(r, triangles)) return error::out_of_memory;
        if (!add_edges()) return error::out_of_memory;
        const std::size_t most = 64 + 16 * std::size_t{limits.max_points};
        if (!tree_.split_crowded(most))
            return tree_.square_count() > most ? error{error::too_many_points, limits_.max_points}
                                               : error{error::out_of_memory};
        if (error e = cut_outline()) return e;
        tree_.forget_edges();
        if (!add_edges() || !note_triangles()) return error::out_of_memory;
        if (error e = add_corners(0)) return e;
        limits_.max_square = limits.max_square;
        if (error e = shorten_edges()) return e;
        turn_diagonals();
        return {};
    }

    using delaunay_refinement::attach;
    using delaunay_refinement::kept;
    using delaunay_refinement::mesh;
    using delaunay_refinement::write;

    [[nodiscard]] const balanced_quadtree& tree() const noexcept { return tree_; }

private:
    /// Whether so many points lie on the outline alone.
    [[nodiscard]] bool needs_too_many() const noexcept
    {
        const auto points = region_->points();
        std::int64_t count = static_cast<std::int64_t>(points.size());
        const std::int64_t width = tree_.width(0);
        for (std::uint32_t loop = 0; loop < region_->loop_count(); ++loop) {
            grid_point p = points[region_->starts()[loop + 1] - 1];
            for (std::uint32_t i = region_->starts()[loop]; i < region_->starts()[loop + 1]; ++i) {
                const grid_point q = points[i];
                const std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y;
                // After cutting, no part is longer than two squares in its main direction.
                count += ((dx < 0 ? -dx : dx) > (dy < 0 ? -dy : dy) ? dx < 0 ? -dx : dx
                          : dy < 0                                  ? -dy
                                                                    : dy) /
                         (2 * width);
                p = q;
            }
        }
        return count > limits_.max_points;
    }

    /// Lists the boundary as it is in the tree. False if out of memory.
    [[nodiscard]] bool add_edges() noexcept
    {
        for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
            const std::uint32_t next = mesh_.next_on_boundary(v);
            if (!tree_.add_edge(mesh_.place(v), mesh_.place(next), v, next)) return false;
        }
        return true;
    }

    // ---- the outline

    [[nodiscard]] error cut_outline() noexcept
    {
        const std::uint32_t count = mesh_.vertex_count();
        for (std::uint32_t v = 0; v < count; ++v) {
            if (!edges_.push_back(v)) return error::out_of_memory;
            while (!edges_.empty()) {
                const std::uint32_t a = edges_.back(), before = mesh_.vertex_count();
                edges_.truncate(edges_.size() - 1);
                if (error e = cut(a)) return e;
                if (mesh_.vertex_count() == before) continue;
                if (mesh_.vertex_count() > limits_.max_points) return {error::too_many_points, limits_.max_points};
                if (!edges_.push_back(a) || !edges_.push_back(before)) return error::out_of_memory;
            }
        }
        return {};
    }

    /// Cuts the boundary edge that leaves a once, if it needs a cut and if that is possible.
    [[nodiscard]] error cut(std::uint32_t a) noexcept
    {
        const grid_point p = mesh_.place(a), q = mesh_.place(mesh_.next_on_boundary(a));
        const std::int64_t square = squared_distance(p, q);
        if (square < 4 * spacing * spacing) return {};
        const std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y, width = width_along(p, q);
        const bool is_level = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
        const std::int64_t first = is_level ? p.x : p.y, last = is_level ? q.x : q.y;
        const std::int64_t low = first < last ? first : last, high = first < last ? last : first;
        const std::int64_t line = width * balanced_quadtree::divided(low + high + width, 2 * width);
        if (5 * (line - low) > 2 * width && 5 * (high - line) > 2 * width) return cut_at(a, is_level, line);
        return 4 * square > 9 * width * width ? split(a) : error{};
    }

    /// The width of the smallest leaf at three places of an edge.
    [[nodiscard]] std::int64_t width_along(grid_point p, grid_point q) const noexcept
    {
        std::uint32_t level = 0;
        for (const std::int64_t k : {1, 2, 3}) {
            const std::uint32_t found = tree_.level_at(((4 - k) * p.x + k * q.x) / 4, ((4 - k) * p.y + k * q.y) / 4);
            level = found > level ? found : level;
        }
        return tree_.width(level);
    }

    /// Cuts the boundary edge that leaves a where it passes a vertical line (if it is level) or a horizontal one. If
    /// its curve is far from the edge there, the edge is halved instead.
    [[nodiscard]] error cut_at(std::uint32_t a, bool is_level, std::int64_t line) noexcept
    {
        const grid_point p = mesh_.place(a), q = mesh_.place(mesh_.next_on_boundary(a));
        const contour_edge edge = mesh_.at(a).edge;
        const auto goal = static_cast<double>(line);
        const auto coordinate = [is_level](point at) noexcept { return is_level ? at.x : at.y; };
        const auto on_line = [&](point at) noexcept { return is_level ? point{goal, at.y} : point{at.x, goal}; };
        const double first = coordinate(boundary_cutter::as_point(p)),
                     share = (goal - first) / (coordinate(boundary_cutter::as_point(q)) - first);
        const point on_chord = on_line(lerp(boundary_cutter::as_point(p), boundary_cutter::as_point(q), share));
        double t = as_double(edge.t0) + share * (as_double(edge.t1) - as_double(edge.t0));
        if (cut_.ends_on_curve(mesh_.at(a).source)) {
            double before = as_double(edge.t0), after = as_double(edge.t1);
            const bool is_below = coordinate(cut_.place_on(edge.curve, before)) < goal;
            if ((coordinate(cut_.place_on(edge.curve, after)) < goal) == is_below) return split(a);
            for (int halvings = 0; halvings < 40; ++halvings) {
                t = 0.5 * (before + after);
                ((coordinate(cut_.place_on(edge.curve, t)) < goal) == is_below ? before : after) = t;
            }
            const point on_curve = on_line(cut_.place_on(edge.curve, t)), off = on_curve - on_chord;
            if (typemesh::dot(off, off) >= 0.09 * static_cast<double>(squared_distance(p, q))) return split(a);
            const auto done = try_split(a, boundary_cutter::rounded(on_curve, 0), static_cast<float>(t));
            if (!done || *done) return done.error();
        }
        for (const int next_best : {0, 1, 2, 3}) {
            const auto done = try_split(a, boundary_cutter::rounded(on_chord, next_best), static_cast<float>(t));
            if (!done || *done) return done.error();
        }
        return {};
    }

    /// Splits the edge that leaves a at p if that keeps the mesh valid; returns whether it did.
    [[nodiscard]] result<bool> try_split(std::uint32_t a, grid_point p, float t) noexcept
    {
        const auto made = cut_.try_split(mesh_, a, p, t);
        if (!made || *made == none) return made ? result<bool>{false} : result<bool>{made.error()};
        return check_changed() ? result<bool>{true} : result<bool>{error::out_of_memory};
    }

    // ---- corners of squares

    /// Notes the triangles of the outline's points.
    [[nodiscard]] bool note_triangles() noexcept
    {
        given_.clear();
        const std::uint32_t count = mesh_.triangle_count();
        triangle* const given = given_.append(count);
        for (std::uint32_t t = 0; given != nullptr && t < count; ++t)
            given[t] = {mesh_.origin(4 * t), mesh_.origin(4 * t + 1), mesh_.origin(4 * t + 2)};
        return given != nullptr;
    }

    /// Adds the corners of squares; with `old` squares given, only those that newer squares have added. The outline
    /// does not change any more, so each corner can be seen from all of the noted triangle that holds it.
    [[nodiscard]] error add_corners(std::uint32_t old) noexcept
    {
        error failed;
        for (std::uint32_t t = 0; t < given_.size(); ++t) {
            const triangle& given = given_[t];
            const grid_point in[] = {mesh_.place(given.a), mesh_.place(given.b), mesh_.place(given.c)};
            std::uint32_t last = t;  // the walk to the next corner begins here
            const bool done = tree_.each_corner(in, old, [&](grid_point p) noexcept {
                if (tree_.is_close(p)) return true;
                std::uint32_t holder = mesh_.locate(last, p).triangle;
                if (holder == none) holder = walk(given.a, p);
                if (holder == none || is_corner(holder, p)) return true;
                last = holder;
                if (mesh_.insert(holder, p) == none)
                    failed = error::out_of_memory;
                else if (mesh_.vertex_count() > limits_.max_points)
                    failed = {error::too_many_points, limits_.max_points};
                return failed == error::none;
            });
            if (!done) return failed;
        }
        return {};
    }

    [[nodiscard]] bool is_corner(std::uint32_t t, grid_point p) const noexcept
    {
        return mesh_.start(4 * t) == p || mesh_.start(4 * t + 1) == p || mesh_.start(4 * t + 2) == p;
    }

    /// The triangle that holds p, found by a straight walk from a boundary point v that sees p; unlike locate() it
    /// finds its way around every bay of the outline. none if the walk ends at the outline.
    [[nodiscard]] std::uint32_t walk(std::uint32_t v, grid_point p) const noexcept
    {
        const grid_point from = mesh_.place(v);
        std::uint32_t h = mesh_.at(v).boundary;
        while (orientation(from, mesh_.place(mesh_.target(h)), p) < 0 ||
               orientation(from, mesh_.place(mesh_.apex(h)), p) >= 0) {
            h = mesh_.twin(refinable_mesh::previous(h));
            if (h == none) return none;
        }
        h = refinable_mesh::next(h);
        while (orientation(mesh_.start(h), mesh_.place(mesh_.target(h)), p) < 0) {
            h = mesh_.twin(h);
            if (h == none) return none;
            const bool is_left = orientation(from, p, mesh_.place(mesh_.apex(h))) > 0;
            h = is_left ? refinable_mesh::next(h) : refinable_mesh::previous(h);
        }
        return h / 4;
    }

    // ---- long edges

    [[nodiscard]] error shorten_edges() noexcept
    {
        for (;;) {
            // All squares of a round are found before any point is added, so their order does not matter.
            const std::uint32_t old = tree_.square_count();
            for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
                if (has_long_edge(t) && !split_square_at(t, old)) return error::out_of_memory;
            if (tree_.square_count() == old) break;
            if (error e = add_corners(old)) return e;
        }
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) kept_ += has_long_edge(t);
        return {};
    }

    [[nodiscard]] bool has_long_edge(std::uint32_t t) const noexcept
    {
        const std::uint32_t h = 4 * t;
        return is_too_long(squared_length(h)) || is_too_long(squared_length(h + 1)) ||
               is_too_long(squared_length(h + 2));
    }

    /// Splits the leaf that holds the centre of the circle around a triangle, unless it is one of the smallest or newer
    /// than the first `old` squares. False if out of memory.
    [[nodiscard]] bool split_square_at(std::uint32_t t, std::uint32_t old) noexcept
    {
        const grid_point centre =
            off_centre(mesh_.start(4 * t), mesh_.start(4 * t + 1), mesh_.start(4 * t + 2), 0x1p100);
        std::uint32_t leaf = tree_.leaf_at(centre.x, centre.y);
        if (tree_.deepest() == 0 || (leaf != none && (leaf >= old || tree_.at(leaf).level == tree_.deepest())))
            return true;
        if (leaf == none) leaf = tree_.root_at(centre);
        return leaf != none && tree_.split(leaf);
    }

    // ---- diagonals

    /// Gives the diagonals of upright rectangles their directions: in the square of column i and row k, counted in its
    /// own width and height, it rises if i + k is even. A mesh that is mirrored about an axis so remains the same.
    void turn_diagonals() noexcept
    {
        for (std::uint32_t h = 0; h < mesh_.end(); h += h % 4 == 2 ? 2 : 1) {
            const std::uint32_t g = mesh_.twin(h);
            if (g == none || g < h) continue;
            const grid_point p = mesh_.start(h), q = mesh_.start(g), r = mesh_.place(mesh_.apex(h)),
                             s = mesh_.place(mesh_.apex(g));
            const std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y;
            if (dx == 0 || dy == 0) continue;
            const grid_point one{p.x, q.y}, other{q.x, p.y};
            if (!(r == one && s == other) && !(r == other && s == one)) continue;
            const std::int64_t column = balanced_quadtree::divided(p.x < q.x ? p.x : q.x, dx < 0 ? -dx : dx),
                               row = balanced_quadtree::divided(p.y < q.y ? p.y : q.y, dy < 0 ? -dy : dy);
            if (((dx < 0) == (dy < 0)) != (((column + row) & 1) == 0)) mesh_.flip(h);
        }
    }

    balanced_quadtree tree_;
    triangle_list given_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
