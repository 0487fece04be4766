// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/impl/steady.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/touching.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/corner_parting.hpp>
#include <typemesh/fill/resolve.hpp>
#include <typemesh/plate/plate_plane.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The union of letters, rectangles and discs in one plane.
///
///     silhouette letters;
///     letters.begin(plane);
///     letters.add(plan, plane);                             // every glyph of a text_plan, where it stands
///     letters.fill(space);                                  // the union: letters.points(), letters.starts()
///
/// Memory is kept for the next silhouette.
class silhouette {
public:
    explicit silhouette(memory source = heap()) noexcept : loops_{source}, curves_{source} {}

    /// Removes everything.
    void begin(const plate_plane& onto) noexcept
    {
        loops_.clear();
        loops_.grid = onto.cells;
        curves_.clear();
    }

    /// Adds the letters of a plan, after its steps (embolden) and where its path places them. Points are rounded to
    /// the plane's grid.
    ///
    /// Fails with error::outline_beyond_grid and error::out_of_memory; some letters may then have been added.
    template <class Plan>
    [[nodiscard]] result<void> add(const Plan& plan, const plate_plane& onto) noexcept
    {
        for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
            const auto form = plan.glyphs()[g].built->form();
            const plate_plane::glyph_place at{plan, g, onto};
            for (std::size_t k = 0; k + 1 < form.starts.size(); ++k) {
                for (std::uint32_t i = form.starts[k]; i < form.starts[k + 1]; ++i) {
                    const point p = at(form.points[i]);
                    if (!(std::fabs(p.x) < grid::reach) || !(std::fabs(p.y) < grid::reach))
                        return error::outline_beyond_grid;
                    if (!put({static_cast<std::int32_t>(p.x), static_cast<std::int32_t>(p.y)}))
                        return error::out_of_memory;
                }
                if (!close()) return error::out_of_memory;
            }
        }
        return {};
    }

    /// Adds a rectangle with round corners, which is symmetric. Arcs deviate from the circle by at most half a cell
    /// more than `tolerance` cells.
    ///
    ///     radius    in cells; it is reduced to half of the shorter side. 0: sharp corners
    [[nodiscard]] result<void> add_rectangle(grid_point low, grid_point high, double radius, double tolerance) noexcept
    {
        const double width = static_cast<double>(high.x) - low.x, height = static_cast<double>(high.y) - low.y;
        if (!(width > 0.0) || !(height > 0.0)) return {};
        const double half = 0.5 * (width < height ? width : height);
        radius = radius < half ? radius : half;
        if (!(radius >= 1.0)) {
            const bool ok = put(low) && put({high.x, low.y}) && put(high) && put({low.x, high.y}) && close();
            return ok ? error{} : error{error::out_of_memory};
        }
        const int steps = arc_steps(radius, tolerance);
        const bool ok =
            put_arc({high.x, high.y}, radius, steps, 1, 1) && put_arc({low.x, high.y}, radius, steps, -1, 1) &&
            put_arc({low.x, low.y}, radius, steps, -1, -1) && put_arc({high.x, low.y}, radius, steps, 1, -1) && close();
        return ok ? error{} : error{error::out_of_memory};
    }

    /// Adds a disc. radius in cells.
    [[nodiscard]] result<void> add_disc(grid_point centre, double radius, double tolerance) noexcept
    {
        const auto r = static_cast<std::int32_t>(std::nearbyint(radius));
        return add_rectangle({centre.x - r, centre.y - r}, {centre.x + r, centre.y + r}, radius, tolerance);
    }

    /// Adds the square that stands on its corner: all points at most `size` from p, in x and y together.
    [[nodiscard]] result<void> add_diamond(grid_point p, std::int32_t size) noexcept
    {
        const bool ok = put({p.x + size, p.y}) && put({p.x, p.y + size}) && put({p.x - size, p.y}) &&
                        put({p.x, p.y - size}) && close();
        return ok ? error{} : error{error::out_of_memory};
    }

    /// Makes the union of everything that was added. Corners that touch are treated as `corners` says.
    ///
    /// Fails as resolve() and corner_parting do; the silhouette is then undefined until begin().
    template <class = void>  // see resolve()
    [[nodiscard]] result<void> fill(workspace& space, touching corners = touching::keep,
                                    std::uint32_t max_pieces = default_max_pieces) noexcept
    {
        if (loops_.points.empty()) return {};
        loops_.corners = corners;
        loops_.forget_order();
        const auto made = resolve(loops_, fill_rule::non_zero, space, {.max_pieces = max_pieces});
        if (!made) return made.error();
        if (made->is_touching() && corners != touching::keep) {
            corner_parting parting;
            if (const auto parted = parting(loops_, curves_, space, max_pieces); !parted) return parted.error();
        }
        return {};
    }

    /// Removes the holes of the union that fill() made, with all that lies in them.
    ///
    /// Fails as fill() does.
    [[nodiscard]] result<void> fill_holes(workspace& space, std::uint32_t max_pieces = default_max_pieces) noexcept
    {
        std::size_t end = 0;
        std::uint32_t kept = 0;
        for (std::uint32_t k = 0, begin = 0; k < loops_.contour_count(); ++k) {
            const std::uint32_t after = loops_.starts[k + 1];
            if (is_outer(begin, after)) {
                for (std::uint32_t i = begin; i < after; ++i, ++end) {
                    loops_.points[end] = loops_.points[i];
                    loops_.edges[end] = loops_.edges[i];
                }
                loops_.starts[++kept] = static_cast<std::uint32_t>(end);
            }
            begin = after;
        }
        loops_.points.truncate(end);
        loops_.edges.truncate(end);
        if (!loops_.starts.empty()) loops_.starts.truncate(kept + 1);
        loops_.forget_order();
        return fill(space, loops_.corners, max_pieces);
    }

    [[nodiscard]] array_view<const grid_point> points() const noexcept { return loops_.points.view(); }
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return loops_.starts.view(); }
    /// Whether a loop of the union that fill() made is an outer one, and not a hole's. Cost: O(its points)
    [[nodiscard]] bool is_outer(std::uint32_t loop) const noexcept
    {
        return is_outer(loops_.starts[loop], loops_.starts[loop + 1]);
    }
    [[nodiscard]] bool empty() const noexcept { return loops_.points.empty(); }

    /// The corners of its bounding box; both are (0, 0) if it is empty.
    [[nodiscard]] grid_point low() const noexcept
    {
        grid_point p = empty() ? grid_point{} : loops_.points[0];
        for (const grid_point q : loops_.points) p = {q.x < p.x ? q.x : p.x, q.y < p.y ? q.y : p.y};
        return p;
    }
    [[nodiscard]] grid_point high() const noexcept
    {
        grid_point p = empty() ? grid_point{} : loops_.points[0];
        for (const grid_point q : loops_.points) p = {q.x > p.x ? q.x : p.x, q.y > p.y ? q.y : p.y};
        return p;
    }

