// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/placement.hpp>
#include <typemesh/text/instances.hpp>

#include <initializer_list>

namespace typemesh::inline TYPEMESH_ABI {

/// Whether a glyph with this direction of its x axis is turned.
[[nodiscard]] constexpr bool is_turned(point right) noexcept { return !(right == point{1.0, 0.0}); }

/// Turns a placement about the glyph's origin: its frame turns, and its pen is written in the turned axes, so that the
/// origin stays where it is. The frame is one of floats; the pen knows how they are rounded.
inline void turn(placement& at, point right) noexcept
{
    if (!is_turned(right)) return;
    const auto c = static_cast<float>(right.x), s = static_cast<float>(right.y);
    const typemesh::frame flat = at.frame;
    const auto sum = [](float a, vec3 v, float b, vec3 w) noexcept {
        return vec3{a * v.x + b * w.x, a * v.y + b * w.y, a * v.z + b * w.z};
    };
    at.frame.right = sum(c, flat.right, s, flat.up);
    at.frame.up = sum(c, flat.up, -s, flat.right);
    const double x = as_double(c), y = as_double(s), square = x * x + y * y;
    at.pen = {(x * at.pen.x + y * at.pen.y) / square, (x * at.pen.y - y * at.pen.x) / square};
}

/// The box of a turned box.
[[nodiscard]] inline box turned_box(const box& own, point right) noexcept
{
    if (!is_turned(right)) return own;
    box all;
    for (const point p : {own.low, own.high, point{own.low.x, own.high.y}, point{own.high.x, own.low.y}})
        all.add({right.x * p.x - right.y * p.y, right.y * p.x + right.x * p.y});
    return all;
}

/// Turns an instance of a mesh that was written with a frame: see glyph_instance.
inline void turn(glyph_instance& instance, point right, const typemesh::frame& flat) noexcept
{
    if (!is_turned(right)) return;
    placement at;
    at.frame = flat;
    turn(at, right);
    const typemesh::frame& to = at.frame;
    instance.x = to(flat.right.x, flat.up.x, flat.toward.x);
    instance.y = to(flat.right.y, flat.up.y, flat.toward.y);
    instance.z = to(flat.right.z, flat.up.z, flat.toward.z);
}

}  // namespace typemesh::inline TYPEMESH_ABI
