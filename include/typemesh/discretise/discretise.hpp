// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/outline.hpp>
#include <typemesh/discretise/discretiser.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh {

namespace detail {

/// Appends points and their edges to contours; neighbours that fall on one grid point become one.
class contour_writer {
public:
    explicit contour_writer(contours& out) noexcept : out_{out} {}

    /// Room for what the last call of this kind used, and for `wanted` points at least.
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

    /// From here on the boundary runs along another curve.
    void begin_curve(std::uint32_t curve) noexcept { leaving_ = {curve, 0.0f, 1.0f}; }

    /// The boundary arrives at p, which its curve reaches at t.
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

    /// True when a contour is left.
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

    /// Gives back what was claimed too much.
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
        more = more < most - room_ ? more : most - room_;
        if (more == 0) {
            failed_ = error::too_large;
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
    grid_point* points_ = nullptr;
    contour_edge* edges_ = nullptr;
    std::size_t size_ = 0, room_ = 0, first_ = 0;
    contour_edge leaving_;  // how the boundary leaves the last point; t1 is not yet known
    error failed_;
};

}  // namespace detail

/// Turns an outline's curves into closed polylines on the grid. What `out` held before is forgotten; its storage is
/// used again.
///
///     curves      the outline, in font units; every control point within the reach of `g` (see grid::fitting)
///     how         the discretiser
///     tolerance   how far a polyline may be from its curve, in font units, rounding to the grid included
///     out         its `curves` refer to the outline: keep that as long as `out` is read
///
/// Points that fall on one grid point with the one before them are merged: the edge before keeps the t at which it
/// first got there, the edge after starts at the t (or the curve) with which the boundary leaves. Contours of which
/// fewer than 3 points are left enclose nothing and are dropped.
///
/// The discretiser is given `tolerance` less g.snap_error(), but never less than g.snap_error(): below twice that error
/// no tolerance can be kept, and asking for more points would give the grid's steps instead of the curve.
///
/// Fails  error::bad_tolerance: not positive and finite
///        error::out_of_memory, error::too_large (2^32 - 1 points or curves and more); `out` is empty then
/// Cost   what the discretiser costs, and a few nanoseconds a point; nothing is allocated once `out` has grown
template <discretiser D>
error discretise(const outline& curves, const D& how, double tolerance, const grid& g, contours& out) noexcept
{
    out.clear();
    out.grid = g;
    if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad_tolerance;
    if (curves.curves.size() > 0xFFFF'FFFFu) return error::too_large;
    if (curves.contour_count() == 0) return {};

    const double snap = g.snap_error(), rest = tolerance - snap > snap ? tolerance - snap : snap;
    const auto snapped = [&g](point p) noexcept {
        TYPEMESH_ASSERT(std::abs(p.x) * g.cells <= grid::reach && std::abs(p.y) * g.cells <= grid::reach,
                        "a discretiser emitted a point outside the grid, or the grid does not fit the outline");
        return g.snap(p);
    };

    detail::contour_writer writer{out};
    writer.begin(2 * curves.curves.size() + 16);
    bool listed = out.starts.push_back(0);
    for (std::uint32_t c = 0; c < curves.contour_count() && listed && !writer.failed(); ++c) {
        const std::uint32_t first = curves.starts[c], end = curves.starts[c + 1];
        if (first == end) continue;
        writer.begin_contour(snapped(curves.curves[first].start()));
        for (std::uint32_t i = first; i < end; ++i) {
            const curve& q = curves.curves[i];
            writer.begin_curve(i);
            const auto emit = [&](point p, double t) noexcept { writer.arrive(snapped(p), static_cast<float>(t)); };
            if (q.degree == 1)
                emit(q.p[1], 1.0);
            else if (q.degree == 2)
                how(q.as_quadratic(), rest, emit);
            else
                how(q.as_cubic(), rest, emit);
        }
        if (writer.end_contour()) listed = out.starts.push_back(static_cast<std::uint32_t>(writer.size()));
    }
    writer.end();
    if (writer.failed() || !listed) {
        out.clear();
        return writer.failed() ? writer.failed() : error{error::out_of_memory};
    }
    out.curves = curves.curves.view();
    return {};
}

}  // namespace typemesh