private:
    /// Whether the points from `begin` to before `after` run counter-clockwise.
    [[nodiscard]] bool is_outer(std::uint32_t begin, std::uint32_t after) const noexcept
    {
        std::uint64_t area = 0;  // doubled; partial sums may wrap
        for (std::uint32_t i = begin; i < after; ++i) {
            const grid_point p = loops_.points[i], q = loops_.points[i + 1 < after ? i + 1 : begin];
            area += static_cast<std::uint64_t>(std::int64_t{p.x} * q.y - std::int64_t{p.y} * q.x);
        }
        return static_cast<std::int64_t>(area) > 0;
    }

    /// The index of the first point of the loop that is being added.
    [[nodiscard]] std::size_t first_of_loop() const noexcept
    {
        return loops_.starts.empty() ? 0 : loops_.starts.back();
    }
    [[nodiscard]] bool put(grid_point p) noexcept
    {
        if (loops_.starts.empty() && !loops_.starts.push_back(0)) return false;
        return loops_.points.push_back(p) && loops_.edges.push_back({});
    }
    [[nodiscard]] bool close() noexcept
    {
        const std::size_t first = first_of_loop();
        if (loops_.points.size() > first + 1 && loops_.points.back() == loops_.points[first]) {  // round sides
            loops_.points.truncate(loops_.points.size() - 1);
            loops_.edges.truncate(loops_.edges.size() - 1);
        }
        loops_.forget_order();
        return loops_.starts.push_back(static_cast<std::uint32_t>(loops_.points.size()));
    }

    /// The number of chords of a quarter circle.
    static int arc_steps(double radius, double tolerance) noexcept
    {
        constexpr double quarter = 1.57079632679489662;
        constexpr int most = 256;
        const double step = 2.0 * std::acos(1.0 - (tolerance < radius ? tolerance / radius : 1.0));
        const double steps = step > 0.0 ? std::ceil(detail::steady(quarter / step)) : most;
        return steps < 2.0 ? 2 : steps < most ? static_cast<int>(steps) : most;
    }

    /// The quarter of a circle in the corner of a box; (sx, sy) is the corner's direction. Its points are mirror images
    /// of the other corners' points, and of each other.
    [[nodiscard]] bool put_arc(grid_point corner, double radius, int steps, std::int32_t sx, std::int32_t sy) noexcept
    {
        constexpr double quarter = 1.57079632679489662;
        const bool ascends = sx == sy;
        for (int i = 0; i <= steps; ++i) {
            const int k = ascends ? i : steps - i;
            const double angle = quarter * k / steps;
            const auto inwards = [radius](double v) noexcept {
                return static_cast<std::int32_t>(std::nearbyint(radius * (1.0 - v)));
            };
            const grid_point p{corner.x - sx * inwards(detail::steady_cosine(angle)),
                               corner.y - sy * inwards(detail::steady_sine(angle))};
            if (loops_.points.size() > first_of_loop() && p == loops_.points.back()) continue;
            if (!put(p)) return false;
        }
        return true;
    }

    contours loops_;
    buffer<curve> curves_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
