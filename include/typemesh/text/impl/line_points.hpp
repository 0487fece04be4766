// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/curve.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/tangent.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/discretise/certified.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A point of a flattened line, and the directions of its curves before and after it. At the start of an open line
/// there is none before; at its end, both are the same.
struct line_point {
    point at;
    point before, after;
};

/// An outline_sink that flattens open and closed lines.
///
///     points   [ first line | second line | ... ]      a closed line does not repeat its first point
///     starts   where each begins; closed: whether each is closed
class line_points {
public:
    explicit line_points(memory source = heap()) noexcept : points{source}, starts{source}, closed{source} {}

    buffer<line_point> points;
    buffer<std::uint32_t> starts;
    buffer<std::uint8_t> closed;
    point pen = {};          ///< added to all points that follow
    double tolerance = 1.0;  ///< of flattening

    void clear() noexcept
    {
        points.clear();
        starts.clear();
        closed.clear();
        begun_ = false;
        pen = {};
        failed = {};
    }

    void move(point p) noexcept
    {
        note(p);
        begun_ = true;
        current_ = p + pen;
        if (!starts.push_back(static_cast<std::uint32_t>(points.size())) || !closed.push_back(0) ||
            !points.push_back({current_, {}, {}}))
            failed = error::out_of_memory;
    }
    void line(point p) noexcept { draw(curve::from(current_, p + pen)); }
    void quadratic(point control, point p) noexcept
    {
        draw(curve::from(typemesh::quadratic{current_, control + pen, p + pen}));
    }
    void cubic(point a, point b, point p) noexcept
    {
        draw(curve::from(typemesh::cubic{current_, a + pen, b + pen, p + pen}));
    }
    void close() noexcept
    {
        if (failed || !begun_) return;
        begun_ = false;
        const std::uint32_t first = starts.back();
        if (!(current_ == points[first].at)) draw_line_to(points[first].at);
        if (failed || points.size() - first < 2) return;
        points[first].before = points.back().before;
        points.truncate(points.size() - 1);
        closed.back() = 1;
    }

    error failed;  ///< the first failure: not finite, without move(), too many points, out of memory

private:
    void note(point p) noexcept
    {
        if (!failed && (!is_finite(p.x) || !is_finite(p.y))) failed = error::outline_not_finite;
    }
    void draw_line_to(point p) noexcept
    {
        begun_ = true;
        draw(curve::from(current_, p));
        begun_ = false;
    }
    void draw(const curve& c) noexcept
    {
        for (std::uint32_t k = 0; k <= c.degree; ++k) note(c.p[k]);
        if (!failed && !begun_) failed = error::bad_outline;
        if (!failed && points.size() > 0x0FFF'FFFFu) failed = error::too_large;
        if (failed) return;
        const hodograph along{c};
        points.back().after = along.at(0.0).after;
        const auto put = [&](point p, double t) noexcept {
            const tangents way = along.at(t);
            if (!failed && !points.push_back({p, way.before, way.after})) failed = error::out_of_memory;
        };
        if (c.degree == 1)
            put(c.p[1], 1.0);
        else if (c.degree == 2)
            certified{}(c.as_quadratic(), tolerance, put);
        else
            certified{}(c.as_cubic(), tolerance, put);
        current_ = c.end();
    }

    point current_;
    bool begun_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
