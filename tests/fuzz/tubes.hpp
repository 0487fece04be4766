// SPDX-License-Identifier: MIT
#pragma once

#include "drawn_shapes.hpp"

#include <typemesh/extrude/tubed.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

/// Region -> neon tubes along its outline.
namespace fuzz {

namespace tube_laws {

using namespace typemesh;
using namespace solid_laws;

struct segment {
    inspect::place a, b;
    std::size_t path = 0;
};

inline double distance(const inspect::place& p, const segment& s)
{
    const double x = s.b.x - s.a.x, y = s.b.y - s.a.y, square = x * x + y * y;
    const double along = square > 0.0 ? ((p.x - s.a.x) * x + (p.y - s.a.y) * y) / square : 0.0,
                 on = (std::clamp)(along, 0.0, 1.0);
    return std::hypot(s.a.x + on * x - p.x, s.a.y + on * y - p.y);
}

/// The middles of a solid's tubes, and their radii in cells.
struct middles {
    std::vector<segment> segments;
    std::vector<double> radii, lengths;

    middles(const tubed_data& data, double em)
    {
        const auto read = data.read();
        const auto starts = read.template of<std::uint32_t>();
        const auto joints = read.template of<detail::tube_joint>();
        for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
            radii.push_back(double(read.template of<detail::tube_path>()[k].radius) * em);
            lengths.push_back(0.0);
            for (std::uint32_t i = starts[k], end = starts[k + 1]; i < end; ++i) {
                const grid_point a = joints[i].at, b = joints[i + 1 == end ? starts[k] : i + 1].at;
                segments.push_back({{double(a.x), double(a.y), 0.0}, {double(b.x), double(b.y), 0.0}, k});
                lengths.back() +=
                    std::hypot(segments.back().b.x - segments.back().a.x, segments.back().b.y - segments.back().a.y);
            }
        }
    }
};

/// Tubes of different loops that do not meet as drawn do not meet: segments that do not cross are closest at an end.
inline broken_law of_clearance(const middles& m, double slack)
{
    for (const segment& s : m.segments)
        for (const segment& other : m.segments) {
            const double apart = m.radii[s.path] + m.radii[other.path];
            if (s.path == other.path || !(m.radii[s.path] > 0.0 && m.radii[other.path] > 0.0)) continue;
            if (distance(s.a, other) < apart - slack) return "tubes of two loops meet";
        }
    return {};
}

/// Every point of the outline lies as close to its tube's middle as `cut` allows.
inline broken_law of_path(const middles& m, const region& drawn, double cut, double slack)
{
    for (std::uint32_t k = 0; k < drawn.loop_count(); ++k) {
        if (!(m.radii[k] > 0.0)) continue;
        for (std::uint32_t i = drawn.starts()[k]; i < drawn.starts()[k + 1]; ++i) {
            const grid_point at = drawn.points()[i];
            double least = 1e300;
            for (const segment& s : m.segments)
                if (s.path == k) least = (std::min)(least, distance({double(at.x), double(at.y), 0.0}, s));
            if (least > 1.5 * cut * m.radii[k] + slack) return "the tube leaves the outline";
        }
    }
    return {};
}

inline bool is_same(const inspect::place& p, const inspect::place& q) { return p.x == q.x && p.y == q.y && p.z == q.z; }

/// Whether a segment passes through a triangle, away from its edges.
inline bool pierces(const inspect::place& a, const inspect::place& b, const inspect::place (&t)[3], double nothing)
{
    const auto volume = [](const auto& o, const auto& p, const auto& q, const auto& r) {
        return inspect::dot(p - o, inspect::cross(q - o, r - o));
    };
    const double from = volume(a, t[0], t[1], t[2]), to = volume(b, t[0], t[1], t[2]);
    if (!((from > nothing && to < -nothing) || (from < -nothing && to > nothing))) return false;
    const double x = volume(a, b, t[0], t[1]), y = volume(a, b, t[1], t[2]), z = volume(a, b, t[2], t[0]);
    return (x > nothing && y > nothing && z > nothing) || (x < -nothing && y < -nothing && z < -nothing);
}

/// No edge passes through a triangle with which it shares no corner.
inline broken_law of_surface(const mesh& m, double nothing)
{
    const auto at = [&m](std::size_t i) { return inspect::to_place(m.vertices[m.indices[i]].position); };
    for (std::size_t t = 0; t < m.indices.size(); t += 3) {
        const inspect::place corners[3] = {at(t), at(t + 1), at(t + 2)};
        for (std::size_t e = 0; e < m.indices.size(); ++e) {
            const inspect::place a = at(e), b = at(e % 3 == 2 ? e - 2 : e + 1);
            bool shares = false;
            for (const inspect::place& c : corners) shares = shares || is_same(c, a) || is_same(c, b);
            if (!shares && pierces(a, b, corners, nothing)) return "an edge passes through a triangle";
        }
    }
    return {};
}

/// `fits_floats`: whether floats can tell all points of the region apart.
inline broken_law of_tubed(const tubed& how, drawn_region& from, bool fits_floats)
{
    tubed_data data;
    mesh m;
    const auto plan = test::write_in_cells(how, from.made, from.caps, from.em, data, m);
    if (!plan) return unless_one_of(plan.error(), {error::bad_option, error::outline_beyond_grid});
    if (broken_law broken = of_mesh(m, how, from, plan->sizes); !broken.empty()) return broken;
    const middles paths{data, from.em};
    for (const double r : paths.radii)
        if (!(r <= double(how.radius) * from.em)) return "a tube is thicker than wanted";
    const std::size_t points = from.made.points().size();
    if (points > 300) return {};
    double reach = 0.0;
    for (const grid_point p : from.made.points())
        reach = (std::max)({reach, std::fabs(double(p.x)), std::fabs(double(p.y))});
    const double rounding = 1.0 + 1e-6 * (reach + from.em);
    if (!plan->touching)
        if (broken_law broken = of_clearance(paths, rounding); !broken.empty()) return broken;
    if (broken_law broken = of_path(paths, from.made, double(how.corner_cut), rounding); !broken.empty()) return broken;
    if (!fits_floats) return {};
    const double turn = 6.283185307179586 / how.sides;
    double volume = 0.0, surface = 0.0;
    for (std::size_t k = 0; k < paths.radii.size(); ++k) {
        volume += 0.5 * how.sides * paths.radii[k] * paths.radii[k] * std::sin(turn) * paths.lengths[k];
        surface += 7.0 * paths.radii[k] * paths.lengths[k];
    }
    if (!(std::fabs(inspect::measure(m.view()).volume - volume) <= 1e-4 * volume + 1e-6 * reach * surface))
        return "the volume is not that of the section along the path";
    if (plan->touching || m.indices.size() > 3000) return {};
    return of_surface(m, 1e-6 * reach * reach * (reach + 1.0));
}

}  // namespace tube_laws

inline broken_law tubes(values in)
{
    using namespace typemesh;
    using namespace tube_laws;
    static constexpr float radii[] = {0.02f, 0.005f, 0.08f, 0.3f, 0.0003f, 2.0f}, cuts[] = {0.5f, 0.0f, 1.0f, 0.1f},
                           creases[] = {15.0f, 0.0f, 44.0f, 180.0f};
    static constexpr std::uint32_t sides[] = {4, 3, 5, 16, 128};
    tubed how{.radius = in.one_of(radii) * float(in.between(0.75, 1.5)), .sides = in.one_of(sides)};
    how.corner_cut = in.one_of(cuts);
    how.crease_degrees = in.one_of(creases);
    how.texture = texture_mappings[in.byte() % std::size(texture_mappings)];
    drawn_shape from;
    if (broken_law broken = from.read(in); !broken.empty()) return broken;
    if (from.made.points().empty()) return {};
    return of_tubed(how, from, from.fits_floats());
}

}  // namespace fuzz
