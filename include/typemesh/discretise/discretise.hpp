// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/discretise/discretiser.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

/// Appends points and their edges to contours. Consecutive points that snap to one grid point become one point.
class contour_writer {
public:
    explicit contour_writer(contours& out) noexcept
        : out_{out}, most_{out.max_points < most ? std::size_t{out.max_points} + 1 : most}
    {
    }

    /// Reserves the capacity that `out` kept from earlier calls, and at least `wanted` points.
    void begin(std::size_t wanted) noexcept
    {
        const std::size_t kept =
            out_.points.capacity() < out_.edges.capacity() ? out_.points.capacity() : out_.edges.capacity();
        claim(kept > wanted ? kept : wanted);
    }

    void begin_contour(grid_point p) noexcept
    {
        first_ = size_;
        push(p);
    }

    /// From here on the boundary follows another curve.
    void begin_curve(std::uint32_t curve) noexcept { leaving_ = {curve, 0.0f, 1.0f}; }

    /// The boundary reaches p, the point of its curve at t.
    void arrive(grid_point p, float t) noexcept
    {
        if (failed_) return;
        if (points_[size_ - 1] == p) {
            leaving_.t0 = t;
            return;
        }
        edges_[size_ - 1] = {leaving_.curve, leaving_.t0, t};
        leaving_.t0 = t;
        push(p);
    }

    /// Returns whether the contour has any points left.
    bool end_contour() noexcept
    {
        if (failed_) return false;
        if (size_ - first_ > 1 && points_[size_ - 1] == points_[first_])
            --size_;
        else
            edges_[size_ - 1] = {leaving_.curve, leaving_.t0, 1.0f};
        if (size_ - first_ >= 3) return true;
        size_ = first_;
        return false;
    }

    /// Whether all points since begin_contour() are collinear, or there are no points. After a failure the result is
    /// false.
    [[nodiscard]] bool is_flat() const noexcept
    {
        if (failed_) return false;
        for (std::size_t i = first_ + 2; i < size_; ++i)
            if (orientation(points_[first_], points_[i - 1], points_[i]) != 0) return false;
        return true;
    }

    /// Removes the points since begin_contour().
    void drop_contour() noexcept { size_ = first_; }

    /// Releases the capacity that was claimed but not used.
    void end() noexcept
    {
        out_.points.truncate(size_);
        out_.edges.truncate(size_);
    }

    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] error failed() const noexcept { return failed_; }

private:
    static constexpr std::size_t most = 0xFFFF'FFFFu;

    void push(grid_point p) noexcept
    {
        if (size_ == room_) claim(room_);
        if (failed_) return;
        points_[size_++] = p;
    }

    void claim(std::size_t more) noexcept
    {
        if (failed_) return;
        more = more < most_ - room_ ? more : most_ - room_;
        if (more == 0) {
            failed_ = out_.max_points < most ? error{error::too_many_points, out_.max_points} : error::too_large;
            return;
        }
        if (out_.points.append(more) == nullptr || out_.edges.append(more) == nullptr) {
            failed_ = error::out_of_memory;
            return;
        }
        room_ += more;
        points_ = out_.points.data();
        edges_ = out_.edges.data();
    }

    contours& out_;
    std::size_t most_;  // one more than allowed: until a contour ends, its last point repeats its first
    grid_point* points_ = nullptr;
    contour_edge* edges_ = nullptr;
    std::size_t size_ = 0, room_ = 0, first_ = 0;
    contour_edge leaving_;  // the edge that leaves the last point; its t1 is not yet known
    error failed_;
};

/// Twice the area that a contour's curves enclose, counter-clockwise positive: Green's formula over the control points.
[[nodiscard]] inline double doubled_area(array_view<const curve> contour) noexcept
{
    double sum = 0.0;
    for (const curve& c : contour) {
        point p[4];  // relative to the contour's start, which keeps the terms small
        for (std::uint32_t i = 0; i <= c.degree; ++i) p[i] = c.p[i] - contour[0].p[0];
        if (c.degree == 1)
            sum += cross(p[0], p[1]);
        else if (c.degree == 2)
            sum += (2.0 * cross(p[0], p[1]) + cross(p[0], p[2]) + 2.0 * cross(p[1], p[2])) / 3.0;
        else
            sum += 0.1 * (6.0 * (cross(p[0], p[1]) + cross(p[2], p[3])) + cross(p[0], p[3]) +
                          3.0 * (cross(p[0], p[2]) + cross(p[1], p[2]) + cross(p[1], p[3])));
    }
    return sum;
}

