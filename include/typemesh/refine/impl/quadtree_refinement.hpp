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
#include <typemesh/refine/impl/boundary_cutter.hpp>
#include <typemesh/refine/impl/edge_splitter.hpp>
#include <typemesh/refine/impl/off_centre.hpp>
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/impl/write_cap.hpp>
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
/// Each insertion is exact, so the mesh is valid after each step, for every region.
///
/// From  M. Bern, D. Eppstein & J. Gilbert, Provably good mesh generation (1994); the order of the steps and the use of
///       a constrained Delaunay triangulation are our own
class quadtree_refinement {
public:
    explicit quadtree_refinement(memory source = heap()) noexcept
        : mesh_{source}, edges_{source}, tree_{source}, given_{source}, numbers_{source}
    {
    }

    /// Corners beyond the next region's edges: see boundary_cutter.
    void attach(array_view<const grid_point> corners) noexcept { edges_.attach(corners); }

    /// Fails  error::out_of_memory, error::too_many_points
    [[nodiscard]] error run(const region& r, array_view<const triangle> triangles,
                            const quadtree_limits& limits) noexcept
    {
        region_ = &r;
        limits_ = limits;
        kept_ = 0;
        edges_.open(r, 0, limits.max_points);
        tree_.open(limits.width);
        const error too_many{error::too_many_points, limits.max_points};
        if (needs_too_many()) return too_many;
        if (!mesh_.open(r, triangles)) return error::out_of_memory;
        if (!add_edges()) return error::out_of_memory;
        const std::size_t most = max_squares(limits.max_points);
        if (!tree_.split_crowded(most)) return tree_.square_count() > most ? too_many : error{error::out_of_memory};
        if (error e = cut_outline()) return e;
        tree_.forget_edges();
        if (!add_edges() || !note_triangles()) return error::out_of_memory;
        if (error e = add_corners(0)) return e;
        if (error e = shorten_edges()) return e;
        turn_diagonals();
        return {};
    }

    /// Writes the refined cap. Fails with error::out_of_memory.
    [[nodiscard]] error write(const refined_cap& out) noexcept { return write_cap(mesh_, *region_, numbers_, out); }

    [[nodiscard]] const refinable_mesh& mesh() const noexcept { return mesh_; }
    /// The number of triangles with an edge that is too long.
    [[nodiscard]] std::uint32_t kept() const noexcept { return kept_; }

    [[nodiscard]] const balanced_quadtree& tree() const noexcept { return tree_; }

private:
    static constexpr std::uint32_t none = refinable_mesh::none;

    /// The limit for squares, by that for points: the tree, too, must end where the mesh would have too many points.
    [[nodiscard]] static std::size_t max_squares(std::uint32_t max_points) noexcept
    {
        return 64 + 16 * std::size_t{max_points};
    }

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
            if (!edges_.list(v)) return error::out_of_memory;
            for (std::uint32_t a = edges_.take(); a != none; a = edges_.take()) {
                const std::uint32_t before = mesh_.vertex_count();
                if (error e = cut(a)) return e;
                if (mesh_.vertex_count() == before) continue;
                if (error e = edges_.too_many(mesh_)) return e;
                if (!edges_.list(a) || !edges_.list(before)) return error::out_of_memory;
            }
        }
        return {};
    }

    /// Cuts the boundary edge that leaves a once, if it needs a cut and if that is possible.
    [[nodiscard]] error cut(std::uint32_t a) noexcept
    {
        const grid_point p = mesh_.place(a), q = mesh_.place(mesh_.next_on_boundary(a));
        const std::int64_t square = squared_distance(p, q);
        if (edge_splitter::is_too_short(square)) return {};
        const std::int64_t dx = std::int64_t{q.x} - p.x, dy = std::int64_t{q.y} - p.y, width = width_along(p, q);
        const bool is_level = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
        const std::int64_t first = is_level ? p.x : p.y, last = is_level ? q.x : q.y;
        const std::int64_t low = first < last ? first : last, high = first < last ? last : first;
        const std::int64_t line = width * balanced_quadtree::divided(low + high + width, 2 * width),
                           nearest = balanced_quadtree::clearance(width);
        if (line - low > nearest && high - line > nearest) return cut_at(a, is_level, line);
        return 4 * square > 9 * width * width ? split(a) : error{};  // longer than one and a half squares
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
        boundary_cutter::places at{as_double(edge.t0) + share * (as_double(edge.t1) - as_double(edge.t0)), on_chord};
        const boundary_cutter& cutter = edges_.cutter();
        if (cutter.ends_on_curve(mesh_.at(a).source)) {
            double before = as_double(edge.t0), after = as_double(edge.t1);
            const auto is_below = [&](double t) noexcept { return coordinate(cutter.place_on(edge.curve, t)) < goal; };
            const bool begins_below = is_below(before);
            if (is_below(after) == begins_below) return split(a);
            for (int i = 0; i < boundary_cutter::halvings; ++i) {
                at.t = 0.5 * (before + after);
                (is_below(at.t) == begins_below ? before : after) = at.t;
            }
            at.on_curve = on_line(cutter.place_on(edge.curve, at.t));
            at.allows_curve = boundary_cutter::is_close(at.on_curve, on_chord, squared_distance(p, q));
            if (!at.allows_curve) return split(a);
        }
        return edges_.split_at(mesh_, a, at, any_triangle);
    }

    [[nodiscard]] error split(std::uint32_t a) noexcept { return edges_.split(mesh_, a, any_triangle); }

    /// For edge_splitter: no triangle needs a look while edges are cut.
    [[nodiscard]] static bool any_triangle(std::uint32_t) noexcept { return true; }

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
                else
                    failed = edges_.too_many(mesh_);
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
        if (limits_.max_square == 0) return false;
        const grid_point a = mesh_.start(4 * t), b = mesh_.start(4 * t + 1), c = mesh_.start(4 * t + 2);
        return squared_distance(a, b) > limits_.max_square || squared_distance(b, c) > limits_.max_square ||
               squared_distance(c, a) > limits_.max_square;
    }

    /// Splits the leaf that holds the centre of the circle around a triangle, unless it is one of the smallest or newer
    /// than the first `old` squares. False if out of memory.
    [[nodiscard]] bool split_square_at(std::uint32_t t, std::uint32_t old) noexcept
    {
        const grid_point centre =
            off_centre(mesh_.start(4 * t), mesh_.start(4 * t + 1), mesh_.start(4 * t + 2), up_to_centre);
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

    refinable_mesh mesh_;
    edge_splitter edges_;
    balanced_quadtree tree_;
    triangle_list given_;
    buffer<std::uint32_t> numbers_;
    const region* region_ = nullptr;
    quadtree_limits limits_;
    std::uint32_t kept_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
