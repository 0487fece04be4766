// SPDX-License-Identifier: MIT

// How far the triangles of a membrane are from the surface that they stand for, and this surface from the triangles:
// the Hausdorff distance, measured in space, because heights rise steeply at the outline.

#include "inflated_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;
using namespace inflating;

namespace {

struct place {
    double x, y, z;
};
place operator-(place a, place b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
place between(place a, place b, double t)
{
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z)};
}
double dot(place a, place b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
double from_segment(place p, place a, place b)
{
    const place along = b - a;
    const double t = std::clamp(dot(p - a, along) / dot(along, along), 0.0, 1.0);
    const place rest = p - between(a, b, t);
    return std::sqrt(dot(rest, rest));
}

/// The distance of a place from a triangle.
double from_triangle(place p, const std::array<place, 3>& t)
{
    const place u = t[1] - t[0], v = t[2] - t[0], w = p - t[0];
    const double uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), wu = dot(w, u), wv = dot(w, v), d = uu * vv - uv * uv,
                 s = (vv * wu - uv * wv) / d, r = (uu * wv - uv * wu) / d;
    if (s >= 0.0 && r >= 0.0 && s + r <= 1.0) {
        const place rest{w.x - s * u.x - r * v.x, w.y - s * u.y - r * v.y, w.z - s * u.z - r * v.z};
        return std::sqrt(dot(rest, rest));
    }
    return (std::min)({from_segment(p, t[0], t[1]), from_segment(p, t[1], t[2]), from_segment(p, t[2], t[0])});
}

/// The triangles of a membrane in em.
std::vector<std::array<place, 3>> triangles_of(const inflated_shape& shape)
{
    const std::vector<grid_point> points = shape.cap.points();
    const std::size_t rim = shape.cap.loops.points.size();
    const auto at_corner = [&](std::uint32_t i) {
        const double z = i < rim ? 0.0 : double{shape.sheet.points()[i - rim].height};
        return place{points[i].x / em, points[i].y / em, z};
    };
    std::vector<std::array<place, 3>> all;
    for (const triangle t : shape.cap.triangles) all.push_back({at_corner(t.a), at_corner(t.b), at_corner(t.c)});
    return all;
}

/// The distance of the triangles from a surface, and of the surface from the triangles. `outside(p)` is the distance of a
/// place from the surface, or negative where it does not count; `surface` are places on it.
template <class Outside>
double hausdorff_distance(const inflated_shape& shape, const Outside& outside, const std::vector<place>& surface)
{
    const auto triangles = triangles_of(shape);
    double farthest = 0.0;
    constexpr int steps = 6;
    for (const auto& t : triangles)
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const double s = double(i) / steps, r = i == steps ? 0.0 : double(j) / (steps - i);
                farthest = (std::max)(farthest, outside(between(between(t[1], t[2], r), t[0], s)));
            }
    for (const place p : surface) {
        double nearest = 1e300;
        for (const auto& t : triangles) {
            const double low = (std::min)({t[0].x, t[1].x, t[2].x}), high = (std::max)({t[0].x, t[1].x, t[2].x});
            if (p.x < low - nearest || p.x > high + nearest) continue;
            nearest = (std::min)(nearest, from_triangle(p, t));
        }
        farthest = (std::max)(farthest, nearest);
    }
    return farthest;
}

/// A section from the outline over the top to the outline, by the angle.
constexpr int section_steps = 48;
constexpr double half_turn = 3.14159265358979;

}  // namespace

TEST_CASE("triangles of a straight stroke lie near half a cylinder, and it near them, in all sizes and positions",
          "[inflate]")
{
    for (const double degrees : {0.0, 17.0, 45.0, 90.0})
        for (const double width : {0.02, 0.04, 0.06, 0.15, 0.4}) {
            CAPTURE(degrees, width);
            const double c = std::cos(degrees / 180.0 * half_turn), s = std::sin(degrees / 180.0 * half_turn),
                         half = 0.5 * width, end = 0.2 + 2.0 * width;
            const inflated_shape stroke{
                {{at(-end * c + half * s, -end * s - half * c), at(end * c + half * s, end * s - half * c),
                  at(end * c - half * s, end * s + half * c), at(-end * c - half * s, -end * s + half * c)}}};
            std::vector<place> cylinder;
            for (int k = 0; k <= section_steps; ++k)
                for (const double along : {-0.15, -0.07, 0.01, 0.13}) {
                    const double turn = half_turn * k / section_steps, across = half * std::cos(turn);
                    cylinder.push_back({along * c - across * s, along * s + across * c, half * std::sin(turn)});
                }
            const double distance = hausdorff_distance(
                stroke,
                [&](place p) {
                    if (std::abs(p.x * c + p.y * s) > 0.2) return -1.0;  // near the ends it is round
                    return std::abs(std::hypot(p.y * c - p.x * s, p.z) - half);
                },
                cylinder);
            // Where triangles leave out the first ring, an eighth of the section is 0.076 of half the width away.
            CHECK(distance < 0.125 * half);
            CHECK(distance < 1.0 / 500);
        }
}

TEST_CASE("triangles of a disc lie near an ellipsoid, and it near them, in all sizes and positions", "[inflate]")
{
    for (const double degrees : {0.0, 1.0, 17.0})
        for (const double half : {0.01, 0.03, 0.075, 0.2}) {
            CAPTURE(degrees, half);
            std::vector<grid_point> round;
            for (int i = 0; i < 180; ++i) {
                const double turn = (2.0 * i + degrees) / 180.0 * half_turn;
                round.push_back(at(half * std::cos(turn), half * std::sin(turn)));
            }
            const double top = std::sqrt(0.5) * half;
            std::vector<place> ellipsoid, section;
            for (int k = 0; k <= section_steps / 2; ++k)
                for (const double around : {0.0, 0.4, 1.9, 3.3, 5.2}) {
                    const double turn = half_turn * k / section_steps, r = half * std::cos(turn);
                    ellipsoid.push_back({r * std::cos(around), r * std::sin(around), top * std::sin(turn)});
                }
            for (int k = 0; k <= 300; ++k)
                section.push_back({half * std::cos(k / 600.0 * half_turn), 0.0, top * std::sin(k / 600.0 * half_turn)});
            const double distance = hausdorff_distance(
                inflated_shape{{round}},
                [&](place p) {
                    const place q{std::hypot(p.x, p.y), 0.0, p.z};
                    double nearest = 1e300;
                    for (std::size_t k = 1; k < section.size(); ++k)
                        nearest = (std::min)(nearest, from_segment(q, section[k - 1], section[k]));
                    return nearest;
                },
                ellipsoid);
            CHECK(distance < 0.03 * half);
            CHECK(distance < 1.0 / 800);
        }
}
