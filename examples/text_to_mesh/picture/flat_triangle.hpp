// SPDX-License-Identifier: MIT
#pragma once

#include "raster.hpp"

#include <cstdint>

namespace text_to_mesh {

/// A triangle on the picture.
struct flat_triangle {
    raster_point at[3];
    double inverse[3];       ///< 1 / distance at the corners
    double plane[3];         ///< 1 / distance = plane[0] + plane[1] x + plane[2] y, x and y in steps from at[0]
    double lowest, highest;  ///< of `inverse`, against rounding where the triangle is seen edge on
    std::uint32_t first;     ///< place of its first index
    std::uint32_t part;
    bool turned_away;
};

/// Of the three corners, 1 together.
struct weights {
    double of[3];
};

/// The share of each corner at a place in the picture, right in perspective.
[[nodiscard]] inline weights weigh(const flat_triangle& t, double x, double y)
{
    const auto twice = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    double dx[3], dy[3];
    for (int i = 0; i < 3; ++i) {
        dx[i] = t.at[i].x - x;
        dy[i] = t.at[i].y - y;
    }
    const double a = twice(dx[1], dy[1], dx[2], dy[2]) * t.inverse[0];
    const double b = twice(dx[2], dy[2], dx[0], dy[0]) * t.inverse[1];
    const double c = twice(dx[0], dy[0], dx[1], dy[1]) * t.inverse[2];
    const double sum = a + b + c;
    return {{a / sum, b / sum, c / sum}};
}

}  // namespace text_to_mesh
