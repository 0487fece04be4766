// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/point.hpp>

#include <cmath>
#include <vector>

namespace test {

using typemesh::vec3;

/// Spread evenly over the sphere (a Fibonacci lattice), then what lies on axes, edges and folds, and beside them.
inline std::vector<vec3> directions(int n)
{
    std::vector<vec3> all;
    for (int i = 0; i < n; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / n, r = std::sqrt(1.0 - z * z), a = 2.399963229728653 * i;
        all.push_back(
            {static_cast<float>(r * std::cos(a)), static_cast<float>(r * std::sin(a)), static_cast<float>(z)});
    }
    for (const float x : {-1.0f, -1e-7f, -0.0f, 0.0f, 1e-7f, 1.0f})
        for (const float y : {-1.0f, -1e-7f, -0.0f, 0.0f, 1e-7f, 1.0f})
            for (const float z : {-1.0f, -1e-7f, -0.0f, 0.0f, 1e-7f, 1.0f}) {
                const float l = std::sqrt(x * x + y * y + z * z);
                if (l > 0.5f) all.push_back({x / l, y / l, z / l});
            }
    return all;
}

inline double degrees_between(vec3 a, vec3 b)
{
    const double x = double(a.y) * b.z - double(a.z) * b.y, y = double(a.z) * b.x - double(a.x) * b.z,
                 z = double(a.x) * b.y - double(a.y) * b.x,
                 along = double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
    return std::atan2(std::sqrt(x * x + y * y + z * z), along) * 57.29577951308232;
}

}  // namespace test
