// SPDX-License-Identifier: MIT
#pragma once

// Points of paths for the tests of text that follows a curve.

#include <typemesh/bend/double3.hpp>

#include <random>
#include <vector>

namespace paths {

using typemesh::double3;

inline std::vector<double3> random_walk(unsigned seed)
{
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> any{-1.0, 1.0};
    std::vector<double3> all{{0.0, 0.0, 0.0}};
    for (int i = 0; i < 6; ++i)
        all.push_back(all.back() + double3{2.0 + any(random), 1.2 * any(random), 1.2 * any(random)});
    return all;
}

}  // namespace paths