/// The points that a discretiser has emitted for one curve so far. They are kept only for TYPEMESH_ASSERT.
struct emitted_points {
    point last = {};
    double t = 0.0;

    /// Adds a point. The result is false if t does not increase or exceeds 1.
    [[nodiscard]] bool take(point p, double at) noexcept
    {
        const bool goes_on = t < at && at <= 1.0;
        last = p;
        t = at;
        return goes_on;
    }
    /// Whether the last point is the end of its curve, within one cell of the grid.
    [[nodiscard]] bool ended_at(point end, const grid& g) const noexcept
    {
        return t >= 1.0 && std::abs(last.x - end.x) * g.cells < 1.0 && std::abs(last.y - end.y) * g.cells < 1.0;
    }
};

/// Snaps the points of one curve to the grid and passes them to the writer.
struct curve_emitter {
    contour_writer& writer;
    const grid& cells;
    emitted_points& emitted;

    void operator()(point p, double t) const noexcept
    {
        TYPEMESH_ASSERT(emitted.take(p, t), "a discretiser must emit its points with t ascending, above 0 and up to 1");
        writer.arrive(snapped(p, cells), static_cast<float>(t));
    }

    [[nodiscard]] static grid_point snapped(point p, const grid& g) noexcept
    {
        TYPEMESH_ASSERT(std::abs(p.x) * g.cells <= grid::reach && std::abs(p.y) * g.cells <= grid::reach,
                        "a discretiser emitted a point outside the grid, or the grid does not fit the outline");
        return g.snap(p);
    }
};

/// Whether finer chords can give a contour an area: not all its curves are lines, and they enclose some cells.
[[nodiscard]] inline bool has_curved_area(array_view<const curve> contour, const grid& g) noexcept
{
    bool curved = false;
    for (const curve& c : contour) curved |= c.degree > 1;
    const double area = curved ? doubled_area(contour) * g.cells * g.cells : 0.0;
    return area > 4.0 || area < -4.0;
}

/// Flattens the contours of one outline, one after the other.
template <discretiser D>
class contour_flattener {
public:
    static constexpr std::uint32_t max_halvings = 31;

    contour_flattener(const outline& curves, const D& how, double tolerance, const grid& g,
                      array_view<const std::uint8_t> halvings, contour_writer& writer) noexcept
        : curves_{curves},
          how_{how},
          tolerance_{tolerance},
          cells_{g},
          halvings_{halvings},
          writer_{writer},
          snap_{g.snap_error()},
          rest_{tolerance - snap_ > snap_ ? tolerance - snap_ : snap_}
    {
    }

    /// Flattens the contour of the curves [first, end), more finely if it would otherwise lose its area. The result is
    /// false if no points are left.
    [[nodiscard]] bool flatten(std::uint32_t first, std::uint32_t end) noexcept
    {
        bool left = flatten(first, end, 0);
        const auto contour = curves_.curves.view().subspan(first, end - first);
        if (writer_.is_flat() && has_curved_area(contour, cells_)) [[unlikely]] {
            for (std::uint32_t finer = 1; finer < max_halvings && !writer_.failed(); ++finer) {
                const bool last = !(halved(finer) > snap_);
                writer_.drop_contour();
                left = flatten(first, end, finer);
                if (last || !writer_.is_flat()) break;
            }
        }
        return left;
    }

private:
    [[nodiscard]] bool flatten(std::uint32_t first, std::uint32_t end, std::uint32_t finer) noexcept
    {
        writer_.begin_contour(curve_emitter::snapped(curves_.curves[first].start(), cells_));
        for (std::uint32_t i = first; i < end && !writer_.failed(); ++i) {
            const curve& q = curves_.curves[i];
            writer_.begin_curve(i);
            emitted_points emitted;
            const curve_emitter put{writer_, cells_, emitted};
            const std::uint32_t times = finer + (halvings_.empty() ? 0u : halvings_[i]);
            const double allowed = times == 0 ? rest_ : halved(times < max_halvings ? times : max_halvings);
            if (q.degree == 1)
                put(q.p[1], 1.0);
            else if (q.degree == 2)
                how_(q.as_quadratic(), allowed, put);
            else
                how_(q.as_cubic(), allowed, put);
            TYPEMESH_ASSERT(emitted.ended_at(q.end(), cells_),
                            "a discretiser's last point must be the end of its curve, with t = 1");
        }
        return writer_.end_contour();
    }

