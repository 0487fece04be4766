// SPDX-License-Identifier: MIT
#pragma once

// The walls beside a point, from the polygon only, and normals to compare with.

#include "mesh.hpp"
#include "support/catch.hpp"

namespace meshes {

struct walls {
    point before, after;
    double degrees;
};

/// The two walls at a point, from the polygon only.
inline walls at(const shapes::shape& s, std::uint32_t i)
{
    const auto normal = [&](std::uint32_t a, std::uint32_t b) {
        const double dx = double(s.loops.points[b].x) - s.loops.points[a].x,
                     dy = double(s.loops.points[b].y) - s.loops.points[a].y;
        return point{dy / std::hypot(dx, dy), -dx / std::hypot(dx, dy)};
    };
    const point p = normal(s.previous(i), i), q = normal(i, s.next(i));
    return {p, q, std::atan2(std::abs(cross(p, q)), typemesh::dot(p, q)) * 180.0 / 3.14159265358979323846};
}

inline void check_equal(vec3 n, point p, double z)
{
    const double l = std::sqrt(typemesh::dot(p, p) + z * z);
    CHECK(n.x == Catch::Approx(p.x / l).margin(1e-6));
    CHECK(n.y == Catch::Approx(p.y / l).margin(1e-6));
    CHECK(n.z == Catch::Approx(z / l).margin(1e-6));
}

}  // namespace meshes
