// SPDX-License-Identifier: MIT
#pragma once

// Curves as discretisers make points of them, and distances from line segments.

#include <typemesh/core/curve.hpp>

#include <algorithm>
#include <vector>

namespace test {

inline double distance_to_segment(typemesh::point q, typemesh::point a, typemesh::point b)
{
    const typemesh::point d = b - a, r = q - a;
    const double dd = dot(d, d);
    const double s = dd > 0.0 ? std::clamp(dot(r, d) / dd, 0.0, 1.0) : 0.0;
    return length(r - s * d);
}

struct emitted {
    typemesh::point p;
    double t = 0.0;
};

template <class Discretiser>
std::vector<emitted> points_of(const Discretiser& how, const typemesh::curve& c, double tolerance)
{
    std::vector<emitted> out;
    const auto put = [&](typemesh::point p, double t) noexcept { out.push_back({p, t}); };
    c.degree == 2 ? how(c.as_quadratic(), tolerance, put) : how(c.as_cubic(), tolerance, put);
    return out;
}

}  // namespace test
