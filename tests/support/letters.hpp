// SPDX-License-Identifier: MIT
#pragma once

// Letters of straight strokes.

#include "support/regions.hpp"

namespace test {

inline polyline scaled(polyline l, std::int32_t factor)
{
    for (grid_point& p : l) p = {p.x * factor, p.y * factor};
    return l;
}

/// A T three units high.
inline polyline letter_tee(std::int32_t unit)
{
    return scaled({{0, 2}, {1, 2}, {1, 0}, {2, 0}, {2, 2}, {3, 2}, {3, 3}, {0, 3}}, unit);
}

/// An H three units high, with a bar from 1.2 to 1.8 units.
inline polyline letter_aitch(std::int32_t unit)
{
    const std::int32_t low = unit * 6 / 5, high = unit * 9 / 5, two = 2 * unit, end = 3 * unit;
    return {{0, 0},     {unit, 0},  {unit, low}, {two, low},   {two, 0},    {end, 0},
            {end, end}, {two, end}, {two, high}, {unit, high}, {unit, end}, {0, end}};
}

}  // namespace test