    /// The discretiser's tolerance after this many halvings.
    [[nodiscard]] double halved(std::uint32_t times) const noexcept
    {
        const double finer = tolerance_ / static_cast<double>(std::uint32_t{1} << times) - snap_;
        return finer > snap_ ? finer : snap_;
    }

    const outline& curves_;
    const D& how_;
    double tolerance_;
    const grid& cells_;
    array_view<const std::uint8_t> halvings_;
    contour_writer& writer_;
    double snap_;
    double rest_;  // halved(0)
};

}  // namespace detail

/// Flattens an outline: turns its curves into closed polylines on the grid. Replaces the content of `out` and reuses
/// its storage.
///
///     curves      the outline, in font units; every control point within the reach of `g` (see grid::fitting)
///     how         the discretiser
///     tolerance   the maximum distance between a polyline and its curve, in font units, including rounding to the grid
///     out         its `curves` refer to the outline, so the outline must outlive every use of `out`. out.tolerance is
///                 the tolerance in cells, at least twice g.snap_error(); 0 if the discretiser keeps no tolerance
///     halvings    the number of times that each curve's tolerance is halved, at most 31; empty: never
///
/// Consecutive points at one grid point are merged. The edge before the merged point ends at the t of the first
/// arrival; the edge after it starts at the t (or the curve) of the last departure.
///
/// If a contour's curves enclose an area, the contour usually keeps at least 3 points that are not collinear. If its
/// tolerance would leave fewer (a dot of two curves that is smaller than the tolerance), the tolerance is halved for
/// this contour until there are enough points or the grid allows no finer step. Contours with fewer than 3 points
/// enclose nothing and are dropped.
///
/// The discretiser gets `tolerance` less g.snap_error(), but never less than g.snap_error(). A tolerance below twice
/// that error cannot be kept: more points would follow the grid's steps instead of the curve.
///
/// Fails  error::bad_tolerance: not positive and finite
///        error::too_many_points (out.max_points), error::out_of_memory, error::too_large (2^32 - 1 points or curves or
///        more); `out` is then empty
/// Cost   the discretiser's cost, and a few nanoseconds per point; no allocation once `out` has grown
template <discretiser D>
result<void> discretise(const outline& curves, const D& how, double tolerance, const grid& g, contours& out,
                        array_view<const std::uint8_t> halvings = {}) noexcept
{
    TYPEMESH_ASSERT(halvings.empty() || halvings.size() == curves.curves.size(),
                    "the halvings must be empty or have one number for each curve");
    out.clear();
    out.grid = g;
    if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad_tolerance;
    if (curves.curves.size() > 0xFFFF'FFFFu) return error::too_large;
    if (curves.contour_count() == 0) return {};

    detail::contour_writer writer{out};
    writer.begin(2 * curves.curves.size() + 16);
    detail::contour_flattener<D> contour{curves, how, tolerance, g, halvings, writer};
    bool listed = out.starts.push_back(0);
    for (std::uint32_t c = 0; c < curves.contour_count() && listed && !writer.failed(); ++c) {
        const std::uint32_t first = curves.starts[c], end = curves.starts[c + 1];
        if (first == end) continue;
        const bool left = contour.flatten(first, end);
        if (left) listed = out.starts.push_back(static_cast<std::uint32_t>(writer.size()));
    }
    writer.end();
    if (writer.failed() || !listed) {
        out.clear();
        return writer.failed() ? writer.failed() : error{error::out_of_memory};
    }
    out.curves = curves.curves.view();
    const double least = 2.0 * g.snap_error();
    if constexpr (keeps_tolerance<D>) out.tolerance = g.cells * (tolerance > least ? tolerance : least);
    return {};
}

}  // namespace typemesh::inline TYPEMESH_ABI
